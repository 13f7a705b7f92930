// The clock of a run's statistics: when samples are taken. It does not depend on any film.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "physics/run.h"

namespace carom {

/// The usual time between samples: there are a thousand steps.
inline double usual_sample_every(const Run& run) { return run.until / 1000.0; }

/// The time between samples: that of the run or, if that is 0, the usual one.
inline double sample_interval(const Run& run) {
    return run.sample_every > 0.0 ? run.sample_every : usual_sample_every(run);
}

/// The number of samples of a run: at 0, at multiples of the interval, and at the end.
inline std::int64_t sample_count(const Run& run) {
    constexpr double rounding = 1e-9;  // no tiny interval after exactly k steps by round-off
    return 1 + static_cast<std::int64_t>(
                   std::max(1.0, std::ceil(run.until / sample_interval(run) - rounding)));
}

/// The time of a sample, counted from 0.
inline double sample_time(const Run& run, std::int64_t index) {
    if (index + 1 >= sample_count(run)) return run.until;
    return static_cast<double>(index) * sample_interval(run);
}

/// Whether a time is that of a sample. What is measured at moments of several kinds, as are the
/// frames of a film and the times that figures show, takes only these into account.
inline bool is_sample_time(const Run& run, double time) {
    const auto nearest = static_cast<std::int64_t>(std::llround(time / sample_interval(run)));
    return time == run.until || time == sample_time(run, nearest);
}

}  // namespace carom

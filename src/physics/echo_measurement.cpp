#include "physics/echo_measurement.h"

#include <algorithm>

namespace carom {

std::optional<double> mirror_time(const std::vector<double>& reversals, double time,
                                  bool ends_branch) {
    const auto next = ends_branch ? std::ranges::lower_bound(reversals, time)
                                  : std::ranges::upper_bound(reversals, time);
    if (next == reversals.begin()) return std::nullopt;
    const double last = *(next - 1);
    const double begin = next - reversals.begin() > 1 ? *(next - 2) : 0.0;
    const double mirror = last - (time - last);
    const double rounding = 1e-12 * last;
    if (mirror < begin - rounding) return std::nullopt;
    return std::max(mirror, begin);
}

EchoMeasurement::EchoMeasurement(const std::vector<double>& reversals, std::vector<double> times,
                                 double present, bool ends_branch) {
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (const double time : times) {
        const auto mirror = mirror_time(reversals, time, ends_branch);
        if (!mirror || *mirror < present) continue;
        (*mirror == time ? reversals_ : mirrors_).push_back({*mirror, time});
    }
    std::ranges::stable_sort(mirrors_, {}, &Mirror::time);
}

void EchoMeasurement::keep(const Positions& positions) {
    const double now = next_time();
    const ExactPositions here = positions();
    for (; next_time() == now; ++next_) mirrors_[next_].positions = here;
}

void EchoMeasurement::keep_at_reversal(double time, const Positions& positions) {
    for (Mirror& mirror : reversals_)
        if (mirror.time == time && !mirror.positions) mirror.positions = positions();
}

std::optional<ReturnDistance> EchoMeasurement::compare(double time, const Positions& positions) {
    if (time == compared_) return distance_;
    compared_ = time;
    distance_.reset();
    for (std::vector<Mirror>* mirrors : {&mirrors_, &reversals_}) {
        const auto mirror = std::ranges::find(*mirrors, time, &Mirror::again);
        if (mirror == mirrors->end() || !mirror->positions) continue;
        distance_ = return_distance(*mirror->positions, positions());
        mirror->positions.reset();
    }
    return distance_;
}

}  // namespace carom

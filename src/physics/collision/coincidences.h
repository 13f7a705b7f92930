// The times at which contacts that share a particle may coincide. Predictions note them, because a
// particle stores only its first contact; the event loop then looks at all contacts of that
// instant.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/collision/pair_collision.h"

namespace carom {

class Coincidences {
  public:
    /// Forgets all times; those closer than `margin` may coincide.
    void reset(double margin) {
        times_.clear();
        margin_ = margin;
        update();
    }

    /// Whether contacts may coincide at a local time.
    bool are_near(double time) const { return time >= from_; }

    /// The same, by the times that were noted alone.
    bool are_noted_near(double time) const {
        return !times_.empty() && time >= times_.front() - margin_;
    }

    /// `is_watching`: contacts may coincide at any time, because particles touch each other without
    /// approaching.
    void watch_always(bool is_watching) {
        is_watching_ = is_watching;
        update();
    }

    double margin() const { return margin_; }

    /// Whether two times are within the margin.
    bool may_coincide(double a, double b) const { return std::abs(a - b) <= margin_; }

    /// Adds a time at which contacts may coincide.
    [[gnu::noinline, gnu::cold]] void note(double time) {
        if (!std::isfinite(time)) return;
        times_.insert(std::ranges::upper_bound(times_, time), time);
        update();
    }

    /// Forgets the times that have passed.
    void forget_before(double time) {
        const auto end = std::ranges::lower_bound(times_, time - 2.0 * margin_);
        if (end == times_.begin()) return;
        times_.erase(times_.begin(), end);
        update();
    }

    void shift_epoch(double shift) {
        for (double& time : times_) time -= shift;
        update();
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(times_, margin_, is_watching_);
        update();
    }

  private:
    void update() {
        from_ = is_watching_     ? -never<double>
                : times_.empty() ? never<double>
                                 : times_.front() - margin_;
    }

    std::vector<double> times_;  ///< in ascending order
    double margin_ = 0.0;
    double from_ = never<double>;
    bool is_watching_ = false;
};

}  // namespace carom

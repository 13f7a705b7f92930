// The branches of a run between its reversals, and the pairs of times at which it should have the
// same positions. Independent of particles.
#pragma once

#include <vector>

#include "physics/multiprecision/multiprecision.h"
#include "physics/run.h"

namespace carom {

/// A part of the run between two reversals, between a reversal and the time at which the way back
/// is left (ways_back.h), or after that time. The path coordinate measures where the gas is in its
/// history: it equals the time until the first reversal, decreases after it, and falls below 0 if
/// the gas goes back beyond its start.
struct Branch {
    double begin, end;             ///< simulated times
    double path;                   ///< path coordinate at the beginning
    Real exact_path;               ///< the same without rounding
    int direction;                 ///< 1 or -1
    bool leaves_way_back = false;  ///< the path ahead differs from the one recorded before
    double path_at(double time) const { return path + direction * (time - begin); }
};

/// Two times at which the gas should have the same positions.
struct MirrorTimes {
    double first, again;
    double path;
    double off;  ///< distance of the two times along the path, if rounding to doubles makes them
                 ///< differ
};

class ReversalSchedule {
  public:
    explicit ReversalSchedule(const Run& run);

    const std::vector<Branch>& branches() const { return branches_; }

    /// For each branch after the first, the mirror times of its farthest point on the path that was
    /// visited before, and those of the start if the branch passes it; in order of the second
    /// times.
    const std::vector<MirrorTimes>& mirror_times() const { return mirror_times_; }

  private:
    MirrorTimes mirror_of(const Branch& later, double path) const;
    void add(const Branch& branch);

    /// The part of a branch to which later branches may return.
    struct Known {
        Branch branch;
        double low, high;  ///< range of the path coordinate
    };
    void forget_beyond(double path, int direction);

    std::vector<Branch> branches_;
    std::vector<Known> known_;
    std::vector<MirrorTimes> mirror_times_;
    double low_ = 0.0, high_ = 0.0;  ///< range of the path coordinate so far
};

}  // namespace carom

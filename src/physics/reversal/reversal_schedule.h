// The branches of a run between its reversals, and the pairs of times at which it should be in the
// same state. Knows no particles.
#pragma once

#include <vector>

#include "physics/multiprecision/multiprecision.h"
#include "physics/run.h"

namespace carom {

/// A part of the run between two reversals, or between a reversal and where the way back is left
/// (ways_back.h), or after that. Where the gas is in its history is the path: the time
/// as it was before the first reversal; it falls after that, and below 0 beyond the start.
struct Branch {
    double begin, end;  ///< simulated times
    double path;        ///< at its begin, and
    Real exact_path;    ///< the same without rounding
    int direction;      ///< 1 or -1
    bool leaves_way_back =
        false;  ///< what lies ahead on its path is not what has been there before
    double path_at(double time) const { return path + direction * (time - begin); }
};

/// Two times at which the gas should have the same positions.
struct MirrorTimes {
    double first, again;
    double path;
    double off;  ///< by how much they miss each other, where the time between has no double
};

class ReversalSchedule {
  public:
    explicit ReversalSchedule(const Run& run);

    const std::vector<Branch>& branches() const { return branches_; }

    /// For each branch after the first the time of its path that is farthest back, and that of the
    /// start if it passes it; in order of the second times.
    const std::vector<MirrorTimes>& mirror_times() const { return mirror_times_; }

  private:
    MirrorTimes mirror_of(const Branch& later, double path) const;
    void add(const Branch& branch);

    /// The part of a branch to which later ones may come back.
    struct Known {
        Branch branch;
        double low, high;  ///< of its path
    };
    void forget_beyond(double path, int direction);

    std::vector<Branch> branches_;
    std::vector<Known> known_;
    std::vector<MirrorTimes> mirror_times_;
    double low_ = 0.0, high_ = 0.0;  ///< the range of the path so far
};

}  // namespace carom

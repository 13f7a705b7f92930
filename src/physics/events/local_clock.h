// Represents time as an epoch plus a short time since then. Contacts are computed in the short
// time, which keeps its precision however long the run. The caller decides when to move the epoch.
// MpClock has the same interface for multiprecision numbers, which need no epoch.
#pragma once

#include "physics/multiprecision/multiprecision.h"
#include "physics/run.h"

namespace carom {

class LocalClock {
  public:
    /// Makes a time on the user's clock the epoch; returns its local time, 0.
    double start(double time) {
        high_ = time;
        low_ = 0.0;
        return 0.0;
    }

    /// Moves the epoch on by `time`; the sum is kept to twice the digits of a double (two-sum).
    void advance(double time) {
        const double sum = high_ + time;
        const double added = sum - high_;
        low_ += (high_ - (sum - added)) + (time - added);
        high_ = sum;
    }

    /// Time since the epoch of a time on the user's clock.
    double local(double time) const { return (time - high_) - low_; }

    /// Time on the user's clock of a time since the epoch.
    double absolute(double local_time) const { return high_ + (low_ + local_time); }

    /// Makes a local time the new epoch; returns its new local time, 0.
    double move_epoch_to(double local_time) {
        advance(local_time);
        return 0.0;
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(high_, low_);
    }

  private:
    double high_ = 0.0;
    double low_ = 0.0;
};

class MpClock {
  public:
    /// Times have the same precision as all other numbers: with fewer bits the difference of two
    /// times would be rounded.
    explicit MpClock(int bits = bits_of_double) : bits_(bits) {}

    Real start(double time) { return local(time); }
    Real local(double time) const { return {time, bits_}; }
    double absolute(const Real& time) const { return static_cast<double>(time); }
    Real move_epoch_to(const Real& time) const { return time; }

    template <class Archive>
    void archive(Archive&) {}

  private:
    int bits_;
};

}  // namespace carom

// Measures how long work takes.
#pragma once

#include <ctime>

namespace carom {

/// Measures seconds since its construction.
class Stopwatch {
  public:
    double wall() const { return seconds_of(CLOCK_MONOTONIC) - wall_begun_; }

    /// CPU time of this thread, which must be the one that constructed the stopwatch.
    double cpu() const { return seconds_of(CLOCK_THREAD_CPUTIME_ID) - cpu_begun_; }

  private:
    static double seconds_of(clockid_t clock) {
        timespec time = {};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double wall_begun_ = seconds_of(CLOCK_MONOTONIC);
    double cpu_begun_ = seconds_of(CLOCK_THREAD_CPUTIME_ID);
};

}  // namespace carom

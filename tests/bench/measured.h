// The CPU time per collision of a gas. The minimum of several measurements is used, as it is the
// least disturbed one; gases that are compared are measured in turn.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <limits>

#include "physics/gas.h"
#include "physics/simulation.h"

namespace carom::test {

inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A gas that has been equilibrated for the time `melting`.
class Measured {
  public:
    Measured(const Gas& gas, double melting)
        : step_(2e5 / static_cast<double>(count_of(gas))), simulation_(gas, melt(melting)) {}

    void measure() {
        const double begin = cpu_seconds();
        const std::int64_t now = simulation_.advance_to(++steps_ * step_).counts.particle;
        const auto collisions = static_cast<double>(now - collisions_);
        collisions_ = now;
        nanoseconds_ = std::min(nanoseconds_, (cpu_seconds() - begin) / collisions * 1e9);
    }

    double nanoseconds() const { return nanoseconds_; }  ///< per collision of two particles

  private:
    static std::int64_t count_of(const Gas& gas) {
        std::int64_t count = 0;
        for (const Species& species : gas.species) count += species.count;
        return count;
    }
    static Run melt(double time) {
        Run run;
        run.equilibrate = time;
        return run;
    }

    double step_;  // some 1e5 to 1e6 collisions
    Simulation simulation_;
    int steps_ = 0;
    std::int64_t collisions_ = 0;
    double nanoseconds_ = std::numeric_limits<double>::infinity();
};

}  // namespace carom::test

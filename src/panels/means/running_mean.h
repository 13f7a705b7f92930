// Numbers of single moments, averaged over the time before the present.
#pragma once

#include <vector>

#include "panels/means/trailing.h"

namespace carom {

/// Means of several numbers over a window before the present, or since the start. Between two
/// moments at which a number is known it counts with the mean of both.
class RunningMean {
  public:
    explicit RunningMean(Over over) : over_(over), sums_(over) {}

    /// The means at the next moment, of which `now` has the numbers (NaN: none).
    std::vector<double> operator()(double time, const std::vector<double>& now, bool is_sample);

  private:
    struct Sums {
        double time = 0.0;
        std::vector<double> now = {}, integral = {}, known_for = {};
    };
    Over over_;
    Trailing<Sums> sums_;
};

}  // namespace carom

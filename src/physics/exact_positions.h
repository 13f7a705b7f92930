// Where all particles are at one time, to the last bit of the run's numbers; and how far apart two
// such states are, also where no double is small enough to tell.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

class Real;

/// Distances of all particles from their places in another state, as lengths.
struct ReturnDistance {
    double largest = 0.0;
    double root_mean_square = 0.0;
    /// Their logarithms, which go on where they are too small for a double; -infinity for 0.
    double log10_largest = -std::numeric_limits<double>::infinity();
    double log10_root_mean_square = -std::numeric_limits<double>::infinity();
};

class ExactPositions {
  public:
    /// Coordinates of each particle one after the other; on periodic axes any image.
    ExactPositions(const Box& box, std::vector<Real> coordinates);

    /// Across periodic borders the nearest image counts.
    friend ReturnDistance return_distance(const ExactPositions& a, const ExactPositions& b);

  private:
    Box box_;
    std::shared_ptr<const std::vector<Real>> coordinates_;
};

/// The same for two states of one gas of which only doubles are known.
ReturnDistance return_distance(const Box& box, const Sample& a, const Sample& b);

}  // namespace carom

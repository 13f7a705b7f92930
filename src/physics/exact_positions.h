// Where all particles are at one time, to the last bit of the run's numbers; and how far apart two
// such states are, also where no double is small enough to express it. Any function may be called
// from any thread.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"

namespace carom {

class Archive;
class Real;

/// Distances of all particles from their positions in another state, as lengths.
struct ReturnDistance {
    double largest = 0.0;
    double root_mean_square = 0.0;
    /// Their logarithms, which go on where they are too small for a double; -infinity for 0.
    double log10_largest = -std::numeric_limits<double>::infinity();
    double log10_root_mean_square = -std::numeric_limits<double>::infinity();

    template <class Archive>
    void archive(Archive& archive) {
        archive(largest, root_mean_square, log10_largest, log10_root_mean_square);
    }
};

/// Made by Simulation::exact_positions().
class ExactPositions {
  public:
    /// Of no particles.
    ExactPositions() = default;

    /// Writes the positions with all their bits, or reads them.
    void archive(Archive& archive);

    /// Across periodic sides the nearest image counts. Throws std::invalid_argument unless both are
    /// states of one gas in numbers of one kind, doubles or multiprecision.
    friend ReturnDistance return_distance(const ExactPositions& a, const ExactPositions& b);

  private:
    friend class Simulation;
    ExactPositions(const Box& box, Eigen::ArrayXXd doubles);
    ExactPositions(const Box& box, std::vector<Real> coordinates);

    Box box_;
    Eigen::ArrayXXd doubles_;  ///< N x dimension, of a run in doubles; else
    /// the coordinates of each particle one after the other; on periodic axes those of any image.
    std::shared_ptr<const std::vector<Real>> coordinates_;
};

ReturnDistance return_distance(const ExactPositions& a, const ExactPositions& b);

/// The same for two states of one gas of which only doubles are known.
ReturnDistance return_distance(const Box& box, const Sample& a, const Sample& b);

}  // namespace carom

// Positions of all particles at one time in the full precision of the run, and the distance between
// two such states, even where it is too small for a double. All functions may be called from any
// thread.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"

namespace carom {

class Archive;
class Real;

/// Distances of all particles from their positions in another state, as lengths.
struct ReturnDistance {
    double largest = 0.0;
    double root_mean_square = 0.0;
    /// Their decimal logarithms, valid even where the distances are too small for a double;
    /// -infinity for 0.
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

    /// Distances of all particles between two states, by the minimum-image convention across
    /// periodic sides. Throws std::invalid_argument unless both are states of the same gas and of
    /// the same kind of numbers, doubles or multiprecision.
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

/// The same for two states of one gas that are known in doubles only.
ReturnDistance return_distance(const Box& box, const Sample& a, const Sample& b);

}  // namespace carom

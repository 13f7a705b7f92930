// The entropy of a gas for each particle, counted over cells: of velocities, which is Boltzmann's
// -H, and of positions.
#pragma once

#include <Eigen/Core>

#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/theory/kinds.h"
#include "stats/cell_averages.h"

namespace carom {

/// -sum p ln p, averaged over the particles of finite mass, where p is the share of a kind's
/// particles in a cell of velocity; dimensionless. It is 0 when all of a kind move alike, and
/// rises to what the same count gives in equilibrium. Kinds are those of kinds_of(): species have
/// no part in it.
class VelocityEntropy {
  public:
    /// Cells are of equal size in velocities measured in thermal ones, sqrt(T / m), at the
    /// temperature of `start`, which is above 0; what lies beyond four of them belongs to the
    /// outermost cells.
    VelocityEntropy(const Particles& particles, const ThermalMotion& start);

    /// Of velocities, N x dimension.
    double of(const Eigen::ArrayXXd& velocity) const;

    /// The mean of the same for velocities that are spread evenly over the energy sphere, in so
    /// many dimensions: what counting leaves of equilibrium's.
    double in_equilibrium(int dimension) const;

  private:
    int cell_of(double u) const;

    Kinds kinds_;
    double degrees_of_freedom_;
    Eigen::ArrayXd scale_;  ///< 1 / thermal velocity; 0 for infinite masses
    int cells_per_axis_;
};

/// -sum p ln p over the particles of finite mass, p the share of them in a cell of the box;
/// dimensionless. Particles that spread over a K times larger area gain ln K.
class PositionEntropy {
  public:
    /// `along_longer`: how many cells are along the longer side; none: as many as leave about five
    /// particles in each, an even number.
    PositionEntropy(const Box& box, const Particles& particles, std::optional<int> along_longer);

    /// Of positions, N x dimension. What is beyond sides that have moved belongs to the outermost
    /// cells.
    double of(const Eigen::ArrayXXd& position) const;

    /// The mean of the same for points that are spread evenly over the whole box: what counting
    /// leaves of ln(cells). The exact sum over the binomial distribution.
    double of_even_spread() const;

    const Cells& cells() const { return cells_; }

  private:
    Cells cells_;
    Eigen::ArrayXd counted_;  ///< 1 for finite masses
};

}  // namespace carom

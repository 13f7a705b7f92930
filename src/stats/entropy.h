// The entropy per particle of a gas, from counts in cells: of the velocities (Boltzmann's -H) and
// of the positions.
#pragma once

#include <Eigen/Core>

#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/theory/kinds.h"
#include "stats/cell_averages.h"

namespace carom {

/// -sum p ln p, averaged over the particles of finite mass, where p is the share of a kind's
/// particles in a velocity cell; dimensionless. It is 0 when all particles of a kind move alike,
/// and rises to the value that the same counting gives in equilibrium (in_equilibrium()). Kinds are
/// those of kinds_of(): the species does not matter.
class VelocityEntropy {
  public:
    /// The cells are of equal size in units of the thermal velocity sqrt(T / m), at the temperature
    /// of `start`, which must be above 0. Velocity components beyond four thermal velocities fall
    /// into the outermost cells.
    VelocityEntropy(const Particles& particles, const ThermalMotion& start);

    /// The entropy of these velocities, N x dimension.
    double of(const Eigen::ArrayXXd& velocity) const;

    /// The mean entropy of velocities distributed uniformly over the energy sphere, in `dimension`
    /// dimensions: the equilibrium value that counting in cells gives for this number of particles.
    double in_equilibrium(int dimension) const;

  private:
    int cell_of(double u) const;

    Kinds kinds_;
    double degrees_of_freedom_;
    Eigen::ArrayXd scale_;  ///< 1 / thermal velocity; 0 for infinite masses
    int cells_per_axis_;
};

/// -sum p ln p, where p is the share of the particles of finite mass that are in a cell of the box;
/// dimensionless. Particles that spread over a K times larger area gain ln K.
class PositionEntropy {
  public:
    /// `along_longer`: the number of cells along the longer side; if empty, the even number that
    /// leaves about five particles in each cell.
    PositionEntropy(const Box& box, const Particles& particles, std::optional<int> along_longer);

    /// The entropy of these positions, N x dimension. Positions beyond sides that have moved count
    /// in the outermost cells.
    double of(const Eigen::ArrayXXd& position) const;

    /// The mean entropy of points distributed uniformly over the whole box: the value below
    /// ln(cells) that counting a finite number of points gives. Computed exactly, as a sum over the
    /// binomial distribution.
    double of_even_spread() const;

    const Cells& cells() const { return cells_; }

  private:
    Cells cells_;
    Eigen::ArrayXd counted_;  ///< 1 for finite masses
};

}  // namespace carom

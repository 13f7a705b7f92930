// The entropy per particle of the velocities of a gas (Boltzmann's -H), from counts in cells, and
// its mean in equilibrium.
#pragma once

#include <Eigen/Core>

#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/theory/boxed_gas.h"
#include "physics/theory/kinds.h"

namespace carom {

/// -sum p ln p, averaged over the particles of finite mass, where p is the share of a kind's
/// particles in a velocity cell; dimensionless. It is 0 when all particles of a kind move alike,
/// and rises to the value that the same counting gives in equilibrium (equilibrium_entropy()).
/// Kinds are those of kinds_of(): the species does not matter.
class VelocityEntropy {
  public:
    /// The cells are of equal size in units of the thermal velocity sqrt(T / m), at the temperature
    /// of `start`, which must be above 0; in space they are larger than in a plane, so that there
    /// are about as many. Velocity components beyond four thermal velocities fall into the
    /// outermost cells.
    VelocityEntropy(const Particles& particles, const ThermalMotion& start);

    /// The entropy of these velocities, N x dimension.
    double of(const Eigen::ArrayXXd& velocity) const;

  private:
    int cells_along_axis(Eigen::Index dimension) const;

    Kinds kinds_;
    Eigen::ArrayXd scale_;  ///< 1 / thermal velocity; 0 for infinite masses
    double most_ = 0.0;     ///< particles of one kind
};

struct SampledMean {
    double mean = 0.0;
    double error = 0.0;  ///< standard error
};

/// The mean of VelocityEntropy in the equilibrium of a gas that has one: over samples of momenta
/// that are uniformly distributed on the sphere of its energy, without momentum along the axes
/// where it is conserved. As many samples as make the error 4e-4, so that three digits are right,
/// or as take about a tenth of a second. The same gas gives the same number.
SampledMean equilibrium_entropy(const BoxedGas& gas);

}  // namespace carom

// Where a particle of an ideal gas is in gravity, for any number of particles that share a fixed
// energy: the barometric law, and what remains of it when they are few.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/simulation.h"
#include "stats/cell_averages.h"

namespace carom {

/// Particles of one kind, between the lowest and the highest place that they reach.
struct FallingKind {
    double mass = 1.0, count = 1.0;
    double height = 1.0;
};

/// The density of a particle at a height is proportional to the volume of phase space that is left
/// to all others, which is found at the saddle point of its Laplace transform: in a column without
/// a lid that is exact for any number, (1 - m g h / E)^(d N / 2 + N - 2) (Velasco, Roman and White
/// 1996), under a lid it errs in the second order of 1/N. For many particles it is exp(-m g h / T).
class BarometricLaw {
  public:
    /// `freedoms`: d N of the kinetic energy, less those of conserved momenta. `energy`: of all,
    /// kinetic and potential, above that of all at rest in their lowest places. `kind`: which one.
    BarometricLaw(double freedoms, double energy, double gravity,
                  const std::vector<FallingKind>& kinds, std::size_t kind);

    /// The probability to be below a height.
    double share_below(double height) const;

  private:
    double step_;                ///< of heights
    std::vector<double> below_;  ///< the probability to be below each
};

/// Of each group of particles, in each of the slabs along an axis that gravity acts along, for an
/// ideal gas with the energy of a sample. Empty where it has none: with infinite masses, fewer than
/// three degrees of freedom or more than twenty kinds of particles.
std::vector<std::vector<double>> barometric_densities(
    const Box& box, const Particles& particles, const Sample& start, int axis, const Cells& slabs,
    const std::vector<std::vector<Eigen::Index>>& groups);

}  // namespace carom

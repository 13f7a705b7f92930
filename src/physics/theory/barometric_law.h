// The height distribution of a particle of an ideal gas in gravity, for any number of particles
// that share a fixed total energy: the barometric law and its corrections for few particles.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "physics/theory/boxed_gas.h"

namespace carom {

/// Particles of one kind, and the distance between the lowest and the highest position that their
/// centres can reach.
struct FallingKind {
    double mass = 1.0, count = 1.0;
    double height = 1.0;
};

/// The probability density of a particle's height is proportional to the phase-space volume left to
/// all other particles, which is evaluated at the saddle point of its Laplace transform. In a
/// column without a lid this is exact for any number of particles,
/// (1 - m g h / E)^(f / 2 + N - 2) with f degrees of freedom of the kinetic energy, d N less one
/// for each conserved momentum (Velasco, Roman and White 1996). Under a lid the error is of second
/// order in 1/N. For many particles the density becomes exp(-m g h / T).
class BarometricLaw {
  public:
    /// `freedoms`: the degrees of freedom of the kinetic energy, d N less one for each conserved
    /// momentum. `energy`: the total kinetic and potential energy, measured from the state with all
    /// particles at rest in their lowest positions. `kind`: index in `kinds` of the particle that
    /// the law is for.
    BarometricLaw(double freedoms, double energy, double gravity,
                  const std::vector<FallingKind>& kinds, std::size_t kind);

    /// The probability that the particle is below `height`, measured from the lowest position of
    /// its kind.
    double share_below(double height) const;

  private:
    double step_;                ///< between tabulated heights
    std::vector<double> below_;  ///< the probability to be below each tabulated height
};

/// More kinds than this have no law: the volumes of phase space would take too long.
inline constexpr std::size_t most_falling_kinds = 20;

/// The number of kinds of particles of a gas by mass and by how far they can fall along an axis; no
/// more than one above most_falling_kinds.
std::size_t falling_kinds(const BoxedGas& gas, int axis);

/// The expected density of some particles of an ideal gas in each of `slabs` slabs side by side
/// along `axis`, along which gravity acts; number of particles per area or volume. Only where law()
/// has one (LawOf::heights).
std::vector<double> barometric_densities(const BoxedGas& gas, int axis, int slabs,
                                         const std::vector<Eigen::Index>& members);

}  // namespace carom

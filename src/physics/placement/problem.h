// The reasons why a gas cannot be placed, or cannot move once placed: as values and in words.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "physics/surfaces/surface_problem.h"

namespace carom {

struct Gas;

/// A single problem. Which of its numbers are used depends on the kind. Particles are counted over
/// all species; -1 means none.
struct Problem {
    enum class Kind {
        too_many,        ///< `count` particles up to this species, more than `bound`
        not_positive,    ///< the distribution of its `quantity` gives `value`
        no_mass,         ///< a point particle whose mass would follow from a density
        no_temperature,  ///< no particle moves that could be scaled to temperature `value`
        momentum,        ///< the momenta of the `count` particles with a speed cannot sum to
                         ///< zero: the largest, of `particle`, is `value`, all others together
                         ///< have `bound`
        too_large,       ///< radius `value` is too large for the box
        too_dense,       ///< all particles cover the fraction `value` of the box
        saturated,       ///< spheres at random places fill the fraction `value` of the box, or of
                         ///< the region of the species: more than random placement reaches
        region_outside,  ///< the region of the species extends outside the box
        region_too_narrow,  ///< the region is too narrow for a particle of radius `value`
        region_too_dense,   ///< the species covers the fraction `value` of its region
        no_lattice,         ///< no lattice holds `count` particles of radius up to `value`, only
                            ///< `fitting`
        lattice_taken,      ///< particles placed before leave only `fitting` sites for `count`
        outside,            ///< `particle` of radius `value` lies outside the box
        overlap,            ///< `particle` and `other` are `value` apart but need at least `bound`
        in_surface,         ///< `particle` overlaps surface `other` (physics/surface.h)
        same_place,         ///< `particle` and `other` are two points at the same place on a line
        no_place,    ///< random placement found room for only `fitting`; they cover the fraction
                     ///< `value`
        no_stretch,  ///< no stretch of a line fits `count` beads of total length `value`; `bound`
                     ///< is free, at most `widest` in one piece; `particle` is set if all are of
                     ///< one species
        jam,         ///< `particle` moves along a row without room (jam.h)
        jam_alone,   ///< `particle` is the whole row
        squeeze,     ///< at time `value` the room between `particle` and `other` vanishes
                     ///< (line_squeeze.h)
    };
    Kind kind{};
    std::size_t species = 0;  ///< index into Gas::species
    Eigen::Index particle = -1, other = -1;
    std::int64_t count = 0, fitting = 0;
    double value = 0.0, bound = 0.0, widest = 0.0;
    std::string_view quantity = {};
};

/// The message and hint of a problem. `region`: the name of the part of the box in which a species
/// is to be placed.
ProblemText to_text(const Problem& problem, const Gas& gas, std::string_view region = "its region");

/// Thrown if a gas cannot be placed or cannot move; what() is the problem's message and hint.
class PlacementError : public std::runtime_error {
  public:
    PlacementError(const Problem& problem, const Gas& gas);
    const Problem& problem() const { return problem_; }
    std::size_t species() const { return problem_.species; }  ///< index into Gas::species

  private:
    Problem problem_;
};

/// The densest packing of equal particles: 1 on a line; in the plane that of a hexagonal lattice,
/// pi / sqrt(12) (Thue 1892, Fejes Toth 1940); in space that of a face-centred cubic lattice, pi /
/// sqrt(18) (Hales, Annals of Mathematics 162, 1065, 2005). Mixtures can be denser with small ones
/// in the gaps, but not when placed at random.
double densest_packing(int dimension);

/// The packing at which the random placement of equal spheres ends in a large box (Zhang and
/// Torquato, Phys. Rev. E 88, 053312, 2013: 0.3841307(21)).
inline constexpr double saturated_packing = 0.3841;

/// A packing at which particles find random places quickly, in the plane or in space: that of the
/// boxes and numbers which hints name.
constexpr double roomy_packing(int dimension) { return dimension == 2 ? 0.5 : 0.3; }

}  // namespace carom

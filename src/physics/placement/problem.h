// Why a gas cannot be placed, or cannot move once it is: as values, and what they say in words.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "physics/gas.h"
#include "physics/surfaces/surface_problem.h"

namespace carom {

/// One thing that cannot be. Which numbers have a meaning depends on the kind; particles are
/// counted over all species, and -1 is none.
struct Problem {
    enum class Kind {
        too_many,           ///< `count` particles up to this species, more than `bound`
        not_positive,       ///< the distribution of its `quantity` gives `value`
        no_mass,            ///< a point whose mass would follow from a density
        no_temperature,     ///< nothing moves that could be brought to temperature `value`
        too_large,          ///< radius `value`, for the box
        too_dense,          ///< all particles cover the part `value` of the box
        region_outside,     ///< the species' region reaches outside the box
        region_too_narrow,  ///< for a disk of radius `value`
        region_too_dense,   ///< the species covers the part `value` of its region
        no_lattice,         ///< holds `count` disks of radius up to `value`, but `fitting`
        lattice_taken,      ///< disks placed before leave `fitting` sites for `count` disks
        outside,            ///< `particle` of radius `value`
        overlap,            ///< of `particle` and `other`, `value` apart, at least `bound` needed
        in_surface,         ///< `particle`, with surface `other` (physics/surface.h)
        same_place,         ///< of `particle` and `other`, two points on a line
        no_place,           ///< random: for more than `fitting`; they cover the part `value`
        no_stretch,         ///< of a line for `count` beads, `value` long; free are `bound`, at
                            ///< most `widest` in one piece; `particle` if all are one species
        jam,                ///< `particle` moves along a row without room (jam.h)
        jam_alone,          ///< `particle` is the whole row
        squeeze,            ///< at time `value`, between `particle` and `other` (line_squeeze.h)
    };
    Kind kind{};
    std::size_t species = 0;  ///< index into Gas::species
    Eigen::Index particle = -1, other = -1;
    std::int64_t count = 0, fitting = 0;
    double value = 0.0, bound = 0.0, widest = 0.0;
    std::string_view quantity = {};
};

/// `region`: how the part of the box is called in which a species is to be.
ProblemText to_text(const Problem& problem, const Gas& gas, std::string_view region = "its region");

/// A gas cannot be placed or cannot move; the text is the problem's message and hint.
class PlacementError : public std::runtime_error {
  public:
    PlacementError(const Problem& problem, const Gas& gas);
    const Problem& problem() const { return problem_; }
    std::size_t species() const { return problem_.species; }  ///< index into Gas::species

  private:
    Problem problem_;
};

/// The densest packing of equal disks in a plane, hexagonal: pi / sqrt(12) (Thue 1892, Fejes Toth
/// 1940). Mixtures can be denser with small ones in the gaps, but not when placed at random.
extern const double densest_packing;

}  // namespace carom

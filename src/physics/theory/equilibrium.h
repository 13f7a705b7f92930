// Reasons why no equilibrium of a gas is known in theory. The equilibrium itself is described in
// theory.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "physics/gas.h"

namespace carom {

/// The reason why no equilibrium of a gas is known.
struct NoEquilibrium {
    enum class Why {
        surfaces,              ///< sides that act, partitions, obstacles or gravity
        moving_infinite_mass,  ///< an infinite mass of `species` moves: energy is not conserved
        momentum_along_x,      ///< momentum is conserved along x but not along y
        momentum_along_y,
        no_finite_mass,
        alone,             ///< a single particle of finite mass
        pair,              ///< two particles whose momentum is conserved
        at_rest,           ///< no energy
        drifts,            ///< momentum is conserved and not zero
        points,            ///< points in a plane never meet
        equal_masses,      ///< equal masses on a line only exchange velocities
        few_between_ends,  ///< two beads between walls, or three on a ring, move like a
        few_on_ring,       ///< point in a triangle (Glashow and Mittag 1997), which need not come
                           ///< near all its states
        parted,            ///< on a line, beads that never move separate those that do
    };
    Why why{};
    std::size_t species = 0;
};

/// Why a gas has no known equilibrium, before its particles are placed: the particles are drawn,
/// and positions that are not listed are assumed to allow an equilibrium. Returns nothing if there
/// is one, or if the gas cannot be drawn.
std::optional<NoEquilibrium> why_no_equilibrium(const Gas& gas);

/// The reason in words, as the end of a sentence.
std::string to_text(const NoEquilibrium& reason, const Gas& gas);

}  // namespace carom

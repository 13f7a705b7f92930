// Why theory knows no equilibrium of a gas. What an equilibrium looks like is in theory.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "physics/gas.h"

namespace carom {

/// Why a gas has no equilibrium that is known.
struct NoEquilibrium {
    enum class Why {
        surfaces,              ///< act, or stand in the box, or it has gravity
        moving_infinite_mass,  ///< of `species`: energy is not conserved
        momentum_along_x,      ///< is conserved, and not along y
        momentum_along_y,
        no_finite_mass,
        alone,             ///< one particle of finite mass
        pair,              ///< two whose momentum is conserved
        at_rest,           ///< no energy
        drifts,            ///< momentum is conserved, and not zero
        points,            ///< of a plane never meet
        equal_masses,      ///< on a line: velocities only change hands
        few_between_ends,  ///< of a line: two beads between walls or three on a ring move as a
        few_on_ring,       ///< point in a triangle (Glashow and Mittag 1997), which need not come
                           ///< near all its states
        parted,            ///< on a line beads that never move part those that do
    };
    Why why{};
    std::size_t species = 0;
};

/// Why a gas has no equilibrium, before it is placed: its particles are drawn, and places that are
/// not listed are taken to allow it. Nothing where it has one, and of a gas that cannot be drawn.
std::optional<NoEquilibrium> why_no_equilibrium(const Gas& gas);

/// It in words, as the end of a sentence.
std::string to_text(const NoEquilibrium& reason, const Gas& gas);

}  // namespace carom

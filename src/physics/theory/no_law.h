// Reasons why theory gives nothing for a quantity of a gas, in words for the user.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "physics/box.h"
#include "util/language.h"

namespace carom {

struct Species;

/// The reason why there is no law for a quantity of a gas.
struct NoLaw {
    enum class Why {
        unknown_gas,  ///< a picture without a gas
        // Something acts.
        bath,
        baths_differ,  ///< heat baths of several temperatures
        driven,        ///< a wall moves at a prescribed velocity
        piston,        ///< a free wall takes part in the energy
        membrane,
        diffuse,  ///< a wall reflects diffusely, whatever the direction before
        partitions,
        obstacles,
        gravity,
        event,                 ///< an event of the run changes walls, energy or velocities
        reversal,              ///< an event of the run changes velocities
        moving_infinite_mass,  ///< one of `species`: energy is not conserved
        fixed_particles,       ///< infinite masses at rest are in the way
        // Too few particles, or too little motion.
        no_finite_mass,
        alone,       ///< a single particle of finite mass
        keeps_axes,  ///< it keeps the energy of its motion along each axis
        unhindered,  ///< a single particle with nothing to collide with
        pair,        ///< two particles whose momentum is conserved
        pair_only,   ///< two particles, of which each has only the other to collide with
        few,         ///< too few for an approximation whose error is of order 1/N
        many,        ///< the law is for a single particle
        at_rest,     ///< no energy
        no_freedom,  ///< a single particle whose momentum is conserved
        drifts,      ///< momentum is conserved and not zero
        points,      ///< points never meet, except on a line
        // Lines.
        line,              ///< the law is for a plane or for space
        equal_masses,      ///< equal masses on a line only exchange velocities
        few_between_ends,  ///< two beads between walls, or three on a ring, move like a
        few_on_ring,       ///< point in a triangle (Glashow and Mittag 1997), which need not come
                           ///< near all its states
        parted,            ///< on a line, beads that never move separate those that do
        keeps_order,       ///< on a line, beads cannot pass one another
        unknown_order,     ///< on a line, the order of beads that are not placed yet
        rods,              ///< the law is for points on a line
        no_room,           ///< beads that fill their line, or particles that fill their box
        // A formula that holds for other boxes or particles only.
        plane_only,    ///< the law is for a plane
        remembers,     ///< in a plane velocities are remembered for too long
        one_axis,      ///< momentum is conserved along some axes only
        bounded,       ///< walls bound all displacements
        bounded_once,  ///< walls bound displacements along some axes
        unequal_masses,
        unequal_radii,
        dense,          ///< denser than the theory of dilute gases allows
        freezes,        ///< so dense that particles freeze
        no_such_phase,  ///< at this packing, or of such a gas, the phase is not stable or not known
        near_freezing,  ///< denser than what a fit was made to
        no_cube,        ///< a box with unequal sides
        off_center,     ///< a partition that is not in the middle
        regions,        ///< parts of the box that are not halves of it
        passes,         ///< particles pass from one part of the box to another
        part_of_line,
        near_wall,
        no_walls,
        no_gap,
        wide_gap,
        no_bath,
        no_piston,
        pistons,   ///< several
        no_force,  ///< nothing holds the piston on the gas
        no_gravity,
        no_floor,    ///< a periodic axis along gravity
        many_kinds,  ///< of masses and radii
        flies_on,    ///< walls that do not end a flight
        shapes,      ///< obstacles of which no mean path is known
        no_board,    ///< obstacles that are not the pegs of a Galton board
        // Not yet.
        no_collisions,   ///< nothing has collided yet
        few_collisions,  ///< too few collisions for diffusion or equilibrium
    };
    Why why{};
    std::size_t species = 0;
    bool operator==(const NoLaw&) const = default;
};
inline constexpr std::size_t reasons_count =
    static_cast<std::size_t>(NoLaw::Why::few_collisions) + 1;

/// The reason in words, as the end of a sentence. `species`: those of the gas, which may be named.
std::string to_text(Language language, const NoLaw& reason, const std::vector<Species>& species);

}  // namespace carom

// Why a box cannot have a surface, or an event of a run cannot happen to it: as values, and what
// they say in words. The one place where that is decided.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/run.h"
#include "physics/surface.h"

namespace carom {

/// What is wrong, in one sentence without a full stop, and a way out.
struct ProblemText {
    std::string message, hint;
};

/// One thing that cannot be.
struct SurfaceProblem {
    enum class Kind {
        not_finite,         ///< a number of this surface; of gravity where there is none
        no_wall,            ///< a side that acts, or is to act, in a periodic box
        along_periodic,     ///< a partition that moves along an axis on which the box is periodic
        partition_outside,  ///< not between the walls
        gap_outside,        ///< gap `item`
        gaps_unordered,     ///< gap `item` begins before the one before ends, or ends as it begins
        piston_gaps,        ///< a piston with holes
        obstacle_outside,   ///< no part of it lies in the box
        obstacle_too_wide,  ///< for a periodic box: it would overlap its own image
        same_corner,        ///< corner `item` is where the next is
        not_on_line,        ///< a partition or an obstacle, or a side that a line does not have
        no_surface,         ///< the event's surface is not there
        not_a_partition,    ///< what is to open or to close
        open_piston,        ///< a piston that is open and not held: nothing would stop it
        not_movable,        ///< an obstacle that is to move or to act
        no_piston,          ///< what is to be held or released
        not_held,           ///< a piston that is to be released
        reaches,            ///< surface `other` at time `value`, moving at a given velocity
        leaves_no_room,     ///< for the disks at time `value`, where `room` is left
        forgets_heat,       ///< velocities are reversed after this heat bath has acted
        forgets_passing,    ///< or after this demon
    };
    Kind kind{};
    std::int32_t surface = -1;              ///< its number (surface.h)
    std::size_t item = 0;                   ///< of its gaps or corners
    std::optional<std::size_t> event = {};  ///< index into Run::events
    std::int32_t other = -1;
    double value = 0.0, room = 0.0;
};

/// Whether a reversal cannot undo what the surface does.
bool loses_memory(const Behaviour& behaviour);

/// What is wrong with the surfaces of a box, and with what the events of a run do to them. Where
/// the `area` of all disks is known, also when driven walls would leave them no room.
std::vector<SurfaceProblem> surface_problems(const Box& box, const Run& run, double area = 0.0);

ProblemText to_text(const SurfaceProblem& problem, const Box& box);

}  // namespace carom

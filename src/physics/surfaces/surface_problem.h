// The reasons why a box cannot have a surface, or why an event of a run cannot happen to it: as
// values and in words. This is the only place where that is decided.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/box.h"
#include "physics/run.h"
#include "physics/surface.h"

namespace carom {

/// A problem in words: one sentence without a full stop, and a suggestion.
struct ProblemText {
    std::string message, hint;
};

/// A single problem.
struct SurfaceProblem {
    enum class Kind {
        not_finite,         ///< a number of this surface is not finite; without a surface, gravity
        no_wall,            ///< a side acts, or is to act, on a periodic axis
        along_periodic,     ///< a partition moves along an axis on which the box is periodic
        partition_outside,  ///< a partition is not between the walls
        no_axis,            ///< a partition is perpendicular to an axis that the box does not have
        gap_outside,        ///< gap `item` is outside
        gaps_unordered,     ///< in the plane: gap `item` begins before the one before ends, or ends
                            ///< as it begins
        gap_empty,          ///< in space: gap `item` has no extent along one of its axes
        gaps_overlap,       ///< in space: gap `item` overlaps gap `other`
        piston_gaps,        ///< a piston has gaps
        obstacle_outside,   ///< no part of the obstacle lies in the box
        obstacle_too_wide,  ///< too wide for a periodic box: it would overlap its own image
        same_corner,        ///< corner `item` coincides with the next
        cuboid_empty,       ///< a cuboid has no extent along one of its axes
        not_in_space,       ///< an obstacle of lines, in space
        not_in_plane,       ///< a cuboid, in a plane
        not_on_line,    ///< a line cannot have it: a partition, an obstacle, the bottom or the top
        no_directions,  ///< a side of a line reflects diffusely
        no_surface,     ///< the surface of the event does not exist
        not_a_partition,  ///< only partitions can be opened or closed
        open_piston,      ///< a piston is open and not held: nothing would stop it
        not_movable,      ///< an obstacle cannot move or act
        no_piston,        ///< only pistons can be held or released
        not_held,         ///< the piston to be released is not held
        reaches,         ///< it reaches surface `other` at time `value`, moving at a given velocity
        leaves_no_room,  ///< it leaves the particles no room at time `value`, when `room` is left
        forgets_heat,    ///< velocities are reversed after this heat bath has acted
        forgets_passing,    ///< velocities are reversed after this demon has acted
        forgets_direction,  ///< velocities are reversed after this diffuse wall has acted
    };
    Kind kind{};
    std::int32_t surface = -1;              ///< its number (surface.h)
    std::size_t item = 0;                   ///< index of the gap or corner
    std::optional<std::size_t> event = {};  ///< index into Run::events
    std::int32_t other = -1;  ///< the number of another surface, or the index of another gap
    double value = 0.0, room = 0.0;
};

/// All problems of the surfaces of a box and of the events of a run that act on them. If `content`,
/// the area or the volume of all particles, is known, also whether driven walls would leave the
/// particles no room.
std::vector<SurfaceProblem> surface_problems(const Box& box, const Run& run, double content = 0.0);

ProblemText to_text(const SurfaceProblem& problem, const Box& box);

}  // namespace carom

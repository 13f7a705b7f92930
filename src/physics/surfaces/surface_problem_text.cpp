// The problems of surfaces in words.
#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "physics/surfaces/surface_error.h"
#include "physics/surfaces/surface_problem.h"

namespace carom {
namespace {

using Kind = SurfaceProblem::Kind;

// How it acts, in words, of what a reversal cannot undo.
const char* word_of_forgetful(Kind kind) {
    return kind == Kind::forgets_heat      ? "heat bath"
           : kind == Kind::forgets_passing ? "demon"
                                           : "diffuse wall";
}

std::string range_text(double size) { return fmt::format("0 to {}", size); }

// A gap, and where the gaps of a partition may lie.
std::string gap_text(const Gap& gap, const Box& box) {
    if (box.dimension < 3) return fmt::format("the gap from {} to {}", gap.from(), gap.to());
    return fmt::format("the gap from ({}, {}) to ({}, {})", gap.low[0], gap.low[1], gap.high[0],
                       gap.high[1]);
}

std::string room_of_gaps(const Partition& partition, const Box& box) {
    if (box.dimension < 3) {
        const int along = 1 - partition.axis;
        return fmt::format("{} = 0 and {}", name_of_axis(along), box.length(along));
    }
    const auto along = other_axes(static_cast<std::size_t>(partition.axis));
    return fmt::format("{} = 0 and {}, and between {} = 0 and {}", name_of_axis(along[0]),
                       box.length(along[0]), name_of_axis(along[1]), box.length(along[1]));
}

ProblemText of_partition(const SurfaceProblem& p, const std::string& name, const Box& box) {
    const Partition& line = *box.surfaces.partition(p.surface);
    const auto gap = [&](std::size_t k) { return gap_text(line.gaps[k], box); };
    switch (p.kind) {
        case Kind::no_axis:
            return {fmt::format("{} is perpendicular to an axis that the box does not have", name),
                    box.dimension == 3 ? "the axes of space are x, y and z"
                                       : "the axes of a plane are x and y"};
        case Kind::partition_outside:
            return {fmt::format("{} at {} = {} is not in the box", name, name_of_axis(line.axis),
                                line.at),
                    fmt::format("the box goes from {}", range_text(box.length(line.axis)))};
        case Kind::gap_empty:
            return {gap(p.item) + " ends where it begins, or before",
                    "give the lower corner of a gap first"};
        case Kind::gaps_overlap:
            return {
                fmt::format("{} overlaps {}", gap(p.item), gap(static_cast<std::size_t>(p.other))),
                "make them smaller, or let them touch: gaps that touch are one opening"};
        case Kind::gap_outside:
            return {gap(p.item) + " is not in the box",
                    fmt::format("gaps of {} lie between {}", name, room_of_gaps(line, box))};
        case Kind::gaps_unordered:
            if (line.gaps[p.item].from() >= line.gaps[p.item].to())
                return {gap(p.item) + " ends where it begins, or before",
                        "give gaps as [from, to], the smaller first"};
            return {gap(p.item) + " begins before the end of the one before",
                    "give gaps as [from, to] in rising order, without overlap"};
        case Kind::piston_gaps:
            return {fmt::format("{} is a piston, which has no gaps", name),
                    "leave out `gaps`, or the mass"};
        default:
            return {fmt::format("{} cannot move across periodic sides", name),
                    fmt::format("make the box solid along {}", name_of_axis(line.axis))};
    }
}

}  // namespace

ProblemText to_text(const SurfaceProblem& p, const Box& box) {
    const std::vector<std::string> names = box.surfaces.names();
    const bool is_there = p.surface >= 0 && p.surface < std::ssize(names);
    const std::string name = is_there ? "`" + names[static_cast<std::size_t>(p.surface)] + "`" : "";
    switch (p.kind) {
        case Kind::not_finite:
            return {fmt::format("a number of {} is not finite, or not positive where it must be",
                                is_there ? name : "gravity"),
                    "give a number, for instance 1"};
        case Kind::no_wall:
            return {fmt::format("{} is periodic: there is no wall", name),
                    "make it and the opposite side solid"};
        case Kind::along_periodic:
        case Kind::partition_outside:
        case Kind::no_axis:
        case Kind::gap_outside:
        case Kind::gaps_unordered:
        case Kind::gap_empty:
        case Kind::gaps_overlap:
        case Kind::piston_gaps:
            return of_partition(p, name, box);
        case Kind::obstacle_outside:
            return {fmt::format("{} lies outside the box", name),
                    fmt::format("the box goes from x = {} and from y = {}", range_text(box.size[0]),
                                range_text(box.size[1])) +
                        (box.dimension == 3 ? " and from z = " + range_text(box.size[2]) : "")};
        case Kind::obstacle_too_wide:
            return {
                fmt::format("{} is wider than the periodic box, and would overlap itself", name),
                "make it smaller, or the box solid"};
        case Kind::same_corner:
            return {fmt::format("two successive corners of {} coincide", name),
                    "leave one of them out"};
        case Kind::cuboid_empty:
            return {fmt::format("{} ends where it begins along an axis, or before", name),
                    "give the lower corner of a cuboid first"};
        case Kind::not_in_space:
            return {fmt::format("{} consists of lines, which have no meaning in space", name),
                    "give a sphere or a cuboid"};
        case Kind::not_in_plane:
            return {fmt::format("{} is a cuboid, which has no meaning in a plane", name),
                    "give a disk, a rectangle, a polygon or a segment"};
        case Kind::not_on_line:
            return {fmt::format("{} has no meaning on a line", name),
                    "a line has a left and a right end, and gravity along it"};
        case Kind::no_directions:
            return {fmt::format("{} cannot be `diffuse` on a line, which has only one direction "
                                "to leave it in",
                                name),
                    "make it `solid`"};
        case Kind::no_surface:
            return {fmt::format("there is no surface {}", p.surface),
                    fmt::format("surfaces are numbered from 0 to {}", names.size() - 1)};
        case Kind::not_a_partition:
            return {fmt::format("{} does not open: only partitions do", name),
                    "give the name of a partition"};
        case Kind::open_piston:
            return {fmt::format("{} is a piston, and if it were open it would leave the box", name),
                    p.event ? "`hold` it before it opens, or make it `solid` by a `wall` event"
                            : "leave out `open`, or its mass"};
        case Kind::not_movable:
            return {fmt::format("{} is an obstacle, which stands still", name),
                    "give a side of the box or a partition"};
        case Kind::no_piston:
            return {fmt::format("{} is no piston at this time", name),
                    "a piston is a side or a partition with a mass"};
        case Kind::not_held:
            return {fmt::format("{} is not held at this time", name),
                    "`hold` it before, or leave this out"};
        case Kind::reaches:
            return {fmt::format("{} reaches `{}` at time {:.4g}", name,
                                names.at(static_cast<std::size_t>(p.other)), p.value),
                    how_to_stop};
        case Kind::leaves_no_room:
            return {fmt::format("{} crushes the gas at time {:.4g}, when there are {:.3g} left "
                                "between the walls",
                                name, p.value, p.room),
                    how_to_stop};
        case Kind::forgets_heat:
        case Kind::forgets_passing:
        case Kind::forgets_direction:
            return {
                fmt::format("{} acts as a {} before the reversal, which cannot undo what it did",
                            name, word_of_forgetful(p.kind)),
                fmt::format("leave out the reversal, or let {} act otherwise before it", name)};
    }
    return {};
}

}  // namespace carom

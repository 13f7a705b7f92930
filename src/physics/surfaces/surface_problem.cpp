#include "physics/surfaces/surface_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/surfaces/barrier.h"
#include "physics/surfaces/behaviours.h"
#include "physics/surfaces/driven_path.h"
#include "physics/surfaces/surface_error.h"
#include "util/overloaded.h"

namespace carom {
namespace {

using Kind = SurfaceProblem::Kind;

bool is_finite(const Behaviour& behaviour) {
    const auto finite = [](auto... values) { return (std::isfinite(values) && ...); };
    return std::visit(
        Overloaded{
            [](const Reflecting&) { return true; },
            [&](const Bath& bath) { return bath.temperature > 0.0 && finite(bath.temperature); },
            [&](const Driven& driven) { return finite(driven.velocity) && driven.until >= 0.0; },
            [&](const Piston& piston) {
                return piston.mass > 0.0 && finite(piston.mass, piston.force, piston.velocity);
            },
            [](const Membrane&) { return true; }, [](const Diffuse&) { return true; }},
        behaviour);
}

// The reason why a reversal cannot undo what it does, if it acts irreversibly.
std::optional<Kind> lost_memory(const Behaviour& behaviour) {
    using Lost = std::optional<Kind>;
    return std::visit(
        Overloaded{[](const Reflecting&) { return Lost(); },
                   [](const Bath&) { return Lost(Kind::forgets_heat); },
                   [](const Driven&) { return Lost(); }, [](const Piston&) { return Lost(); },
                   [](const Membrane& membrane) {
                       return membrane.is_demon() ? Lost(Kind::forgets_passing) : Lost();
                   },
                   [](const Diffuse&) { return Lost(Kind::forgets_direction); }},
        behaviour);
}

bool is_finite(const Obstacle& obstacle) {
    if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape))
        return is_finite(disk->center) && disk->radius >= 0.0 && std::isfinite(disk->radius);
    const auto& [corners, is_closed] = std::get<Obstacle::Lines>(obstacle.shape);
    return corners.size() >= (is_closed ? 3U : 2U) &&
           std::ranges::all_of(corners, [](const Vec& one) { return is_finite(one); });
}

// The smallest and the largest coordinates of an obstacle.
std::pair<Vec, Vec> extent_of(const Obstacle& obstacle) {
    if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape))
        return {disk->center - Vec(disk->radius, disk->radius),
                disk->center + Vec(disk->radius, disk->radius)};
    const auto& corners = std::get<Obstacle::Lines>(obstacle.shape).corners;
    Vec low = corners.front(), high = low;
    for (const Vec& corner : corners) {
        low = lower(low, corner);
        high = upper(high, corner);
    }
    return {low, high};
}

// Whether it means something on a line.
bool acts_on_line(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return true; }, [](const Bath&) { return true; },
                   [](const Driven&) { return true; }, [](const Piston&) { return true; },
                   [](const Membrane&) { return true; }, [](const Diffuse&) { return false; }},
        behaviour);
}

// How it acts, in words, of what a reversal cannot undo.
const char* word_of_forgetful(Kind kind) {
    return kind == Kind::forgets_heat      ? "heat bath"
           : kind == Kind::forgets_passing ? "demon"
                                           : "diffuse wall";
}

class Search {
  public:
    explicit Search(const Box& box) : box_(box), surfaces_(box.surfaces) {}

    std::vector<SurfaceProblem> found() && { return std::move(found_); }

    void look_at_box() {
        if (!is_finite(surfaces_.gravity)) add(Kind::not_finite, -1);
        for (std::int32_t side = 0; side < 2 * box_.dimension; ++side)
            if (const auto kind =
                    problem_of(side, surfaces_.sides[static_cast<std::size_t>(side)], true))
                add(*kind, side);
        if (box_.dimension == 1) return look_at_line();
        std::int32_t surface = surfaces_.first_partition();
        for (const Partition& partition : surfaces_.partitions)
            look_at_partition(surface++, partition);
        for (const Obstacle& obstacle : surfaces_.obstacles) look_at_obstacle(surface++, obstacle);
    }

    // Checks the effects of the events, one after another; effects of reversals are not considered.
    void look_at_events(const Run& run) {
        std::vector<Behaviour> behaviours = behaviours_of(box_);
        std::vector<bool> held(behaviours.size());
        for (std::size_t k = 0; k < behaviours.size(); ++k)
            remember(static_cast<std::int32_t>(k), behaviours[k]);
        for (event_ = 0; *event_ < run.events.size(); ++*event_) {
            std::visit(
                Overloaded{
                    [&](const ReverseVelocities&) {
                        if (forgetful_) add(forgetful_->kind, forgetful_->surface);
                    },
                    [](const Perturbation&) {},
                    [&](const SetOpen& action) { set_open(action, behaviours, held); },
                    [&](const MoveSurface& action) {
                        change(action.surface, Driven{action.velocity}, behaviours, held);
                    },
                    [&](const HoldPiston& action) { hold(action.surface, true, behaviours, held); },
                    [&](const ReleasePiston& action) {
                        hold(action.surface, false, behaviours, held);
                    },
                    [&](const ChangeSurface& action) {
                        change(action.surface, action.behaviour, behaviours, held);
                    },
                    [](const Heat&) {}},
                run.events[*event_].action);
        }
    }

  private:
    void add(Kind kind, std::int32_t surface, std::size_t item = 0) {
        found_.push_back({.kind = kind, .surface = surface, .item = item, .event = event_});
    }

    void set_open(const SetOpen& event, const std::vector<Behaviour>& behaviours,
                  const std::vector<bool>& held) {
        const auto k = static_cast<std::size_t>(event.surface);
        if (is_there(event.surface) && surfaces_.partition(event.surface) == nullptr)
            add(Kind::not_a_partition, event.surface);
        else if (event.is_open && k < held.size() && piston_of(behaviours[k]) && !held[k])
            add(Kind::open_piston, event.surface);
    }

    // The reason why a side or a partition cannot have this behaviour, at the start or after an
    // event.
    std::optional<Kind> problem_of(std::int32_t surface, const Behaviour& behaviour,
                                   bool from_start) const {
        if (!is_finite(behaviour)) return Kind::not_finite;
        if (box_.dimension == 1 && !acts_on_line(behaviour)) return Kind::no_directions;
        const Partition* partition = surfaces_.partition(surface);
        const bool is_periodic = box_.is_periodic(surfaces_.axis_of(surface));
        if (partition == nullptr) {
            if (is_periodic && !(from_start && only_reflects(behaviour))) return Kind::no_wall;
            return std::nullopt;
        }
        if (moves(behaviour) && is_periodic) return Kind::along_periodic;
        if (piston_of(behaviour) && !partition->gaps.empty()) return Kind::piston_gaps;
        return std::nullopt;
    }

    void look_at_line() {
        const std::vector<Behaviour> behaviours = behaviours_of(box_);
        for (std::size_t k = 0; k < behaviours.size(); ++k)
            if (!box_.has_surface(k) && (!surfaces_.is_side(k) || !only_reflects(behaviours[k])))
                add(Kind::not_on_line, static_cast<std::int32_t>(k));
    }

    void look_at_partition(std::int32_t surface, const Partition& partition) {
        if (partition.axis != 0 && partition.axis != 1) return add(Kind::not_finite, surface);
        if (!(partition.at >= 0.0 && partition.at <= box_.length(partition.axis)))
            return add(Kind::partition_outside, surface);
        double before = 0.0;
        for (std::size_t k = 0; k < partition.gaps.size(); ++k) {
            const double from = partition.gaps[k].from(), to = partition.gaps[k].to();
            if (!(from >= 0.0 && to <= box_.length(1 - partition.axis)))
                return add(Kind::gap_outside, surface, k);
            if (!(from >= before && to > from)) return add(Kind::gaps_unordered, surface, k);
            before = to;
        }
        if (const auto kind = problem_of(surface, partition.behaviour, true)) add(*kind, surface);
        if (partition.is_open && piston_of(partition.behaviour)) add(Kind::open_piston, surface);
    }

    void look_at_obstacle(std::int32_t surface, const Obstacle& obstacle) {
        if (!is_finite(obstacle)) return add(Kind::not_finite, surface);
        const auto [low, high] = extent_of(obstacle);
        const bool is_near = on_each_axis(box_.dimension, [&](int axis) {
            return !(high[axis] < 0.0) && !(low[axis] > box_.size[axis]);
        });
        if (!is_near) return add(Kind::obstacle_outside, surface);
        for (const int axis : {0, 1})
            if (box_.is_periodic(axis) && high[axis] - low[axis] > box_.length(axis))
                return add(Kind::obstacle_too_wide, surface);
        const auto* lines = std::get_if<Obstacle::Lines>(&obstacle.shape);
        const std::size_t count = lines != nullptr ? lines->corners.size() : 0;
        for (std::size_t k = 0; k < count; ++k)
            if ((k + 1 < count || lines->is_closed) &&
                lines->corners[k] == lines->corners[(k + 1) % count])
                return add(Kind::same_corner, surface, k);
    }

    bool is_there(std::int32_t surface) {
        const bool is = surface >= 0 && surface < surfaces_.count() && box_.has_surface(surface);
        if (!is) add(Kind::no_surface, surface);
        return is;
    }

    void change(std::int32_t surface, const Behaviour& behaviour,
                std::vector<Behaviour>& behaviours, std::vector<bool>& held) {
        if (!is_there(surface)) return;
        if (surface >= surfaces_.first_obstacle()) return add(Kind::not_movable, surface);
        if (const auto kind = problem_of(surface, behaviour, false)) return add(*kind, surface);
        behaviours[static_cast<std::size_t>(surface)] = behaviour;
        held[static_cast<std::size_t>(surface)] = false;
        remember(surface, behaviour);
    }

    // Remembers the first surface that acts irreversibly.
    void remember(std::int32_t surface, const Behaviour& behaviour) {
        const auto kind = lost_memory(behaviour);
        if (kind && !forgetful_) forgetful_ = {.kind = *kind, .surface = surface};
    }

    void hold(std::int32_t surface, bool is_held, const std::vector<Behaviour>& behaviours,
              std::vector<bool>& held) {
        if (!is_there(surface)) return;
        const auto k = static_cast<std::size_t>(surface);
        if (!piston_of(behaviours[k])) return add(Kind::no_piston, surface);
        if (!is_held && !held[k]) return add(Kind::not_held, surface);
        held[k] = is_held;
    }

    const Box& box_;
    const Surfaces& surfaces_;
    std::optional<std::size_t> event_;
    std::optional<SurfaceProblem> forgetful_;  // if velocities were reversed
    std::vector<SurfaceProblem> found_;
};

std::string range_text(double size) { return fmt::format("0 to {}", size); }

ProblemText of_partition(const SurfaceProblem& p, const std::string& name, const Box& box) {
    const Partition& line = *box.surfaces.partition(p.surface);
    const char* along = line.axis == 0 ? "y" : "x";
    switch (p.kind) {
        case Kind::partition_outside:
            return {fmt::format("{} at {} = {} is not in the box", name, line.axis == 0 ? "x" : "y",
                                line.at),
                    fmt::format("the box goes from {}", range_text(box.length(line.axis)))};
        case Kind::gap_outside:
            return {fmt::format("the gap from {} to {} is not in the box", line.gaps[p.item].from(),
                                line.gaps[p.item].to()),
                    fmt::format("gaps of {} lie between {} = {}", name, along,
                                fmt::format("0 and {}", box.length(1 - line.axis)))};
        case Kind::gaps_unordered:
            if (line.gaps[p.item].from() >= line.gaps[p.item].to())
                return {fmt::format("the gap from {} to {} ends where it begins, or before",
                                    line.gaps[p.item].from(), line.gaps[p.item].to()),
                        "give gaps as [from, to], the smaller first"};
            return {fmt::format("the gap from {} to {} begins before the end of the one before",
                                line.gaps[p.item].from(), line.gaps[p.item].to()),
                    "give gaps as [from, to] in rising order, without overlap"};
        case Kind::piston_gaps:
            return {fmt::format("{} is a piston, which has no gaps", name),
                    "leave out `gaps`, or the mass"};
        default:
            return {fmt::format("{} cannot move across periodic sides", name),
                    fmt::format("make the box solid along {}", line.axis == 0 ? "x" : "y")};
    }
}

}  // namespace

std::vector<SurfaceProblem> surface_problems(const Box& box, const Run& run, double area) {
    Search search(box);
    search.look_at_box();
    search.look_at_events(run);
    auto found = std::move(search).found();
    if (const auto end = found.empty() ? driven_end(box, run, area) : std::nullopt)
        found.push_back({.kind = end->other ? Kind::reaches : Kind::leaves_no_room,
                         .surface = end->surface,
                         .other = end->other.value_or(-1),
                         .value = end->time,
                         .room = end->room});
    return found;
}

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
        case Kind::gap_outside:
        case Kind::gaps_unordered:
        case Kind::piston_gaps:
            return of_partition(p, name, box);
        case Kind::obstacle_outside:
            return {fmt::format("{} lies outside the box", name),
                    fmt::format("the box goes from x = {} and from y = {}", range_text(box.size[0]),
                                range_text(box.size[1]))};
        case Kind::obstacle_too_wide:
            return {
                fmt::format("{} is wider than the periodic box, and would overlap itself", name),
                "make it smaller, or the box solid"};
        case Kind::same_corner:
            return {fmt::format("two successive corners of {} coincide", name),
                    "leave one of them out"};
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

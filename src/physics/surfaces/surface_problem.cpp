#include "physics/surfaces/surface_problem.h"

#include <algorithm>
#include <cmath>

#include "physics/surfaces/barrier.h"
#include "physics/surfaces/behaviours.h"
#include "physics/surfaces/driven_path.h"
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
    if (const auto* ball = std::get_if<Obstacle::Ball>(&obstacle.shape))
        return is_finite(ball->center) && ball->radius >= 0.0 && std::isfinite(ball->radius);
    if (const auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape))
        return is_finite(cuboid->low) && is_finite(cuboid->high);
    const auto& [corners, is_closed] = std::get<Obstacle::Lines>(obstacle.shape);
    return corners.size() >= (is_closed ? 3U : 2U) &&
           std::ranges::all_of(corners, [](const Vec& one) { return is_finite(one); });
}

// The smallest and the largest coordinates of an obstacle.
std::pair<Vec, Vec> extent_of(const Obstacle& obstacle) {
    if (const auto* ball = std::get_if<Obstacle::Ball>(&obstacle.shape)) {
        const Vec reach(ball->radius, ball->radius, ball->radius);
        return {ball->center - reach, ball->center + reach};
    }
    if (const auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape))
        return {cuboid->low, cuboid->high};
    const auto& corners = std::get<Obstacle::Lines>(obstacle.shape).corners;
    Vec low = corners.front(), high = low;
    for (const Vec& corner : corners) {
        low = lower(low, corner);
        high = upper(high, corner);
    }
    return {low, high};
}

// Whether two gaps have points in common that are not at their rims.
bool overlap(const Gap& a, const Gap& b) {
    bool they_do = true;
    for (const std::size_t k : {0U, 1U})
        they_do = they_do && a.low[k] < b.high[k] && b.low[k] < a.high[k];
    return they_do;
}

// Whether it means something on a line.
bool acts_on_line(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return true; }, [](const Bath&) { return true; },
                   [](const Driven&) { return true; }, [](const Piston&) { return true; },
                   [](const Membrane&) { return true; }, [](const Diffuse&) { return false; }},
        behaviour);
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
        if (partition.axis < 0 || partition.axis >= box_.dimension)
            return add(Kind::no_axis, surface);
        if (!(partition.at >= 0.0 && partition.at <= box_.length(partition.axis)))
            return add(Kind::partition_outside, surface);
        if (!(box_.dimension == 3 ? are_gaps_in_space(surface, partition)
                                  : are_gaps_in_plane(surface, partition)))
            return;
        if (const auto kind = problem_of(surface, partition.behaviour, true)) add(*kind, surface);
        if (partition.is_open && piston_of(partition.behaviour)) add(Kind::open_piston, surface);
    }

    // Whether the gaps of a partition have no problem; otherwise adds the first.
    bool are_gaps_in_plane(std::int32_t surface, const Partition& partition) {
        double before = 0.0;
        for (std::size_t k = 0; k < partition.gaps.size(); ++k) {
            const double from = partition.gaps[k].from(), to = partition.gaps[k].to();
            const bool is_inside = from >= 0.0 && to <= box_.length(1 - partition.axis);
            if (!is_inside || !(from >= before && to > from)) {
                add(is_inside ? Kind::gaps_unordered : Kind::gap_outside, surface, k);
                return false;
            }
            before = to;
        }
        return true;
    }

    bool are_gaps_in_space(std::int32_t surface, const Partition& partition) {
        const auto along = other_axes(static_cast<std::size_t>(partition.axis));
        for (std::size_t k = 0; k < partition.gaps.size(); ++k) {
            const Gap& gap = partition.gaps[k];
            bool is_inside = true, has_extent = true;
            for (const std::size_t a : {0U, 1U}) {
                is_inside = is_inside && gap.low[a] >= 0.0 && gap.high[a] <= box_.length(along[a]);
                has_extent = has_extent && gap.high[a] > gap.low[a];
            }
            if (!is_inside || !has_extent) {
                add(is_inside ? Kind::gap_empty : Kind::gap_outside, surface, k);
                return false;
            }
            for (std::size_t other = 0; other < k; ++other) {
                if (!overlap(gap, partition.gaps[other])) continue;
                add(Kind::gaps_overlap, surface, k);
                found_.back().other = static_cast<std::int32_t>(other);
                return false;
            }
        }
        return true;
    }

    void look_at_obstacle(std::int32_t surface, const Obstacle& obstacle) {
        const auto* cuboid = std::get_if<Obstacle::Cuboid>(&obstacle.shape);
        const auto* lines = std::get_if<Obstacle::Lines>(&obstacle.shape);
        if (lines != nullptr && box_.dimension == 3) return add(Kind::not_in_space, surface);
        if (cuboid != nullptr && box_.dimension == 2) return add(Kind::not_in_plane, surface);
        if (!is_finite(obstacle)) return add(Kind::not_finite, surface);
        if (cuboid != nullptr &&
            !on_each_axis(3, [&](int axis) { return cuboid->high[axis] > cuboid->low[axis]; }))
            return add(Kind::cuboid_empty, surface);
        const auto [low, high] = extent_of(obstacle);
        const bool is_near = on_each_axis(box_.dimension, [&](int axis) {
            return !(high[axis] < 0.0) && !(low[axis] > box_.size[axis]);
        });
        if (!is_near) return add(Kind::obstacle_outside, surface);
        for (int axis = 0; axis < box_.dimension; ++axis)
            if (box_.is_periodic(axis) && high[axis] - low[axis] > box_.length(axis))
                return add(Kind::obstacle_too_wide, surface);
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

}  // namespace

std::vector<SurfaceProblem> surface_problems(const Box& box, const Run& run, double content) {
    Search search(box);
    search.look_at_box();
    search.look_at_events(run);
    auto found = std::move(search).found();
    if (const auto end = found.empty() ? driven_end(box, run, content) : std::nullopt)
        found.push_back({.kind = end->other ? Kind::reaches : Kind::leaves_no_room,
                         .surface = end->surface,
                         .other = end->other.value_or(-1),
                         .value = end->time,
                         .room = end->room});
    return found;
}

}  // namespace carom

#include "physics/theory/boxed_gas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "physics/placement/members.h"
#include "physics/surfaces/behaviours.h"
#include "util/overloaded.h"

namespace carom {
namespace {

using Why = NoLaw::Why;

// A curve is drawn from a few hundred points. If there are more different masses than this,
// neighbouring masses are merged, to within a thousandth of the logarithmic range of masses.
constexpr std::size_t most_groups = 1024;

// Momentum left by round-off carries this part of the energy at most.
constexpr double negligible_share = 1e-12;

std::vector<MassGroup> group_by_mass(std::vector<double> masses) {
    std::sort(masses.begin(), masses.end());
    std::vector<MassGroup> groups;
    for (const double mass : masses) {
        if (!groups.empty() && groups.back().mass == mass)
            groups.back().count += 1.0;
        else
            groups.push_back({mass, 1.0});
    }
    if (groups.size() <= most_groups) return groups;
    std::vector<MassGroup> merged;
    const double ratio = std::pow(masses.back() / masses.front(), 1.0 / double(most_groups));
    for (const MassGroup& group : groups) {
        if (!merged.empty() && group.mass < merged.back().mass * ratio)
            merged.back().count += group.count;
        else
            merged.push_back(group);
    }
    return merged;
}

void add_influence(const Behaviour& behaviour, Influences& all) {
    std::visit(Overloaded{[](const Reflecting&) {}, [&](const Bath&) { all.bath = true; },
                          [&](const Driven&) { all.driven = true; },
                          [&](const Piston&) { all.piston = true; },
                          [&](const Membrane&) { all.membrane = true; },
                          [&](const Diffuse&) { all.diffuse = true; }},
               behaviour);
}

void add_influence(const RunEvent& event, Influences& all) {
    std::visit(Overloaded{[&](const ReverseVelocities&) { all.velocities = true; },
                          [&](const Perturbation&) { all.velocities = true; },
                          [&](const SetOpen&) { all.wall_event = true; },
                          [&](const MoveSurface&) { all.wall_event = true; },
                          [&](const HoldPiston&) { all.wall_event = true; },
                          [&](const ReleasePiston&) { all.wall_event = true; },
                          [&](const ChangeSurface&) { all.wall_event = true; },
                          [&](const Heat&) { all.heat_event = true; }},
               event.action);
}

// Whether the partition with this number is open, has gaps or is opened by an event.
bool lets_through(const Surfaces& surfaces, std::int32_t number,
                  const std::vector<RunEvent>& events) {
    const Partition& partition = *surfaces.partition(number);
    if (partition.is_open || !partition.gaps.empty()) return true;
    return std::ranges::any_of(events, [&](const RunEvent& event) {
        const auto* open = opening_of(event);
        return open != nullptr && open->surface == number && open->is_open;
    });
}

// The temperature of all baths among these behaviours, if there is one.
struct BathTemperature {
    bool differs = false;
    std::optional<double> value = {};
};

BathTemperature bath_temperature_of(const std::vector<std::optional<Behaviour>>& walls) {
    BathTemperature found;
    for (const std::optional<Behaviour>& wall : walls) {
        const auto* bath = wall ? bath_of(*wall) : nullptr;
        if (bath == nullptr) continue;
        found.differs = found.differs || (found.value && *found.value != bath->temperature);
        found.value = bath->temperature;
    }
    return found;
}

// Events at one instant count as one: single walls are not looked at in between.
std::vector<double> bath_temperatures(const Box& box, const std::vector<RunEvent>& events) {
    std::vector<std::optional<Behaviour>> walls;
    for (std::size_t k = 0; k < box.surfaces.numbered_sides().size(); ++k)
        walls.push_back(box.has_surface(k) && !box.is_periodic(k / 2)
                            ? std::optional(box.surfaces.sides.at(k))
                            : std::nullopt);
    for (const Partition& partition : box.surfaces.partitions)
        walls.emplace_back(partition.behaviour);
    std::vector<double> found;
    for (std::size_t next = 0;;) {
        const BathTemperature now = bath_temperature_of(walls);
        if (now.differs) return {};
        if (now.value && std::ranges::find(found, *now.value) == found.end())
            found.push_back(*now.value);
        if (next == events.size()) return found;
        for (const double instant = events[next].at;
             next < events.size() && events[next].at == instant; ++next) {
            const auto given = given_behaviour(events[next]);
            const auto k = given ? static_cast<std::size_t>(given->first) : walls.size();
            if (k < walls.size() && walls[k]) walls[k] = given->second;
        }
    }
}

Influences influences_of(const Box& box, const std::vector<RunEvent>& events) {
    const Surfaces& surfaces = box.surfaces;
    Influences all;
    Run run;
    run.events = events;
    const std::vector<std::vector<Behaviour>> behaviours = behaviours_in_time(surfaces, run);
    for (std::size_t k = 0; k < behaviours.size(); ++k) {
        const bool is_wall =
            !surfaces.is_side(k) || (box.has_surface(k) && !box.is_periodic(k / 2));
        for (const Behaviour& one : behaviours[k])
            if (is_wall) add_influence(one, all);
    }
    all.bath_temperatures = bath_temperatures(box, events);
    all.partitions = !surfaces.partitions.empty();
    for (std::int32_t k = surfaces.first_partition(); k < surfaces.first_obstacle(); ++k)
        all.divided = all.divided || !lets_through(surfaces, k, events);
    all.obstacles = !surfaces.obstacles.empty();
    for (std::size_t axis = 0; axis < all.gravity.size(); ++axis)
        all.gravity[axis] = surfaces.gravity[axis] != 0.0;
    for (const RunEvent& event : events) add_influence(event, all);
    return all;
}

// Whether all beads of finite mass lie in a single stretch between beads that never move.
bool beads_are_together(const Box& box, const Particles& particles, const Sample& sample) {
    const Beads order = beads_along(sample, 0);
    const auto moves = [&](std::size_t k) { return particles.inverse_mass[order[k].second] > 0.0; };
    int stretches = moves(0) && !(box.is_periodic(0) && moves(order.size() - 1)) ? 1 : 0;
    for (std::size_t k = 1; k < order.size(); ++k) stretches += moves(k) && !moves(k - 1);
    return stretches <= 1;
}

bool have_one_mass(const Particles& particles) {
    const auto finite = particles.inverse_mass > 0.0;
    const double lightest = particles.inverse_mass.maxCoeff();
    return (finite.select(particles.inverse_mass, lightest) == lightest).all();
}

// Additional reasons on a line.
std::optional<NoLaw> why_not_on_line(const BoxedGas& gas) {
    const Particles& particles = *gas.particles;
    if (have_one_mass(particles)) return NoLaw{Why::equal_masses};
    if (gas.finite < (gas.conserves[0] ? 4.0 : 3.0))
        return NoLaw{gas.conserves[0] ? Why::few_on_ring : Why::few_between_ends};
    if (gas.is_placed && !beads_are_together(gas.box, particles, gas.line))
        return NoLaw{Why::parted};
    return std::nullopt;
}

std::optional<NoLaw> why_not(const BoxedGas& gas) {
    if (const auto reason = why_not_isolated(gas)) return reason;
    if (gas.finite == 0.0) return NoLaw{Why::no_finite_mass};
    if (gas.finite == 1.0) return NoLaw{Why::alone};
    if (gas.finite == 2.0 && gas.conserves_all()) return NoLaw{Why::pair};
    if (gas.finite == 2.0 && gas.conserves_some()) return NoLaw{Why::few};
    if (!(gas.energy > 0.0)) return NoLaw{Why::at_rest};
    if (gas.drifts) return NoLaw{Why::drifts};
    if (gas.box.dimension == 1) return why_not_on_line(gas);
    if (gas.has_points()) return NoLaw{Why::points};
    return std::nullopt;
}

EquilibriumGas equilibrium_of(const BoxedGas& gas) {
    EquilibriumGas all;
    all.energy = gas.energy;
    all.alpha = 0.5 * gas.box.dimension;
    all.beta = 0.5 * std::round(gas.freedoms()) - all.alpha;
    std::vector<double> found;
    for (const double inverse : gas.particles->inverse_mass)
        if (inverse > 0.0) found.push_back(1.0 / inverse);
    all.groups = group_by_mass(std::move(found));
    for (MassGroup& group : all.groups)
        for (std::size_t axis = 0; axis < gas.conserves.size(); ++axis)
            if (gas.conserves.at(axis)) group.largest_share.at(axis) = 1.0 - group.mass / gas.mass;
    return all;
}

bool holds(const BoxedGas& gas, Why reason) {
    const Influences& all = gas.influences;
    switch (reason) {
        case Why::unknown_gas:
            return gas.particles == nullptr;
        case Why::bath:
            return all.bath;
        case Why::baths_differ:
            return all.baths_differ();
        case Why::driven:
            return all.driven;
        case Why::piston:
            return all.piston;
        case Why::membrane:
            return all.membrane;
        case Why::diffuse:
            return all.diffuse;
        case Why::partitions:
            return all.partitions;
        case Why::obstacles:
            return all.obstacles;
        case Why::gravity:
            return all.has_gravity();
        case Why::event:
            return all.wall_event || all.heat_event;
        case Why::moving_infinite_mass:
            return gas.moving_infinite_mass.has_value();
        case Why::fixed_particles:
            return gas.fixed > 0.0;
        case Why::no_finite_mass:
            return gas.finite == 0.0;
        default:
            throw std::logic_error("a reason that influences alone do not decide");
    }
}

}  // namespace

std::optional<NoLaw> first_of(const BoxedGas& gas, std::initializer_list<Why> reasons) {
    for (const Why reason : reasons) {
        if (!holds(gas, reason)) continue;
        if (reason == Why::moving_infinite_mass) return NoLaw{reason, *gas.moving_infinite_mass};
        return NoLaw{reason};
    }
    return std::nullopt;
}

std::optional<NoLaw> why_not_isolated(const BoxedGas& gas) {
    return first_of(gas, {Why::unknown_gas, Why::moving_infinite_mass, Why::driven,
                          Why::baths_differ, Why::bath, Why::piston, Why::membrane, Why::event,
                          Why::gravity, Why::partitions, Why::obstacles});
}

BoxedGas::BoxedGas(const Box& its_box, const std::vector<RunEvent>& events,
                   const Particles& its_particles, const Sample& start)
    : box(its_box),
      particles(&its_particles),
      influences(influences_of(its_box, events)),
      finite(static_cast<double>((its_particles.inverse_mass > 0.0).count())),
      fixed(static_cast<double>(its_particles.count()) - finite),
      thermal(thermal_motion(its_box, its_particles, start)) {
    const Eigen::ArrayXd masses =
        (particles->inverse_mass > 0.0).select(particles->inverse_mass.inverse(), 0.0);
    const Eigen::ArrayXd square_speed = start.velocity.square().rowwise().sum();
    mass = masses.sum();
    is_placed = (start.position != 0.0).any();
    energy = 0.5 * (masses * square_speed).sum();
    for (Eigen::Index i = 0; i < particles->count() && !moving_infinite_mass; ++i)
        if (masses[i] == 0.0 && square_speed[i] > 0.0)
            moving_infinite_mass = static_cast<std::size_t>(particles->species[i]);
    for (Eigen::Index axis = 0; axis < box.dimension; ++axis) {
        conserves.at(static_cast<std::size_t>(axis)) = conserves_momentum(box, *particles, axis);
        if (conserves.at(static_cast<std::size_t>(axis)))
            drift[axis] = masses.matrix().dot(start.velocity.col(axis).matrix()) / mass;
        const double gravity = box.surfaces.gravity[axis];
        if (gravity == 0.0 || !is_placed) continue;
        const auto lowest = gravity < 0.0 ? particles->radius : box.size[axis] - particles->radius;
        falling_energy -= gravity * (masses * (start.position.col(axis) - lowest)).sum();
    }
    for (Eigen::Index axis = 0; axis < start.position.cols() && particles->count() > 0; ++axis)
        mean_place[axis] = start.position.col(axis).mean();
    drifts = 0.5 * mass * square(drift) > negligible_share * energy;
    if (box.dimension == 1) line = start;
    no_equilibrium = why_not(*this);
    if (!no_equilibrium) equilibrium = equilibrium_of(*this);
}

std::optional<EquilibriumGas> among(const EquilibriumGas& gas, const Particles& particles,
                                    const std::vector<Eigen::Index>& chosen) {
    std::vector<double> wanted;
    for (const Eigen::Index i : chosen)
        if (particles.inverse_mass[i] > 0.0) wanted.push_back(1.0 / particles.inverse_mass[i]);
    if (wanted.empty()) return std::nullopt;
    EquilibriumGas some = gas;
    some.groups = group_by_mass(std::move(wanted));
    for (MassGroup& group : some.groups) {
        const auto heavier =
            std::upper_bound(gas.groups.begin(), gas.groups.end(), group.mass,
                             [](double mass, const MassGroup& other) { return mass < other.mass; });
        group.largest_share = std::prev(heavier)->largest_share;
    }
    return some;
}

}  // namespace carom

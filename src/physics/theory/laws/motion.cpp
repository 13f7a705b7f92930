// The laws of collisions and of paths.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "physics/placement/members.h"
#include "physics/theory/billiard.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/equation_of_state.h"
#include "physics/theory/error_growth.h"
#include "physics/theory/laws/laws.h"
#include "util/overloaded.h"

namespace carom::laws {
namespace {

constexpr double rounding = 1e-12;

// Whether particles have collided often enough for what only collisions bring about.
std::optional<NoLaw> why_not_yet(const Asked& asked, double enough) {
    if (!asked.collisions || *asked.collisions >= enough) return std::nullopt;
    return NoLaw{*asked.collisions > 0.0 ? Why::few_collisions : Why::no_collisions};
}

bool moves_by_itself(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return false; }, [](const Bath&) { return false; },
                   [](const Driven& its) { return its.velocity != 0.0; },
                   [](const Piston& its) { return its.force != 0.0 || its.velocity != 0.0; },
                   [](const Membrane&) { return false; }, [](const Diffuse&) { return false; }},
        behaviour);
}

// The mean squared displacement of independent places, of which each is anywhere between walls:
// twice the variance of a place along each axis.
double plateau_of_places(const BoxedGas& gas, const std::vector<Eigen::Index>& list) {
    double sum = 0.0;
    for (const Eigen::Index i : list) {
        double squares = 0.0;
        for (int axis = 0; axis < gas.box.dimension; ++axis) {
            const double room = gas.box.size[axis] - 2.0 * gas.particles->radius[i];
            squares += room * room;
        }
        sum += squares / 6.0;
    }
    return sum / static_cast<double>(list.size());
}

// The k-th of n beads has the k-th of n places on the length that all leave free, whose variance is
// k (n + 1 - k) / ((n + 1)^2 (n + 2)) of its square.
double plateau_on_line(const BoxedGas& gas, const std::vector<Eigen::Index>& list) {
    const Beads order = beads_along(gas.line, 0);
    const double n = gas.finite, free = gas.box.size[0] - 2.0 * gas.particles->radius.sum();
    double sum = 0.0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (std::ranges::find(list, order[k].second) == list.end()) continue;
        const double rank = static_cast<double>(k) + 1.0;
        sum += 2.0 * rank * (n + 1.0 - rank) / ((n + 1.0) * (n + 1.0) * (n + 2.0)) * free * free;
    }
    return sum / static_cast<double>(list.size());
}

// Displacements level off where walls bound them along all axes, and the particles come to be
// anywhere between: one that is alone only goes to and fro.
Law bounded(const BoxedGas& gas, const std::vector<Eigen::Index>& list) {
    const bool is_line = gas.box.dimension == 1;
    if (!is_line && !gas.box.is_closed()) return none(Why::bounded_once);
    Law law = none(is_line ? Why::keeps_order : Why::bounded);
    const auto uneven = first_of(
        gas, {Why::moving_infinite_mass, Why::driven, Why::baths_differ, Why::piston, Why::membrane,
              Why::gravity, Why::partitions, Why::obstacles, Why::fixed_particles});
    if (uneven || gas.influences.wall_event || !gas.has_partner()) return law;
    if (!is_line)
        law.value = plateau_of_places(gas, list);
    else if (gas.is_placed)
        law.value = plateau_on_line(gas, list);
    return law;
}

}  // namespace

// Heat scales velocities, and changes none that is 0.
bool moves(const BoxedGas& gas) {
    const Influences& all = gas.influences;
    const Surfaces& surfaces = gas.box.surfaces;
    return gas.energy > 0.0 || gas.moving_infinite_mass || all.bath || all.wall_event ||
           all.has_gravity() || std::ranges::any_of(surfaces.sides, moves_by_itself) ||
           std::ranges::any_of(surfaces.partitions, moves_by_itself, &Partition::behaviour);
}

Law collision_rate(const BoxedGas& gas, const Asked&) {
    const Particles& particles = *gas.particles;
    if (const auto reason = why_not_isolated(gas)) return none(*reason);
    if (particles.count() < 2 || gas.finite == 0.0) return value(0.0);
    if (gas.box.dimension == 1 && gas.fixed > 0.0) return none(Why::parted);
    if (packing_fraction(gas.box, particles) >= 1.0 - rounding) return none(Why::no_room);
    if (!(gas.thermal.energy > 0.0)) return value(0.0);
    if (gas.box.dimension == 1 && !gas.is_placed && !are_equal(particles.inverse_mass))
        return none(Why::unknown_order);
    return value(2.0 * collisions_per_time(gas) / static_cast<double>(particles.count()));
}

Law mean_free_path(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason = why_not_isolated(gas)) return none(*reason);
    if (gas.fixed > 0.0) return none(Why::fixed_particles);
    const Law speed = mean_speed(gas, {}), rate = collision_rate(gas, asked);
    if (!speed) return speed;
    if (!rate) return rate;
    return value(speed.value / rate.value);
}

Law displacement(const BoxedGas& gas, const Asked& asked) {
    const std::vector<Eigen::Index> list = members(gas, asked);
    if (list.empty()) return none(Why::no_finite_mass);
    if (const auto reason = first_of(gas, {Why::moving_infinite_mass})) return none(*reason);
    if (!moves(gas)) return none(Why::at_rest);
    if (!gas.box.is_periodic()) return bounded(gas, list);
    if (const auto reason = first_of(gas, {Why::gravity, Why::partitions})) return none(*reason);
    if (!gas.has_partner()) return none(Why::unhindered);
    if (gas.drifts) return none(Why::drifts);
    if (gas.box.dimension == 1) return none(gas.fixed > 0.0 ? Why::parted : Why::keeps_order);
    if (gas.are_points() && !gas.influences.obstacles) return none(Why::points);
    if (gas.finite == 2.0 && gas.conserves_all()) return none(Why::pair);
    // At least so many that most of a velocity is forgotten.
    if (const auto reason = why_not_yet(asked, 3.0)) return none(*reason);
    return {};
}

// A collision with a mass M removes on average the fraction 4 / d M / (m + M) of the velocity of a
// particle of mass m from its autocorrelation, for very many particles. The mean square of the
// relative velocity along the line of centres, at the collisions, is 2 D / (D + 1) times its mean
// square at any time instead of 2 times, if D degrees of freedom share the energy; and where
// momentum is conserved the mean square of a particle's own velocity is less than T / m.
Law autocorrelation(const BoxedGas& gas, const Asked& asked) {
    if (gas.no_equilibrium) return none(*gas.no_equilibrium);
    if (gas.influences.velocities) return none(Why::reversal);
    const std::vector<Eigen::Index> list = members(gas, asked);
    if (list.empty()) return none(Why::no_finite_mass);
    // At least so many that energy is shared.
    if (const auto reason = why_not_yet(asked, 5.0)) return none(*reason);
    const double freedoms = gas.freedoms(), d = gas.box.dimension;
    double thermal = 0.0, all = 0.0;  // sums of <v^2> in units of T d
    for (const Eigen::Index i : list) {
        const double inverse = gas.particles->inverse_mass[i];
        thermal += inverse;
        all += inverse - gas.conserved() / (d * gas.mass);
    }
    return value(thermal / all * freedoms / (freedoms + 1.0));
}

Law free_flight(const BoxedGas& gas, const Asked& asked) {
    const Influences& all = gas.influences;
    const bool has_walls = !gas.box.is_periodic();
    if (gas.box.dimension == 1) return none(Why::line);
    if (gas.finite != 1.0 || gas.fixed > 0.0) return none(Why::many);
    if (all.velocities || all.wall_event || all.heat_event) return none(Why::event);
    if (!all.obstacles) return none(Why::unhindered);
    if (const auto reason = first_of(gas, {Why::driven, Why::bath, Why::piston, Why::membrane,
                                           Why::gravity, Why::partitions}))
        return none(*reason);
    if (!(gas.energy > 0.0)) return none(Why::at_rest);
    if (has_walls && !asked.ends_at_walls) return none(Why::flies_on);
    const auto path = mean_path_of_billiard(gas.box, gas.particles->radius[0], asked.ends_at_walls);
    return path ? value(*path) : none(Why::shapes);
}

// Of many equal spheres in a periodic box. In a plane the velocities of disks are remembered for so
// long that there is no coefficient.
Law diffusion(const BoxedGas& gas, const Asked& asked) {
    constexpr double fewest = 200.0, most_uneven = 0.05;
    const Particles& particles = *gas.particles;
    if (gas.box.dimension == 2) return none(Why::remembers);
    const Law grows = displacement(gas, asked);
    if (!grows) return none(*grows.none);
    if (const auto reason =
            first_of(gas, {Why::fixed_particles, Why::obstacles, Why::event, Why::bath}))
        return none(*reason);
    if (gas.influences.velocities) return none(Why::reversal);
    if (!are_equal(particles.inverse_mass)) return none(Why::unequal_masses);
    if (!are_equal(particles.radius)) return none(Why::unequal_radii);
    if (gas.finite < fewest) return none(Why::few);
    const double packing = packing_fraction(gas.box, particles);
    if (packing > largest_packing_of_fluid(3)) return none(Why::freezes);
    if (packing > largest_packing_of_diffusion) return none(Why::near_freezing);
    const double side = std::cbrt(gas.box.content());
    if (gas.box.longest_side() - gas.box.shortest_side() > most_uneven * side)
        return none(Why::no_cube);
    return value(diffusion_of_spheres(gas.finite / gas.box.content(), 2.0 * particles.radius[0],
                                      gas.thermal.temperature(), 1.0 / particles.inverse_mass[0],
                                      side));
}

Law memoryless(const BoxedGas& gas, const Asked& asked) {
    const Influences& all = gas.influences;
    if (gas.finite == 0.0) return none(Why::no_finite_mass);
    if (!gas.has_partner()) return none(Why::unhindered);
    if (!moves(gas)) return none(Why::at_rest);
    if (gas.finite + gas.fixed == 2.0 && !all.obstacles) return none(Why::pair_only);
    if (gas.box.dimension > 1 && gas.are_points() && !all.obstacles) return none(Why::points);
    if (asked.collisions && *asked.collisions == 0.0) return none(Why::no_collisions);
    return {};
}

// The fits are to 50 disks and 32 spheres and more; it is not known how far below it may be
// continued.
Law error_growth(const BoxedGas& gas, const Asked&) {
    constexpr Eigen::Index fewest = 10;
    const Particles& particles = *gas.particles;
    if (gas.box.dimension == 1) return none(Why::line);
    if (const auto reason = why_not_isolated(gas)) return none(*reason);
    if (const auto reason =
            first_of(gas, {Why::diffuse, Why::no_finite_mass, Why::fixed_particles}))
        return none(*reason);
    if (particles.count() < fewest) return none(Why::few);
    if (!(gas.energy > 0.0)) return none(Why::at_rest);
    if (!are_equal(particles.inverse_mass)) return none(Why::unequal_masses);
    if (!are_equal(particles.radius)) return none(Why::unequal_radii);
    if (gas.are_points()) return none(Why::points);
    return value(bits_lost_per_collision(gas.box.dimension, packing_fraction(gas.box, particles)));
}

}  // namespace carom::laws

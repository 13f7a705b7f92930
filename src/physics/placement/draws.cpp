#include "physics/placement/draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <string_view>

#include "physics/mechanics.h"
#include "physics/placement/members.h"
#include "physics/placement/problem.h"
#include "physics/sampling/directions.h"
#include "util/random.h"

namespace carom {
namespace {

Random stream(const Gas& gas, std::size_t species, std::string_view what) {
    return Random(gas.seed, fmt::format("{} of species {}", what, species));
}

double draw_one(const ValueRule& rule, Eigen::Index i, Random& random) {
    if (const auto* number = std::get_if<double>(&rule)) return *number;
    if (const auto* list = std::get_if<std::vector<double>>(&rule))
        return (*list)[static_cast<std::size_t>(i)];
    if (const auto* uniform = std::get_if<UniformDistribution>(&rule))
        return random.uniform(uniform->low, uniform->high);
    const auto& normal = std::get<NormalDistribution>(rule);
    return normal.mean + normal.deviation * random.normal();
}

// A normal distribution is truncated at zero: other draws are repeated, up to a maximum number of
// tries.
Eigen::ArrayXd draw_positive(const Gas& gas, std::size_t species, const ValueRule& rule,
                             std::string_view what, bool or_zero) {
    constexpr int most_tries = 1000;
    Random random = stream(gas, species, what);
    Eigen::ArrayXd values(static_cast<Eigen::Index>(gas.species[species].count));
    const auto is_good = [&](double value) { return value > 0.0 || (or_zero && value == 0.0); };
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        values[i] = draw_one(rule, i, random);
        for (int tries = 1; !is_good(values[i]); ++tries) {
            if (tries == most_tries || !std::holds_alternative<NormalDistribution>(rule))
                throw PlacementError({.kind = Problem::Kind::not_positive,
                                      .species = species,
                                      .value = values[i],
                                      .quantity = what},
                                     gas);
            values[i] = draw_one(rule, i, random);
        }
    }
    return values;
}

void remove_momentum(const Box& box, const Eigen::ArrayXd& inverse_masses,
                     Eigen::ArrayXXd& velocities) {
    if (inverse_masses.size() < 2 || (inverse_masses == 0.0).any()) return;
    const Eigen::ArrayXd masses = inverse_masses.inverse();
    for (int axis = 0; axis < box.dimension; ++axis)
        if (box.is_periodic(axis))
            velocities.col(axis) -=
                sum_in_order(masses * velocities.col(axis)) / sum_in_order(masses);
}

// A speed and the direction that was drawn with it: an angle in the plane, a unit vector in space,
// none on a line.
struct DrawnSpeed {
    double speed = 0.0, angle = 0.0;
    Vec direction = {};

    Vec in_plane() const { return {speed * std::cos(angle), speed * std::sin(angle)}; }
    Vec in_space() const { return speed * direction; }
};

std::vector<DrawnSpeed> draw_speeds(const Gas& gas, std::size_t species, const ValueRule& speed,
                                    Eigen::Index count) {
    Random random = stream(gas, species, "velocity");
    std::vector<DrawnSpeed> drawn(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < count; ++i) {
        DrawnSpeed& its = drawn[static_cast<std::size_t>(i)];
        its.speed = draw_one(speed, i, random);
        if (gas.box.dimension == 2) its.angle = random_angle(random);
        if (gas.box.dimension == 3) its.direction = random_direction(random);
    }
    return drawn;
}

Eigen::ArrayXXd in_random_directions(const Gas& gas, std::size_t species, const ValueRule& speed,
                                     Eigen::Index count) {
    Eigen::ArrayXXd velocities(count, gas.box.dimension);
    Eigen::Index i = 0;
    for (const DrawnSpeed& drawn : draw_speeds(gas, species, speed, count))
        put(gas.box.dimension == 2 ? drawn.in_plane() : drawn.in_space(), velocities, i++);
    return velocities;
}

// To the left or to the right with equal probability.
Eigen::ArrayXXd left_or_right(const Gas& gas, std::size_t species, const ValueRule& speed,
                              Eigen::Index count) {
    Random random = stream(gas, species, "velocity");
    random.below(2);  // not used; without it the velocities that seeds give would change
    Eigen::ArrayXXd velocities(count, 1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double v = draw_one(speed, i, random);
        velocities(i, 0) = random.below(2) == 1 ? v : -v;
    }
    return velocities;
}

Eigen::ArrayXXd thermal(const Gas& gas, std::size_t species, double temperature,
                        const Eigen::ArrayXd& inverse_masses) {
    Random random = stream(gas, species, "velocity");
    Eigen::ArrayXXd velocities(inverse_masses.size(), gas.box.dimension);
    for (Eigen::Index i = 0; i < inverse_masses.size(); ++i)
        for (int axis = 0; axis < gas.box.dimension; ++axis)
            velocities(i, axis) = std::sqrt(temperature * inverse_masses[i]) * random.normal();
    return velocities;
}

Eigen::ArrayXd draw_radii(const Gas& gas, std::size_t species) {
    return draw_positive(gas, species, gas.species[species].radius, "radius", true);
}

// 0 for an infinite mass.
Eigen::ArrayXd draw_inverse_masses(const Gas& gas, std::size_t species,
                                   const Eigen::ArrayXd& radii) {
    const MassRule& rule = gas.species[species].mass;
    if (std::holds_alternative<Infinite>(rule)) return Eigen::ArrayXd::Zero(radii.size());
    if (const auto* density = std::get_if<Density>(&rule)) {
        const Eigen::ArrayXd value = draw_positive(gas, species, density->value, "density", false);
        if (!(radii > 0.0).all())
            throw PlacementError({.kind = Problem::Kind::no_mass, .species = species}, gas);
        const int dimension = gas.box.dimension;
        Eigen::ArrayXd powers = radii;
        for (int k = 1; k < dimension; ++k) powers *= radii;
        return (value * content_of_ball(1.0, dimension) * powers).inverse();
    }
    return draw_positive(gas, species, std::get<ValueRule>(rule), "mass", false).inverse();
}

Eigen::ArrayXXd draw_velocities(const Gas& gas, std::size_t species,
                                const Eigen::ArrayXd& inverse_masses) {
    const VelocityRule& rule = gas.species[species].velocity;
    const Eigen::Index count = inverse_masses.size();
    Eigen::ArrayXXd velocities = Eigen::ArrayXXd::Zero(count, gas.box.dimension);
    if (const auto* fixed = std::get_if<Velocity>(&rule)) {
        assert(fixed->values.size() == 1 ||
               fixed->values.size() == static_cast<std::size_t>(count));
        for (Eigen::Index i = 0; i < count; ++i)
            put(fixed->values[fixed->values.size() == 1 ? 0 : std::size_t(i)], velocities, i);
        return velocities;
    }
    if (const auto* speed = std::get_if<Speed>(&rule))
        velocities = gas.box.dimension == 1
                         ? left_or_right(gas, species, speed->value, count)
                         : in_random_directions(gas, species, speed->value, count);
    if (const auto* temperature = std::get_if<Temperature>(&rule)) {
        velocities = thermal(gas, species, temperature->value, inverse_masses);
        remove_momentum(gas.box, inverse_masses, velocities);
    }
    return velocities;
}

constexpr std::string_view balance_stream = "directions that sum to zero";

// The particles of a gas that have a `speed`.
struct SpeedDraws {
    std::vector<Eigen::Index> particles;
    std::vector<DrawnSpeed> drawn;
    Eigen::ArrayXd momentum;

    SpeedDraws(const Gas& gas, const Particles& all) {
        for_each_species(gas, [&](std::size_t s, Eigen::Index first, Eigen::Index count) {
            const auto* rule = std::get_if<Speed>(&gas.species[s].velocity);
            if (rule == nullptr) return;
            const std::vector<DrawnSpeed> its = draw_speeds(gas, s, rule->value, count);
            drawn.insert(drawn.end(), its.begin(), its.end());
            for (Eigen::Index i = 0; i < count; ++i) particles.push_back(first + i);
        });
        momentum.resize(std::ssize(particles));
        for (std::size_t k = 0; k < drawn.size(); ++k)
            momentum[static_cast<Eigen::Index>(k)] =
                std::abs(drawn[k].speed) / all.inverse_mass[particles[k]];
    }
    bool are_at_rest() const { return !(momentum > 0.0).any(); }
};

// The problem if the momenta cannot sum to zero, at the species of the largest one.
Problem unbalanced(const SpeedDraws& draws, const Particles& particles) {
    Eigen::Index largest = 0;
    const double most = draws.momentum.maxCoeff(&largest);
    const auto k = static_cast<std::size_t>(largest);
    return {.kind = Problem::Kind::momentum,
            .species = static_cast<std::size_t>(particles.species[draws.particles[k]]),
            .particle = draws.particles[k],
            .count = (draws.momentum > 0.0).count(),
            .value = most,
            .bound = draws.momentum.sum() - most};
}

bool balance_in_plane(const Gas& gas, const std::array<bool, 3>& axes, SpeedDraws& draws,
                      Sample& start) {
    Random random(gas.seed, balance_stream);
    Eigen::ArrayXd angles(std::ssize(draws.drawn));
    for (std::size_t k = 0; k < draws.drawn.size(); ++k)
        angles[static_cast<Eigen::Index>(k)] = draws.drawn[k].angle;
    if (!balance_angles(draws.momentum, {axes[0], axes[1]}, random, angles)) return false;
    for (std::size_t k = 0; k < draws.drawn.size(); ++k) {
        draws.drawn[k].angle = angles[static_cast<Eigen::Index>(k)];
        put(draws.drawn[k].in_plane(), start.velocity, draws.particles[k]);
    }
    return true;
}

bool balance_in_space(const Gas& gas, const std::array<bool, 3>& axes, SpeedDraws& draws,
                      Sample& start) {
    Random random(gas.seed, balance_stream);
    std::vector<Vec> directions;
    for (const DrawnSpeed& drawn : draws.drawn) directions.push_back(drawn.direction);
    if (!balance_directions(draws.momentum, axes, random, directions)) return false;
    for (std::size_t k = 0; k < draws.drawn.size(); ++k) {
        draws.drawn[k].direction = directions[k];
        put(draws.drawn[k].in_space(), start.velocity, draws.particles[k]);
    }
    return true;
}

// The numbers of the beads of each momentum, with the largest momenta first.
std::pair<std::vector<EqualMomenta>, std::vector<std::size_t>> equal_momenta(
    const Eigen::ArrayXd& momenta) {
    std::vector<std::size_t> order(static_cast<std::size_t>(momenta.size())), group(order.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto momentum = [&](std::size_t k) { return momenta[static_cast<Eigen::Index>(k)]; };
    std::ranges::stable_sort(order, [&](auto a, auto b) { return momentum(a) > momentum(b); });
    std::vector<EqualMomenta> groups;
    for (const std::size_t k : order) {
        constexpr double rounding = 1e-15;
        if (groups.empty() || momentum(k) < (1.0 - rounding) * groups.back().momentum)
            groups.push_back({momentum(k), 0, 0});
        ++groups.back().count;
        group[k] = groups.size() - 1;
    }
    return {std::move(groups), std::move(group)};
}

// Of the beads with the same momentum, all choices of those to the right are equally probable.
bool balance_on_ring(const Gas& gas, const SpeedDraws& draws, Sample& start) {
    Random balance(gas.seed, balance_stream);
    auto [groups, group] = equal_momenta(draws.momentum);
    if (!balance_signs(groups, balance)) return false;
    std::vector<Random> random;
    for (std::size_t s = 0; s < gas.species.size(); ++s) {
        random.push_back(stream(gas, s, "velocity"));
        random.back().below(2);  // as in left_or_right()
    }
    std::size_t k = 0;
    for_each_species(gas, [&](std::size_t s, Eigen::Index first, Eigen::Index count) {
        if (!std::holds_alternative<Speed>(gas.species[s].velocity)) return;
        for (Eigen::Index i = first; i < first + count; ++i, ++k) {
            EqualMomenta& its = groups[group[k]];
            const bool right = random[s].below(static_cast<std::uint64_t>(its.count--)) <
                               static_cast<std::uint64_t>(its.to_the_right);
            if (right) --its.to_the_right;
            start.velocity(i, 0) = right ? draws.drawn[k].speed : -draws.drawn[k].speed;
        }
    });
    return true;
}

// Turns the velocities of all particles with a `speed`, of whatever species, so that their momenta
// sum to zero where momentum is conserved. Throws PlacementError if no directions do that.
void balance_speeds(const Gas& gas, const Particles& particles, Sample& start) {
    std::array<bool, 3> axes{};
    for (int axis = 0; axis < gas.box.dimension; ++axis)
        axes[static_cast<std::size_t>(axis)] = conserves_momentum(gas.box, particles, axis);
    if (std::ranges::count(axes, true) == 0) return;
    SpeedDraws draws(gas, particles);
    if (draws.are_at_rest()) return;
    const bool is_balanced = gas.box.dimension == 1   ? balance_on_ring(gas, draws, start)
                             : gas.box.dimension == 2 ? balance_in_plane(gas, axes, draws, start)
                                                      : balance_in_space(gas, axes, draws, start);
    if (!is_balanced) throw PlacementError(unbalanced(draws, particles), gas);
}

// Scales the velocities of a species, which have no drift, to its temperature.
void scale_to_temperature(const Gas& gas, std::size_t species, const Particles& particles,
                          Sample& start) {
    const auto* temperature = std::get_if<Temperature>(&gas.species[species].velocity);
    if (temperature == nullptr || !temperature->is_exact || temperature->value == 0.0) return;
    std::vector<Eigen::Index> members;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (particles.species[i] == static_cast<int>(species)) members.push_back(i);
    const double sampled = thermal_motion(gas.box, particles, start, members).temperature();
    if (!(sampled > 0.0))
        throw PlacementError({.kind = Problem::Kind::no_temperature,
                              .species = species,
                              .value = temperature->value},
                             gas);
    for (const Eigen::Index i : members)
        start.velocity.row(i) *= std::sqrt(temperature->value / sampled);
}

constexpr std::int64_t most_particles = 50'000'000;

// The species at which the total number of particles exceeds the limit for a gas.
std::optional<Problem> too_many(const Gas& gas) {
    std::int64_t left = most_particles;
    for (std::size_t s = 0; s < gas.species.size(); ++s) {
        const std::int64_t count = gas.species[s].count;
        assert(count >= 0);
        if (count > left)
            return Problem{.kind = Problem::Kind::too_many,
                           .species = s,
                           .count = count,
                           .bound = static_cast<double>(most_particles)};
        left -= count;
    }
    return std::nullopt;
}

// Sets the positions of particles if all are listed.
void set_listed_places(const Gas& gas, Sample& start) {
    const bool are_listed = std::ranges::all_of(gas.species, [](const Species& species) {
        return species.count == 0 ||
               (has_position<Places>(species) && fitting_rules(species).position);
    });
    if (!are_listed) return;
    for_each_listed(
        gas, [&](std::size_t, Eigen::Index i, const Vec& place) { put(place, start.position, i); });
}

}  // namespace

std::int64_t total_count(const Gas& gas) {
    std::int64_t sum = 0;
    for (const Species& species : gas.species) sum += species.count;
    return sum;
}

FittingRules fitting_rules(const Species& species) {
    const auto fits = [&](const ValueRule& rule) {
        const auto* list = std::get_if<std::vector<double>>(&rule);
        return list == nullptr || std::ssize(*list) == species.count;
    };
    const auto* mass = std::get_if<ValueRule>(&species.mass);
    const auto* density = std::get_if<Density>(&species.mass);
    const auto* speed = std::get_if<Speed>(&species.velocity);
    const auto* velocity = std::get_if<Velocity>(&species.velocity);
    const auto* places = std::get_if<Places>(&species.position);
    return {.radius = fits(species.radius),
            .mass = (!mass || fits(*mass)) && (!density || fits(density->value)),
            .velocity =
                (!speed || fits(speed->value)) && (!velocity || velocity->values.size() == 1 ||
                                                   std::ssize(velocity->values) == species.count),
            .position = !places || std::ssize(places->values) == species.count};
}

std::optional<std::pair<Particles, Sample>> try_draw_gas(const Gas& gas) {
    constexpr double most_drawn = 1e7;  // gases that are too large are refused for that
    double count = 0.0;
    for (const Species& species : gas.species) {
        const FittingRules fits = fitting_rules(species);
        if (!fits.radius || !fits.mass || !fits.velocity || !fits.position) return std::nullopt;
        count += static_cast<double>(species.count);
    }
    if (count > most_drawn) return std::nullopt;
    std::vector<Problem> problems;
    auto drawn = draw_gas(gas, problems);
    if (!problems.empty()) return std::nullopt;
    return drawn;
}

std::pair<Particles, Sample> draw_gas(const Gas& gas) {
    std::vector<Problem> problems;
    auto drawn = draw_gas(gas, problems);
    if (!problems.empty()) throw PlacementError(problems.front(), gas);
    return drawn;
}

std::pair<Particles, Sample> draw_gas(const Gas& gas, std::vector<Problem>& problems) {
    const auto more = too_many(gas);
    if (more) problems.push_back(*more);
    const Eigen::Index count = more ? 0 : total_count(gas);
    Particles particles{Eigen::ArrayXd::Zero(count), Eigen::ArrayXd::Ones(count),
                        Eigen::ArrayXi::Zero(count)};
    Sample start{0.0, Eigen::ArrayXXd::Zero(count, gas.box.dimension),
                 Eigen::ArrayXXd::Zero(count, gas.box.dimension)};
    Eigen::Index first = 0;
    for (std::size_t s = 0; s < gas.species.size() && !more; ++s) {
        const auto its_count = static_cast<Eigen::Index>(gas.species[s].count);
        auto radii = particles.radius.segment(first, its_count);
        auto inverse_masses = particles.inverse_mass.segment(first, its_count);
        particles.species.segment(first, its_count).setConstant(static_cast<int>(s));
        try {
            radii = draw_radii(gas, s);
            inverse_masses = draw_inverse_masses(gas, s, radii);
            start.velocity.middleRows(first, its_count) = draw_velocities(gas, s, inverse_masses);
        } catch (const PlacementError& error) {
            problems.push_back(error.problem());
        }
        first += its_count;
    }
    if (!more) set_listed_places(gas, start);
    if (!problems.empty()) return {std::move(particles), std::move(start)};
    try {
        balance_speeds(gas, particles, start);
    } catch (const PlacementError& error) {
        problems.push_back(error.problem());
    }
    for (std::size_t s = 0; s < gas.species.size(); ++s) try {
            scale_to_temperature(gas, s, particles, start);
        } catch (const PlacementError& error) {
            problems.push_back(error.problem());
        }
    return {std::move(particles), std::move(start)};
}

}  // namespace carom

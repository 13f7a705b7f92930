#include "physics/placement/draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <string_view>

#include "physics/mechanics.h"
#include "physics/placement/problem.h"
#include "util/random.h"

namespace carom {
namespace {

Random stream(const Gas& gas, std::size_t species, std::string_view what) {
    return Random(gas.seed, fmt::format("{} of species {}", what, species));
}

double draw_one(const Quantity& quantity, Eigen::Index i, Random& random) {
    if (const auto* number = std::get_if<double>(&quantity)) return *number;
    if (const auto* list = std::get_if<std::vector<double>>(&quantity))
        return (*list)[static_cast<std::size_t>(i)];
    if (const auto* uniform = std::get_if<UniformDistribution>(&quantity))
        return random.uniform(uniform->low, uniform->high);
    const auto& normal = std::get<NormalDistribution>(quantity);
    return normal.mean + normal.deviation * random.normal();
}

// A normal distribution is truncated at zero: other draws are repeated, up to a maximum number of
// tries.
Eigen::ArrayXd draw_positive(const Gas& gas, std::size_t species, const Quantity& quantity,
                             std::string_view what, bool or_zero) {
    constexpr int most_tries = 1000;
    Random random = stream(gas, species, what);
    Eigen::ArrayXd values(static_cast<Eigen::Index>(gas.species[species].count));
    const auto is_good = [&](double value) { return value > 0.0 || (or_zero && value == 0.0); };
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        values[i] = draw_one(quantity, i, random);
        for (int tries = 1; !is_good(values[i]); ++tries) {
            if (tries == most_tries || !std::holds_alternative<NormalDistribution>(quantity))
                throw PlacementError({.kind = Problem::Kind::not_positive,
                                      .species = species,
                                      .value = values[i],
                                      .quantity = what},
                                     gas);
            values[i] = draw_one(quantity, i, random);
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

Eigen::ArrayXXd in_random_directions(const Gas& gas, std::size_t species, const Quantity& speed,
                                     Eigen::Index count) {
    Random random = stream(gas, species, "velocity");
    Eigen::ArrayXXd velocities(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double v = draw_one(speed, i, random);
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        velocities.row(i) << v * std::cos(angle), v * std::sin(angle);
    }
    return velocities;
}

// To the left or to the right with equal probability. On a ring, where the total momentum will be
// removed, exactly half of the beads go each way; otherwise two beads alone would end up at rest
// half of the time.
Eigen::ArrayXXd left_or_right(const Gas& gas, std::size_t species, const Quantity& speed,
                              Eigen::Index count) {
    Random random = stream(gas, species, "velocity");
    Eigen::ArrayXXd velocities(count, 1);
    const bool ring = gas.box.is_periodic(0);
    Eigen::Index to_the_right = (count + static_cast<Eigen::Index>(random.below(2))) / 2;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double v = draw_one(speed, i, random);
        const auto left = static_cast<std::uint64_t>(count - i);
        const bool right = ring ? random.below(left) < static_cast<std::uint64_t>(to_the_right)
                                : random.below(2) == 1;
        if (right) --to_the_right;
        velocities(i, 0) = right ? v : -v;
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
        if (gas.box.dimension == 1) return (value * 2.0 * radii).inverse();
        return (value * std::numbers::pi * radii.square()).inverse();
    }
    return draw_positive(gas, species, std::get<Quantity>(rule), "mass", false).inverse();
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
            velocities.row(i) = fixed->values[fixed->values.size() == 1 ? 0 : std::size_t(i)]
                                    .head(gas.box.dimension)
                                    .transpose();
        return velocities;
    }
    if (const auto* speed = std::get_if<Speed>(&rule))
        velocities = gas.box.dimension == 1
                         ? left_or_right(gas, species, speed->value, count)
                         : in_random_directions(gas, species, speed->value, count);
    if (const auto* temperature = std::get_if<Temperature>(&rule))
        velocities = thermal(gas, species, temperature->value, inverse_masses);
    remove_momentum(gas.box, inverse_masses, velocities);
    return velocities;
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

}  // namespace

std::int64_t total_count(const Gas& gas) {
    std::int64_t sum = 0;
    for (const Species& species : gas.species) sum += species.count;
    return sum;
}

FittingRules fitting_rules(const Species& species) {
    const auto fits = [&](const Quantity& quantity) {
        const auto* list = std::get_if<std::vector<double>>(&quantity);
        return list == nullptr || std::ssize(*list) == species.count;
    };
    const auto* mass = std::get_if<Quantity>(&species.mass);
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
    if (!problems.empty()) return {std::move(particles), std::move(start)};
    for (std::size_t s = 0; s < gas.species.size(); ++s) try {
            scale_to_temperature(gas, s, particles, start);
        } catch (const PlacementError& error) {
            problems.push_back(error.problem());
        }
    return {std::move(particles), std::move(start)};
}

}  // namespace carom

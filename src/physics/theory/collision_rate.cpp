#include "physics/theory/collision_rate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "physics/placement/members.h"
#include "physics/theory/equation_of_state.h"

namespace carom {
namespace {

using Eigen::Index;
using std::numbers::pi;

/// A group of particles with the same, or nearly the same, radius and mass.
struct Alike {
    double radius, inverse_mass, count;
};

// Sorts the particles by size and mass and divides them into groups of one kind. If there are very
// many kinds, neighbours in this order are merged, so that the sum over pairs of groups stays
// short.
std::vector<Alike> groups_of(const Particles& particles) {
    constexpr std::size_t most_groups = 1000;
    std::vector<Alike> order;
    for (Index i = 0; i < particles.count(); ++i)
        order.push_back({particles.radius[i], particles.inverse_mass[i], 1.0});
    std::sort(order.begin(), order.end(), [](const Alike& a, const Alike& b) {
        return std::tie(a.radius, a.inverse_mass) < std::tie(b.radius, b.inverse_mass);
    });
    std::vector<Alike> groups;
    for (const Alike& one : order) {
        const bool same = !groups.empty() && groups.back().radius == one.radius &&
                          groups.back().inverse_mass == one.inverse_mass;
        if (same)
            groups.back().count += 1.0;
        else
            groups.push_back(one);
    }
    if (groups.size() <= most_groups) return groups;
    groups.clear();
    for (std::size_t k = 0; k < most_groups; ++k) {
        const std::size_t begin = k * order.size() / most_groups;
        const std::size_t end = (k + 1) * order.size() / most_groups;
        groups.push_back(order[(begin + end) / 2]);
        groups.back().count = static_cast<double>(end - begin);
    }
    return groups;
}

double pairs(const std::vector<Alike>& groups, std::size_t a, std::size_t b) {
    return a == b ? 0.5 * groups[a].count * (groups[a].count - 1.0)
                  : groups[a].count * groups[b].count;
}

// sum over all pairs of f(one, other), the groups being alike within.
template <typename Function>
double sum_of_pairs(const std::vector<Alike>& groups, const Function& f) {
    double sum = 0.0;
    for (std::size_t a = 0; a < groups.size(); ++a)
        for (std::size_t b = a; b < groups.size(); ++b)
            sum += pairs(groups, a, b) * f(groups[a], groups[b]);
    return sum;
}

// 1 / A or 1 / V for a touching pair, corrected for solid walls: centres stay a radius away from
// them, and within a distance s of a wall not all directions of contact are possible (on average a
// share 1/pi is lost in a plane, 1/4 in space).
double contact_density(const Box& box, double s) {
    const double share = box.dimension == 2 ? pi : 4.0;
    double density = 1.0;
    double lost = 0.0;
    for (int axis = 0; axis < box.dimension; ++axis) {
        const bool solid = !box.is_periodic(axis);
        const double room = solid ? box.size[axis] - s : box.size[axis];
        if (room <= 0.0) return 1.0 / box.content();
        density /= room;
        if (solid) lost += 2.0 * s / (share * room);
    }
    return density * std::max(0.0, 1.0 - lost);
}

// What the contact values of a mixture depend on.
struct Mixture {
    int dimension;
    double packing;
    double inverse_size;  // the mean radius over the mean square, in space the mean square over the
                          // mean cube

    Mixture(const Box& box, const Particles& particles)
        : dimension(box.dimension), packing(packing_fraction(box, particles)) {
        const Eigen::ArrayXd square = particles.radius.square();
        inverse_size = dimension == 2 ? particles.radius.sum() / square.sum()
                                      : square.sum() / (square * particles.radius).sum();
    }

    double at_contact(double a, double b) const {
        const double free = 1.0 - packing;
        if (dimension == 2)
            return 1.0 / free +
                   9.0 / 8.0 * (a * b / (a + b)) * packing * inverse_size / (free * free);
        const double part = a * b / (a + b) * packing * inverse_size / free;
        return (1.0 + part * (3.0 + 2.0 * part)) / free;
    }
};

double rate_of_collisions(const BoxedGas& gas) {
    const std::vector<Alike> groups = groups_of(*gas.particles);
    const double t = gas.thermal.temperature(), factor = mean_speed_factor(gas.freedoms());
    const Mixture mixture(gas.box, *gas.particles);
    const double of_speed = squared_mean_length(gas.box.dimension);
    return sum_of_pairs(groups, [&](const Alike& a, const Alike& b) {
        const double s = a.radius + b.radius;
        if (s == 0.0) return 0.0;  // points never meet
        const double chi = mixture.at_contact(a.radius, b.radius);
        const double g = factor * std::sqrt(of_speed * t * (a.inverse_mass + b.inverse_mass));
        return cross_section(s, gas.box.dimension) * chi * g * contact_density(gas.box, s);
    });
}

// Sums over all pairs of numbers in rising order: the k-th is the greater one in k pairs.
double rate_of_exchange(const BoxedGas& gas) {
    const bool ring = gas.box.is_periodic(0);
    const Eigen::ArrayXd velocity = gas.line.velocity.col(0);
    Eigen::ArrayXd order = ring ? velocity : velocity.abs();
    std::sort(order.begin(), order.end());
    const auto last = static_cast<double>(order.size() - 1);
    double sum = 0.0;
    for (Index k = 0; k < order.size(); ++k) {
        const auto below = static_cast<double>(k);
        sum += order[k] * (ring ? below - (last - below) : below);
    }
    return sum;
}

// The sum over neighbours of half their mean relative speed, times the density of the gap between
// them at 0 and the length that the beads leave free. This length is divided at random into one gap
// more than there are beads between walls, and as many on a ring.
double speed_of_neighbours(const BoxedGas& gas) {
    const Beads order = beads_along(gas.line, 0);
    const std::size_t count = order.size(), ring = gas.box.is_periodic(0) ? 1 : 0;
    const double t = gas.thermal.temperature(), factor = mean_speed_factor(gas.freedoms());
    const auto inverse_mass = [&](std::size_t k) {
        return gas.particles->inverse_mass[order[k % count].second];
    };
    double sum = 0.0;
    for (std::size_t k = 1; k < count + ring; ++k)
        sum += factor * std::sqrt(2.0 * t * (inverse_mass(k - 1) + inverse_mass(k)) / pi);
    return 0.5 * sum * static_cast<double>(count - ring);
}

double rate_on_line(const BoxedGas& gas) {
    const Particles& particles = *gas.particles;
    const double room = gas.box.size[0] * (1.0 - packing_fraction(gas.box, particles));
    const bool equal = (particles.inverse_mass == particles.inverse_mass[0]).all();
    return (equal ? rate_of_exchange(gas) : speed_of_neighbours(gas)) / room;
}

}  // namespace

double contact_correlation(const Box& box, const Particles& particles, double radius,
                           double other_radius) {
    return Mixture(box, particles).at_contact(radius, other_radius);
}

double packing_fraction(const Box& box, const Particles& particles) {
    return sum_of_sizes(box, particles.radius) / box.content();
}

double cross_section(double contact, int dimension) {
    return dimension == 1 ? 1.0 : content_of_ball(contact, dimension - 1);
}

double cross_sections(const Eigen::ArrayXd& radii, int dimension) {
    double sum = 0.0;
    for (const double radius : radii) sum += cross_section(2.0 * radius, dimension);
    return sum;
}

double dilute_free_path(double content, double cross_sections) {
    return content / (std::numbers::sqrt2 * cross_sections);
}

double diffusion_of_spheres(double density, double diameter, double temperature, double mass,
                            double side) {
    // What Chapman and Enskog's series add to their first order.
    constexpr double of_diffusion = 1.01896, of_viscosity = 1.016;
    const double packing = density * content_of_ball(0.5 * diameter, 3);
    const double contact =
        (compressibility_factor(3, EquationOfState::accurate, packing) - 1.0) / (4.0 * packing);
    const double enskog = of_diffusion * 0.375 * std::sqrt(temperature / (pi * mass)) /
                          (density * diameter * diameter * contact);
    const double x = density * diameter * diameter * diameter / std::numbers::sqrt2;
    const double covered = 4.0 * packing;
    const double viscosity = of_viscosity * 0.3125 * std::sqrt(mass * temperature / pi) /
                             (diameter * diameter) *
                             (1.0 / contact + covered * (0.8 + 0.761 * covered * contact));
    const double unbounded = enskog * (1.0 + x * (0.05403 + x * (6.3656 - 10.9425 * x)));
    return unbounded -
           2.837297 * temperature / (6.0 * pi * (viscosity + mass * density * unbounded) * side);
}

double collisions_per_time(const BoxedGas& gas) {
    return gas.box.dimension == 1 ? rate_on_line(gas) : rate_of_collisions(gas);
}

}  // namespace carom

#include "physics/mechanics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <variant>

namespace carom {
namespace {

double mass_of(double inverse) {
    double best = 1.0 / inverse;
    if (!std::isfinite(best)) return best;
    std::size_t shortest = fmt::format("{}", best).size();
    for (const double towards : {0.0, std::numeric_limits<double>::infinity()}) {
        const double near = std::nextafter(1.0 / inverse, towards);
        const std::size_t digits = fmt::format("{}", near).size();
        if (1.0 / near != inverse || digits >= shortest) continue;
        best = near;
        shortest = digits;
    }
    return best;
}

// Masses, with 0 in place of infinite ones.
Eigen::ArrayXd finite_masses(const Particles& particles) {
    return (particles.inverse_mass > 0.0).select(1.0 / particles.inverse_mass, 0.0);
}

// `counted`: 1 for the particles of finite mass that are looked at, 0 for others. Those that are
// absent count for nothing.
ThermalMotion motion_of(const Box& box, const Particles& particles, const Sample& sample,
                        Eigen::ArrayXd counted) {
    Eigen::ArrayXd mass = finite_masses(particles);
    if (sample.membership)
        for (Eigen::ArrayXd* each : {&mass, &counted})
            *each = sample.membership->is_present.select(*each, 0.0);
    ThermalMotion motion;
    for (Eigen::Index a = 0; a < sample.velocity.cols(); ++a) {
        const auto v = sample.velocity.col(a);
        const bool conserved = conserves_momentum(box, particles, a);
        const double drift = conserved ? sum_in_order(mass * v) / sum_in_order(mass) : 0.0;
        motion.energy += 0.5 * sum_in_order(counted * mass * (v - drift).square());
        motion.degrees_of_freedom += sum_in_order(counted);
        if (conserved)
            motion.degrees_of_freedom -= sum_in_order(counted * mass) / sum_in_order(mass);
    }
    return motion;
}

}  // namespace

// With four partial sums, which the compiler can vectorize.
double sum_in_order(const Eigen::ArrayXd& values) {
    const Eigen::Index count = values.size(), in_fours = count / 4 * 4, in_pairs = count / 2 * 2;
    std::array<double, 4> sums{};
    for (Eigen::Index i = 0; i < in_fours; i += 4)
        for (Eigen::Index k = 0; k < 4; ++k) sums[static_cast<std::size_t>(k)] += values[i + k];
    std::array<double, 2> pair{sums[0] + sums[2], sums[1] + sums[3]};
    if (in_fours < in_pairs) {
        pair[0] += values[in_fours];
        pair[1] += values[in_fours + 1];
    }
    const double sum = pair[0] + pair[1];
    return in_pairs < count ? sum + values[in_pairs] : sum;
}

Eigen::ArrayXd masses(const Particles& particles) {
    Eigen::ArrayXd result(particles.count());
    for (Eigen::Index i = 0; i < result.size(); ++i)
        result[i] = i > 0 && particles.inverse_mass[i] == particles.inverse_mass[i - 1]
                        ? result[i - 1]
                        : mass_of(particles.inverse_mass[i]);
    return result;
}

bool infinite_mass_moves(const Particles& particles, const Sample& sample) {
    return ((sample.velocity != 0.0).rowwise().any() && particles.inverse_mass == 0.0).any();
}

double mean_over_finite_masses(const Particles& particles, const Eigen::ArrayXd& energies) {
    const auto finite = particles.inverse_mass > 0.0;
    return finite.select(energies, 0.0).sum() / static_cast<double>(finite.count());
}

double mean_of_speeds(const Particles& particles, const Eigen::ArrayXd& speeds) {
    return (particles.inverse_mass > 0.0).any() ? mean_over_finite_masses(particles, speeds)
                                                : speeds.mean();
}

Vec impulse_of(const Particles& particles, const Collision& collision) {
    const double inverse = particles.inverse_mass[collision.first];
    if (inverse > 0.0) return (collision.first_before - collision.first_after) / inverse;
    const double other =
        collision.second.is_particle() ? particles.inverse_mass[collision.second.particle()] : 0.0;
    if (other > 0.0) return (collision.second_after - collision.second_before) / other;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown};
}

Eigen::ArrayXd momentum(const Particles& particles, const Sample& sample) {
    const Eigen::ArrayXd mass = 1.0 / particles.inverse_mass;
    Eigen::ArrayXd sum(sample.velocity.cols());
    for (Eigen::Index a = 0; a < sum.size(); ++a) {
        const auto v = sample.velocity.col(a);
        sum[a] = (v != 0.0).select(mass * v, 0.0).sum();
    }
    return sum;
}

bool conserves_momentum(const Box& box, Eigen::Index axis) {
    const Surfaces& surfaces = box.surfaces;
    if (!box.is_periodic(axis) || surfaces.gravity[axis] != 0.0 || !surfaces.obstacles.empty())
        return false;
    for (std::size_t side = 0; side < surfaces.numbered_sides().size(); ++side)
        if (box.has_surface(side) && !box.is_periodic(side / 2) && !is_smooth(surfaces.sides[side]))
            return false;
    return std::ranges::none_of(surfaces.partitions, [&](const Partition& line) {
        return line.axis == axis || !line.gaps.empty() || !is_smooth(line.behaviour);
    });
}

bool conserves_momentum(const Box& box, const Particles& particles, Eigen::Index axis) {
    return (particles.inverse_mass > 0.0).all() && conserves_momentum(box, axis);
}

ThermalMotion thermal_motion(const Box& box, const Particles& particles, const Sample& sample) {
    return motion_of(box, particles, sample, (particles.inverse_mass > 0.0).cast<double>());
}

ThermalMotion thermal_motion(const Box& box, const Particles& particles, const Sample& sample,
                             const std::vector<Eigen::Index>& members) {
    Eigen::ArrayXd counted = Eigen::ArrayXd::Zero(particles.count());
    for (const Eigen::Index i : members) counted[i] = particles.inverse_mass[i] > 0.0;
    return motion_of(box, particles, sample, counted);
}

}  // namespace carom

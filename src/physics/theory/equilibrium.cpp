#include "physics/theory/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "physics/placement/members.h"
#include "physics/theory/theory.h"

namespace carom {
namespace {

using Why = NoEquilibrium::Why;

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
            groups.push_back({mass, 1.0, 1.0});
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

// Whether all beads of finite mass lie in a single stretch between beads that never move.
bool beads_are_together(const Box& box, const Particles& particles, const Sample& sample) {
    const Beads order = beads_along(sample, 0);
    const auto moves = [&](std::size_t k) { return particles.inverse_mass[order[k].second] > 0.0; };
    int stretches = moves(0) && !(box.is_periodic(0) && moves(order.size() - 1)) ? 1 : 0;
    for (std::size_t k = 1; k < order.size(); ++k) stretches += moves(k) && !moves(k - 1);
    return stretches <= 1;
}

// Additional reasons on a line; `momentum`: whether momentum is conserved.
std::optional<NoEquilibrium> why_not_on_line(const Box& box, const Particles& particles,
                                             const Sample& sample, bool momentum) {
    const auto finite = particles.inverse_mass > 0.0;
    const double lightest = particles.inverse_mass.maxCoeff();
    if ((finite.select(particles.inverse_mass, lightest) == lightest).all())
        return NoEquilibrium{.why = Why::equal_masses};
    if (finite.count() < (momentum ? 4 : 3))
        return NoEquilibrium{.why = momentum ? Why::few_on_ring : Why::few_between_ends};
    if (!beads_are_together(box, particles, sample)) return NoEquilibrium{.why = Why::parted};
    return std::nullopt;
}

bool drifts(const Eigen::ArrayXd& masses, const Sample& sample, double energy) {
    const Eigen::RowVectorXd momentum = masses.matrix().transpose() * sample.velocity.matrix();
    return 0.5 * momentum.squaredNorm() / masses.sum() > negligible_share * energy;
}

std::optional<NoEquilibrium> why_not(const Box& box, const Particles& particles,
                                     const Sample& sample) {
    if (!box.surfaces.are_plain()) return NoEquilibrium{.why = Why::surfaces};
    const auto finite = particles.inverse_mass > 0.0;
    const Eigen::ArrayXd square_speed = sample.velocity.square().rowwise().sum();
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (!finite[i] && square_speed[i] > 0.0)
            return NoEquilibrium{.why = Why::moving_infinite_mass,
                                 .species = static_cast<std::size_t>(particles.species[i])};
    const bool along_x = conserves_momentum(box, particles, 0),
               along_y = conserves_momentum(box, particles, 1);
    if (box.dimension == 2 && along_x != along_y)
        return NoEquilibrium{.why = along_x ? Why::momentum_along_x : Why::momentum_along_y};
    const Eigen::Index count = finite.count();
    if (count == 0) return NoEquilibrium{.why = Why::no_finite_mass};
    if (count == 1) return NoEquilibrium{.why = Why::alone};
    if (along_x && count == 2) return NoEquilibrium{.why = Why::pair};
    const Eigen::ArrayXd masses = finite.select(particles.inverse_mass.inverse(), 0.0);
    const double energy = 0.5 * (masses * square_speed).sum();
    if (!(energy > 0.0)) return NoEquilibrium{.why = Why::at_rest};
    if (along_x && drifts(masses, sample, energy)) return NoEquilibrium{.why = Why::drifts};
    if (box.dimension == 2 && !(particles.radius > 0.0).all())
        return NoEquilibrium{.why = Why::points};
    if (box.dimension == 1) return why_not_on_line(box, particles, sample, along_x);
    return std::nullopt;
}

// Sets the positions of listed particles. If other particles are placed later, beads of infinite
// mass are assumed not to separate those that move.
void set_known_places(const Gas& gas, const Particles& particles, Sample& sample) {
    for_each_listed(gas, [&](std::size_t, Eigen::Index i, const Eigen::Array2d& place) {
        sample.position.row(i) = place.head(gas.box.dimension).transpose();
    });
    const bool all_listed = std::ranges::all_of(gas.species, [](const Species& species) {
        return species.count == 0 || has_position<Places>(species);
    });
    if (!all_listed) sample.position.col(0) = (particles.inverse_mass > 0.0).cast<double>();
}

}  // namespace

std::optional<EquilibriumGas> equilibrium(const Box& box, const Particles& particles,
                                          const Sample& sample, const std::vector<int>& species) {
    if (why_not(box, particles, sample)) return std::nullopt;
    const auto finite = particles.inverse_mass > 0.0;
    const bool momentum = conserves_momentum(box, particles, 0);
    const Eigen::ArrayXd masses = finite.select(particles.inverse_mass.inverse(), 0.0);
    const Eigen::ArrayXd square_speed = sample.velocity.square().rowwise().sum();
    EquilibriumGas gas;
    gas.energy = 0.5 * (masses * square_speed).sum();
    gas.alpha = 0.5 * box.dimension;
    gas.beta = gas.alpha * (static_cast<double>(finite.count()) - (momentum ? 2.0 : 1.0));
    std::vector<double> found;
    for (const double mass : masses)
        if (mass > 0.0) found.push_back(mass);
    gas.groups = group_by_mass(std::move(found));
    if (momentum)
        for (MassGroup& group : gas.groups) group.largest_share = 1.0 - group.mass / masses.sum();
    if (species.empty()) return gas;
    std::vector<Eigen::Index> chosen;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (std::ranges::find(species, particles.species[i]) != species.end()) chosen.push_back(i);
    return among(gas, particles, chosen);
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

std::optional<NoEquilibrium> why_no_equilibrium(const Gas& gas) {
    auto drawn = try_draw_gas(gas);
    if (!drawn) return std::nullopt;
    auto& [particles, sample] = *drawn;
    set_known_places(gas, particles, sample);
    return why_not(gas.box, particles, sample);
}

std::string to_text(const NoEquilibrium& reason, const Gas& gas) {
    switch (reason.why) {
        case Why::moving_infinite_mass: {
            const std::string& name = gas.species[reason.species].name;
            return (name.empty() ? "a particle of infinite mass"
                                 : fmt::format("`{}` has infinite mass and", name)) +
                   " moves, so that energy is not conserved";
        }
        case Why::surfaces:
            return "walls that act, obstacles or gravity change it";
        case Why::momentum_along_x:
        case Why::momentum_along_y:
            return fmt::format(
                "the box is periodic along {} only, so that momentum is conserved "
                "along one axis and not along the other",
                reason.why == Why::momentum_along_x ? "x" : "y");
        case Why::no_finite_mass:
            return "no particle has a finite mass";
        case Why::alone:
            return "a single particle has nothing to share its energy with";
        case Why::pair:
            return "in a periodic box two particles keep the energy that they have between them";
        case Why::at_rest:
            return "all particles are at rest";
        case Why::drifts:
            return "it moves as a whole; the momentum of the given velocities is not zero";
        case Why::points:
            return "points in a plane never meet";
        case Why::equal_masses:
            return "on a wire particles of equal mass only exchange their velocities";
        case Why::few_between_ends:
            return "between walls fewer than three beads need not be ergodic";
        case Why::few_on_ring:
            return "on a ring fewer than four beads need not be ergodic";
        case Why::parted:
            return "beads that never move separate those that do";
    }
    return {};
}

}  // namespace carom

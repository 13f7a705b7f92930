#include "panels/instruments/flux_theory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/mechanics.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/theory.h"

namespace carom {
namespace {

// Beyond these limits the theory of dilute gases has errors of more than a few per cent.
struct DiluteGas {
    static constexpr double densest = 0.05;      // share of the area that disks fill
    static constexpr double paths = 2.0;         // least free path over the width that a gap leaves
    static constexpr double widest_gaps = 0.25;  // share of a partition
};

double packing(const Box& box, const Particles& particles) {
    return (std::numbers::pi * particles.radius.square()).sum() / (box.size[0] * box.size[1]);
}

// A flux that is constant in time.
class EvenFlux : public FluxTheory {
  public:
    explicit EvenFlux(FluxRates rates) : rates_(rates) {}
    std::array<FluxRates, 2> at(const FrameInput&) override { return {rates_, rates_}; }

  private:
    FluxRates rates_;
};

// In each direction the rate of a particle is half of the mean |v| along the axis over the length
// available to it; in the plane this mean is 2 / pi of the mean speed. Crossing particles are
// weighted with their speed, so that their mean share of the energy is larger: (d + 1) / 2 out of
// alpha + beta + 1/2.
std::unique_ptr<FluxTheory> even_flux(const PanelContext& context, const CrossedLine& line,
                                      const std::vector<Eigen::Index>& members) {
    const Box& box = context.scene.gas.box;
    if (!context.equilibrium || line.between || members.empty()) return nullptr;
    const bool is_line = box.dimension == 1, is_periodic = box.is_periodic(line.axis);
    const Eigen::ArrayXd& radius = context.particles.radius;
    const double r = radius[members.front()];
    const bool has_one_radius =
        std::ranges::all_of(members, [&](Eigen::Index i) { return radius[i] == r; });
    double length = box.length(line.axis);
    if (!is_periodic) {
        if (is_line ? radius.maxCoeff() > 0.0
                    : packing(box, context.particles) > DiluteGas::densest)
            return nullptr;
        if (!has_one_radius) return nullptr;
        length -= 2.0 * r;
        if (line.at < 8.0 * r || line.at > box.length(line.axis) - 8.0 * r) return nullptr;
    }
    const auto gas = among(*context.equilibrium, context.particles, members);
    if (!gas) return nullptr;
    double rate = 0.0, energy = 0.0;
    const double freedom = 0.5 * (box.dimension + 1);
    for (const MassGroup& group : gas->groups) {
        EquilibriumGas one = *gas;
        one.groups = {group};
        const double along = mean_speed(one) * (is_line ? 1.0 : 2.0 / std::numbers::pi);
        const double crossing = 0.5 * group.count * along / length;
        rate += crossing;
        energy +=
            crossing * gas->energy * group.largest_share * freedom / (gas->alpha + gas->beta + 0.5);
    }
    return std::make_unique<EvenFlux>(FluxRates{rate, energy});
}

// The flux through gaps, from each side by its own number and temperature.
class GapFlux : public FluxTheory {
  public:
    GapFlux(const PanelContext& context, const CrossedLine& line, std::int32_t partition,
            const std::vector<Eigen::Index>& members)
        : context_(context),
          line_(line),
          partition_(static_cast<std::size_t>(partition)),
          is_member_(static_cast<std::size_t>(context.particles.count())) {
        for (const Eigen::Index i : members) is_member_[static_cast<std::size_t>(i)] = true;
        for (const auto& [from, to] : context.scene.gas.box.surfaces.partition(partition)->gaps)
            gaps_.push_back(to - from);
    }

    std::array<FluxRates, 2> at(const FrameInput& o) override {
        const Box& box = context_.scene.gas.box;
        if (o.advanced.surfaces.at(partition_).is_open)
            return {FluxRates{NAN, NAN}, FluxRates{NAN, NAN}};
        std::array<std::vector<Eigen::Index>, 2> sides;
        for (Eigen::Index i = 0; i < o.sample.position.rows(); ++i)
            sides[o.sample.position(i, line_.axis) < line_.at ? 0 : 1].push_back(i);
        std::array<FluxRates, 2> rates{FluxRates{NAN, NAN}, FluxRates{NAN, NAN}};
        for (std::size_t side = 0; side < 2; ++side) {
            const double width = side == 0 ? line_.at : box.length(line_.axis) - line_.at;
            if (!is_like_equilibrium(sides.at(side), width)) continue;
            const double temperature =
                thermal_motion(box, context_.particles, o.sample, sides.at(side)).temperature();
            double sum = 0.0;
            for (const Eigen::Index i : sides.at(side)) sum += rate_of(i, width, temperature);
            rates.at(side) = {sum, 1.5 * temperature * sum};
        }
        return rates;
    }

  private:
    // Whether particles collide with each other before they have crossed their side, but reach a
    // gap one by one: the mean free path must lie between these two lengths.
    bool is_like_equilibrium(const std::vector<Eigen::Index>& side, double width) const {
        double diameters = 0.0;
        for (const Eigen::Index i : side) diameters += 2.0 * context_.particles.radius[i];
        if (side.size() < 2) return false;
        const double area = width * context_.scene.gas.box.length(1 - line_.axis);
        const double path = dilute_free_path(area, diameters);
        const double least = 2.0 * context_.particles.radius.minCoeff();
        return path <= width && path >= DiluteGas::paths * (std::ranges::max(gaps_) - least);
    }

    // The rate of one particle: its centre can move in the room of the side that its radius leaves,
    // and pass the part of a gap that its radius leaves.
    double rate_of(Eigen::Index i, double width, double temperature) const {
        const double r = context_.particles.radius[i];
        const double inverse_mass = context_.particles.inverse_mass[i];
        if (!is_member_[static_cast<std::size_t>(i)] || inverse_mass == 0.0) return 0.0;
        double gap = 0.0;
        for (const double each : gaps_) gap += std::max(0.0, each - 2.0 * r);
        const double room =
            (width - 2.0 * r) * (context_.scene.gas.box.length(1 - line_.axis) - 2.0 * r);
        return gap / room * std::sqrt(temperature * inverse_mass / (2.0 * std::numbers::pi));
    }

    PanelContext context_;
    CrossedLine line_;
    std::size_t partition_;
    std::vector<bool> is_member_;
    std::vector<double> gaps_;
};

bool reflects(const Behaviour& behaviour) { return std::holds_alternative<Reflecting>(behaviour); }

bool changes_surface(const RunEvent& event) {
    return std::holds_alternative<ChangeSurface>(event.action) ||
           std::holds_alternative<MoveSurface>(event.action);
}

std::unique_ptr<FluxTheory> gap_flux(const PanelContext& context, const CrossedLine& line,
                                     std::int32_t number,
                                     const std::vector<Eigen::Index>& members) {
    const Box& box = context.scene.gas.box;
    const Surfaces& surfaces = box.surfaces;
    const Partition& partition = *surfaces.partition(number);
    double gaps = 0.0;
    for (const auto& [from, to] : partition.gaps) gaps += to - from;
    const bool is_still = reflects(partition.behaviour) &&
                          std::ranges::all_of(surfaces.sides, reflects) &&
                          std::ranges::none_of(context.scene.run.events, changes_surface);
    if (!is_still || surfaces.partitions.size() > 1 || !surfaces.obstacles.empty() ||
        (surfaces.gravity != 0.0).any() || box.is_periodic(0) || box.is_periodic(1) ||
        !(gaps > 0.0) || gaps > DiluteGas::widest_gaps * box.length(1 - line.axis) ||
        packing(box, context.particles) > DiluteGas::densest)
        return nullptr;
    return std::make_unique<GapFlux>(context, line, number, members);
}

}  // namespace

std::unique_ptr<FluxTheory> flux_theory(const PanelContext& context, const CrossedLine& line,
                                        std::optional<std::int32_t> partition,
                                        const std::vector<Eigen::Index>& members) {
    if ((context.particles.inverse_mass == 0.0).any()) return nullptr;  // they are in the way
    return partition ? gap_flux(context, line, *partition, members)
                     : even_flux(context, line, members);
}

}  // namespace carom

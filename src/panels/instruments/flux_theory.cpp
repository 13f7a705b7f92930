#include "panels/instruments/flux_theory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/mechanics.h"
#include "physics/theory/collision_rate.h"

namespace carom {
namespace {

// Beyond this limit, too, the theory of dilute gases has errors of more than a few per cent.
struct DiluteGas {
    static constexpr double paths = 2.0;  // least free path over the width that a gap leaves
};

// A flux that is constant in time.
class EvenFlux : public FluxTheory {
  public:
    explicit EvenFlux(FluxRates rates) : rates_(rates) {}
    std::array<FluxRates, 2> at(const FrameInput&) override { return {rates_, rates_}; }

  private:
    FluxRates rates_;
};

// The flux through gaps, from each side by its own number and temperature.
class GapFlux : public FluxTheory {
  public:
    GapFlux(const PanelContext& context, const CrossedLine& line, std::int32_t partition,
            const std::vector<Eigen::Index>& members)
        : context_(context),
          line_(line),
          partition_(static_cast<std::size_t>(partition)),
          gaps_(context.box().surfaces.partition(partition)->gaps),
          is_member_(static_cast<std::size_t>(context.particles.count())) {
        for (const Eigen::Index i : members) is_member_[static_cast<std::size_t>(i)] = true;
    }

    std::array<FluxRates, 2> at(const FrameInput& o) override {
        const Box& box = context_.box();
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
            // They cross in proportion to their velocity along the axis.
            rates.at(side) = {sum, 0.5 * (box.dimension + 1) * temperature * sum};
        }
        return rates;
    }

  private:
    // Whether particles collide with each other before they have crossed their side, but reach a
    // gap one by one: the mean free path must lie between these two lengths.
    bool is_like_equilibrium(const std::vector<Eigen::Index>& side, double width) const {
        if (side.size() < 2) return false;
        const Box& box = context_.box();
        const double room = width * box.content_across(line_.axis);
        const double path =
            dilute_free_path(room, cross_sections(context_.particles.radius(side), box.dimension));
        const double least = 2.0 * context_.particles.radius.minCoeff();
        double widest = 0.0;
        for (const Gap& gap : gaps_) widest = std::max(widest, gap.widest(box.dimension));
        return path <= width && path >= DiluteGas::paths * (widest - least);
    }

    // The rate of one particle: its centre can move in the room of the side that its radius leaves,
    // and pass the part of a gap that its radius leaves.
    double rate_of(Eigen::Index i, double width, double temperature) const {
        const double r = context_.particles.radius[i];
        const double inverse_mass = context_.particles.inverse_mass[i];
        if (!is_member_[static_cast<std::size_t>(i)] || inverse_mass == 0.0) return 0.0;
        const Box& box = context_.box();
        double open = 0.0, room = width - 2.0 * r;
        for (const Gap& gap : gaps_) open += gap.extent(box.dimension, r);
        for (int axis = 0; axis < box.dimension; ++axis)
            if (axis != line_.axis) room *= box.length(axis) - 2.0 * r;
        return open / room * std::sqrt(temperature * inverse_mass / (2.0 * std::numbers::pi));
    }

    PanelContext context_;
    CrossedLine line_;
    std::size_t partition_;
    std::vector<Gap> gaps_;
    std::vector<bool> is_member_;
};

}  // namespace

std::unique_ptr<FluxTheory> flux_theory(const PanelContext& context, const CrossedLine& line,
                                        std::optional<std::int32_t> partition,
                                        const std::vector<Eigen::Index>& members) {
    if (partition) {
        if (!law(context.gas, LawOf::gap_flux, {.surface = *partition})) return nullptr;
        return std::make_unique<GapFlux>(context, line, *partition, members);
    }
    const Law found =
        law(context.gas, LawOf::flux,
            {.of = members, .axis = line.axis, .at = line.at, .is_whole_line = !line.between});
    if (!found) return nullptr;
    return std::make_unique<EvenFlux>(FluxRates{found.value, found.energy});
}

}  // namespace carom

// The histogram of velocity components of particles, with the equilibrium distribution of this
// finite gas.
#include "panels/plots/histogram_panel.h"
#include "panels/registry.h"
#include "physics/gas.h"
#include "physics/theory/theory.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

// The numbers of a particle that are counted.
int velocities_each(const PanelSpec& panel, const Gas& gas) {
    return panel.component.value_or(Component::both) == Component::both ? gas.box.dimension : 1;
}

std::unique_ptr<Panel> make_velocity_histogram(const PanelContext& context, const PanelSpec& spec) {
    const Component component = spec.component.value_or(Component::both);
    const bool both = component == Component::both;
    const int dimension = context.box().dimension;  // as often a particle counts with `both`
    const Eigen::Index first = axis_of(spec);
    HistogramSubject subject{
        .title = both && dimension > 1 ? Phrase{"Distribution of velocity components"}
                                       : Phrase{"Velocity distribution"},
        .quantity =
            quantities::velocity.named(both                        ? Phrase{"velocity"}
                                       : component == Component::x ? Phrase{"velocity along x"}
                                       : component == Component::y ? Phrase{"velocity along y"}
                                                                   : Phrase{"velocity along z"}),
        .values = {},
        .density = {},
        .symmetric = true,
        .means = false,
        .tested = TestedQuantity::velocity};
    const std::optional<int> along = both ? std::nullopt : std::optional(static_cast<int>(first));
    subject.density = [along](const EquilibriumGas& gas, double v) {
        return velocity_density(gas, v, along);
    };
    subject.values = [both, first](const FrameInput& o) {
        return both ? values_in(o.sample.velocity) : values_in(o.sample.velocity, first);
    };
    subject.courses = [first, last = both ? dimension - 1 : first](const PathPiece& piece,
                                                                   const auto& take) {
        for (Eigen::Index axis = first; axis <= last; ++axis)
            take({piece.from, piece.to, {piece.velocity[axis], piece.acceleration[axis], 0.0}});
    };
    return std::make_unique<HistogramPanel>(context, spec, std::move(subject));
}

}  // namespace

PanelKind velocity_histogram_kind() {
    using enum Ability;
    return histogram_kind(
        {.name = "velocity-histogram",
         .words = Phrase{"velocity histogram"},
         .shows = "A histogram of the velocities along one axis, or of both components together, "
                  "with the equilibrium distribution.",
         .make = make_velocity_histogram,
         .abilities = {bars, of, over, component, both, theory, equilibrium, means, comparison}},
        quantities::velocity, false, velocities_each);
}

}  // namespace carom

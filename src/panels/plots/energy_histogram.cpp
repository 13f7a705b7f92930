// The histogram of the kinetic energies of particles, with the equilibrium distribution of this
// finite gas.
#include "panels/plots/histogram_panel.h"
#include "panels/registry.h"
#include "physics/theory/theory.h"
#include "scene/panel_kind.h"
#include "stats/paths/course.h"

namespace carom {
namespace {

std::unique_ptr<Panel> make_energy_histogram(const PanelContext& context, const PanelSpec& spec) {
    HistogramSubject subject{.title = Phrase{"Energy distribution"},
                             .quantity = quantities::energy,
                             .values = [](const FrameInput& o) { return values_in(o.energy); },
                             .density = energy_density,
                             .tested = TestedQuantity::energy,
                             .colored_by = ColorBy::energy};
    subject.courses = [inverse = context.particles.inverse_mass](const PathPiece& piece,
                                                                 const auto& take) {
        take(square_of_speed(piece, 0.5 / inverse[piece.particle]));
    };
    if (context.box().dimension == 1)  // infinite at 0
        subject.probability = energy_probability;
    return std::make_unique<HistogramPanel>(context, spec, std::move(subject));
}

}  // namespace

PanelKind energy_histogram_kind() {
    using enum Ability;
    return histogram_kind(
        {.name = "energy-histogram",
         .words = Phrase{"energy histogram"},
         .shows = "A histogram of the kinetic energies of the particles, with the equilibrium "
                  "distribution.",
         .make = make_energy_histogram,
         .abilities = {bars, of, over, theory, equilibrium, means, comparison, any_space},
         .tried_as = {"energy"}},
        quantities::energy, true);
}

}  // namespace carom

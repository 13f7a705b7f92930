// The histogram of the speeds of particles, with the equilibrium distribution of this finite gas.
#include "panels/plots/histogram_panel.h"
#include "panels/registry.h"
#include "physics/theory/theory.h"
#include "scene/panel_kind.h"
#include "stats/paths/course.h"

namespace carom {
namespace {

std::unique_ptr<Panel> make_speed_histogram(const PanelContext& context, const PanelSpec& spec) {
    HistogramSubject subject{.title = Phrase{"Speed distribution"},
                             .quantity = quantities::speed,
                             .values = [](const FrameInput& o) { return values_in(o.speed); },
                             .courses =
                                 [](const PathPiece& piece, const auto& take) {
                                     Course course = square_of_speed(piece, 1.0);
                                     course.is_root = true;
                                     take(course);
                                 },
                             .density = speed_density,
                             .tested = TestedQuantity::speed,
                             .colored_by = ColorBy::speed};
    return std::make_unique<HistogramPanel>(context, spec, std::move(subject));
}

}  // namespace

PanelKind speed_histogram_kind() {
    using enum Ability;
    return histogram_kind(
        {.name = "speed-histogram",
         .words = Phrase{"speed histogram"},
         .shows = "A histogram of the speeds, now or averaged over a time (`over`), with the "
                  "equilibrium distribution.",
         .make = make_speed_histogram,
         .abilities = {bars, of, over, theory, equilibrium, means, comparison}},
        true);
}

}  // namespace carom

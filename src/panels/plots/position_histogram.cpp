// The histogram of the positions of particles along one axis.
#include "panels/plots/histogram_panel.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "stats/paths/course.h"

namespace carom {
namespace {

std::unique_ptr<Panel> make_position_histogram(const PanelContext& context, const PanelSpec& spec) {
    const Box& box = context.box();
    const Eigen::Index axis = axis_of(spec);
    HistogramSubject subject{
        .title = Phrase{"Distribution of positions"},
        .quantity = quantities::length.named(box.dimension == 1 ? Phrase{"position"}
                                             : axis == 0        ? Phrase{"position along x"}
                                             : axis == 1        ? Phrase{"position along y"}
                                                                : Phrase{"position along z"}),
        .values = [axis](const FrameInput& o) { return values_in(o.sample.position, axis); },
        .courses =
            [axis, period = box.is_periodic(static_cast<int>(axis)) ? box.size[axis] : 0.0](
                const PathPiece& piece, const auto& take) {
                courses_in_box(course_of_place(piece, axis), period, take);
            },
        .extent = std::pair{0.0, box.size[axis]},
        .position_axis = axis,
        .means = false};
    const Law board = law(context.gas, LawOf::binomial, {.axis = static_cast<int>(axis)});
    for (std::size_t k = 0; k < board.places.size(); ++k)
        subject.shares.emplace_back(board.places[k], board.curve[k]);
    if (board) {
        subject.curve = Phrase{"binomial: independent choices"};
        subject.short_curve = Phrase{"binomial"};
    }
    return std::make_unique<HistogramPanel>(context, spec, std::move(subject));
}

}  // namespace

PanelKind position_histogram_kind() {
    using enum Ability;
    return histogram_kind(
        {.name = "position-histogram",
         .words = Phrase{"position histogram"},
         .shows = "A histogram of the positions along one axis; on a Galton board of pegs with the "
                  "binomial distribution that balls would have if each row sent them to the left "
                  "or to the right independently.",
         .make = make_position_histogram,
         .abilities = {bars, of, over, component, means, comparison}},
        quantities::position);
}

}  // namespace carom

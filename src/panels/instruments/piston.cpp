// The position of moving walls and partitions against time. For one free piston over a gas, also
// the mean and the standard deviation that it would have over an ideal gas, and the period of its
// oscillations.
#include <memory>

#include "panels/instruments/measured_surfaces.h"
#include "panels/instruments/piston_over_gas.h"
#include "panels/registry.h"
#include "panels/surfaces/surface_words.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

SeriesSubject piston(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    SeriesSubject subject{{.title = say(language, "Position"), .quantity = quantities::position}};
    const SurfaceNumbers& all = spec.options.as<MovingOptions>().surfaces;
    subject.lines = lines_of_surfaces(language, context.box(), all);
    const auto known = std::make_shared<std::optional<PistonOverGas>>();
    subject.read = [context, surfaces = all, known, is_first = true](const FrameInput& o) mutable {
        if (std::exchange(is_first, false) && surfaces.size() == 1)
            *known = piston_over_gas(context, surfaces.front(), o);
        std::vector<double> places;
        for (const std::int32_t surface : surfaces)
            places.push_back(place_of_surface(context.box(), o.advanced.surfaces,
                                              static_cast<std::size_t>(surface)));
        return places;
    };
    if (spec.theory) {
        subject.levels = [known]() -> ReferenceLevels {
            if (!*known) return {};
            return {ReferenceLevel{"ideal gas, mean", (*known)->mean_place(),
                                   (*known)->law.deviation()}};
        };
        subject.numbers = [known]() -> std::vector<std::vector<MeanError>> {
            if (!*known || !(*known)->period()) return {};
            return {{{*(*known)->period(), 0.0}}};
        };
        subject.add = [language](const HistoryRecord& record, plot::Plot& whole) {
            const auto& numbers = record.runs.front().numbers;
            if (numbers.empty() || record.compares()) return;
            const std::string period = three_digits(language, numbers.front().front().mean);
            whole.notes.push_back(
                {.entries = {{.words = {say(language, "slow oscillations: period {}", period),
                                        say(language, "period {}", period)}}}});
        };
    }
    return subject;
}

}  // namespace

PanelKind piston_kind() {
    using enum Ability;
    return series_kind<piston>(
        {.name = "piston",
         .words = Phrase{"piston"},
         .shows = "The position of moving walls and partitions against time; for a free piston, "
                  "with the mean position over an ideal gas, its standard deviation as a band, and "
                  "the period of the slow oscillations.",
         .abilities = {theory, means, comparison},
         .asked = {{"position", "where it is"}},
         .keys = moving_keys(),
         .rule = check_moving,
         .laws = always(std::vector{LawOf::piston}),
         .measured_at = measured_at(&MovingOptions::surfaces)});
}

}  // namespace carom

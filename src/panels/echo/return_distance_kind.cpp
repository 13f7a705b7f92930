// The kind of the panel in return_distance.cpp.
#include "panels/echo/return_distance.h"
#include "panels/registry.h"
#include "physics/gas.h"
#include "physics/theory/law.h"
#include "scene/panel_kind.h"
#include "scene/reading/panel_reading.h"

namespace carom {
namespace {

std::vector<Binding<ReturnDistanceOptions>> return_distance_keys() {
    return {bind_key("against", &ReturnDistanceOptions::against_collisions,
                     one_of<bool>({{"time", false}, {"collisions", true}}),
                     "The horizontal axis: the time since the reversal, or the mean number of "
                     "collisions per particle since then.")};
}

// Reports a run without a reversal, and a growth law that is asked for although none is known.
void check_return_distance(PanelSpec& panel, const Node& node, Reading& reading) {
    check_reversal(node.is_mapping() ? *given(node, "kind") : node, reading);
    const Node* asked = given(node, "theory");
    if (asked == nullptr || !panel.theory || reading.gas.species.empty()) return;
    if (asked->source->origin == Origin::template_file) return;
    if (const auto reason = why_no_law(reading.gas, reading.run, LawOf::error_growth))
        reading.errors.add(*asked,
                           "the law by which errors grow is not known for this gas: " +
                               to_text(Language::english, *reason, reading.gas.species),
                           "leave out `theory`; the curve is then drawn where there is one");
}

}  // namespace

PanelKind return_distance_kind() {
    using enum Ability;
    return {
        .name = "return-distance",
        .words = Phrase{"return error"},
        .shows = "The deviation from an exact return after a reversal, against time or collisions.",
        .make = make_return_distance,
        .abilities = {theory, comparison},
        .keys = option_keys(return_distance_keys()),
        .rule = check_return_distance,
        .suits = [](const Gas&, const Run& run) { return !reversal_times(run).empty(); },
        .laws = always(std::vector{LawOf::error_growth})};
}

}  // namespace carom

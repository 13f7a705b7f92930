#include "panels/echo/return_distance_keys.h"

#include "physics/theory/error_growth.h"
#include "scene/reading/panel_reading.h"

namespace carom {
std::vector<Binding<PanelSpec>> return_distance_keys() {
    return {bind_key("against", &PanelSpec::against_collisions,
                     one_of<bool>({{"time", false}, {"collisions", true}}),
                     "The horizontal axis: the time since the reversal, or the collisions of each "
                     "particle since then, on average.")};
}

void check_return_distance(PanelSpec& panel, const Node& node, Reading& reading) {
    check_reversal(node.is_mapping() ? *given(node, "kind") : node, reading);
    const Node* asked = given(node, "theory");
    if (asked == nullptr || !panel.theory || reading.gas.species.empty()) return;
    if (asked->source->origin == Origin::template_file) return;
    if (const auto reason = why_no_growth_law(reading.gas))
        reading.errors.add(*asked, *reason,
                           "leave out `theory`; the curve is then drawn where there is one");
}

}  // namespace carom

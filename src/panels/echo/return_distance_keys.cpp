#include "panels/echo/return_distance_keys.h"

#include <algorithm>
#include <array>

#include "scene/reading/panel_reading.h"

namespace carom {
namespace {

// Whether all particles have one radius and one mass, as far as the scene says it in one number.
bool are_equal(const Gas& gas) {
    const auto one_number = [](const Species& species) -> std::optional<std::array<double, 2>> {
        const auto* radius = std::get_if<double>(&species.radius);
        const auto* density = std::get_if<Density>(&species.mass);
        const auto* mass =
            density != nullptr ? &density->value : std::get_if<Quantity>(&species.mass);
        const double* number = mass != nullptr ? std::get_if<double>(mass) : nullptr;
        if (radius == nullptr || number == nullptr) return std::nullopt;
        return std::array{*radius, density != nullptr ? -*number : *number};
    };
    const auto first = one_number(gas.species.front());
    return first && std::ranges::all_of(gas.species, [&](const Species& species) {
               return one_number(species) == first;
           });
}

void check_growth_law(const Node& asked, const Gas& gas, Errors& errors) {
    const std::string hint = "leave out `theory`; the curve is then drawn where there is one";
    if (gas.box.dimension == 1)
        errors.add(asked,
                   "no growth law is known for beads on a wire, where errors grow far more slowly",
                   hint);
    else if (!are_equal(gas))
        errors.add(
            asked,
            "no growth law is known for this gas, only for disks of one radius and one finite mass",
            hint);
}

}  // namespace

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
    if (asked->source->origin != Origin::template_file)
        check_growth_law(*asked, reading.gas, reading.errors);
}

}  // namespace carom

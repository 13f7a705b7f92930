#include "scene/instruments/instrument_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "scene/keys/binding.h"
#include "scene/limits.h"
#include "scene/reading/overlay_reading.h"
#include "util/text.h"

namespace carom {
namespace {

// By their numbers; those that this box does not have are empty.
std::vector<std::string> measurable(const Box& box) {
    std::vector<std::string> names = box.surfaces.names();
    names.resize(static_cast<std::size_t>(box.surfaces.first_obstacle()));
    for (std::size_t side = 0; side < 4; ++side)
        if (side >= static_cast<std::size_t>(2 * box.dimension) ||
            box.is_periodic(static_cast<Eigen::Index>(side / 2)))
            names[side].clear();
    return names;
}

std::vector<std::string> named(const std::vector<std::string>& names) {
    std::vector<std::string> all;
    std::ranges::copy_if(names, std::back_inserter(all),
                         [](const std::string& name) { return !name.empty(); });
    return all;
}

std::optional<std::int32_t> surface_called(const std::string& name, const Node& node,
                                           Reading& reading) {
    const std::vector<std::string> names = measurable(reading.gas.box);
    const auto found = std::ranges::find(names, name);
    if (!name.empty() && found != names.end())
        return static_cast<std::int32_t>(found - names.begin());
    const std::vector<std::string> there = named(names);
    reading.errors.add(node, fmt::format("there is no solid wall or partition {}", in_quotes(name)),
                       there.empty()
                           ? "the box has neither"
                           : spelling_hint(name, there, "there are " + listed(there, "and", "`")));
    return std::nullopt;
}

bool may_move(const Behaviour& behaviour) {
    return std::holds_alternative<Piston>(behaviour) || std::holds_alternative<Driven>(behaviour);
}

// At some time of the run.
bool may_move(const Reading& reading, std::int32_t surface) {
    const Surfaces& surfaces = reading.gas.box.surfaces;
    const Partition* line = surfaces.partition(surface);
    if (may_move(line != nullptr ? line->behaviour
                                 : surfaces.sides[static_cast<std::size_t>(surface)]))
        return true;
    return std::ranges::any_of(reading.run.events, [&](const RunEvent& event) {
        const auto* change = std::get_if<ChangeSurface>(&event.action);
        const auto* move = std::get_if<MoveSurface>(&event.action);
        return (change != nullptr && change->surface == surface && may_move(change->behaviour)) ||
               (move != nullptr && move->surface == surface);
    });
}

const Node& place_of_surfaces(const Node& node) {
    const Node* written = node.is_mapping() ? find(node, "surfaces") : nullptr;
    return written != nullptr ? *written : node;
}

// Those that a panel can measure at; where the scene names none all that there are.
template <class Suits>
void keep_suitable(PanelSpec& panel, const Node& node, Reading& reading, const Suits& suits,
                   const std::string& what, const std::string& hint) {
    const std::vector<std::string> names = measurable(reading.gas.box);
    const bool is_named = node.is_mapping() && find(node, "surfaces") != nullptr;
    if (is_named && panel.surfaces.empty()) return;  // reported
    for (const std::int32_t surface : panel.surfaces)
        if (!suits(surface))
            reading.errors.add(
                place_of_surfaces(node),
                fmt::format("`{}` is not {}", names[static_cast<std::size_t>(surface)], what),
                hint);
    if (is_named) return;
    for (std::size_t k = 0; k < names.size(); ++k)
        if (!names[k].empty() && suits(static_cast<std::int32_t>(k)))
            panel.surfaces.push_back(static_cast<std::int32_t>(k));
    if (panel.surfaces.empty())
        reading.errors.add(node, fmt::format("a panel of kind `{}` needs {}", panel.kind, what),
                           hint);
}

void require_one(PanelSpec& panel, const Node& node, Reading& reading) {
    if (panel.surfaces.size() < 2) return;
    std::vector<std::string> names;
    for (const std::int32_t surface : panel.surfaces)
        names.push_back(reading.gas.box.surfaces.names()[static_cast<std::size_t>(surface)]);
    reading.errors.add(
        place_of_surfaces(node),
        fmt::format("a panel of kind `{}` shows one surface, and there are several", panel.kind),
        "choose one by `surfaces`: " + listed(names, "or", "`"));
}

}  // namespace

Notation<std::vector<std::int32_t>> surfaces_notation() {
    auto name = text(1, most_name_letters).called("the name of a wall or a partition");
    name.forms.front().words = {"left"};
    Notation<std::vector<std::int32_t>> all =
        one_or_list(parsed(name, surface_called), most_chosen, "a list of walls and partitions");
    all.write = [](const std::vector<std::int32_t>&) { return std::string(); };
    return all;
}

Notation<std::vector<NamedRegion>> regions_notation() {
    const KeyTable<NamedRegion> table{
        .name = "a region",
        .keys = {bind_key("name", &NamedRegion::name, text(1, most_name_letters),
                          "What it is called in the picture.")
                     .required(),
                 bind_key("within", &NamedRegion::region, region_notation("within"),
                          "Its corners: [x0, y0, x1, y1], on a wire [x0, x1].")
                     .required()}};
    return list_of(mapping(table, "{name, within: [x0, y0, x1, y1]}"), 1, most_chosen,
                   "a list of {name, within}");
}

void check_pressure_volume(PanelSpec& panel, const Node& node, Reading& reading) {
    keep_suitable(
        panel, node, reading,
        [&](std::int32_t surface) {
            return Surfaces::is_side(surface) && may_move(reading, surface);
        },
        "a wall of the box that moves",
        "give `box.walls` a `velocity`, or a `mass` with a `force`");
    require_one(panel, node, reading);
}

void check_piston(PanelSpec& panel, const Node& node, Reading& reading) {
    keep_suitable(
        panel, node, reading, [&](std::int32_t surface) { return may_move(reading, surface); },
        "a wall or a partition that moves",
        "give it a `mass` or a `velocity`, or an event of the run that moves it");
}

void check_sides(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.regions.empty()) {
        if (!panel.surfaces.empty())
            reading.errors.add(place_of_surfaces(node),
                               "`surfaces` and `regions` exclude one another",
                               "leave one of them out");
        return;
    }
    if (node.is_mapping() && find(node, "regions") != nullptr) return;  // reported
    keep_suitable(
        panel, node, reading, [](std::int32_t surface) { return !Surfaces::is_side(surface); },
        "a partition of the box",
        "add one to `partitions`, or give the panel `regions: [{name: left, within: [x0, y0, x1, "
        "y1]}]`");
    require_one(panel, node, reading);
}

}  // namespace carom

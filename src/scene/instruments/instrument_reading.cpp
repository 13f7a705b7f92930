#include "scene/instruments/instrument_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "physics/surfaces/behaviours.h"
#include "scene/keys/binding.h"
#include "scene/keys/check.h"
#include "scene/limits.h"
#include "scene/reading/overlay_reading.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

// Returns the names of the surfaces at which panels can measure, indexed by surface number; empty
// for those that this box does not have.
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

// Returns whether a surface moves at some time of the run.
bool may_move(const Reading& reading, std::int32_t surface) {
    const auto all = behaviours_in_time(reading.gas.box.surfaces, reading.run);
    return std::ranges::any_of(all.at(static_cast<std::size_t>(surface)), moves);
}

const Node& place_of_surfaces(const Node& node) {
    const Node* written = node.is_mapping() ? find(node, "surfaces") : nullptr;
    return written != nullptr ? *written : node;
}

// Checks that the panel can measure at the surfaces that the scene names; if it names none, takes
// all suitable ones of the box.
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

// Returns whether particles can pass through a surface at some time of the run, while the surface
// stays in one place.
bool lets_through(const Reading& reading, std::int32_t surface) {
    const Partition* line = reading.gas.box.surfaces.partition(surface);
    if (line == nullptr || may_move(reading, surface)) return false;
    if (line->is_open || !line->gaps.empty() || membrane_of(line->behaviour)) return true;
    return std::ranges::any_of(reading.run.events, [&](const RunEvent& event) {
        const auto* set = opening_of(event);
        const auto given = given_behaviour(event);
        return (set != nullptr && set->surface == surface && set->is_open) ||
               (given && given->first == surface && membrane_of(given->second));
    });
}

// Returns the first event of a run that a word stands for: a reversal, heat, or an event that acts
// on the surface of that name.
std::optional<WatchStart> event_called(const std::string& word, const Node& node,
                                       Reading& reading) {
    std::vector<std::string> there{"start"};
    const std::vector<std::string> names = reading.gas.box.surfaces.names();
    const std::vector<RunEvent>& events = reading.run.events;
    for (std::size_t k = 0; k < events.size(); ++k) {
        std::string name;
        if (reverses(events[k])) name = "reversal";
        if (heats(events[k])) name = "heat";
        if (const auto surface = surface_of(events[k])) {
            const auto number = static_cast<std::size_t>(*surface);
            if (number >= names.size()) return std::nullopt;  // of a box with mistakes, reported
            name = names[number];
        }
        if (name == word) return WatchStart{events[k].at, k};
        if (!name.empty() && std::ranges::find(there, name) == there.end()) there.push_back(name);
    }
    reading.errors.add(node, fmt::format("no event of the run is called {}", in_quotes(word)),
                       fmt::format("`since` takes a time{}{}", there.size() == 1 ? " or " : ", ",
                                   listed(there, "or", "`")));
    return std::nullopt;
}

void check_line(const PanelSpec& panel, const Node& node, Reading& reading) {
    if (node.is_mapping() && find(node, "surfaces") != nullptr)
        refuse_together(reading.errors, place_of_surfaces(node), {"surfaces", "line"});
    if (panel.counted == Counted::hits)
        reading.errors.add(*given(node, "count"), "nothing hits a `line`: it is no wall",
                           "leave out `count`, or name walls by `surfaces`");
}

bool is_written(const Node& node, const char* key) {
    return node.is_mapping() && find(node, key) != nullptr;
}

constexpr const char* passable = "a partition that lets particles through and does not move";
const char* how_to_pass(const Box& box) {
    return box.dimension == 1 ? "count at `line: {x: PLACE}`"
                              : "give a partition `gaps` or `passes`, let an event open it, or "
                                "count at `line: {x: PLACE}`";
}

}  // namespace

Notation<CountingLine> counting_line_notation() {
    struct Written {
        std::optional<double> x, y;
        std::optional<TwoNumbers> between;
    };
    const KeyTable<Written> table{
        .name = "`line`",
        .keys = {bind_key("x", &Written::x, number(not_negative),
                          "The x coordinate of a line perpendicular to the x axis."),
                 bind_key("y", &Written::y, number(not_negative),
                          "The y coordinate of a line perpendicular to the y axis."),
                 bind_key("between", &Written::between, pair_of(any_number, "[from, to]"),
                          "Where the line begins and ends along the other axis.")
                     .default_text("across the whole box")},
        .choices = {{{"x", "y"}, true}}};
    const auto complete = [](const Written& written, const Node& node,
                             Reading& reading) -> std::optional<CountingLine> {
        if (written.x.has_value() == written.y.has_value()) return std::nullopt;  // reported
        const Box& box = reading.gas.box;
        CountingLine line{.axis = written.x ? 0 : 1, .at = written.x ? *written.x : *written.y};
        if (line.axis >= box.dimension || (box.dimension == 1 && written.between)) {
            reading.errors.add(node, "on a wire a `line` takes only `x`",
                               "a wire is crossed at a place: {x: 10}");
            return std::nullopt;
        }
        if (box.size[line.axis] > 0.0 && line.at > box.size[line.axis]) {
            reading.errors.add(node, "this line lies outside the box",
                               "the box goes from 0 to its size");
            return std::nullopt;
        }
        if (!written.between) return line;
        line.between = std::pair((*written.between)[0], (*written.between)[1]);
        if (line.between->first < line.between->second) return line;
        reading.errors.add(*given(node, "between"),
                           "expected [from, to] with from < to for `between`",
                           "write the smaller one first");
        return std::nullopt;
    };
    return parsed(mapping(table, "{x: place} or {y: place}"), complete);
}

Notation<WatchStart> watch_start_notation() {
    auto word = text(1, most_name_letters).called("a time or the name of what starts it");
    word.forms.front().words = {"start"};
    const auto read = [](const std::string& what, const Node& node,
                         Reading& reading) -> std::optional<WatchStart> {
        if (what == "start") return WatchStart{};
        const auto time = number_in(node);
        if (!time) return event_called(what, node, reading);
        const double until = reading.run.until;
        if (*time >= 0.0 && !(until > 0.0 && *time >= until)) return WatchStart{.at = *time};
        reading.errors.add(
            node,
            fmt::format("expected a time from 0 on and below `until` ({}) for `since`, found "
                        "{}",
                        until, in_quotes(node.text)),
            "an earlier time; it is simulated time");
        return std::nullopt;
    };
    return parsed(word, read);
}

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
                          "Its name in the picture.")
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
            return reading.gas.box.surfaces.is_side(surface) && may_move(reading, surface);
        },
        "a wall of the box that moves", "give a side in `box.walls` a `velocity` or a `mass`");
    require_one(panel, node, reading);
}

void check_piston(PanelSpec& panel, const Node& node, Reading& reading) {
    keep_suitable(
        panel, node, reading, [&](std::int32_t surface) { return may_move(reading, surface); },
        "a wall or a partition that moves",
        "give it a `mass` or a `velocity`, or an event of the run that moves it");
}

void check_piston_histogram(PanelSpec& panel, const Node& node, Reading& reading) {
    check_piston(panel, node, reading);
    require_one(panel, node, reading);
}

void check_sides(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.regions.empty()) {
        if (!panel.surfaces.empty())
            refuse_together(reading.errors, place_of_surfaces(node), {"surfaces", "regions"});
        return;
    }
    if (node.is_mapping() && find(node, "regions") != nullptr) return;  // reported
    keep_suitable(
        panel, node, reading,
        [&](std::int32_t surface) { return !reading.gas.box.surfaces.is_side(surface); },
        "a partition of the box",
        reading.gas.box.dimension == 1
            ? "give the panel `regions: [{name: left, within: [x0, x1]}]`"
            : "add one to `partitions`, or give the panel `regions: [{name: left, within: [x0, y0, "
              "x1, y1]}]`");
    require_one(panel, node, reading);
}

void check_parts(PanelSpec& panel, const Node& node, Reading& reading) {
    const bool has_surfaces = is_written(node, "surfaces");
    const char* parts = has_surfaces ? "surfaces" : "regions";
    if (!is_written(node, parts)) return;
    const std::vector<const char*> others =
        has_surfaces ? std::vector{"of", "regions", "compare"} : std::vector{"of", "test"};
    for (const char* other : others)
        if (is_written(node, other))
            return refuse_together(reading.errors, *find(node, other), {other, parts});
    if (!has_surfaces) return;
    keep_suitable(
        panel, node, reading,
        [&](std::int32_t surface) {
            return !reading.gas.box.surfaces.is_side(surface) && !may_move(reading, surface);
        },
        "a partition that does not move",
        reading.gas.box.dimension == 1
            ? "name another one, or parts by `regions: [{name: left, within: [x0, x1]}]`"
            : "name another one, or parts by `regions: [{name: left, within: [x0, y0, x1, y1]}]`");
    require_one(panel, node, reading);
}

void check_pressure(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.gauge || is_written(node, "surfaces")) return;
    const std::vector<std::string> names = measurable(reading.gas.box);
    if (std::ranges::none_of(names.begin(),
                             names.begin() + reading.gas.box.surfaces.first_partition(),
                             [](const std::string& name) { return !name.empty(); }))
        reading.errors.add(*given(node, "gauge"), "a gauge needs a solid wall of the box",
                           "make a wall solid, or name a partition by `surfaces`");
}

void check_thermometer(PanelSpec& panel, const Node& node, Reading& reading) {
    if (!panel.regions.empty() && is_written(node, "of"))
        refuse_together(reading.errors, *find(node, "of"), {"of", "regions"});
}

void check_flux(PanelSpec& panel, const Node& node, Reading& reading) {
    if (panel.of.size() > 1)
        reading.errors.add(*find(node, "of"), "a flux takes one item in `of`",
                           "keep one, or give a panel for each");
    if (is_written(node, "line")) return check_line(panel, node, reading);
    keep_suitable(
        panel, node, reading, [&](std::int32_t surface) { return lets_through(reading, surface); },
        passable, how_to_pass(reading.gas.box));
    require_one(panel, node, reading);
}

void check_counter(PanelSpec& panel, const Node& node, Reading& reading) {
    if (is_written(node, "line")) return check_line(panel, node, reading);
    const bool is_named = is_written(node, "surfaces");
    const auto can_pass = [&](std::int32_t surface) { return lets_through(reading, surface); };
    if (!panel.counted) {
        std::vector<std::int32_t> all = panel.surfaces;
        if (!is_named)
            for (std::int32_t k = reading.gas.box.surfaces.first_partition();
                 k < reading.gas.box.surfaces.first_obstacle(); ++k)
                all.push_back(k);
        const bool some = std::ranges::any_of(all, can_pass);
        const bool every = std::ranges::all_of(all, can_pass);
        panel.counted = some && (every || !is_named) ? Counted::crossings : Counted::hits;
    }
    if (panel.counted == Counted::crossings) {
        keep_suitable(panel, node, reading, can_pass, passable, how_to_pass(reading.gas.box));
    } else {
        keep_suitable(
            panel, node, reading,
            [&](std::int32_t surface) {
                return is_named || reading.gas.box.surfaces.is_side(surface);
            },
            "a solid wall of the box", "make a wall solid, or count at `line: {x: PLACE}`");
    }
}

}  // namespace carom

#include "scene/instruments/instrument_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "physics/box.h"
#include "physics/surfaces/behaviours.h"
#include "scene/keys/binding.h"
#include "scene/limits.h"
#include "scene/reading/camera/camera_reading.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

// Returns the names of the surfaces at which panels can measure, indexed by surface number; empty
// for those that this box does not have.
std::vector<std::string> measurable(const Box& box) {
    std::vector<std::string> names = box.surfaces.names();
    names.resize(static_cast<std::size_t>(box.surfaces.first_obstacle()));
    for (std::int32_t side = 0; box.surfaces.is_side(side); ++side)
        if (!box.has_surface(side) || box.is_periodic(side / 2))
            names[static_cast<std::size_t>(side)].clear();
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
    const std::vector<std::string> names = measurable(reading.box());
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

}  // namespace

bool may_move(const Reading& reading, std::int32_t surface) {
    const auto all = behaviours_in_time(reading.box().surfaces, reading.run);
    return std::ranges::any_of(all.at(static_cast<std::size_t>(surface)), moves);
}

bool has_solid_side(const Box& box) {
    const std::vector<std::string> names = measurable(box);
    return std::any_of(names.begin(), names.begin() + box.surfaces.first_partition(),
                       [](const std::string& name) { return !name.empty(); });
}

bool is_written(const Node& node, const char* key) {
    return node.is_mapping() && find(node, key) != nullptr;
}

const Node& place_of_surfaces(const Node& node) {
    const Node* written = node.is_mapping() ? find(node, "surfaces") : nullptr;
    return written != nullptr ? *written : node;
}

void keep_suitable(const PanelSpec& panel, SurfaceNumbers& surfaces, const SuitableSurface& what,
                   const Node& node, Reading& reading) {
    const std::vector<std::string> names = measurable(reading.box());
    const bool is_named = is_written(node, "surfaces");
    if (is_named && surfaces.empty()) return;  // reported
    for (const std::int32_t surface : surfaces)
        if (!what.suits(surface))
            reading.errors.add(
                place_of_surfaces(node),
                fmt::format("`{}` is not {}", names[static_cast<std::size_t>(surface)], what.what),
                what.hint);
    if (is_named) return;
    for (std::size_t k = 0; k < names.size(); ++k)
        if (!names[k].empty() && what.suits(static_cast<std::int32_t>(k)))
            surfaces.push_back(static_cast<std::int32_t>(k));
    if (surfaces.empty())
        reading.errors.add(
            node, fmt::format("a panel of kind `{}` needs {}", panel.kind, what.what), what.hint);
}

void require_one(const PanelSpec& panel, const SurfaceNumbers& surfaces, const Node& node,
                 Reading& reading) {
    if (surfaces.size() < 2) return;
    std::vector<std::string> names;
    for (const std::int32_t surface : surfaces)
        names.push_back(reading.box().surfaces.names()[static_cast<std::size_t>(surface)]);
    reading.errors.add(
        place_of_surfaces(node),
        fmt::format("a panel of kind `{}` shows one surface, and there are several", panel.kind),
        "choose one by `surfaces`: " + listed(names, "or", "`"));
}

bool lets_through(const Reading& reading, std::int32_t surface) {
    const Partition* line = reading.box().surfaces.partition(surface);
    if (line == nullptr || may_move(reading, surface)) return false;
    if (line->is_open || !line->gaps.empty() || membrane_of(line->behaviour)) return true;
    return std::ranges::any_of(reading.run.events, [&](const RunEvent& event) {
        const auto* set = opening_of(event);
        const auto given = given_behaviour(event);
        return (set != nullptr && set->surface == surface && set->is_open) ||
               (given && given->first == surface && membrane_of(given->second));
    });
}

namespace {

// Returns the first event of a run that a word stands for: a reversal, heat, or an event that acts
// on the surface of that name.
std::optional<WatchStart> event_called(const std::string& word, const Node& node,
                                       Reading& reading) {
    std::vector<std::string> there{"start"};
    const std::vector<std::string> names = reading.box().surfaces.names();
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

// The part of a line or a plane at which particles are counted, from its ends or its corners.
std::optional<Gap> counted_part(const std::vector<double>& ends, const Node& node, const Box& box,
                                Errors& errors) {
    const bool is_plane = box.dimension == 2;
    if (ends.size() == (is_plane ? 2U : 4U))
        if (const auto part = region_of(box.dimension - 1, ends))
            return Gap({part->low[0], part->low[1]}, {part->high[0], part->high[1]});
    errors.add(node,
               is_plane ? "expected [from, to] with from < to for `between`"
                        : "expected [a0, b0, a1, b1] with a0 < a1 and b0 < b1 for `between`",
               is_plane ? "write the smaller one first"
                        : "the lower corner of a rectangle, then its upper one, without the "
                          "coordinate that `line` gives");
    return std::nullopt;
}

}  // namespace

Notation<CountingLine> counting_line_notation() {
    struct Written {
        std::optional<double> x, y, z;
        std::optional<std::vector<double>> between;
    };
    const KeyTable<Written> table{
        .name = "`line`",
        .keys =
            {bind_key("x", &Written::x, number(not_negative, quantities::length),
                      "The x coordinate of a line perpendicular to the x axis."),
             bind_key("y", &Written::y, number(not_negative, quantities::length),
                      "The y coordinate of a line perpendicular to the y axis."),
             bind_key("z", &Written::z, number(not_negative, quantities::length),
                      "The z coordinate of a plane perpendicular to the z axis, in a box with "
                      "three lengths."),
             bind_key(
                 "between", &Written::between,
                 list_of(number(any_number, quantities::length), 2, {4}, "[from, to]"),
                 "Where the line begins and ends along the other axis; in space the corners of a "
                 "rectangle in the plane, [a0, b0, a1, b1], in the order x, y, z without "
                 "the axis that `line` gives.")
                 .default_text("across the whole box")},
        .choices = {{{"x", "y", "z"}, true}}};
    const auto complete = [](const Written& written, const Node& node,
                             Reading& reading) -> std::optional<CountingLine> {
        const std::array along{written.x, written.y, written.z};
        const auto first = std::ranges::find_if(along, [](auto at) { return at.has_value(); });
        if (std::ranges::count_if(along, [](auto at) { return at.has_value(); }) != 1)
            return std::nullopt;  // reported
        const Box& box = reading.box();
        CountingLine line{.axis = static_cast<int>(first - along.begin()), .at = **first};
        if (box.dimension == 1 && (line.axis > 0 || written.between)) {
            reading.errors.add(node, "on a wire a `line` takes only `x`",
                               "a wire is crossed at a place: {x: 10}");
            return std::nullopt;
        }
        if (line.axis >= box.dimension) {
            reading.errors.add(node, "a box with two lengths has no z: a `line` takes `x` or `y`",
                               "for instance {x: 10}");
            return std::nullopt;
        }
        if (box.size[line.axis] > 0.0 && line.at > box.size[line.axis]) {
            reading.errors.add(node, "this line lies outside the box",
                               "the box goes from 0 to its size");
            return std::nullopt;
        }
        if (!written.between) return line;
        line.between = counted_part(*written.between, *given(node, "between"), box, reading.errors);
        return line.between ? std::optional(line) : std::nullopt;
    };
    return parsed(mapping(table, "{x: place} or {y: place}"), complete);
}

Notation<WatchStart> watch_start_notation() {
    auto word = text(1, most_name_letters).called("a time or the name of what starts it");
    word.forms.front().words = {"start"};
    word.forms.front().quantity = quantities::time;
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

Notation<SurfaceNumbers> surfaces_notation() {
    auto name = text(1, most_name_letters).called("the name of a wall or a partition");
    name.forms.front().words = {"left"};
    Notation<SurfaceNumbers> all =
        one_or_list(parsed(name, surface_called), most_chosen, "a list of walls and partitions");
    all.write = [](const SurfaceNumbers&) { return std::string(); };
    return all;
}

Notation<std::vector<NamedRegion>> regions_notation() {
    const KeyTable<NamedRegion> table{
        .name = "a region",
        .keys = {
            bind_key("name", &NamedRegion::name, text(1, most_name_letters),
                     "Its name in the picture.")
                .required(),
            bind_key("within", &NamedRegion::region, region_notation("within"),
                     "Its corners: [x0, y0, x1, y1], on a wire [x0, x1], in space [x0, y0, z0, x1, "
                     "y1, z1].")
                .required()}};
    return list_of(mapping(table, "{name, within: [x0, y0, x1, y1]}"), 1, most_chosen,
                   "a list of {name, within}");
}

}  // namespace carom

#include "scene/reading/template.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "scene/scene.h"
#include "scene/time/captions.h"
#include "scene/yaml/file_text.h"
#include "scene/yaml/yaml.h"
#include "util/files/atomic_file.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (fs::directory_iterator entry{folder, ignored}, end; !ignored && entry != end;
         entry.increment(ignored))
        if (entry->path().extension() == ".yaml") names.push_back(entry->path().stem().string());
    std::ranges::sort(names);
    return names;
}

std::string name_without_ending(const std::string& name, const NamedFiles& kind) {
    constexpr std::string_view ending = ".yaml";
    return kind.has_ending && name.ends_with(ending) ? name.substr(0, name.size() - ending.size())
                                                     : name;
}

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

void report_unknown(const Node& asked, const fs::path& scenes, const fs::path& films,
                    const NamedFiles& kind, Errors& errors) {
    const std::vector<std::string> names = names_in(films);
    const std::string& name = asked.text;
    std::string hint = names.empty() ? fmt::format("no {}s in {}", kind.what, films.string())
                                     : fmt::format("{}s: {}", kind.what, fmt::join(names, ", "));
    if (const auto near = nearest_spelling(name, names))
        hint = fmt::format("did you mean `{}`?", *near);
    if (!kind.has_ending && name.ends_with(".yaml") &&
        (is_there(scenes / name) || is_there(films / name)))
        hint = fmt::format("without its extension: `{}`", fs::path(name).stem().string());
    errors.add(asked, fmt::format("there is no {} {}", kind.what, in_quotes(name)), hint);
}

// Returns 0 if the file cannot be read: it is not the template that the user asked for, so no error
// is reported.
std::size_t panel_places(const fs::path& file) {
    Source source{.origin = Origin::template_file};
    Errors errors;
    const auto root = read_yaml_file(file, source, errors);
    const Node* layout = root ? find(*root, "layout") : nullptr;
    const Node* panels = layout != nullptr ? find(*layout, "panels") : nullptr;
    return panels && panels->is_list() ? panels->items.size() : 0;
}

bool is_excluded(const std::string& key, const Node& film, const std::vector<Choice>& choices) {
    const auto is_given = [&](const std::string& name) { return find(film, name) != nullptr; };
    return std::ranges::any_of(choices, [&](const Choice& choice) {
        return std::ranges::find(choice.names, key) != choice.names.end() &&
               std::ranges::any_of(choice.names, is_given);
    });
}

bool is_inside(const Slot& slot, const LayoutSpec& layout) {
    return is_within(slot, {0.0, 0.0, layout.grid_width, layout.grid_height});
}

void check_caption_line(const Node& line, const LayoutSpec& layout, Errors& errors) {
    const LayoutSpec with_line = with_caption_line(layout);
    std::vector<Slot> slots{with_line.title, with_line.gas, with_line.color_bar};
    if (with_line.clock) slots.push_back(*with_line.clock);
    if (with_line.monitors) slots.push_back(*with_line.monitors);
    slots.insert(slots.end(), with_line.panels.begin(), with_line.panels.end());
    if (std::ranges::any_of(slots, [](const Slot& slot) { return slot.height <= 0.0; }))
        errors.add(line, "the place for captions leaves another place without room",
                   "make it lower, or move it away from the others");
}

struct NamedPlace {
    std::string name;  // as messages have it
    Placed<Slot> place;
};

/// A layout with the nodes of its places.
struct LayoutDraft : LayoutSpec {
    std::optional<TwoNumbers> grid;
    std::vector<NamedPlace> places;
};

// The key of a place in the grid; complete_layout() checks it when the grid is known.
template <typename Field>
Binding<LayoutDraft> slot_key(std::string name, Field LayoutSpec::*field,
                              const Notation<Placed<Slot>>& slot, std::string meaning) {
    const auto fill = [field, name](LayoutDraft& layout, const Placed<Slot>& place) {
        layout.*field = place.value;
        layout.places.push_back({fmt::format("`{}`", name), place});
    };
    return bind_with<LayoutDraft>(std::move(name), fill, slot, std::move(meaning));
}

Notation<Placed<Slot>> slot_notation() {
    const Range units{0.0, largest_grid};
    const auto slot = [](const std::vector<double>& sides) {
        return Slot{sides.at(0), sides.at(1), sides.at(2), sides.at(3)};
    };
    const auto check = [](const Slot& place, const Node& node, Reading& reading) {
        if (place.width <= 0.0 || place.height <= 0.0)
            reading.errors.add(node,
                               "expected [x, y, width, height] with a positive width and height",
                               "for instance [0, 0, 20, 10]");
    };
    return placed(
        checked(mapped(list_of(number(units), 4, {4}, "[x, y, width, height]"), slot), check));
}

// One direction of places.
struct Along {
    double Slot::*start;
    double Slot::*size;
    double end(const Slot& slot) const { return slot.*start + slot.*size; }
};
constexpr Along across{&Slot::x, &Slot::width}, down{&Slot::y, &Slot::height};

// Lengthens the gas's place to the end of those of the panels; others between them move on.
void lengthen_gas(LayoutSpec& layout, const Along& along, const Along& other) {
    double end = along.end(layout.gas);
    for (const Slot& slot : layout.panels) end = std::max(end, along.end(slot));
    std::vector<Slot*> others{&layout.title, &layout.color_bar};
    for (std::optional<Slot>* slot : {&layout.caption, &layout.clock, &layout.monitors})
        if (*slot) others.push_back(&**slot);
    const double from = along.end(layout.gas);
    double last = from;
    std::erase_if(others, [&](const Slot* slot) {
        return slot->*along.start < from || slot->*along.start >= end ||
               other.end(*slot) <= layout.gas.*other.start ||
               slot->*other.start >= other.end(layout.gas);
    });
    for (const Slot* slot : others) last = std::max(last, along.end(*slot));
    const double more = end - last;
    if (more <= 0.0) return;
    layout.gas.*along.size += more;
    for (Slot* slot : others) slot->*along.start += more;
}

bool overlap(const Slot& a, const Slot& b) {
    constexpr double rounding = 1e-9;
    return std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x) > rounding &&
           std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y) > rounding;
}

// The places of panels are those without quotes.
bool lies_over_gas(const NamedPlace& one, const NamedPlace& gas) {
    return gas.name == "`gas`" && one.name.front() != '`' &&
           is_within(one.place.value, gas.place.value);
}

// The title ends before a key of one line.
bool is_key_in_title(const NamedPlace& key, const NamedPlace& title) {
    return title.name == "`title`" && key.name == "`color_bar`" && is_one_line(key.place.value);
}

bool may_overlap(const NamedPlace& a, const NamedPlace& b) {
    return lies_over_gas(a, b) || lies_over_gas(b, a) || is_key_in_title(a, b) ||
           is_key_in_title(b, a);
}

// Reports places that overlap. The place of captions may overlap others, which are then made
// smaller, and that of a panel may lie over the gas.
void check_overlaps(const LayoutDraft& layout, Errors& errors) {
    std::vector<const NamedPlace*> seen;
    for (const NamedPlace& one : layout.places) {
        if (one.name == "`caption`") continue;
        for (const NamedPlace* before : seen)
            if (overlap(before->place.value, one.place.value) && !may_overlap(one, *before)) {
                errors.add(
                    *one.place.node,
                    fmt::format("the place of {} overlaps that of {}", one.name, before->name),
                    "places may touch; only `caption` may lie over others, which are then "
                    "made smaller, and a panel may lie over the gas if its place is wholly inside "
                    "that of the gas");
                break;
            }
        seen.push_back(&one);
    }
}

void complete_layout(LayoutDraft& layout, const Node& node, Reading& reading) {
    if (!layout.grid) return;
    layout.grid_width = (*layout.grid)[0];
    layout.grid_height = (*layout.grid)[1];
    for (const auto& [name, place] : layout.places)
        if (!is_inside(place.value, layout))
            reading.errors.add(
                *place.node,
                fmt::format("the place reaches outside the grid of {} by {}", layout.grid_width,
                            layout.grid_height),
                fmt::format("x and width together are at most {}, y and height at most {}",
                            layout.grid_width, layout.grid_height));
    if (std::ranges::all_of(layout.places, [&](const NamedPlace& one) {
            return is_inside(one.place.value, layout);
        }))
        check_overlaps(layout, reading.errors);
    const bool is_whole =  // missing or empty places have their own messages
        given(node, "title") && given(node, "gas") && given(node, "color_bar") &&
        std::ranges::all_of(layout.places, [](const NamedPlace& one) {
            return one.place.value.width > 0.0 && one.place.value.height > 0.0;
        });
    if (layout.caption && is_whole)
        check_caption_line(*given(node, "caption"), layout, reading.errors);
}

KeyTable<LayoutDraft> layout_table() {
    const Range sides{1.0, largest_grid};
    const auto slot = slot_notation();
    const auto panels = [](LayoutDraft& layout, const std::vector<Placed<Slot>>& places) {
        int count = 0;
        layout.panels = values_of(places);
        for (const Placed<Slot>& place : places)
            layout.places.push_back({fmt::format("panel {}", ++count), place});
    };
    return {
        .name = "`layout`",
        .keys =
            {bind_key("grid", &LayoutDraft::grid, pair_of(number(sides), "[width, height]"),
                      "Width and height of the picture in units of the layout; one unit is the "
                      "smallest size of text.")
                 .required(),
             slot_key("title", &LayoutSpec::title, slot,
                      "The place of the title, and of the subtitle if there is no `caption`.")
                 .required(),
             slot_key("gas", &LayoutSpec::gas, slot, "The place of the box.").required(),
             slot_key("color_bar", &LayoutSpec::color_bar, slot,
                      "The place of the key of the disks' colours: upright, or in one line where "
                      "the place is less than 3 units high; there it may lie over the place of the "
                      "title, which ends before it.")
                 .required(),
             slot_key("caption", &LayoutSpec::caption, slot,
                      "The place of captions in films that have any, and of the subtitle in the "
                      "first four seconds; places that overlap it are made smaller, except for "
                      "`monitors` of one line, which share it.")
                 .default_text("the bottom of the gas's place"),
             slot_key("clock", &LayoutSpec::clock, slot,
                      "The place of the time, at its right end; the row of numbers then has none.")
                 .default_text("none"),
             slot_key("monitors", &LayoutSpec::monitors, slot,
                      "The place of the row of numbers: each below its name, or, where the place "
                      "is less than 3 units high, all in one line that ends at the right.")
                 .default_text("none"),
             bind_with<LayoutDraft>(
                 "panels", panels, list_of(slot, 0, most_panels, "a list of [x, y, width, height]"),
                 "The places of the panels, in order. Places may touch; only `caption` may overlap "
                 "others. A panel whose place is inside that of the gas lies over the gas, and "
                 "enters at the first collision.")
                 .default_text("none")},
        .rule = complete_layout};
}

}  // namespace

bool stays_inside(const fs::path& file, const fs::path& folder) {
    std::error_code failed;
    const fs::path inside = fs::weakly_canonical(folder, failed);
    const fs::path target = fs::weakly_canonical(file, failed);
    return !failed && target.parent_path() == inside;
}

Notation<LayoutSpec> layout_notation() {
    return parsed(mapping(layout_table()), [](const LayoutDraft& layout, const Node& node,
                                              Reading&) {
        const bool has_panels = find(node, "panels") == nullptr || given(node, "panels") != nullptr;
        return layout.grid && has_panels ? std::optional<LayoutSpec>(layout) : std::nullopt;
    });
}

LayoutSpec without_panels(LayoutSpec layout) {
    lengthen_gas(layout, across, down);
    lengthen_gas(layout, down, across);
    layout.panels.clear();
    return layout;
}

std::optional<TemplateFile> find_template(const Node& asked, const fs::path& scene,
                                          const fs::path& templates, Errors& errors,
                                          const NamedFiles& kind) {
    const std::string name = name_without_ending(asked.text, kind);
    const bool typed = asked.source->origin == Origin::command_line;
    if (typed && (asked.text.find('/') != std::string::npos || asked.text.ends_with(".yaml")))
        return TemplateFile{fs::path{asked.text}.stem().string(), asked.text};
    if (!is_plain_name(name)) {
        errors.add(
            asked,
            fmt::format("expected the name of a {}, found {}", kind.what, in_quotes(asked.text)),
            typed ? "a name, or a file that ends in .yaml"
                  : fmt::format("a {} is a file in the scene's folder or in templates/{}, "
                                "without folder{}",
                                kind.what, kind.folder, kind.has_ending ? "" : " and extension"));
        return std::nullopt;
    }
    const fs::path beside = folder_of(scene) / (name + ".yaml");
    if (is_there(beside) && !same_file(beside, scene)) {
        if (stays_inside(beside, folder_of(scene)))
            return TemplateFile{name, scene.parent_path() / (name + ".yaml")};
        errors.add(asked,
                   fmt::format("the {} {} is a link that leads out of the scene's folder",
                               kind.what, in_quotes(name)),
                   "copy the file into the folder");
        return std::nullopt;
    }
    const fs::path own = templates / kind.folder / (name + ".yaml");
    if (is_there(own)) return TemplateFile{name, own};
    report_unknown(asked, folder_of(scene), templates / kind.folder, kind, errors);
    return std::nullopt;
}

std::vector<fs::path> named_paths(const Node& asked, const fs::path& scene,
                                  const NamedFiles& kind) {
    return {asked.text, scene.parent_path() / (name_without_ending(asked.text, kind) + ".yaml")};
}

std::vector<std::string> templates_with_places(const fs::path& templates, std::size_t panels) {
    std::vector<std::pair<std::size_t, std::string>> found;
    for (const std::string& name : names_in(templates / "films"))
        if (const std::size_t places = panel_places(templates / "films" / (name + ".yaml"));
            places >= panels)
            found.emplace_back(places, name);
    std::ranges::sort(found);
    std::vector<std::string> names;
    for (const auto& [places, name] : found) names.push_back(name);
    return names;
}

Node lay_over(const Node& film, const Node& template_file, const std::vector<Choice>& choices) {
    Node merged = film;
    for (std::size_t i = 0; i < template_file.keys.size(); ++i) {
        const std::string& key = template_file.keys[i].text;
        if (key == "layout" || find(film, key) != nullptr || is_excluded(key, film, choices))
            continue;
        merged.keys.push_back(template_file.keys[i]);
        merged.items.push_back(template_file.items[i]);
    }
    return merged;
}

}  // namespace carom

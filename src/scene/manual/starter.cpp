#include "scene/manual/starter.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "scene/keys/key_text.h"
#include "scene/reading/scene_reading.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr std::string_view schema_mark = "# yaml-language-server:";

std::string first_line(const std::string& schema) {
    return fmt::format("{} $schema={}\n", schema_mark, schema);
}

/// Keys with their values. One that begins with # is an example for a key that the scene does not
/// give; without an entry, the example is the default or a short value.
using Values = std::map<std::string, std::string>;

bool is_given(const Values& values, const std::string& key) {
    const auto found = values.find(key);
    return found != values.end() && !found->second.starts_with('#');
}

// Returns words as comment lines of limited width.
std::string comment(const std::string& words, const std::string& indent) {
    constexpr std::size_t width = 96;
    std::string text, line;
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        const std::string word = words.substr(begin, end - begin);
        if (!line.empty() && indent.size() + line.size() + word.size() + 3 > width) {
            text += indent + "#" + line + "\n";
            line.clear();
        }
        line += " " + word;
        begin = end + 1;
    }
    return text + indent + "#" + line + "\n";
}

std::string words_of(const Key& key) {
    std::string words = key.meaning;
    if (!key.default_text.empty()) words += " Default: " + key.default_text + ".";
    const bool is_kind = key.name == "kind";  // too many to be listed
    return words +
           " Values: " + (is_kind ? "those that `carom help panel` lists" : forms_text(key)) + ".";
}

std::string value_of(const Key& key, const Values& values) {
    const auto found = values.find(key.name);
    if (found == values.end()) return example_text(key);
    return found->second.substr(found->second.starts_with('#') ? 1 : 0);
}

// Returns the key that the scene gives and with which this one cannot be combined; empty: none.
std::string given_instead_of(const Key& key, const Section& section, const Values& values) {
    for (const Choice& choice : section.choices) {
        if (std::ranges::find(choice.names, key.name) == choice.names.end()) continue;
        for (const std::string& name : choice.names)
            if (name != key.name && is_given(values, name)) return name;
    }
    return "";
}

// Returns the comment about a key in whose place the scene gives another one.
std::string instead(const Key& key, const std::string& other, const Values& values) {
    Key told = key;
    if (const std::string known = "Instead of `" + other + "`: "; told.meaning.starts_with(known))
        told.meaning = capitalised(told.meaning.substr(known.size()));
    return fmt::format("Or, in the place of `{}`, `{}: {}`: {}", other, key.name,
                       value_of(key, values), words_of(told));
}

// What a key needs that the scene does not have, by its name.
const Values needed{{"surfaces", "With a partition of this name"},
                    {"gas", "In a scene with `units: real`"},
                    {"pressure", "With `shape`"},
                    {"viewpoint", "In a box with three lengths"},
                    {"beside", "Without the panel `energy-by-species`"}};

std::string lines_of(const Key& key, const Section& section, const Values& values,
                     const std::string& indent) {
    const std::string end_of_words = indent + "#\n";  // no key stands behind them
    if (const std::string other = given_instead_of(key, section, values); !other.empty())
        return comment(instead(key, other, values), indent) + end_of_words;
    if (const auto found = needed.find(key.name); found != needed.end())
        return comment(fmt::format("{}, `{}: {}`: {}", found->second, key.name,
                                   value_of(key, values), words_of(key)),
                       indent) +
               end_of_words;
    return comment(words_of(key), indent) + fmt::format("{}{}{}: {}\n", indent,
                                                        is_given(values, key.name) ? "" : "# ",
                                                        key.name, value_of(key, values));
}

bool applies_to(const Key& key, const std::string& kind) {
    return key.kinds.empty() || std::ranges::find(key.kinds, kind) != key.kinds.end();
}

/// A part of a scene that is written out: the value of a key, by the key's name.
using Parts = std::map<std::string, std::string>;

// Returns the lines of the keys of a section; of a panel or figure, of those that its kind takes.
std::string section_lines(const Section& section, const Values& values, const std::string& indent,
                          const Parts& parts = {}) {
    const auto kind = values.find("kind");
    std::string text;
    for (const Key& key : section.keys) {
        if (kind != values.end() && !applies_to(key, kind->second)) continue;
        const auto part = parts.find(key.name);
        text += part == parts.end()
                    ? lines_of(key, section, values, indent)
                    : comment(key.meaning, indent) + indent + key.name + ":\n" + part->second;
    }
    return text;
}

// Returns the lines of an item of a list.
std::string item_lines(const Section& section, const Values& values, const std::string& indent) {
    return indent + "-\n" + section_lines(section, values, indent + "  ");
}

std::string species_lines(const Section& item) {
    return item_lines(item,
                      {{"name", "light"},
                       {"count", "160"},
                       {"radius", "0.5"},
                       {"mass", "1"},
                       {"speed", "2"},
                       {"temperature", "#2"},
                       {"label", "#light"}},
                      "  ") +
           "  - {name: heavy, count: 30, radius: 1.6, mass: 12, speed: 2}\n";
}

std::string run_lines(const Section& run) {
    return section_lines(run,
                         {{"until", "75"},
                          {"sample_every", "#0.1"},
                          {"time_step", "#0.01"},
                          {"most_collisions", "#1000000"},
                          {"events", "#[{at: 20, caption: The energies approach each other}]"}},
                         "  ");
}

std::string film_lines(const Section& film, const std::string& kind) {
    const std::string panels =
        "    - energy-by-species\n" +
        item_lines(section_of(film, "panels"),
                   {{"kind", kind},
                    {"show", "#{from: 10}"},
                    {"bins", "#40"},
                    {"range", "#[0, 6]"},
                    {"surfaces", "divider"},
                    {"regions", "#[{name: left half, within: [0, 0, 32, 48]}]"}},
                   "    ") +
        "    - energy-histogram\n";
    return section_lines(film,
                         {{"seconds", "30"},
                          {"color_by", "species"},
                          {"trails", "#{of: heavy, seconds: 1}"},
                          {"field", "#{of: density, cells: 20}"},
                          {"slow", "#[{from: 10, to: 15, factor: 0.3}]"},
                          {"monitors", "#[collisions, mean-energy]"},
                          {"spotlight", "#[{from: 20, to: 30, of: heavy}]"},
                          {"camera", "#[{at: 20, view: [0, 0, 32, 24]}, {at: 30, view: box}]"},
                          {"callouts", "#[{at: 10, points_to: 0, text: a light disk}]"},
                          {"beside", "{own_label: seed 1, label: seed 2, set: seed=2}"},
                          {"fade_out", "#{within: [0, 36, 64, 48], seconds: 3}"}},
                         "  ", {{"panels", panels}});
}

std::string figure_lines(const Section& figure, const std::string& kind) {
    return item_lines(figure,
                      {{"name", "speeds"},
                       {"kind", kind},
                       {"of", "#light"},
                       {"bins", "#40"},
                       {"range", "#[0, 6]"},
                       {"surfaces", "divider"},
                       {"regions", "#[{name: left half, within: [0, 0, 32, 48]}]"},
                       {"seeds", "#8"},
                       {"at", "#50"},
                       {"over", "#{window: 10}"},
                       {"theme", "#print"}},
                      "  ") +
           "  - {name: energies, kind: energy-by-species, size: page}\n";
}

}  // namespace

std::string starter_scene(PanelKinds kinds, const std::string& schema, const std::string& name) {
    const Section scene = scene_table(kinds, 2).section();
    const auto inner = [&](const char* key) -> const Section& { return section_of(scene, key); };
    const std::string& kind = kinds.front().name;  // whose keys a panel and a figure show
    const Values values{{"title", "Light and heavy disks share energy, not speed"},
                        {"seed", "1"},
                        {"gravity", "#[0, -0.05]"},
                        {"partitions", "#[{name: divider, x: 32}]"},
                        {"obstacles", "#[{name: peg, disk: [32, 24], radius: 3}]"},
                        {"measure", "#[mean-free-path, {kind: temperature, of: heavy}]"}};
    const Parts parts{
        {"box", section_lines(inner("box"), {{"size", "[64, 48]"}, {"length", "#64"}}, "  ")},
        {"gas", species_lines(inner("gas"))},
        {"run", run_lines(inner("run"))},
        {"film", film_lines(inner("film"), kind)},
        {"figures", figure_lines(inner("figures"), kind)}};
    std::string text = first_line(schema);
    text += comment(
        fmt::format("A scene: `carom render {0}` makes its film, `carom figures {0}` its figures, "
                    "and `carom check {0}` says whether it is valid, and what it is.",
                    name),
        "");
    text += comment(
        "Remove the # in front of a key to use it. Its value is the default, or an example. "
        "`carom help scene NAME` explains a key with all that it may contain, `carom help panel "
        "NAME` a kind of panel.",
        "");
    for (const Key& key : scene.keys)
        text += "\n" + section_lines({.name = scene.name, .keys = {key}}, values, "", parts);
    return text;
}

std::string starter_from(const std::string& scene, const std::string& schema) {
    std::string text = scene;
    if (text.starts_with(schema_mark))
        text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
    return first_line(schema) + text;
}

}  // namespace carom

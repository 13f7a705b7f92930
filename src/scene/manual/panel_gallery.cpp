#include "scene/manual/panel_gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "scene/manual/key_table.h"
#include "scene/manual/sections.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr const char* introduction = R"(## Panels

What a film shows beside the gas (`film.panels`), and what figures show (`figures`). Each picture is made from the scene under it, a file of [panels](panels), by `carom figures FILE`. In a film a panel is an item of `panels`, with the same keys but for `name`, `theme` and `size`.

Keys of a single kind stand under its picture, [keys of several panels](#keys-of-several-panels) after the last. All panels have the keys of [a panel](#a-panel) in films, and those of [a figure](#a-figure) in figures. `carom help panel NAME` shows all keys of a kind.

)";

constexpr const char* set_opening =
    R"(# yaml-language-server: $schema=../../scenes/set.schema.json
# Made by `./dev docs` from src/panels/registry.cpp: every kind of panel, in its order.
title: Every kind of panel
formats: [png]
scenes:
)";

std::string in_attribute(const std::string& text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '"' ? "&quot;" : c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return escaped;
}

bool is_told_alike(const Key& key, const Section& section, const Section& other) {
    const std::size_t index = other.index(key.name);
    return index < other.keys.size() && are_told_alike(section, key, other, other.keys[index]);
}

// Returns the names of keys of figures that this kind takes, and that panels in films have not, or
// have otherwise.
std::vector<std::string> names_in_figures(PanelKinds kinds, const std::string& kind) {
    const Section &panel = panel_section(kinds), &figure = figure_section(kinds);
    std::vector<std::string> names;
    for (const Key* key : keys_of_kind(figure, kind).shared)
        if (!is_told_alike(*key, figure, panel)) names.push_back(key->name);
    return names;
}

std::string keys_of(PanelKinds kinds, const PanelKind& kind) {
    std::string rows;
    for (const auto& [section, key] : keys_in_gallery(kinds))
        if (key->kinds == std::vector{kind.name}) rows += key_row(*section, *key);
    std::vector<std::string> shared;
    for (const Key* key : keys_of_kind(panel_section(kinds), kind.name).shared)
        shared.push_back(key->name);
    std::vector<std::string> words;
    if (!shared.empty())
        words.push_back(fmt::format("{} ([keys of several panels](#keys-of-several-panels))",
                                    listed(shared, "and", "`")));
    if (const auto names = names_in_figures(kinds, kind.name); !names.empty())
        words.push_back(
            fmt::format("in figures {} ([a figure](#a-figure))", listed(names, "and", "`")));
    std::string text = rows.empty() ? "" : key_table(rows);
    if (!words.empty())
        text += fmt::format("{}: {}.\n\n", rows.empty() ? "Keys" : "Also", fmt::join(words, "; "));
    return text;
}

std::string entry(PanelKinds kinds, const PanelKind& kind, const PanelExample& example) {
    return fmt::format(
               "### `{0}`\n\n{1}{2}\n\n<img src=\"panels/{0}.png\" width=\"420\" alt=\"{3}\">\n\n"
               "```yaml\n{4}```\n\n",
               kind.name, kind.shows,
               fmt::format("{}{}", kind.in_films_instead.empty() ? "" : " For figures only.",
                           kind.in_space_instead.empty() ? "" : " Not in space."),
               in_attribute(example.alt), example.scene) +
           keys_of(kinds, kind);
}

std::string shared_keys(PanelKinds kinds) {
    std::string rows;
    for (const auto& [section, key] : keys_in_gallery(kinds))
        if (key->kinds.size() > 1) rows += key_row(*section, *key);
    return "### Keys of several panels\n\n" + key_table(rows);
}

}  // namespace

std::string panel_set(PanelKinds kinds) {
    std::string text = set_opening;
    for (const PanelKind& kind : kinds) text += fmt::format("  - {}.yaml\n", kind.name);
    return text;
}

KeysInGallery keys_in_gallery(PanelKinds kinds) {
    const Section &panel = panel_section(kinds), &figure = figure_section(kinds);
    KeysInGallery keys;
    for (const Key& key : panel.keys)
        if (!key.kinds.empty()) keys.emplace_back(&panel, &key);
    for (const Key& key : figure.keys)
        if (key.kinds.size() == 1 && !is_told_alike(key, figure, panel))
            keys.emplace_back(&figure, &key);
    return keys;
}

std::string panel_gallery(PanelKinds kinds, const std::map<std::string, PanelExample>& examples) {
    std::vector<std::string> links;
    std::string entries;
    for (const PanelKind& kind : kinds) {
        links.push_back(fmt::format("[`{0}`](#{0})", kind.name));
        entries += entry(kinds, kind, examples.at(kind.name));
    }
    return fmt::format("{}{}\n\n{}{}", introduction, fmt::join(links, ", "), entries,
                       shared_keys(kinds));
}

}  // namespace carom

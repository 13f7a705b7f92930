#include "scene/manual/panel_gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace carom {
namespace {

constexpr const char* introduction = R"(## Panels

What a film shows beside the gas (`film.panels`), and what figures show (`figures`). Each picture is made from the scene under it, a file of [panels](panels), by `carom figures FILE`. In a film a panel is an item of `panels`, with the same keys but for `name`, `theme` and `size`. All keys: [a panel](#a-panel), [a figure](#a-figure).

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

std::string entry(const PanelKind& kind, const PanelExample& example) {
    return fmt::format(
        "### `{0}`\n\n{1}{2}\n\n<img src=\"panels/{0}.png\" width=\"420\" alt=\"{3}\">\n\n"
        "```yaml\n{4}```\n\n",
        kind.name, kind.shows, kind.in_films_instead.empty() ? "" : " For figures only.",
        in_attribute(example.alt), example.scene);
}

}  // namespace

std::string panel_set(PanelKinds kinds) {
    std::string text = set_opening;
    for (const PanelKind& kind : kinds) text += fmt::format("  - {}.yaml\n", kind.name);
    return text;
}

std::string panel_gallery(PanelKinds kinds, const std::map<std::string, PanelExample>& examples) {
    std::vector<std::string> links;
    std::string entries;
    for (const PanelKind& kind : kinds) {
        links.push_back(fmt::format("[`{0}`](#{0})", kind.name));
        entries += entry(kind, examples.at(kind.name));
    }
    return fmt::format("{}{}\n\n{}", introduction, fmt::join(links, ", "), entries);
}

}  // namespace carom

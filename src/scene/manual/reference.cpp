#include "scene/manual/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "scene/manual/color_chart.h"
#include "scene/manual/key_table.h"
#include "scene/manual/sections.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/sets/set_reading.h"
#include "scene/style/style_reading.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr const char* opening = R"(# The scene language

<!-- Made by `./dev docs` from the bindings of the keys, src/scene/reading/ and src/panels/registry.cpp, and from the scenes in panels/: change these, not this. -->

A scene is one YAML file: what is in the box, what happens to it, what the viewer sees. This page has a picture of every [panel](#panels) with the lines that make it, and [every key](#a-scene) with its values and its default.

)";

constexpr const char* example = R"(title: Light and heavy disks
box: {size: [64, 48], walls: periodic}
gas:
  - {name: light, count: 160, radius: 0.5, speed: 2}
  - {name: heavy, count: 30, radius: {uniform: [1, 2]}, density: 1.5, temperature: 2}
run: {until: 60, equilibrate: 5}
film:
  seconds: 30
  color_by: species
  panels:
    - energy-by-species
    - {kind: speed-histogram, bins: 40, title: How fast they are}
)";

constexpr const char* rules =
    R"(- An unknown key, a key that is there twice, or a value of the wrong kind is an error, reported with its place, together with all others of the file.
- Quantities are in reduced units: a length, a mass and a time of your choice, Boltzmann's constant 1.
- A number is written in decimal (`0.5`, `1e9`), without quotes; programs that read YAML 1.1, such as PyYAML, take it for a number only with a point and a sign of the exponent (`1.0e+9`). Texts need quotes where YAML would read something else, such as `": "` or `#`.
- A box with two lengths in `size` is a plane that holds disks, one with three is a part of space that holds spheres, and one with a `length` is a wire that holds beads. Where keys differ on a wire or in space, a table of their own lists them. In space x goes to the right, y up, and z toward the viewer; its sides are `left`, `right`, `bottom`, `top`, `back` and `front`.
- An editor with a YAML language server completes and checks all this: `carom schema > scene.schema.json`, and as the first line of a scene `# yaml-language-server: $schema=scene.schema.json`. `carom new` writes that line.
- `carom check SCENE` says whether a scene is valid.

)";

// Returns rows about a section on a wire or in space: keys that are new or differ there, and keys
// that do not exist there.
std::string other_rows(const Section& plane, const Section& other, const std::string& where) {
    const Otherwise found = otherwise(plane, other);
    std::string rows;
    for (const Key* key : found.keys) rows += key_row(other, *key);
    std::string text =
        rows.empty() ? "" : fmt::format("{}:\n\n", capitalised(where)) + key_table(rows);
    if (!found.missing.empty())
        text += fmt::format("Not {}: {}.\n\n", where, listed(found.missing, "and", "`"));
    return text;
}

// "a-panel" for "a panel": where a link to a section leads.
std::string anchor(const std::string& heading) {
    std::string place = lower(heading);
    std::erase_if(place, [](char c) { return c == '`' || c == '\''; });
    std::ranges::replace(place, ' ', '-');
    return place;
}

bool has_kinds(const Section& section) {
    return std::ranges::any_of(section.keys, [](const Key& key) { return !key.kinds.empty(); });
}

class Page {
  public:
    // `panels` is the gallery of panels, which has told these keys.
    Page(std::string text, const KeysInGallery& panels) : text_(std::move(text)) {
        for (const auto& [section, key] : panels) told_.push_back({section, key, true});
    }

    // Adds a section of the plane together with those of the wire and of space, then the sections
    // inside it; each name once.
    void add_all(const SectionsOfBoxes& all) {
        for (const SectionsOfBoxes& section : sections_within(all))
            if (shown_.insert(section.plane->name).second) add(section);
    }

    void add(const std::string& text) { text_ += text; }
    const std::string& text() const { return text_; }

  private:
    // What panels, figures, instruments and comparisons say alike is told once.
    void add(const SectionsOfBoxes& section) {
        const Section& plane = *section.plane;
        const bool is_of_panels = has_kinds(plane);
        std::string rows;
        std::map<std::string, std::vector<std::string>> elsewhere;  // keys by section
        for (const Key& key : plane.keys) {
            const auto told = std::ranges::find_if(told_, [&](const Told& one) {
                return is_of_panels && are_told_alike(plane, key, *one.section, *one.key);
            });
            if (told == told_.end())
                rows += key_row(plane, key);
            else
                elsewhere[told->is_in_gallery ? "" : told->section->name].push_back(key.name);
            if (is_of_panels && told == told_.end()) told_.push_back({&plane, &key, false});
        }
        text_ += fmt::format("## {}\n\n", capitalised(plane.name)) + key_table(rows) +
                 further_keys(elsewhere);
        for (const std::string& choice : choices_in_words(plane)) text_ += choice + "\n\n";
        text_ += other_rows(plane, *section.wire, "on a wire");
        text_ += other_rows(plane, *section.space, "in space");
    }

    static std::string further_keys(
        const std::map<std::string, std::vector<std::string>>& elsewhere) {
        std::vector<std::string> words;
        for (const auto& [section, keys] : elsewhere)
            words.push_back(section.empty()
                                ? "those of its kind, beside its picture in [Panels](#panels)"
                                : fmt::format("{}, as of [{}](#{})", listed(keys, "and", "`"),
                                              section, anchor(section)));
        if (words.empty()) return "";
        return fmt::format("Further keys: {}.\n\n", fmt::join(words, "; "));
    }

    std::string text_;
    std::set<std::string> shown_;
    struct Told {
        const Section* section;
        const Key* key;
        bool is_in_gallery;
    };
    std::vector<Told> told_;  // keys of panels
};

}  // namespace

std::string reference_example() { return example; }

std::string scene_reference(PanelKinds kinds, const std::vector<std::string>& formats,
                            const std::map<std::string, PanelExample>& panels) {
    Page page(
        opening + fmt::format("```yaml\n{}```\n\n", example) + rules + panel_gallery(kinds, panels),
        keys_in_gallery(kinds));
    page.add_all(sections_of_scenes(kinds));
    page.add(
        "A film template, a file in `templates/films/` or beside the scene, has the keys of "
        "`film` except `template`, and a `layout`:\n\n");
    const Section film_template = template_table(kinds).section();
    const Section& layout = section_of(film_template, "layout");
    page.add_all(in_any_box(layout));
    page.add(
        "A figure set, a file given to `carom figures`, lists scenes whose figures belong "
        "together ([figures.md](figures.md)):\n\n");
    const Section set = set_table(kinds, formats).section();
    page.add_all(in_any_box(set));
    page.add(
        "A style, a file beside the scene or in `templates/styles/`, gives the pictures of scenes "
        "that name it their colours, fonts and sizes ([styles.md](styles.md)):\n\n");
    page.add_all(in_any_box(style_table().section()));
    page.add(color_section());
    page.add(
        "## Limits\n\nWhat exceeds a limit is refused before memory is taken: "
        "[limits.md](limits.md) lists all limits.\n");
    return page.text();
}

}  // namespace carom

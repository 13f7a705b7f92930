#include "scene/manual/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/keys/key_text.h"
#include "scene/manual/color_chart.h"
#include "scene/manual/sections.h"
#include "scene/reading/film_reading.h"
#include "scene/reading/scene_reading.h"
#include "scene/sets/set_reading.h"
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
- A box with `size` is a plane that holds disks, one with `length` is a wire that holds beads. Where keys differ on a wire, a second table lists them.
- An editor with a YAML language server completes and checks all this: `carom schema > scene.schema.json`, and as the first line of a scene `# yaml-language-server: $schema=scene.schema.json`. `carom new` writes that line.
- `carom check SCENE` says whether a scene is valid.

)";

std::string cell(std::string text) {
    for (std::size_t i = text.find('|'); i != std::string::npos; i = text.find('|', i + 2))
        text.insert(i, "\\");
    return text;
}

std::string row(const Section& section, const Key& key) {
    std::string meaning = key.meaning;
    if (!key.kinds.empty()) meaning += " Applies to " + listed(key.kinds, "and", "`") + ".";
    if (!key.formerly.empty()) meaning += " Formerly `" + key.formerly + "`, which is still read.";
    std::string values = forms_text(key);
    if (std::ranges::find(key.forms, Shape::color, &Form::shape) != key.forms.end())
        values += ", see [Colours](#colours)";
    return fmt::format("| `{}` | {} | {} | {} |\n", key.name, cell(meaning), cell(values),
                       cell(default_of(section, key)));
}

std::string table(const std::string& rows) {
    return "| key | meaning | values | default |\n| --- | --- | --- | --- |\n" + rows + "\n";
}

// Returns rows about a section on a wire: keys that are new or differ there, and keys that do not
// exist there.
std::string wire_rows(const SectionPair& section) {
    const OnWire others = on_wire(section);
    std::string rows;
    for (const Key* key : others.keys) rows += row(*section.wire, *key);
    std::string text = rows.empty() ? "" : "On a wire:\n\n" + table(rows);
    if (!others.missing.empty())
        text += fmt::format("Not on a wire: {}.\n\n", listed(others.missing, "and", "`"));
    return text;
}

std::string section_text(const SectionPair& section) {
    std::string rows;
    for (const Key& key : section.plane->keys) rows += row(*section.plane, key);
    std::string text = fmt::format("## {}\n\n", capitalised(section.plane->name)) + table(rows);
    for (const std::string& choice : choices_in_words(*section.plane)) text += choice + "\n\n";
    return text + wire_rows(section);
}

class Page {
  public:
    explicit Page(std::string text) : text_(std::move(text)) {}

    // Adds a section of the plane together with that of the wire, then the sections inside it; each
    // name once.
    void add(const Section& plane, const Section& wire) {
        for (const SectionPair& section : sections_within(plane, wire))
            if (shown_.insert(section.plane->name).second) text_ += section_text(section);
    }

    void add(const std::string& text) { text_ += text; }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::set<std::string> shown_;
};

}  // namespace

std::string reference_example() { return example; }

std::string scene_reference(PanelKinds kinds, const std::vector<std::string>& formats,
                            const std::map<std::string, PanelExample>& panels) {
    Page page(opening + fmt::format("```yaml\n{}```\n\n", example) + rules +
              panel_gallery(kinds, panels));
    page.add(scene_table(kinds, 2).section(), scene_table(kinds, 1).section());
    page.add(
        "A film template, a file in `templates/films/` or beside the scene, has the keys of "
        "`film` except `template`, and a `layout`:\n\n");
    const Section film_template = template_table(kinds).section();
    const Section& layout = section_of(film_template, "layout");
    page.add(layout, layout);
    page.add(
        "A figure set, a file given to `carom figures`, lists scenes whose figures belong "
        "together ([figures.md](figures.md)):\n\n");
    const Section set = set_table(kinds, formats).section();
    page.add(set, set);
    page.add(color_section());
    page.add(
        "## Limits\n\nWhat exceeds a limit is refused before memory is taken: "
        "[limits.md](limits.md) lists all limits.\n");
    return page.text();
}

}  // namespace carom

// What is made from the key table: the reference page, and the scene to start from.
#include "scene/manual/reference.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "media/formats.h"
#include "panels/registry.h"
#include "scene/keys/colors.h"
#include "scene/keys/key_text.h"
#include "scene/load.h"
#include "scene/manual/color_chart.h"
#include "scene/manual/starter.h"
#include "scene/reading/scene_reading.h"
#include "support/files.h"
#include "support/test_root.h"

using namespace carom;
using test::contents;
namespace fs = std::filesystem;

namespace {

Scene loaded(const std::string& text) {
    fs::current_path(carom::test::checkout());
    try {
        return load_scene_text(text, "starter.yaml", {"templates", panel_kinds()});
    } catch (const SceneError& error) {
        FAIL_CHECK(error.what());
        return {};
    }
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

// What is in docs/panels/.
std::map<std::string, PanelExample> panel_examples() {
    const fs::path folder = carom::test::checkout() / "docs/panels";
    std::map<std::string, PanelExample> examples;
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        CHECK(fs::exists(folder / (kind.name + ".yaml")));
        examples[kind.name].scene = contents(folder / (kind.name + ".yaml"));
    }
    const auto captions = nlohmann::json::parse(contents(folder / "captions.json"));
    for (const auto& figure : captions.at("figures"))
        examples[figure.at("name")].alt = figure.at("alt");
    return examples;
}

std::string reference_page() {
    return scene_reference(panel_kinds(), figure_formats(), panel_examples());
}

// A key behind a #, as the starter writes it: `    # label: words`.
const std::regex hidden_key(R"(( *)# ([a-z_]+): ([^ ].*[^.]|.))");

// The sections of which the starter offers each key; of a panel and a figure, each key of a
// histogram of speeds.
std::vector<Section> sections_offered() {
    const Section scene = scene_table(panel_kinds(), 2).section();
    std::vector<Section> all{scene};
    for (const char* name : {"box", "gas", "run", "film", "figures"})
        all.push_back(section_of(scene, name));
    all.push_back(section_of(section_of(scene, "film"), "panels"));
    for (Section& section : all)
        std::erase_if(section.keys, [](const Key& key) {
            return !key.kinds.empty() && std::ranges::count(key.kinds, "speed-histogram") == 0;
        });
    return all;
}

bool is_key(const std::string& name) {
    return std::ranges::any_of(sections_offered(), [&](const Section& section) {
        return section.index(name) < section.keys.size();
    });
}

}  // namespace

TEST_CASE("the reference page is current") {
    fs::current_path(carom::test::checkout());
    const std::map<fs::path, std::string> files{{"docs/scene-reference.md", reference_page()},
                                                {"docs/colors.svg", color_chart()}};
    for (const auto& made : files) {
        const auto& file = made.first;
        const auto& text = made.second;
        if (std::getenv("CAROM_UPDATE_DOCS") != nullptr) std::ofstream(file) << text;
        CAPTURE(file);
        const bool current = contents(file) == text;
        INFO("make it anew with ./dev docs");
        CHECK(current);
    }
}

TEST_CASE("the set of all panels is current") {
    const fs::path file = carom::test::checkout() / "docs/panels/panels.yaml";
    if (std::getenv("CAROM_UPDATE_DOCS") != nullptr)
        std::ofstream(file) << panel_set(panel_kinds());
    const bool current = contents(file) == panel_set(panel_kinds());
    INFO("make it anew with ./dev docs");
    CHECK(current);
}

TEST_CASE("every kind of panel has a valid scene of a few lines that shows it") {
    const std::map<std::string, PanelExample> examples = panel_examples();
    CHECK(examples.size() == panel_kinds().size());
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        CHECK(kind.shows.ends_with("."));
        const PanelExample& example = examples.at(kind.name);
        CHECK(!example.alt.empty());
        const Scene scene = loaded(example.scene);
        REQUIRE(scene.figures.size() == 1);
        CHECK(scene.figures.front().name == kind.name);
        CHECK(scene.figures.front().panel.kind == kind.name);
        const std::vector<std::string> lines = lines_of(example.scene);
        CHECK(lines.size() <= 12);
        for (const std::string& line : lines) {
            CAPTURE(line);
            CHECK(line.size() <= 100);
        }
    }
}

TEST_CASE("the page shows every kind of panel, with a picture and its scene") {
    const std::string page = reference_page();
    const std::string gallery = page.substr(0, page.find("\n## A scene\n"));
    for (const auto& shown : panel_examples()) {
        const auto& kind = shown.first;
        const auto& example = shown.second;
        CAPTURE(kind);
        const std::size_t begin = gallery.find("\n### `" + kind + "`\n");
        REQUIRE(begin != std::string::npos);
        const std::size_t end = gallery.find("\n### ", begin + 1);
        const std::string entry = gallery.substr(begin, end - begin);
        CHECK(entry.find("<img src=\"panels/" + kind + ".png\"") != std::string::npos);
        CHECK(entry.find("```yaml\n" + example.scene + "```") != std::string::npos);
        CHECK(gallery.find("[`" + kind + "`](#" + kind + ")") != std::string::npos);
    }
}

TEST_CASE("the page lists every colour that a scene can name, once, with its picture") {
    const std::string page = reference_page();
    const std::size_t begin = page.find("\n## Colours\n");
    REQUIRE(begin != std::string::npos);
    const std::string rows = page.substr(page.find("| group |", begin));
    const std::string chart = color_chart();
    std::set<std::string> seen;
    for (const ColorGroup& group : color_groups())
        for (const NamedColor& color : group.colors) {
            CAPTURE(color.hex);
            CHECK(chart.find("fill=\"" + color.hex + "\"") != std::string::npos);
            for (const std::string& name : color.names) {
                CAPTURE(name);
                CHECK(seen.insert(name).second);
                CHECK(color_hex(name) == color.hex);
                const std::size_t place = rows.find("`" + name + "`");
                REQUIRE(place != std::string::npos);
                CHECK(rows.find("`" + name + "`", place + 1) == std::string::npos);
            }
        }
    CHECK(seen.size() == color_names().size());
    CHECK(page.find("see [Colours](#colours) | chosen by the film |") != std::string::npos);
}

TEST_CASE("the reference page tells every key, and its example is valid") {
    const std::string page = reference_page();
    for (const int dimension : {1, 2, 3}) {
        const Section scene = scene_table(panel_kinds(), dimension).section();
        for (const char* name : {"box", "gas", "run", "film"})
            for (const Key& key : section_of(scene, name).keys) {
                CAPTURE(key.name);
                CHECK(page.find("| `" + key.name + "` | " + key.meaning) != std::string::npos);
            }
    }
    CHECK(page.find("```yaml\n" + reference_example() + "```") != std::string::npos);
    CHECK(loaded(reference_example()).film.panels.size() == 2);
    CHECK(page.find("(limits.md)") != std::string::npos);
}

TEST_CASE("the page tells each key of panels once, and names it at each kind that takes it") {
    std::string page = reference_page();
    const std::size_t defaults = page.find("\n## `figure_defaults`\n");  // has some of a figure's
    REQUIRE(defaults != std::string::npos);
    page.erase(defaults, page.find("\n## ", defaults + 1) - defaults);
    const Section scene = scene_table(panel_kinds(), 2).section();
    const Section& panel = section_of(section_of(scene, "film"), "panels");
    const Section& figure = section_of(scene, "figures");
    for (const Section* section : {&panel, &figure, &section_of(scene, "measure")})
        for (const Key& key : section->keys) {
            CAPTURE(section->name);
            CAPTURE(key.name);
            std::set<std::string> rows;
            std::size_t count = 0;
            for (const std::string& line : lines_of(page))
                if (line.starts_with("| `" + key.name + "` | " + key.meaning)) {
                    rows.insert(line);
                    ++count;
                }
            CHECK(count >= 1);
            CHECK(count == rows.size());
            for (const std::string& kind : key.kinds) {
                CAPTURE(kind);
                const std::size_t begin = page.find("\n### `" + kind + "`\n");
                const std::string entry =
                    page.substr(begin, page.find("\n### ", begin + 1) - begin);
                CHECK(entry.find("`" + key.name + "`") != std::string::npos);
            }
        }
}

TEST_CASE("no item of the page is longer than a few lines") {
    constexpr std::size_t most = 600;
    for (const std::string& line : lines_of(reference_page())) {
        CAPTURE(line);
        const bool is_list_of_links = line.starts_with("[`speed-histogram`]");
        CHECK((line.size() <= most || is_list_of_links));
    }
}

TEST_CASE("the page tells what a wire and a box in space have otherwise") {
    const std::string page = reference_page();
    const std::size_t species = page.find("## An item of `gas`");
    REQUIRE(species != std::string::npos);
    const std::string part = page.substr(species, page.find("\n## ", species) - species);
    const std::size_t wire = part.find("On a wire:");
    REQUIRE(wire != std::string::npos);
    const std::size_t space = part.find("In space:");
    REQUIRE(space != std::string::npos);
    CHECK(part.find("| `radius` | The radius of each sphere.") > space);
    CHECK(part.find("density * 4/3 * pi * radius^3") > space);
    CHECK(page.find("Not in space: `disk`, `rectangle`, `polygon` and `segment`.") !=
          std::string::npos);
    CHECK(part.find("| `radius` | The radius of each disk.") < wire);
    CHECK(part.find("| `radius` | Half the length of each bead") > wire);
    CHECK(part.find("| `drawn_radius` | The radius with which disks are drawn") < wire);
    CHECK(part.find("| `drawn_radius` | The radius with which the beads are drawn") > wire);
    CHECK(part.find("| `speed` |", wire) != std::string::npos);
    REQUIRE(space > wire);
    CHECK(part.substr(wire, space - wire).find("| `count` |") == std::string::npos);
    CHECK(page.find("Not on a wire: `bottom` and `top`.") != std::string::npos);
}

TEST_CASE("the scene to start from is valid, and means what it says") {
    const std::string text = starter_scene(panel_kinds(), "scene.schema.json", "mine.yaml");
    CHECK(text.starts_with("# yaml-language-server: $schema=scene.schema.json\n"));
    CHECK(text.find("`carom render mine.yaml`") != std::string::npos);
    for (const std::string& line : lines_of(text)) {
        CAPTURE(line);
        CHECK((line.size() <= 100 || line.find(": ") != std::string::npos));
    }
    const Scene scene = loaded(text);
    CHECK(scene.gas.species.size() == 2);
    CHECK(scene.run.until == 75.0);
    CHECK(scene.film.panels.size() == 3);
}

TEST_CASE("each key behind a # in the scene to start from can be taken as it stands") {
    const std::vector<std::string> lines = lines_of(starter_scene(panel_kinds(), "s", "mine.yaml"));
    int taken = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch match;
        if (!std::regex_match(lines[i], match, hidden_key) || !is_key(match[2])) continue;
        std::vector<std::string> changed = lines;
        changed[i] = match[1].str() + match[2].str() + ": " + match[3].str();
        CAPTURE(changed[i]);
        ++taken;
        CHECK(loaded(joined(changed)).notes.empty());
    }
    CHECK(taken > 70);
}

TEST_CASE("the scene to start from offers every key of every section") {
    const std::string text = starter_scene(panel_kinds(), "s", "mine.yaml");
    const std::regex separators("\n *# ");
    const std::string words = std::regex_replace(text, separators, " ");
    for (const Section& section : sections_offered())
        for (const Key& key : section.keys) {
            CAPTURE(section.name);
            CAPTURE(key.name);
            const std::regex given("\n *(# )?" + key.name + ":");
            const bool is_offered = std::regex_search(text, given) ||
                                    words.find(", `" + key.name + ": ") != std::string::npos;
            CHECK(is_offered);
            CHECK(key.meaning.size() > 3);
        }
}

TEST_CASE("a scene made from another keeps its text behind a line of its own") {
    CHECK(starter_from("title: T\n", "a.json") ==
          "# yaml-language-server: $schema=a.json\ntitle: T\n");
    CHECK(starter_from("# yaml-language-server: $schema=b.json\n# words\n", "a.json") ==
          "# yaml-language-server: $schema=a.json\n# words\n");
    CHECK(starter_from("# yaml-language-server: $schema=b.json", "a.json") ==
          "# yaml-language-server: $schema=a.json\n");
}

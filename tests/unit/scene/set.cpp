// Figure sets: what they say, and how their mistakes are told.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "media/formats.h"
#include "panels/registry.h"
#include "scene/sets/set_reading.h"
#include "support/files.h"
#include "support/test_root.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

// A set in the folder sets/ of a folder with a scene.
struct Example {
    test::TemporaryFolder folder;
    fs::path path;

    explicit Example(const std::string& text) {
        fs::create_directory(folder.path() / "sets");
        folder.write("scene.yaml", "");
        folder.write("sets/beside.yaml", "");
        path = folder.write("sets/set.yaml", text);
    }

    std::string message() const {
        const fs::path before = fs::current_path();
        fs::current_path(folder.path());
        std::string text;
        try {
            load_figure_set("sets/set.yaml", panel_kinds(), figure_formats());
        } catch (const SceneError& error) {
            text = error.what();
        }
        fs::current_path(before);
        return text;
    }
};

}  // namespace

TEST_CASE("a set lists scenes, in its folder and in the one above") {
    const Example example(
        "title: T\nscenes:\n  - ../scene.yaml\n"
        "  - {scene: beside.yaml, title: Other, figures: [b, a]}\n"
        "template: [html, mine.md]\nformats: [png, svg]\n");
    CHECK(is_figure_set(example.path));
    const SetFile set = load_figure_set(example.path, panel_kinds(), figure_formats());
    CHECK(set.title == "T");
    CHECK(set.description.empty());
    REQUIRE(set.scenes.size() == 2);
    CHECK(fs::equivalent(set.scenes[0].path, example.folder.path() / "scene.yaml"));
    CHECK_FALSE(set.scenes[0].title.has_value());
    CHECK(set.scenes[0].figures.empty());
    CHECK(set.scenes[1].title == "Other");
    CHECK(set.scenes[1].figures.size() == 2);
    CHECK(set.scenes[1].figures[0].first == "b");
    CHECK(set.templates.size() == 2);
    CHECK(set.templates[0] == "html");
    CHECK(fs::path(set.templates[1]) == example.folder.path() / "sets/mine.md");
    CHECK(set.formats == std::vector<std::string>{"png", "svg"});
}

TEST_CASE("a set has a page in HTML, unless it says otherwise") {
    const Example example("title: T\nscenes: [beside.yaml]\n");
    CHECK(load_figure_set(example.path, panel_kinds(), figure_formats()).templates ==
          std::vector<std::string>{"html"});
}

TEST_CASE("a scene is no set, nor is what cannot be read") {
    CHECK_FALSE(is_figure_set(carom::test::checkout() / "scenes/cradle.yaml"));
    CHECK_FALSE(is_figure_set("nowhere.yaml"));
    CHECK_FALSE(is_figure_set(
        Example("title: T\nbox: {size: [9, 9]}\ngas: []  # as in other scenes\n").path));
}

TEST_CASE("a set is known by its key, however that is written") {
    CHECK(is_figure_set(Example("{title: T, 'scenes': [beside.yaml]}\n").path));
    CHECK(is_figure_set(Example("title: T\n\"sc\\x65nes\": [beside.yaml]\n").path));
}

TEST_CASE("mistakes in a set are told with their places") {
    CHECK(Example("titel: T\nscenes:\n  - /etc/passwd\n  - ../../scene.yaml\n").message() ==
          "sets/set.yaml:1:1: error: `titel` is not a key of a figure set\n"
          "    1 | titel: T\n"
          "      | ^^^^^\n"
          "  hint: did you mean `title`?\n"
          "\n"
          "sets/set.yaml:3:5: error: the scene `/etc/passwd` is neither in the set's folder nor in "
          "the one above\n"
          "    3 |   - /etc/passwd\n"
          "      |     ^^^^^^^^^^^\n"
          "  hint: give its path from the set: ../one-hot-particle.yaml\n"
          "\n"
          "sets/set.yaml:4:5: error: the scene `../../scene.yaml` is neither in the set's folder "
          "nor in the one above\n"
          "    4 |   - ../../scene.yaml\n"
          "      |     ^^^^^^^^^^^^^^^^\n"
          "  hint: give its path from the set: ../one-hot-particle.yaml");
    CHECK(
        Example("title: T\nscenes: [{title: a}]\ntemplate: word\nformats: [jpg]\n").message() ==
        "sets/set.yaml:2:10: error: an item of `scenes` needs `scene`\n"
        "    2 | scenes: [{title: a}]\n"
        "      |          ^^^^^^^^^^\n"
        "  hint: `scene`: The scene's file, relative to the set; it may lie in the folder above "
        "the set's.\n"
        "\n"
        "sets/set.yaml:3:11: error: expected a template of pages, found `word`\n"
        "    3 | template: word\n"
        "      |           ^^^^\n"
        "  hint: `markdown`, `html`, `latex`, or a file beside the set that ends in .md, .html or "
        ".tex\n"
        "\n"
        "sets/set.yaml:4:11: error: expected `svg`, `pdf`, `png` or `csv` for an item of "
        "`formats`, "
        "found `jpg`\n"
        "    4 | formats: [jpg]\n"
        "      |           ^^^\n"
        "  hint: for instance `svg`");
    CHECK(Example("").message().find("the set is empty") != std::string::npos);
}

TEST_CASE("a link does not lead a set out of its folders") {
    const Example example("title: T\nscenes: [link.yaml]\n");
    fs::create_symlink("/etc/passwd", example.folder.path() / "sets/link.yaml");
    CHECK(example.message().find("neither in the set's folder") != std::string::npos);
}

TEST_CASE("a scene that is not there is told with its place in the set") {
    CHECK(Example("title: T\nscenes:\n  - ../scen.yaml\n  - {scene: .}\n  - besides\n"
                  "comparisons:\n  - {name: c, kind: entropy, scenes: [beside.yaml, none.yaml]}\n")
              .message() ==
          "sets/set.yaml:3:5: error: the scene `../scen.yaml` is not there\n"
          "    3 |   - ../scen.yaml\n"
          "      |     ^^^^^^^^^^^^\n"
          "  hint: did you mean `scene.yaml`?\n"
          "\n"
          "sets/set.yaml:4:13: error: the scene `.` is a folder\n"
          "    4 |   - {scene: .}\n"
          "      |             ^\n"
          "\n"
          "sets/set.yaml:5:5: error: the scene `besides` is not there\n"
          "    5 |   - besides\n"
          "      |     ^^^^^^^\n"
          "  hint: paths are relative to the set\n"
          "\n"
          "sets/set.yaml:7:52: error: the scene `none.yaml` is not there\n"
          "    7 |   - {name: c, kind: entropy, scenes: [beside.yaml, none.yaml]}\n"
          "      |                                                    ^^^^^^^^^\n"
          "  hint: paths are relative to the set");
}

TEST_CASE("a comparison has no keys of kinds that cannot be compared") {
    const std::string message =
        Example(
            "title: T\nscenes: [beside.yaml]\ncomparisons:\n"
            "  - {name: a, kind: temperature, scenes: [beside.yaml, ../scene.yaml], walk: true}\n")
            .message();
    CHECK(message.find("`walk` is not a key of a comparison") != std::string::npos);
}

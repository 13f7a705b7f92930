// Styles: their keys, where they are found, and what pictures take from them.
#include "scene/style/style.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "media/formats.h"
#include "panels/registry.h"
#include "scene/load.h"
#include "scene/reading/figure_reading.h"
#include "scene/scene.h"
#include "scene/sets/set_reading.h"
#include "support/files.h"
#include "support/relative.h"
#include "support/resources.h"
#include "util/diagnostics.h"

using namespace carom;
using test::relative;

namespace {

const std::string plain = R"(title: A gas
box: {size: [40, 30]}
gas: [{name: a, count: 20, radius: 0.5, temperature: 1}]
run: {until: 10}
)";

void write_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

SceneResources with_style(const std::string& style) {
    SceneResources resources = test::resources();
    resources.files["house.yaml"] = style;
    return resources;
}

Scene styled(const std::string& style, const std::string& more = "", const Overrides& sets = {}) {
    return load_scene_text(plain + "style: house.yaml\n" + more, "scene.yaml", with_style(style),
                           sets);
}

std::vector<Diagnostic> errors_of(const std::string& style, const SceneResources& resources) {
    SceneResources its = resources;
    its.files["house.yaml"] = style;
    try {
        load_scene_text(plain + "style: house.yaml\n", "scene.yaml", its);
    } catch (const SceneError& error) {
        return error.diagnostics();
    }
    return {};
}

}  // namespace

TEST_CASE("a style gives a scene its theme, colours, fonts and sizes") {
    const Scene scene = styled(R"(base: print
font: Latin Modern Roman
numbers: Inter
sizes: {figure: {width: 80 mm, text: 8 pt}, film: {text: 1.1}}
colors: {page: "#fffdf8", theory: crimson, series: ["#0b7285", teal], slow: "#000080", fast: red}
figures: {format: [pdf, png], theme: light, dpi: 600}
)",
                               "figures: [{name: f, kind: speed-histogram}]\n");
    const Style& style = *scene.film.style;
    CHECK(scene.film.theme == ThemeName::print);
    CHECK(style.fonts == StyleFonts{"Latin Modern Roman", "Inter", ""});
    CHECK(style.colors.of.at("page") == "#fffdf8");
    CHECK(style.colors.of.at("theory") == "#dc143c");
    CHECK(style.colors.series == std::vector<std::string>{"#0b7285", "#008080"});
    CHECK(style.film_text == 1.1);
    CHECK(style.figure_text == 8.0);
    CHECK(style.dots == 600.0);
    CHECK(scene.figure_formats == std::vector<std::string>{"pdf", "png"});
    CHECK(scene.figures[0].theme == ThemeName::light);
    CHECK(scene.figures[0].width == relative(8.0, 1e-9));
    CHECK(scene.figures[0].style == scene.film.style);
    CHECK(scene.source.files.contains("house.yaml"));
    const Scene without = load_scene_text(plain, "scene.yaml", test::resources());
    CHECK(without.film.style == nullptr);
    CHECK(without.source.physics == scene.source.physics);
}

TEST_CASE("what a scene and its figures say wins over the style") {
    const Scene scene = styled("sizes: {figure: {width: 8 cm}}\nbase: light\n", R"(
film: {theme: dark}
figure_defaults: {theme: print, size: [6, 4], format: svg}
figures:
  - {name: a, kind: speed-histogram}
  - {name: b, kind: speed-histogram, theme: light, width: 3 in}
  - {name: c, kind: speed-histogram, size: slide}
)");
    CHECK(scene.film.theme == ThemeName::dark);
    CHECK(scene.figure_formats == std::vector<std::string>{"svg"});
    CHECK(scene.figures[0].theme == ThemeName::print);
    CHECK(scene.figures[0].width == 6.0);
    CHECK(scene.figures[0].height == 4.0);
    CHECK(scene.figures[1].theme == ThemeName::light);
    CHECK(scene.figures[1].width == relative(7.62, 1e-9));
    CHECK(!scene.figures[1].height);
    CHECK(scene.figures[2].slide);
}

TEST_CASE("widths of figures have units") {
    for (const auto& [written, centimetres] : {std::pair{"8", 8.0},
                                               {"8 cm", 8.0},
                                               {"8cm", 8.0},
                                               {"85 mm", 8.5},
                                               {"3.5 in", 8.89},
                                               {"252 pt", 8.89},
                                               {"336 px", 8.89}}) {
        CAPTURE(written);
        const auto figure = [](const std::string& keys) {
            return load_scene_text(
                       plain + "figures: [{name: a, kind: speed-histogram, " + keys + "}]\n",
                       "scene.yaml", test::resources())
                .figures.at(0);
        };
        CHECK(figure(std::string("width: ") + written).width == relative(centimetres, 1e-9));
        CHECK(figure(std::string("size: ") + written).width == relative(centimetres, 1e-9));
        const FigureSpec both = figure(std::string("size: [9 cm, ") + written + "]");
        CHECK(both.width == 9.0);
        CHECK(both.height.value() == relative(centimetres, 1e-9));
    }
    CHECK_THROWS_AS(load_scene_text(plain + "figures: [{name: a, kind: gas, width: 8 em}]\n", "s",
                                    test::resources()),
                    SceneError);
    CHECK_THROWS_AS(load_scene_text(plain + "figures: [{name: a, kind: gas, width: 8 m}]\n", "s",
                                    test::resources()),
                    SceneError);
}

TEST_CASE("mistakes in a style have their places in its file, and hints") {
    const SceneResources resources = test::resources();
    const auto wrong =
        errors_of("base: bright\ncolors:\n  pgae: white\n  slow: blue\nfnot: Inter\n", resources);
    REQUIRE(wrong.size() == 4);
    CHECK(wrong[0].span.file == "house.yaml");
    CHECK(wrong[0].span.line == 1);
    CHECK(wrong[0].hint == "did you mean `light`?");
    CHECK(wrong[1].span.line == 3);
    CHECK(wrong[1].span.column == 3);
    CHECK(wrong[1].hint.starts_with("did you mean `page`?"));
    CHECK(wrong[2].span.line == 4);
    CHECK(wrong[2].hint == "give both");
    CHECK(wrong[3].span.line == 5);
    CHECK(wrong[3].hint.starts_with("did you mean `font`?"));
}

TEST_CASE("a font that the machine lacks is an error that names the nearest") {
    SceneResources resources = test::resources();
    resources.styles.families = [] {
        return std::vector<std::string>{"DejaVu Sans", "Inter", "Source Sans 3"};
    };
    CHECK(errors_of("font: source sans 3\nnumbers: Inter\n", resources).empty());
    const auto near = errors_of("colors: {}\nfont: Sorce Sans 3\n", resources);
    REQUIRE(near.size() == 1);
    CHECK(near[0].message == "this machine has no font `Sorce Sans 3`");
    CHECK(near[0].hint == "did you mean `Source Sans 3`?");
    CHECK(near[0].span.line == 2);
    const auto like = errors_of("formulas: DejaVu Blackletter\n", resources);
    REQUIRE(like.size() == 1);
    CHECK(like[0].hint.starts_with("the nearest that is there is `DejaVu Sans`"));
    const auto known = errors_of("font: Latin Modern Roman\n", resources);
    REQUIRE(known.size() == 1);
    CHECK(known[0].hint == "install the Debian package fonts-lmodern");
}

TEST_CASE("runs that are compared or beside have colours") {
    const Scene scene = load_scene_text(plain + R"(
film:
  beside: {own_label: a, label: b, set: seed=2, own_color: teal, color: "#aa0000"}
figures:
  - name: f
    kind: speed-histogram
    compare: [{label: a, color: navy}, {label: b, set: seed=2}]
)",
                                        "scene.yaml", test::resources());
    CHECK(scene.film.runs.colors() ==
          std::vector<std::optional<std::string>>{"#008080", "#aa0000"});
    CHECK(scene.figures[0].compare[0].color == "#000080");
    CHECK(!scene.figures[0].compare[1].color);
}

TEST_CASE("figures take keys from an anchor") {
    const Scene scene = load_scene_text(plain + R"(
figure_defaults: &all {theme: print, width: 6 cm}
figures:
  - {name: a, kind: speed-histogram, <<: *all, theme: dark, x_title: v, y_title: ""}
)",
                                        "scene.yaml", test::resources());
    CHECK(scene.figures[0].theme == ThemeName::dark);
    CHECK(scene.figures[0].width == 6.0);
    CHECK(scene.figures[0].panel.x_title == "v");
    CHECK(scene.figures[0].panel.y_title == "");
}

TEST_CASE("a style is found beside the scene, by name, and on the command line") {
    const test::TemporaryFolder folder;
    write_file(folder.path() / "scene.yaml", plain + "style: mine\n");
    write_file(folder.path() / "mine.yaml", "base: print\n");
    write_file(folder.path() / "other.yaml", "base: dark\n");
    const SceneResources resources = test::resources();
    const auto path = folder.path() / "scene.yaml";
    CHECK(load_scene(path, resources).film.theme == ThemeName::print);
    CHECK(load_scene(path, resources, {"style=conference"}).film.theme == ThemeName::dark);
    CHECK(load_scene(path, resources, {"style=" + (folder.path() / "other.yaml").string()})
              .film.theme == ThemeName::dark);
    try {
        load_scene(path, resources, {"style=confrence"});
        FAIL("there is no such style");
    } catch (const SceneError& error) {
        CHECK(error.diagnostics().front().message == "there is no style `confrence`");
        CHECK(error.diagnostics().front().hint == "did you mean `conference`?");
    }
}

TEST_CASE("a figure set gives its scenes and comparisons a style and defaults") {
    const test::TemporaryFolder folder;
    write_file(folder.path() / "scene.yaml", plain + R"(
figures: [{name: a, kind: speed-histogram}, {name: b, kind: speed-histogram, theme: light}]
)");
    write_file(folder.path() / "house.yaml", "base: print\nsizes: {figure: {width: 7 cm}}\n");
    write_file(folder.path() / "set.yaml", R"(title: A set
scenes: [scene.yaml]
comparisons:
  - {name: c, kind: speed-histogram, scenes: [scene.yaml, {scene: scene.yaml, label: b, set: seed=2}]}
style: house.yaml
figure_defaults: {format: [svg], width: 60 mm}
)");
    const SetFile set =
        load_figure_set(folder.path() / "set.yaml", panel_kinds(), figure_formats());
    CHECK(set.formats == std::vector<std::string>{"svg"});
    SceneResources resources = test::resources();
    resources.set = set.defaults;
    const Scene scene = load_scene(folder.path() / "scene.yaml", resources);
    CHECK(scene.film.theme == ThemeName::print);
    CHECK(scene.figures[0].theme == ThemeName::print);
    CHECK(scene.figures[0].width == relative(6.0, 1e-9));
    CHECK(scene.figures[1].theme == ThemeName::light);
    const FigureSpec compared = figure_of(set.comparisons.front(), scene, panel_kinds());
    CHECK(compared.theme == ThemeName::print);
    CHECK(compared.width == relative(6.0, 1e-9));
    CHECK(compared.style == scene.film.style);
}

TEST_CASE("the formats of figures are those that are written") {
    CHECK(std::vector<std::string>(figure_format_names.begin(), figure_format_names.end()) ==
          figure_formats());
}

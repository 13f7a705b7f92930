// Figures of gases in space: the examples of the manual, with a third length of the box.
#include <doctest/doctest.h>

#include <regex>
#include <string>
#include <vector>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "support/figure_run.h"
#include "support/files.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;

namespace {

// A scene of the manual in a box that is 30 deep.
std::string in_space(std::string scene) {
    const std::string number = "(-?[0-9.]+)";
    const auto write = [&](const std::string& pattern, const std::string& instead) {
        scene = std::regex_replace(scene, std::regex(pattern), instead);
    };
    write("title: [^\n]*", "title: T");
    write("box: \\{size: \\[" + number + ", " + number + "\\]", "box: {size: [$1, $2, 30]");
    write("gaps: \\[\\[" + number + ", " + number + "\\]\\]", "gaps: [[$1, 0, $2, 30]]");
    write("\\[\\[" + number + ", " + number + "\\]\\]", "[[$1, $2, 0.5]]");
    write("gravity: \\[" + number + ", " + number + "\\]", "gravity: [$1, $2, 0]");
    write("within: \\[" + number + ", " + number + ", " + number + ", " + number + "\\]",
          "within: [$1, $2, 0, $3, $4, 30]");
    return scene;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// Nothing of a plane is said of a gas in space.
void check_words(const std::string& text) {
    for (const char* word : {"disk", "Disk", "plane", "area", "Hexagonal", "hexagonal"})
        CHECK_MESSAGE(!has(text, word), word << ": " << text);
}

}  // namespace

TEST_CASE("the kinds of panels show a gas in space, in its words and units") {
    int shown = 0;
    bool counts_spheres = false, has_pressure = false;
    for (const PanelKind& kind : panel_kinds()) {
        CAPTURE(kind.name);
        const std::string written =
            test::contents(test::checkout() / "docs/panels" / (kind.name + ".yaml"));
        if (!kind.in_space_instead.empty() || has(written, "length:")) continue;
        ++shown;
        const Scene scene = test::scene_from(in_space(written));
        REQUIRE(scene.gas.box.dimension == 3);
        const FigureRun run = test::run_of(scene);
        const Figure& figure = run.figures().front();
        const FigureWords words = words_of(run, figure);
        check_words(words.caption);
        check_words(words.alt);
        counts_spheres = counts_spheres || has(words.caption, " spheres");
        for (const std::string& column : column_names(table_of(figure))) {
            check_words(column);
            has_pressure = has_pressure || has(column, "energy/volume");
        }
        draw_figure(run, figure, VectorFormat::svg, {});
    }
    CHECK(shown >= 32);
    CHECK(counts_spheres);
    CHECK(has_pressure);
}

TEST_CASE("runs in space, in a plane and on a line side by side are those of each") {
    const std::string scene =
        "title: T\nbox: {size: [30, 22, 20]}\ngas: [{count: 40, radius: 0.3, "
        "speed: 2}]\nrun: {until: 4}\nfilm: {seconds: 1}\nfigures: [{name: a, ";
    const std::vector<std::pair<std::string, std::string>> boxes{{"space", "box.size=[30, 22, 20]"},
                                                                 {"plane", "box.size=[30, 22]"},
                                                                 {"line", "box={length: 30}"}};
    int compared = 0;
    for (const PanelKind& kind : panel_kinds()) {
        if (!kind.can(Ability::any_space)) continue;
        CAPTURE(kind.name);
        ++compared;
        std::string runs;
        for (const auto& [label, value] : boxes)
            runs += (runs.empty() ? "" : ", ") + ("{label: " + label + ", set: \"" + value + "\"}");
        const bool has_bars = kind.can(Ability::bars);
        const std::string figure =
            "kind: " + kind.name + ", at: 4" +
            (has_bars ? ", bins: 12, range: [0, 6], mean_now: false, mean_start: false" : "");
        const FigureRun together =
            test::run_of(test::scene_from(scene + figure + ", compare: [" + runs + "]}]\n"));
        const Table table = table_of(together.figures().front());
        for (const auto& [label, value] : boxes) {
            CAPTURE(label);
            const FigureRun alone =
                test::run_of(test::scene_from(scene + figure + "}]\n", {value}));
            std::vector<std::vector<TableCell>> rows;
            for (const std::vector<TableCell>& row : table.rows)
                if (std::get<std::string>(row.front()) == label)
                    rows.emplace_back(row.begin() + 1, row.end());
            CHECK(rows == table_of(alone.figures().front()).rows);
        }
    }
    CHECK(compared == 4);
}

// Collision maps as figures: their words, whole and apart at every size, and their true numbers.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "panels/collision/collision_map_keys.h"
#include "support/figure_run.h"
#include "support/files.h"
#include "support/scene_text.h"
#include "support/test_root.h"

using namespace carom;
using test::run_of;

namespace {

Scene scene_of(const std::string& figures) {
    return test::scene_from(
        "title: Two beads\nbox: {length: 26}\ndescription: They meet.\n"
        "gas:\n  - {name: light, position: 4, mass: 1, velocity: 0}\n"
        "  - {name: heavy, position: 14, mass: 100, velocity: -1}\n"
        "run: {until: 26}\nfilm: {seconds: 2, fps: 10}\nfigures:\n" +
        figures);
}

bool collide(const DrawnLine& a, const DrawnLine& b) {
    const double gap = 0.25 * std::min(a.size, b.size);
    return std::min(a.ink.right(), b.ink.right()) - std::max(a.ink.x, b.ink.x) > -gap &&
           std::min(a.ink.bottom(), b.ink.bottom()) > std::max(a.ink.y, b.ink.y);
}

}  // namespace

TEST_CASE("words of collision maps are whole and apart at every size, in every theme") {
    const std::vector<std::string> maps{"of: [0, 1]",
                                        "of: [1, 0], scaled: true",
                                        "walk: true, of: [1, 0]",
                                        "walk: true, scaled: false",
                                        "masses: [1, 3], velocities: [1, -0.2]",
                                        "masses: [1, infinite], velocities: [-1.2345, -123.456]",
                                        "masses: [infinite, 2.5], velocities: [0, -0.5]",
                                        "masses: [1e-6, 123456], velocities: [1e5, -1e-5]"};
    const std::vector<std::string> sizes{"column",  "page",    "slide",  "[4, 3]",
                                         "[5, 10]", "[16, 3]", "[12, 8]"};
    std::string figures;
    int count = 0;
    for (const std::string& map : maps)
        for (const std::string& size : sizes) {
            ++count;
            figures +=
                fmt::format("  - {{name: a{0}, kind: collision-map, {1}, size: {2}, theme: {3}}}\n",
                            count, map, size, count % 3 == 0 ? "dark" : "print");
        }
    const Scene scene = scene_of(figures);
    const FigureRun run = run_of(scene);
    std::size_t seen = 0;
    for (const Figure& figure : run.figures()) {
        CAPTURE(figure.spec->name);
        const TextLog log;
        const Canvas canvas = draw_figure(run, figure, std::nullopt, {"title", "words"});
        for (std::size_t i = 0; i < log.lines.size(); ++i) {
            const DrawnLine& line = log.lines[i];
            CAPTURE(line.markup);
            CHECK_FALSE(line.is_cut);
            CHECK(line.ink.x >= 0);
            CHECK(line.ink.y >= 0);
            CHECK(line.ink.right() <= canvas.size().width);
            CHECK(line.ink.bottom() <= canvas.size().height);
            for (std::size_t k = 0; k < i; ++k) {
                CAPTURE(log.lines[k].markup);
                CHECK_FALSE(collide(line, log.lines[k]));
            }
        }
        const auto says = [&](const std::string& words) {
            return std::ranges::count(log.lines, words, &DrawnLine::markup);
        };
        CHECK(says("present") == 0);  // a figure has none, but a time
        const bool is_walk = figure.spec->panel.options.as<CollisionMapOptions>().walk;
        if (is_walk && figure.spec->width > 5.0) CHECK(says("at time 26") == 1);
        seen += log.lines.size();
    }
    CHECK(seen > 400);
}

TEST_CASE("captions and alternative texts of collision maps have the numbers that they show") {
    const Scene scene = scene_of(
        "  - {name: a, kind: collision-map, walk: true, of: [1, 0]}\n"
        "  - {name: b, kind: collision-map, walk: true, of: [1, 0], at: 0}\n"
        "  - {name: c, kind: collision-map, masses: [1, 3], velocities: [1, -0.2]}\n"
        "  - {name: d, kind: collision-map, masses: [1, infinite], velocities: [1, -0.5]}\n"
        "  - {name: e, kind: collision-map, caption: Mine}\n"
        "  - {name: f, kind: collision-map, masses: [3, 0.1], velocities: [0.1, -3]}\n");
    const FigureRun run = run_of(scene);
    const auto words = [&](std::size_t index) { return words_of(run, run.figures()[index]); };
    CHECK(words(0).caption ==
          "Two beads. Collision map. Beads of mass 100 and mass 1 at energy 50: 16 collisions "
          "with one another and 15 with a wall, from velocities −1 and 0 to 0.999 and 0.478.");
    CHECK(
        words(0).alt ==
        "Collision map from time 0 to 26. Beads of mass 100 and mass 1 at energy 50: 16 collisions "
        "with one another and 15 with a wall, from velocities −1 and 0 to 0.999 and 0.478.");
    CHECK(words(1).caption.find("0 collisions with one another and 0 with a wall, from velocities "
                                "−1 and 0 to −1 and 0.") != std::string::npos);
    CHECK(words(2).caption ==
          "Two beads. Collision map. Beads of mass 1 and mass 3, with velocities 1 and −0.2 before "
          "their collision and −0.8 and 0.4 after it: energy 0.56 and momentum 0.4 are conserved.");
    // Not of the scene, nor of a time.
    CHECK(words(2).alt ==
          "Collision map. Beads of mass 1 and mass 3, with velocities 1 and −0.2 before "
          "their collision and −0.8 and 0.4 after it: energy 0.56 and momentum 0.4 are conserved.");
    CHECK(words(3).caption.find("−2 and −0.5 after it: the infinite mass keeps its velocity, "
                                "and the relative speed 1.5 is conserved.") != std::string::npos);
    CHECK(words(4).caption == "Mine");
    CHECK(words(5).caption.find("momentum 0 are conserved") !=
          std::string::npos);  // but for round-off
}

TEST_CASE("the manual's example of collision maps is a scene with one figure of each kind") {
    const std::string manual = test::contents(carom::test::checkout() / "docs/figures.md");
    const std::size_t from = manual.find("```yaml\n", manual.find("## Collision maps")) + 8;
    const Scene scene = test::scene_from("title: Two beads\n" +
                                         manual.substr(from, manual.find("```", from) - from));
    const FigureRun run = run_of(scene);
    REQUIRE(run.figures().size() == 5);
    for (const Figure& figure : run.figures()) CHECK(figure.spec->panel.kind == "collision-map");
    CHECK(words_of(run, run.figures()[2]).caption.find("5 collisions with one another and 4") !=
          std::string::npos);
}

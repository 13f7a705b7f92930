// Fields over the gas and profiles: their numbers, and what is seen of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "draw/text.h"
#include "panels/field/field_layer.h"
#include "panels/frame.h"
#include "panels/gas/particle_panel.h"
#include "panels/plot/plot_panel.h"
#include "panels/registry.h"
#include "panels/table.h"
#include "scene/scene.h"
#include "support/first_frame.h"
#include "support/scene_text.h"
#include "util/archive.h"

using namespace carom;

namespace {

// Twelve at rest in the lower left quarter, two in the lower right one, four that move in the upper
// left one.
const std::string three_groups =
    "gas: [{name: many, count: 12, radius: 0.1, position: {within: [1, 1, 9, 9]}}, "
    "{name: two, count: 2, radius: 0.1, position: {within: [11, 1, 19, 9]}}, "
    "{name: moving, count: 4, radius: 0.1, mass: 2, position: [[2, 12], [4, 12], [6, 12], [8, "
    "12]], "
    "velocity: [[1, 0], [3, 0], [1, 0], [3, 0]]}]\n";

Scene scene_with(const std::string& field, const std::string& more = "panels: []",
                 const std::string& gas = three_groups) {
    const std::string box = gas.starts_with("walls") ? ", " : "}\n";
    return test::scene_from("title: T\nbox: {size: [20, 20]" + box + gas +
                            "run: {until: 4}\nfilm: {seconds: 1, size: [1280, 720], field: {" +
                            field + "}, " + more + "}\n");
}

std::vector<float> values_of(const Scene& scene) {
    const test::FirstFrame first(scene);
    return static_cast<const ParticleState&>(*first.frame.states.front()).field->values;
}

// Draws all frames of a scene.
struct WholeFilm {
    Scene scene;
    Simulation simulation;
    PanelSet panels;
    explicit WholeFilm(Scene its)
        : scene(std::move(its)),
          simulation(scene.gas, scene.run),
          panels(scene, simulation.particles(), simulation.sample()) {}
    Recording record() {
        Recording run = panels.record(simulation, timeline(scene), [](auto&&...) {});
        panels.fix_axes();
        return run;
    }
    // The values of the last frame.
    static std::vector<float> last(PanelSet& set, const Recording& run) {
        std::vector<float> values;
        run.play(run.ticks().size(), [&](const Tick& tick, const Sample& sample,
                                         const AdvanceResult& advanced) {
            const FrameData frame = set.frame_data(tick, sample, advanced);
            values = static_cast<const ParticleState&>(*frame.states.front()).field->values;
        });
        return values;
    }
};

}  // namespace

TEST_CASE("a field shows what is in its cells, and nothing where there are fewer than three") {
    const std::vector<float> density = values_of(scene_with("of: density, cells: 2"));
    REQUIRE(density.size() == 4);
    CHECK(density[0] == doctest::Approx(0.12));
    CHECK(std::isnan(density[1]));
    CHECK(density[2] == doctest::Approx(0.04));
    CHECK(std::isnan(density[3]));
    CHECK(values_of(scene_with("of: speed, cells: 2"))[2] == doctest::Approx(2.0));
    CHECK(values_of(scene_with("of: flow, cells: 2"))[2] == doctest::Approx(2.0));
    // Four of mass 2 that are 1 from their mean: 4 * 2 * 1² over 2 * 3.
    CHECK(values_of(scene_with("of: temperature, cells: 2"))[2] == doctest::Approx(4.0 / 3.0));
    const std::vector<float> share =
        values_of(scene_with("of: concentration, species: many, cells: 2"));
    CHECK(share[0] == doctest::Approx(1.0));
    CHECK(share[2] == doctest::Approx(0.0));
}

TEST_CASE("the scale of a field is one for the film, and is read back with it") {
    WholeFilm film(scene_with("of: density, cells: 4, over: 1", "panels: []",
                              "walls: {left: {temperature: 1}, bottom: {temperature: 1}}}\n"
                              "gas: [{count: 200, radius: 0.1, temperature: 1}]\n"));
    const Recording run = film.record();
    const std::vector<float> values = WholeFilm::last(film.panels, run);
    Archive written;
    film.panels.archive(written);
    PanelSet again(film.scene, film.simulation.particles(), film.simulation.sample());
    Archive read(written.finished(), "a test");
    again.archive(read);
    read.expect_end();
    const std::vector<float> values_again = WholeFilm::last(again, run);
    REQUIRE(values.size() == values_again.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        CHECK(values[k] == values_again[k]);
        sum += static_cast<double>(values[k]);
    }
    // All cells are full enough: each has 25, and all together 200 particles.
    CHECK(sum == doctest::Approx(200.0 / 25.0).epsilon(1e-5));
}

TEST_CASE("along a direction in which all places are alike a field is the mean, and says so") {
    const auto words_of = [](const std::string& gas) {
        return words_of_field(scene_with("of: density, cells: 4", "panels: []", gas));
    };
    const std::string disks = "gas: [{count: 200, radius: 0.1, temperature: 1}]\n";
    const Scene scene = scene_with("of: density, cells: 4", "panels: []",
                                   "walls: {left: {temperature: 4}}}\n" + disks);
    const test::FirstFrame first(scene);
    const std::vector<float>& slabs =
        static_cast<const ParticleState&>(*first.frame.states.front()).field->values;
    REQUIRE(slabs.size() == 4);
    std::vector<double> counts(4);
    Simulation simulation(scene.gas, scene.run);
    for (const double x : simulation.sample().position.col(0))
        counts[static_cast<std::size_t>(x / 5.0)] += 1.0;
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(slabs[k] == doctest::Approx(counts[k] / (5.0 * 20.0)));
    CHECK(
        words_of("walls: {left: {temperature: 4}}}\n" + disks) ==
        "Field: density, mean over height and the last 0.5, in cells of 5 by 20; cells with fewer "
        "than 3 particles are blank");
    CHECK(words_of("walls: {top: {temperature: 4}}}\n" + disks).find("mean over width and") !=
          std::string::npos);
    CHECK(words_of(disks).find("mean over the box and the last 0.5, in cells of 20 by 20") !=
          std::string::npos);
    CHECK(words_of(three_groups).find("density, mean over the last 0.5, in cells of 5 by 5") !=
          std::string::npos);
}

TEST_CASE("disks over a field hide nothing of it") {
    const std::string gas =
        "gas: [{name: large, count: 4, radius: 4, position: [[5, 5], [15, 5], [5, 15], "
        "[15, 15]]}, {name: dots, count: 12, radius: 0.05, position: {within: "
        "[1, 1, 9, 9]}}]\n";
    const test::FirstFrame first(
        scene_with("of: density, cells: 2, opacity: 1", "panels: []", gas));
    const Rect box = first.box();
    const auto at = [&](double x, double y) {
        return first.view
                   .data[std::lround(box.bottom() - y * box.height / 20.0) * first.view.stride +
                         std::lround(box.x + x * box.width / 20.0)] &
               0xFFFFFF;
    };
    // Inside of a disk, between disks, and in a cell with a disk alone.
    CHECK(at(9.5, 9.5) == at(9.7, 0.3));
    CHECK(at(5.0, 8.5) == at(9.7, 0.3));
    CHECK(at(15.0, 5.0) == at(19.5, 9.5));
    CHECK(at(15.0, 5.0) != at(5.0, 8.5));
}

TEST_CASE("the outlines of disks stand out from the darkest and the lightest cells of a field") {
    const std::string gas =
        "gas: [{name: many, count: 60, radius: 0.1, position: {within: [1, 1, 9, 9]}}, {name: few, "
        "count: 3, radius: 0.1, position: {within: [11, 11, 19, 19]}}]\n";
    for (const std::string kind : {"dark", "light", "print"})
        for (const std::string palette : {"viridis", "magma"}) {
            CAPTURE(kind + ", " + palette);
            const test::FirstFrame first(
                scene_with("of: density, cells: 2",
                           "panels: [], theme: " + kind + ", palette: " + palette, gas));
            const Theme& theme = theme_of(first.scene.film.theme);
            const Rect box = first.box();
            const auto at = [&](double x, double y) {
                const PixelView& view = first.view;
                return rgb(
                    view.data[std::lround(box.bottom() - y * box.height / 20.0) * view.stride +
                              std::lround(box.x + x * box.width / 20.0)] &
                    0xFFFFFF);
            };
            const Color most = at(0.5, 0.5), least = at(19.5, 19.5);
            CHECK(contrast(theme.ink, most) >= 2.0);
            CHECK(contrast(theme.ink, least) >= 2.0);
            CHECK(contrast(most, least) >= 1.5);
            CHECK(to_pixel(least) != to_pixel(theme.ground));
        }
}

TEST_CASE("hot cells are warmer in colour than cold ones, in dark and light themes") {
    const std::string gas =
        "gas: [{name: hot, count: 60, radius: 0.1, temperature: 4, position: {within: [1, 1, 9, "
        "9]}}, {name: cold, count: 60, radius: 0.1, temperature: 0.2, position: {within: [11, 11, "
        "19, 19]}}]\n";
    for (const std::string kind : {"dark", "light"}) {
        CAPTURE(kind);
        const test::FirstFrame first(
            scene_with("of: temperature, cells: 2", "panels: [], theme: " + kind, gas));
        const Rect box = first.box();
        const auto at = [&](double x, double y) {
            return rgb(first.view.data[std::lround(box.bottom() - y * box.height / 20.0) *
                                           first.view.stride +
                                       std::lround(box.x + x * box.width / 20.0)] &
                       0xFFFFFF);
        };
        const Color hot = at(0.5, 0.5), cold = at(19.5, 19.5);
        CHECK(hot.red - hot.blue > cold.red - cold.blue + 0.2);
    }
}

TEST_CASE("a field is listed and told in words") {
    const test::FirstFrame first(scene_with("of: density, cells: 2"));
    const Table table = first.panels.gas().table(*first.frame.states.front(), Theme{});
    CHECK(column_names(table).back() == "density (1/length^2)");
    int cells = 0;
    for (const std::vector<TableCell>& row : table.rows) {
        REQUIRE(row.size() == table.columns.size());
        const auto* part = std::get_if<std::string>(&row.front());
        cells += part != nullptr && *part == "cell";
    }
    CHECK(cells == 4);
    const std::string words = first.panels.gas().account(*first.frame.states.front());
    CHECK(words ==
          "Field: density, mean over the last 0.5, in cells of 10 by 10; cells with fewer than 3 "
          "particles are blank. The values are between 0.0400 and 0.120.");
}

TEST_CASE("the key of a flow has the numbers of the film's language") {
    // The scale of a flow of 0.45 ends at 0.6.
    const std::string gas = "gas: [{count: 20, radius: 0.1, velocity: [0.45, 0]}]\n";
    const test::FirstFrame first(scene_with("of: flow, cells: 2", "panels: [], language: de", gas));
    const TextLog log;
    FramePainter(first.panels).paint(first.frame);
    CHECK(
        std::ranges::any_of(log.lines, [](const DrawnLine& line) { return line.markup == "0,6"; }));
}

TEST_CASE("beads on a line have fields too") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {length: 20}\ngas: [{count: 40, radius: 0.01, temperature: 1}]\n"
        "run: {until: 4}\nfilm: {seconds: 1, size: [1280, 720], panels: [], "
        "field: {of: density, cells: 4}}\n");
    const std::vector<float> values = values_of(scene);
    REQUIRE(values.size() == 4);
    double sum = 0.0;
    for (const float value : values)
        if (!std::isnan(value)) sum += static_cast<double>(value);
    CHECK(sum == doctest::Approx(40.0 / 5.0));
}

TEST_CASE("a profile shows slabs along an axis, with an ideal gas where gravity acts") {
    const auto plot_of = [](const std::string& panel, const std::string& gravity) {
        const test::FirstFrame first(test::scene_from(
            "title: T\nbox: {size: [20, 40]}\n" + gravity +
            "gas: [{name: a, count: 100, radius: 0.1, temperature: 1}]\nrun: {until: 4}\n"
            "film: {seconds: 1, panels: [" +
            panel + "]}\n"));
        const auto& shown = dynamic_cast<const PlotPanel&>(*first.panels.panels().back().panel);
        return shown.plot(first.frame.states.back().get());
    };
    const auto lines_of = [](const plot::Plot& plot, const std::string& part) {
        std::vector<plot::Polyline> lines;
        for (const plot::AnyLayer& layer : plot.layers)
            if (const auto* line = std::get_if<plot::Polyline>(&layer); line && line->part == part)
                lines.push_back(*line);
        return lines;
    };
    const plot::Plot along_x = plot_of("{kind: profile, cells: 4, over: now}", "");
    CHECK(lines_of(along_x, "law").empty());
    REQUIRE(lines_of(along_x, "profile").size() == 1);
    const plot::Polyline across = lines_of(along_x, "profile").front();
    double sum = 0.0;  // each slab has two ends
    for (std::size_t k = 0; k < across.y.size(); ++k) sum += 0.5 * across.y[k];
    CHECK(sum * 5.0 * 40.0 == doctest::Approx(100.0));
    CHECK(across.x[across.x.size() - 1] == doctest::Approx(20.0));

    const plot::Plot up =
        plot_of("{kind: profile, component: y, cells: 10, over: now}", "gravity: [0, -0.1]\n");
    REQUIRE(lines_of(up, "law").size() == 1);
    const plot::Polyline law = lines_of(up, "law").front();
    double all = 0.0;  // height is up
    for (std::size_t k = 0; k < law.x.size(); ++k) all += law.x[k] * 4.0 * 20.0;
    CHECK(all == doctest::Approx(100.0));
    CHECK(law.y[0] == doctest::Approx(2.0));
    CHECK(law.x[0] > 2.0 * law.x[9]);
    CHECK(lines_of(plot_of("{kind: profile, component: y, theory: false}", "gravity: [0, -0.1]\n"),
                   "law")
              .empty());
}

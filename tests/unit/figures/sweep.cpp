// Figures that show a sweep: what they run is what carom run does, what they read is what they
// would have run, and their curves are those of theory.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "figures/sweep_figure.h"
#include "figures/sweep_theory.h"
#include "panels/plot/plot_panel.h"
#include "runs/sweep_summary.h"
#include "support/figure_run.h"
#include "support/files.h"
#include "support/scene_text.h"
#include "util/diagnostics.h"

using namespace carom;
using test::run_of;

namespace {

const std::string physics =
    "box: {size: [30, 20]}\ngas: [{name: a, count: 40, radius: 0.3, temperature: {exact: 1}}]\n"
    "run: {until: 20}\n";

Scene scene_of(const std::string& figure, const std::string& gas = physics,
               const Overrides& overrides = {}) {
    return test::scene_from(
        "title: A gas\nseed: 5\n" + gas + "figures: [{name: f, kind: sweep, " + figure + "}]\n",
        overrides);
}

SweptNumbers numbers_of(const Scene& scene, int threads = 1) {
    return swept_numbers(scene, scene.figures.front(), threads, {});
}

template <class Work>
std::string refusal_of(const Work& work) {
    try {
        work();
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

// The same before anything is run.
std::string refusal(const Scene& scene) {
    const std::string words = refusal_of([&] { run_of(scene); });
    CHECK(refusal_of([&] { check_swept_figure(scene, scene.figures.front()); }) == words);
    return words;
}

// The summary that carom join would write of the sweep of this figure.
void write_summary(const Scene& scene, const test::TemporaryFolder& folder) {
    const SweepShown& shown = *sweep_of(scene.figures.front());
    SweepSummary summary{.carom = "0", .physics = scene.source.physics, .sweep = shown.sweep};
    const auto scene_at = [&](std::int64_t point) {
        return shown.scene_with(shown.sweep.changes_at(point));
    };
    summary.numbers = numbers_of_runs(*scene_at(0));
    for (std::int64_t point = 0; point < shown.sweep.points(); ++point) {
        const std::int64_t seeds = shown.sweep.seeds.count();
        summary.points.push_back(
            {seeds, statistics_of(
                        run_part(shown.sweep, point * seeds, (point + 1) * seeds, 1, scene_at))});
    }
    folder.write("summary.json", text_of(summary));
}

}  // namespace

TEST_CASE("a figure shows the means of runs with the scene's seeds, and their standard errors") {
    const Scene scene =
        scene_of("number: virial pressure, vary: \"gas.0.radius=0.2:0.4:3\", seeds: 3");
    const SweptNumbers swept = numbers_of(scene, 2);
    CHECK(swept.across == "radius");
    REQUIRE(swept.lines.size() == 1);
    const SweptLine& line = swept.lines.front();
    CHECK(line.x == std::vector<double>{0.2, 0.3, 0.4});
    for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0.0, squares = 0.0;
        for (const char* seed : {"5", "6", "7"}) {
            const Scene one = scene_of(
                "number: temperature, vary: \"run.until=20\"", physics,
                {"gas.0.radius=" + std::to_string(line.x[k]), std::string("seed=") + seed});
            const double pressure = run_physics(one).summary.virial_pressure.value();
            sum += pressure;
            squares += pressure * pressure;
        }
        CHECK(line.mean[k] == doctest::Approx(sum / 3.0).epsilon(1e-12));
        CHECK(line.error[k] ==
              doctest::Approx(std::sqrt((squares - sum * sum / 3.0) / 6.0)).epsilon(1e-6));
        CHECK(line.runs[k] == 3);
    }
    const SweptNumbers alone = numbers_of(scene, 1);
    CHECK(alone.lines.front().mean == line.mean);
}

TEST_CASE("a figure of a joined sweep is that of its own runs, pixel for pixel") {
    const test::TemporaryFolder folder;
    const std::string keys = "number: wall pressure, ";
    const Scene own = scene_of(keys + "vary: \"gas.0.radius=0.2:0.4:3\", seeds: 2");
    write_summary(own, folder);
    const std::string from = "figures.f.seeds.from=" + folder.path().string();
    const Scene joined = scene_of(keys + "seeds: {from: S}", physics, {from});
    const FigureRun one = run_of(own), other = run_of(joined);
    const Canvas a = draw_figure(one, one.figures().front(), {}, {});
    const Canvas b = draw_figure(other, other.figures().front(), {}, {});
    CHECK(csv(table_of(one.figures().front())) == csv(table_of(other.figures().front())));
    REQUIRE(a.size().width == b.size().width);
    const PixelView p = a.pixels(), q = b.pixels();
    for (int y = 0; y < p.height; ++y)
        REQUIRE(std::equal(p.data + y * p.stride, p.data + y * p.stride + p.width,
                           q.data + y * q.stride));
    CHECK(words_of(one, one.figures().front()).caption ==
          words_of(other, other.figures().front()).caption);

    // Of another gas, though with the same keys.
    const Scene refused = scene_of(keys + "seeds: {from: S}", physics, {from, "gas.0.count=41"});
    CHECK(refusal(refused).find("of another scene") != std::string::npos);
    CHECK(refusal(scene_of(keys + "seeds: {from: nowhere}")).find("nowhere is not there") !=
          std::string::npos);
    folder.write("summary.json", "{}");
    CHECK(refusal(joined).find("not the summary of a sweep") != std::string::npos);
}

TEST_CASE("the curve of a pressure begins as that of an ideal gas and rises as hard disks do") {
    const SweptNumbers swept = numbers_of(
        scene_of("number: virial pressure, vary: \"gas.0.radius=0.01:0.5:2\", across: packing"));
    const SweptLine& line = swept.lines.front();
    const double ideal = 40.0 / (30.0 * 20.0);
    for (const double y : line.ideal.y) CHECK(y == doctest::Approx(ideal).epsilon(1e-9));
    CHECK(line.theory.y.front() == doctest::Approx(ideal).epsilon(0.002));
    CHECK(line.x.back() == doctest::Approx(40.0 * std::numbers::pi * 0.25 / 600.0));
    // The second virial coefficient of disks in a box that centres reach within a radius.
    const double eta = line.theory.x[1];
    CHECK(line.theory.y[1] > ideal * (1.0 + 2.0 * eta));
    CHECK(line.theory.y[1] < ideal * (1.0 + 4.0 * eta + 10.0 * eta * eta + 0.02));
    CHECK(numbers_of(scene_of("number: virial pressure, vary: \"gas.0.radius=0.1:0.5:2\", theory: "
                              "false"))
              .lines.front()
              .theory.y.empty());
    const std::string heated = physics.substr(0, physics.size() - 2) +
                               ", events: [{at: 10, heat: {to: {temperature: 2}}}]}\n";
    CHECK(numbers_of(scene_of("number: virial pressure, vary: \"gas.0.radius=0.1:0.5:2\"", heated))
              .lines.front()
              .theory.y.empty());
}

TEST_CASE(
    "the pressure of spheres has curves of the fluid, of coexistence and of the crystal, which "
    "meet") {
    const std::string spheres =
        "box: {size: [9.524406, 6.349604, 6.349604], walls: periodic}\n"
        "gas: [{name: a, count: 384, radius: 0.4, temperature: {exact: 1}, position: lattice}]\n"
        "run: {until: 0.1}\n";
    const SweptLine line = numbers_of(scene_of("number: virial pressure, across: packing, "
                                               "vary: \"gas.0.radius=0.47,0.48,0.52\"",
                                               spheres))
                               .lines.front();
    const SweptCurve &fluid = line.theory, &both = line.coexistence, &crystal = line.crystal;
    REQUIRE(fluid.x.size() > 2);
    REQUIRE(both.x.size() > 2);
    REQUIRE(crystal.x.size() > 2);
    CHECK(fluid.x.back() == doctest::Approx(0.492).epsilon(1e-4));
    CHECK(both.x.front() == doctest::Approx(0.492).epsilon(1e-4));
    CHECK(both.x.back() == doctest::Approx(0.543).epsilon(1e-4));
    CHECK(crystal.x.front() == doctest::Approx(0.543).epsilon(1e-4));
    // There both have the pressure of coexistence, to the rounding of these packings.
    CHECK(fluid.y.back() == doctest::Approx(both.y.front()).epsilon(0.004));
    CHECK(crystal.y.front() == doctest::Approx(both.y.back()).epsilon(0.004));
    // Of the same number in the same volume: at the diameter d it is 11.5727 / d^3, but for 1/N.
    for (std::size_t k = 0; k < both.x.size(); ++k)
        CHECK(both.y[k] * both.x[k] ==
              doctest::Approx(11.5727 * std::numbers::pi / 6.0 * 383.0 / 384.0).epsilon(1e-6));
    CHECK(crystal.y.back() > both.y.front());
}

TEST_CASE("the pressure of rods is Tonks' at every value") {
    const std::string rods =
        "box: {length: 50}\ngas: [{name: a, count: 10, radius: 0.5, temperature: {exact: 2}}]\n"
        "run: {until: 5}\n";
    const SweptLine line =
        numbers_of(scene_of("number: virial pressure, vary: \"gas.0.radius=0.25:1.5:2\"", rods))
            .lines.front();
    REQUIRE(line.theory.x.size() == 9);
    for (std::size_t k = 0; k < line.theory.x.size(); ++k)
        CHECK(line.theory.y[k] ==
              doctest::Approx(10.0 * 2.0 / (50.0 - 20.0 * line.theory.x[k])).epsilon(1e-9));
}

TEST_CASE("between whole numbers theory has all values of a key that is not a count") {
    const SweptLine line =
        numbers_of(scene_of("number: collision rate, vary: \"gas.0.temperature.exact=1:9:2\""))
            .lines.front();
    REQUIRE(line.theory.x.size() == 9);
    for (std::size_t k = 0; k < line.theory.x.size(); ++k) {
        CHECK(line.theory.x[k] == doctest::Approx(1.0 + static_cast<double>(k)));
        CHECK(line.theory.y[k] / line.theory.y[0] == doctest::Approx(std::sqrt(line.theory.x[k])));
    }
    CHECK(numbers_of(scene_of("number: collision rate, vary: \"gas.0.temperature.exact=1,2\""))
              .lines.front()
              .theory.x[1] == doctest::Approx(1.125));
}

TEST_CASE("numbers that differ by round-off have an axis around them, and one run each is said") {
    const FigureRun run = run_of(scene_of("number: temperature, vary: \"gas.0.radius=0.1:0.5:5\""));
    const Figure& figure = run.figures()[0];
    const plot::Axis axis =
        dynamic_cast<const PlotPanel&>(*figure.panel).plot(figure.moments.front().state.get()).y;
    CHECK(axis.low < 0.95);
    CHECK(axis.high > 1.05);
    CHECK(words_of(run, figure).alt.find("Temperature against radius: one run each. ") !=
          std::string::npos);
}

TEST_CASE("a value is named by its key, in the language of the film") {
    const Gas one = scene_of("number: mean energy, vary: \"gas.0.radius=0.1,0.2\"").gas;
    const Gas two =
        scene_of("number: mean energy, vary: \"gas.0.radius=0.1,0.2\"",
                 "box: {size: [30, 20]}\ngas: [{name: a, count: 4}, {name: b2, count: 4}]\n"
                 "run: {until: 2}\n")
            .gas;
    const auto words = [](const char* key, const char* value, const Gas& gas,
                          Language language = Language::english) {
        return words_of_value(language, key, value, gas);
    };
    CHECK(words("gas.0.radius", "0.35", one) == "radius 0.35");
    CHECK(words("gas.1.radius", "0.35", two) == "radius of b2 0.35");
    CHECK(words("gas.b2.radius", "0.35", two) == "radius of b2 0.35");
    CHECK(words("gas.a.temperature.exact", "1.5", two) == "temperature of a 1.5");
    CHECK(words("run.until", "2", two) == "until 2");
    CHECK(words("gas.0.radius", "0.35", one, Language::german) == "Radius 0,35");
    CHECK(words("gas.0.color", "'#12.5'", one, Language::german) == "color '#12.5'");
}

TEST_CASE("keys that are not across make lines with names") {
    const SweptNumbers swept =
        numbers_of(scene_of("number: mean energy, vary: [\"gas.0.temperature.exact=1,2\", "
                            "\"gas.0.count=20:30:3\"], across: gas.0.count, set: run.until=2"));
    CHECK(swept.across == "number of particles");
    REQUIRE(swept.lines.size() == 2);
    CHECK(swept.lines[0].name == "temperature 1");
    CHECK(swept.lines[1].name == "temperature 2");
    CHECK(swept.lines[1].x == std::vector<double>{20.0, 25.0, 30.0});
    for (const double mean : swept.lines[1].mean) CHECK(mean == doctest::Approx(2.0));
    for (const double y : swept.lines[1].theory.y) CHECK(y == doctest::Approx(2.0));
    for (const double x : swept.lines[1].theory.x) CHECK(x == std::round(x));
}

TEST_CASE("the key of several lines shows how each is drawn, in the language of the film") {
    const std::string two =
        "number: wall pressure, vary: [\"gas.0.temperature.exact=1,2\", "
        "\"gas.0.count=20:30:3\"], across: gas.0.count, set: run.until=2";
    for (const bool theory : {true, false}) {
        const FigureRun run = run_of(
            scene_of(two + (theory ? "" : ", theory: false"), physics + "film: {language: de}\n"));
        const plot::Plot plot =
            dynamic_cast<const PlotPanel&>(*run.figures().front().panel).plot(nullptr);
        CHECK(plot.x.title.pieces.front().markup == "Teilchenzahl");
        const Table table = table_of(run.figures().front());
        const std::vector<std::string> names = column_names(table);
        CHECK(std::ranges::count(names, "number of particles") == 1);
        const auto of = static_cast<std::size_t>(std::ranges::find(names, "of") - names.begin());
        CHECK(std::get<std::string>(table.rows.at(0).at(of)) == "temperature 1");
        const std::vector<plot::KeyEntry>& entries = plot.notes.front().entries;
        REQUIRE(entries.size() == (theory ? 3 : 2));  // the last says what the lines are
        std::vector<plot::Polyline> lines;
        std::vector<plot::Points> points;
        for (const plot::AnyLayer& layer : plot.layers) {
            if (const auto* line = std::get_if<plot::Polyline>(&layer); line && !line->piece)
                lines.push_back(*line);
            if (const auto* point = std::get_if<plot::Points>(&layer)) points.push_back(*point);
        }
        REQUIRE(lines.size() == 2);
        REQUIRE(points.size() == 2);
        for (const std::size_t k : {0U, 1U}) {
            CHECK(points[k].of == (k == 0 ? "temperature 1" : "temperature 2"));
            CHECK(entries[k].words.front().pieces.front().markup ==
                  (k == 0 ? "Temperatur 1" : "Temperatur 2"));
            REQUIRE(entries[k].swatch);
            CHECK(entries[k].swatch->dashes == lines[k].stroke.dashes);
            REQUIRE(entries[k].dot);
            CHECK(entries[k].dot->role.index == points[k].dot.role.index);
            CHECK(entries[k].dot->role.index == lines[k].stroke.role.index);
        }
        CHECK(lines[0].stroke.dashes != lines[1].stroke.dashes);
        CHECK((plot.account.find("Linien: harte Scheiben") != std::string::npos) == theory);
    }
}

TEST_CASE("of one point no theory is seen, and none is named") {
    const FigureRun run = run_of(scene_of("number: wall pressure, vary: gas.0.radius=0.3"));
    const plot::Plot plot =
        dynamic_cast<const PlotPanel&>(*run.figures().front().panel).plot(nullptr);
    CHECK(plot.notes.empty());
    CHECK(plot.account.find("Dashed") == std::string::npos);
}

TEST_CASE("fixed disks have no part in means") {
    const std::string with_fixed =
        "box: {size: [30, 20], walls: periodic}\n"
        "gas: [{name: a, count: 40, radius: 0.3, temperature: {exact: 1}}, "
        "{name: fixed, count: 20, radius: 0.3, mass: infinite}]\nrun: {until: 20}\n";
    const auto swept = [&](const std::string& number) {
        const Scene scene =
            scene_of("number: " + number + ", vary: \"gas.0.count=30,40\", seeds: 2", with_fixed);
        return std::pair{numbers_of(scene).lines.front().mean,
                         theory_of_number(number, scene, {1, 2})};
    };
    // As long as momentum is not conserved, a disk has the energy of two degrees of freedom.
    const auto [energy, exact] = swept("mean energy");
    CHECK(energy[1] == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(*exact == doctest::Approx(1.0).epsilon(1e-9));
    const auto [speed, of_maxwell] = swept("mean speed");
    CHECK(speed[1] == doctest::Approx(*of_maxwell).epsilon(0.05));  // of some 10^3 velocities
}

TEST_CASE("a number that runs do not have is refused with the nearest one") {
    const std::string message =
        refusal(scene_of("number: virial presure, vary: \"gas.0.radius=0.2,0.3\""));
    CHECK(message.find("no number `virial presure`") != std::string::npos);
    CHECK(message.find("did you mean `virial pressure`?") != std::string::npos);
    CHECK(refusal(scene_of("number: temperature, vary: \"gas.0.name=a,b\"")).find("no number") !=
          std::string::npos);
}

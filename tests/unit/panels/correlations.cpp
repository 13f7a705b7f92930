// Correlations and free flights as plots: what is in them, of one run, of the mean of several and
// of several side by side.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/curve_panel.h"
#include "panels/plot/draw_plot.h"
#include "panels/registry.h"
#include "scene/scene.h"
#include "stats/paths/free_flights.h"
#include "support/scene_text.h"
#include "util/archive.h"

using namespace carom;

namespace {

// A panel of a scene that sees a run twice.
struct Run2 {
    Scene scene;
    Simulation start;
    Particles particles;
    BoxedGas gas_at_rest;
    int frames;
    std::unique_ptr<Panel> panel;
    std::shared_ptr<const PanelState> state = {};
    CollisionCounts counts = {};

    Run2(const std::string& text, const PanelSpec& spec, int frames_in_all = 20)
        : scene(test::scene_from(text)),
          start(scene.gas, scene.run),
          particles(start.particles()),
          gas_at_rest(scene.gas.box, scene.run.events, particles, start.sample()),
          frames(frames_in_all),
          panel(make_panel({scene, particles, frames + 1, gas_at_rest}, spec)) {
        see([&](const FrameInput& input) { panel->survey(input); });
    }
    Run2(const Run2&) = delete;

    void see(const auto& each) {
        Simulation simulation = start;
        simulation.record_collisions(panel->surveys_collisions());
        for (int k = 0; k <= frames; ++k) {
            const AdvanceResult advanced = simulation.advance_to(scene.run.until * k / frames);
            Tick tick;
            tick.time = scene.run.until * k / frames;
            tick.frame = k;
            const Sample& sample = simulation.sample();
            each(FrameInput{tick, sample, speeds(sample), kinetic_energies(particles, sample),
                            advanced});
            counts = advanced.counts;
        }
    }
    void show() {
        see([&](const FrameInput& input) { state = panel->state(input); });
    }
    plot::Plot finished() {
        panel->fix_axes();
        show();
        return plots().plot(state.get());
    }
    PlotPanel& plots() { return dynamic_cast<PlotPanel&>(*panel); }
};

template <class Layer>
std::vector<Layer> layers_of(const plot::Plot& plot, const std::string& part = "") {
    std::vector<Layer> found;
    for (const plot::AnyLayer& layer : plot.layers)
        if (const auto* one = std::get_if<Layer>(&layer))
            if (part.empty() || one->part == part) found.push_back(*one);
    return found;
}

std::string gas_of(const std::string& more, const std::string& box = "[20, 20], walls: periodic",
                   int seed = 1) {
    return "title: A gas\nseed: " + std::to_string(seed) + "\nbox: {size: " + box +
           "}\ngas: [{name: a, count: 60, radius: 0.5, temperature: 4}" + more +
           "]\nrun: {until: 20}\nfilm: {seconds: 2, fps: 10}\n";
}

std::string words_in(const plot::Plot& plot) {
    std::string all;
    for (const plot::Note& note : plot.notes)
        for (const plot::KeyEntry& entry : note.entries)
            for (const plot::Text::Piece& piece : entry.words.front().pieces)
                all += piece.markup + "; ";
    return all;
}

}  // namespace

TEST_CASE("g(r) of a lattice at rest has its neighbours in their rings") {
    // 10 x 10 disks 2 apart: from 2 diameters on, at 2, 2 sqrt 2, 4 and so on.
    Run2 run(
        "title: A lattice\nbox: {size: [20, 20], walls: periodic}\n"
        "gas: [{name: a, count: 100, radius: 0.5, position: lattice}]\n"
        "run: {until: 3}\nfilm: {seconds: 2, fps: 10}\n",
        {.kind = "pair-correlation"});
    const Sample& sample = run.start.sample();
    const plot::Plot plot = run.finished();
    const plot::Bars g = layers_of<plot::Bars>(plot).at(0);
    CHECK(g.to[g.value.size() - 1] == doctest::Approx(5.0));
    double pairs = 0.0, expected = 0.0;
    for (std::size_t k = 0; k < g.value.size(); ++k) {
        const double ring = std::numbers::pi * (g.to[k] * g.to[k] - g.from[k] * g.from[k]) / 400.0;
        pairs += g.value[k] * 99.0 * 50.0 * ring;
    }
    for (Eigen::Index i = 0; i < 100; ++i)
        for (Eigen::Index j = i + 1; j < 100; ++j)
            expected += length(run.scene.gas.box.nearest(vec_in(sample.position, j) -
                                                         vec_in(sample.position, i))) < 5.0
                            ? 1.0
                            : 0.0;
    CHECK(pairs == doctest::Approx(expected));
    CHECK(layers_of<plot::Points>(plot, "contact").empty());  // nothing moves
}

TEST_CASE("g(r) of a gas rises at contact to what Henderson has, and comes to 1") {
    Run2 run(gas_of(""), {.kind = "pair-correlation"}, 40);
    const plot::Plot plot = run.finished();
    const plot::Bars g = layers_of<plot::Bars>(plot).at(0);
    const double packing = 60.0 * std::numbers::pi * 0.25 / 400.0;
    const double henderson = (1.0 - 7.0 * packing / 16.0) / ((1.0 - packing) * (1.0 - packing));
    const plot::Points contact = layers_of<plot::Points>(plot, "contact").at(0);
    CHECK(contact.x[0] == doctest::Approx(1.0));
    CHECK(contact.y[0] == doctest::Approx(henderson).epsilon(1e-12));
    double first = 0.0, far = 0.0;
    int rings = 0;
    for (std::size_t k = 0; k < g.value.size(); ++k) {
        if (g.to[k] < 1.0 + 1e-9) CHECK(g.value[k] < 1e-9);
        if (g.from[k] > 1.0 - 1e-9 && g.to[k] < 1.2 + 1e-9) first += 0.25 * g.value[k];
        if (g.from[k] > 3.0) far += g.value[k], ++rings;
    }
    CHECK(first ==
          doctest::Approx(henderson).epsilon(0.08));  // 4 of 100 rings, 150 collisions each
    CHECK(far / rings == doctest::Approx(1.0).epsilon(0.02));
    CHECK(plot.account.starts_with("The pair correlation is highest, "));
    CHECK(plot.y.high > henderson);
}

TEST_CASE("the velocity autocorrelation begins at 1 with the slope of the collision rate") {
    Run2 run(gas_of(""), panel_of("velocity-autocorrelation", AutocorrelationOptions{.lags = 3.0}),
             40);
    const plot::Plot plot = run.finished();
    const plot::Polyline curve = layers_of<plot::Polyline>(plot, "curve").at(0);
    const plot::Polyline slope = layers_of<plot::Polyline>(plot, "slope at 0").at(0);
    CHECK(curve.y[0] == 1.0);
    // Of equal masses in a plane it is the number of collisions of a disk in a unit of time, with
    // the factors of 118 degrees of freedom, and of a velocity that the 59 others balance.
    const double factor = 118.0 / 119.0 * 60.0 / 59.0;
    const double rate = factor * 2.0 * static_cast<double>(run.counts.particle) / (60.0 * 20.0);
    const double found = (slope.y[1] - slope.y[0]) / (slope.x[1] - slope.x[0]);
    CHECK(found == doctest::Approx(-rate).epsilon(1e-9));
    // Of about a thousand collisions, at a lag of 0.05 within five per cent.
    CHECK((curve.y[1] - 1.0) / curve.x[1] == doctest::Approx(-rate).epsilon(0.15));
    CHECK(words_in(plot).find("slope \u2212") != std::string::npos);
    CHECK(plot.account.find("falls to one half") != std::string::npos);
}

TEST_CASE("of mixtures between walls the slope has every mass and every wall in it") {
    Run2 run(gas_of(", {name: b, count: 30, radius: 0.3, mass: 5, temperature: 4}", "[20, 20]"),
             {.kind = "velocity-autocorrelation",
              .of = {Chosen{.species = 0}, Chosen{.species = 1}},
              .options = Options::of(AutocorrelationOptions{.lags = 2.0})},
             40);
    std::array<double, 2> lost{};
    run.see([&](const FrameInput& input) {
        for (const Collision& one : input.advanced.collisions) {
            const auto mass = [&](std::int32_t i) { return i < 60 ? 1.0 : 5.0; };
            const auto add = [&](std::int32_t i, double share) {
                lost[i < 60 ? 0 : 1] += 2.0 * share / (i < 60 ? 60.0 : 30.0) / 20.0;
            };
            if (one.second.is_surface()) {
                add(one.first, 1.0);
                continue;
            }
            const double sum = mass(one.first) + mass(one.second.particle());
            add(one.first, mass(one.second.particle()) / sum);
            add(one.second.particle(), mass(one.first) / sum);
        }
    });
    const auto slopes = layers_of<plot::Polyline>(run.finished(), "slope at 0");
    const auto curves = layers_of<plot::Polyline>(run.plots().plot(run.state.get()), "curve");
    for (std::size_t k = 0; k < 2; ++k) {
        // 90 disks between walls have 180 degrees of freedom.
        CHECK((slopes.at(k).y[1] - 1.0) / slopes[k].x[1] ==
              doctest::Approx(-lost[k] * 180.0 / 181.0).epsilon(1e-9));
        CHECK((curves.at(k).y[1] - 1.0) / curves[k].x[1] == doctest::Approx(-lost[k]).epsilon(0.2));
    }
}

TEST_CASE("fixed disks have no part in the slope of all") {
    const auto slope_of = [](const std::vector<Chosen>& of) {
        Run2 run(gas_of(", {name: b, count: 20, radius: 0.3, mass: infinite}", "[20, 20]"),
                 {.kind = "velocity-autocorrelation",
                  .of = of,
                  .options = Options::of(AutocorrelationOptions{.lags = 2.0})});
        const plot::Polyline slope = layers_of<plot::Polyline>(run.finished(), "slope at 0").at(0);
        return (slope.y[1] - slope.y[0]) / (slope.x[1] - slope.x[0]);
    };
    CHECK(slope_of({}) < -0.01);
    CHECK(slope_of({}) == doctest::Approx(slope_of({Chosen{.species = 0}})).epsilon(1e-12));
}

TEST_CASE("where walls act no slope is drawn") {
    Run2 run(gas_of("", "[20, 20], walls: {left: {temperature: 4}}"),
             panel_of("velocity-autocorrelation", AutocorrelationOptions{.lags = 2.0}));
    CHECK(layers_of<plot::Polyline>(run.finished(), "slope at 0").empty());
}

TEST_CASE("free paths have the exact mean, and bars that are shares of all that ended") {
    Run2 run(gas_of(""), {.kind = "free-path"});
    double way = 0.0;
    FreeFlights flights(run.scene.gas.box, false, {});
    std::vector<double> lengths;
    run.see([&](const FrameInput& input) {
        for (const FreeFlight& one : flights.see(input.sample, input.advanced.collisions))
            lengths.push_back(one.length);
        for (const FlightTotals& one : flights.totals()) way += one.way;
    });
    const plot::Plot plot = run.finished();
    const double mean = way / (2.0 * static_cast<double>(run.counts.particle));
    CHECK(layers_of<plot::Marker>(plot, "mean").at(0).value == doctest::Approx(mean));
    const plot::Bars bars = layers_of<plot::Bars>(plot).at(0);
    for (std::size_t k = 0; k < bars.value.size(); ++k) {
        const auto inside = std::ranges::count_if(
            lengths, [&](double length) { return length >= bars.from[k] && length < bars.to[k]; });
        CHECK(bars.value[k] ==
              doctest::Approx(100.0 * double(inside) / double(lengths.size())).epsilon(1e-9));
    }
    // The law has the same mean: from one bin to the next it falls by e^(-width / mean).
    const plot::Polyline law = layers_of<plot::Polyline>(plot, "memoryless").at(0);
    CHECK(law.y[10] / law.y[0] ==
          doctest::Approx(std::exp(-(law.x[10] - law.x[0]) / mean)).epsilon(1e-9));
    CHECK(words_in(plot).find("exponential law (Boltzmann)") != std::string::npos);
    CHECK(plot.account.starts_with("Mean free path "));
}

TEST_CASE("free times are free paths over the speed, on a logarithmic axis too") {
    const std::string one =
        "title: One disk\nbox: {size: [2, 2], walls: periodic}\n"
        "obstacles: [{name: peg, disk: [1, 1], radius: 0.5}]\n"
        "gas: [{name: a, count: 1, radius: 0.1, velocity: [1.6, 1.2], position: [0.2, 0.3]}]\n"
        "run: {until: 2000}\nfilm: {seconds: 2, fps: 10}\n";
    Run2 paths(one, {.kind = "free-path"}),
        times(one, panel_of("free-time", FreeFlightOptions{.logarithmic = true}));
    const plot::Plot path = paths.finished(), time = times.finished();
    CHECK(layers_of<plot::Marker>(path, "mean").at(0).value ==
          doctest::Approx(2.0 * layers_of<plot::Marker>(time, "mean").at(0).value));
    // Sinai's exact mean, of a point among disks of radius 0.6.
    CHECK(words_in(path).find("exact: 2.39") != std::string::npos);
    CHECK(words_in(time).find("exact: 1.2") != std::string::npos);
    CHECK(time.y.kind == plot::Axis::Kind::logarithmic);
}

TEST_CASE("fixed disks have no part in free flights and displacements of all") {
    const std::string pegs =
        "title: T\nbox: {size: [10, 10], walls: periodic}\n"
        "gas: [{name: peg, radius: 2, mass: infinite, position: [[2.5, 5], [7.5, 0]]}, {name: "
        "ball, "
        "count: 3, radius: 0.2, speed: 1}]\nrun: {until: 200}\nfilm: {seconds: 2, fps: 10}\n";
    const auto displacements = [](bool all_origins) {
        return panel_of("mean-squared-displacement",
                        DisplacementOptions{.fit_from = 2.0, .all_origins = all_origins});
    };
    for (const PanelSpec& all : {PanelSpec{.kind = "free-path"}, PanelSpec{.kind = "free-time"},
                                 displacements(false), displacements(true)}) {
        CAPTURE(all.kind);
        PanelSpec ball = all;
        ball.of = {Chosen{.species = 1}};
        Run2 of_all(pegs, all), of_ball(pegs, ball);
        CHECK(of_all.finished().account == of_ball.finished().account);
    }
}

TEST_CASE("between walls alone a disk has no exact mean free path") {
    Run2 run(
        "title: T\nbox: {size: [20, 15]}\n"
        "gas: [{count: 1, radius: 0.5, position: [5, 5], velocity: [1, 0.3]}]\n"
        "run: {until: 400}\nfilm: {seconds: 2, fps: 10}\n",
        panel_of("free-path", FreeFlightOptions{.ends_at_walls = true}));
    CHECK(words_in(run.finished()).find("exact") == std::string::npos);
}

TEST_CASE("a profile in gravity has a law where disks share their energy and pass one another") {
    const auto laws = [](const std::string& box, const std::string& gas) {
        Run2 run("title: T\nbox: " + box + "\ngas: [{radius: 0.1, " + gas +
                     "}]\nrun: {until: 10}\nfilm: {seconds: 2, fps: 10}\n",
                 {.kind = "profile",
                  .component = box.starts_with("{size") ? Component::y : Component::x});
        return layers_of<plot::Polyline>(run.finished(), "law").size();
    };
    const std::string line = "{length: 20}\ngravity: -0.5",
                      plane = "{size: [10, 20]}\ngravity: [0, -0.5]";
    CHECK(laws(line, "count: 6, temperature: 1") == 0);
    CHECK(laws(line, "mass: [1, 2, 1, 2], position: [2, 4, 6, 8], velocity: [1, 0, 1, 0]") == 0);
    CHECK(laws(plane, "count: 1, velocity: [1, 2]") == 0);
    CHECK(laws(plane, "count: 6, temperature: 1") == 1);
}

TEST_CASE("walls end free paths where the scene says so") {
    const std::string one =
        "title: One disk\nbox: {size: [3, 2]}\n"
        "gas: [{name: a, count: 1, radius: 0.5, velocity: [1, 0], position: [1, 1]}]\n"
        "run: {until: 100}\nfilm: {seconds: 2, fps: 10}\n";
    Run2 without(one, {.kind = "free-path"}),
        with(one, panel_of("free-path", FreeFlightOptions{.ends_at_walls = true}));
    CHECK(layers_of<plot::Marker>(without.finished(), "mean").empty());
    CHECK(layers_of<plot::Marker>(with.finished(), "mean").at(0).value ==
          doctest::Approx(2.0).epsilon(0.02));
}

TEST_CASE("hexagonal order is 1 in a hexagonal lattice, and little in a gas") {
    const auto order = [](const std::string& text) {
        Run2 run(text, {.kind = "orientational-order"});
        std::vector<double> last;
        for (const plot::Polyline& line : layers_of<plot::Polyline>(run.finished(), "line"))
            last.push_back(line.y[line.y.size() - 1]);
        return last;
    };
    const std::vector<double> gas = order(gas_of(""));
    REQUIRE(gas.size() == 2);
    CHECK(gas[0] < 0.3);     // whole gas
    CHECK(gas[1] > gas[0]);  // of each its own neighbours, often only one
    std::string places;
    const double row = 2.2 * std::sqrt(0.75);
    for (int k = 0; k < 6; ++k)
        for (int i = 0; i < 5; ++i)
            places += (places.empty() ? "[" : ", [") +
                      std::to_string(0.3 + 2.2 * i + 1.1 * (k % 2)) + ", " +
                      std::to_string(0.3 + row * k) + "]";
    const std::vector<double> crystal =
        order("title: A crystal\nbox: {size: [11, " + std::to_string(6.0 * row) +
              "], walls: periodic}\ngas: [{name: a, count: 30, radius: 0.9, position: [" + places +
              "]}]\nrun: {until: 1}\nfilm: {seconds: 2, fps: 10}\n");
    CHECK(crystal[0] == doctest::Approx(1.0).epsilon(1e-5));
    CHECK(crystal[1] == doctest::Approx(1.0).epsilon(1e-5));
}

TEST_CASE("displacements over all origins are means over starts, and D has an error") {
    Run2 run(gas_of(""),
             panel_of("mean-squared-displacement",
                      DisplacementOptions{.fit_from = 3.0, .all_origins = true, .lags = 4.0}),
             100);
    const plot::Plot plot = run.finished();
    const plot::Polyline curve = layers_of<plot::Polyline>(plot, "curve").at(0);
    CHECK(curve.x[60] == doctest::Approx(4.0));
    // Against starts at all frames: 100 starts of 60 disks each miss little of what lies between.
    std::vector<Eigen::ArrayXXd> place;
    run.see([&](const FrameInput& input) {
        Eigen::ArrayXXd now = input.sample.position;
        if (!place.empty()) now -= 20.0 * ((now - place.back()) / 20.0).round();
        place.push_back(now);
    });
    double squares = 0.0;
    for (std::size_t i = 0; i + 20 < place.size(); ++i)
        squares += (place[i + 20] - place[i]).square().rowwise().sum().mean() / 81.0;
    CHECK(curve.y[60] == doctest::Approx(squares).epsilon(0.01));
    const plot::Polyline fit = layers_of<plot::Polyline>(plot, "fit").at(0);
    CHECK(fit.x[0] == doctest::Approx(3.0));
    const double diffusion = (fit.y[1] - fit.y[0]) / (fit.x[1] - fit.x[0]) / 4.0;
    CAPTURE(plot.account);
    CHECK(std::stod(plot.account.substr(4)) == doctest::Approx(diffusion).epsilon(0.02));
    CHECK(plot.account.find(" ± 0.") != std::string::npos);
    const plot::Polyline ballistic = layers_of<plot::Polyline>(plot, "ballistic").at(0);
    CHECK_FALSE(ballistic.still);  // what is drawn once is drawn before anything is measured
    CHECK_FALSE(fit.still);
    CHECK(curve.y[1] == doctest::Approx(ballistic.y[40] / ballistic.x[40] / ballistic.x[40] *
                                        curve.x[1] * curve.x[1])
                            .epsilon(0.05));
}

TEST_CASE("a mean of runs has the mean of their curves, with its error") {
    for (const char* kind : {"pair-correlation", "velocity-autocorrelation", "free-time"}) {
        CAPTURE(kind);
        Run2 one(gas_of(""), {.kind = kind}),
            other(gas_of("", "[20, 20], walls: periodic", 2), {.kind = kind});
        one.plots().fix_axes_of_runs({other.panel.get()}, {});
        one.show();
        other.show();
        const auto both = one.plots().state_of_runs({one.state, other.state});
        const plot::Plot mean = one.plots().plot(both.get());
        const plot::Plot first = one.plots().plot(one.state.get());
        const plot::Plot second = one.plots().plot(other.state.get());
        CHECK(words_in(mean).find("mean of 2 runs") != std::string::npos);
        const auto check = [&](const plot::Column& value, const plot::Column& error,
                               const plot::Column& a, const plot::Column& b) {
            REQUIRE(value.size() == a.size());
            for (std::size_t k = 0; k < value.size(); ++k) {
                CHECK(value[k] == doctest::Approx(0.5 * (a[k] + b[k])));
                CHECK(error[k] == doctest::Approx(0.5 * std::abs(a[k] - b[k])));
            }
        };
        if (const auto bars = layers_of<plot::Bars>(mean); !bars.empty())
            check(bars[0].value, bars[0].error, layers_of<plot::Bars>(first)[0].value,
                  layers_of<plot::Bars>(second)[0].value);
        else
            check(layers_of<plot::Polyline>(mean, "curve").at(0).y,
                  layers_of<plot::Band>(mean).at(0).error,
                  layers_of<plot::Polyline>(first, "curve").at(0).y,
                  layers_of<plot::Polyline>(second, "curve").at(0).y);
    }
}

TEST_CASE("the error of D is that of the mean, where it is one of several runs") {
    const PanelSpec spec =
        panel_of("mean-squared-displacement",
                 DisplacementOptions{.fit_from = 3.0, .all_origins = true, .lags = 4.0});
    Run2 one(gas_of(""), spec), other(gas_of("", "[20, 20], walls: periodic", 2), spec);
    one.plots().fix_axes_of_runs({other.panel.get()}, {});
    one.show();
    other.show();
    const auto diffusion = [](const std::shared_ptr<const PanelState>& state) {
        return dynamic_cast<const CurveState&>(*state).runs[0].numbers[0][0].mean;
    };
    const double first = diffusion(one.state), second = diffusion(other.state);
    const auto both = one.plots().state_of_runs({one.state, other.state});
    const std::string words = one.plots().plot(both.get()).account;
    CAPTURE(words);
    CHECK(std::stod(words.substr(4)) == doctest::Approx(0.5 * (first + second)).epsilon(0.05));
    CHECK(std::stod(words.substr(words.find("±") + 2)) ==
          doctest::Approx(0.5 * std::abs(first - second)).epsilon(0.1));
}

TEST_CASE("runs side by side have a curve each on common axes") {
    for (const PanelSpec& spec :
         {panel_of("pair-correlation", PairCorrelationOptions{.to = 5.0}),
          PanelSpec{.kind = "velocity-autocorrelation"}, PanelSpec{.kind = "free-path"}}) {
        CAPTURE(spec.kind);
        Run2 thin(gas_of("", "[40, 40], walls: periodic"), spec), dense(gas_of(""), spec);
        thin.plots().fix_axes_of_runs({dense.panel.get()}, {"thin", "dense"});
        thin.show();
        dense.show();
        const auto both = thin.plots().state_of_runs({thin.state, dense.state});
        const plot::Plot plot = thin.plots().plot(both.get());
        CHECK(plot.runs == std::vector<std::string>{"thin", "dense"});
        CHECK(plot.accounts_of_runs.size() == 2);
        const std::size_t curves =
            layers_of<plot::Bars>(plot).size() + layers_of<plot::Polyline>(plot, "curve").size();
        CHECK(curves == 2);
    }
}

TEST_CASE("what another process reads of a first pass shows the same") {
    for (const char* kind : {"pair-correlation", "velocity-autocorrelation", "free-path"}) {
        CAPTURE(kind);
        Run2 here(gas_of(""), {.kind = kind}), there(gas_of(""), {.kind = kind});
        const Table expected = plot::table_of(here.finished());
        Archive out;
        here.panel->archive(out);
        there.panel = make_panel(
            {there.scene, there.particles, there.frames + 1, there.gas_at_rest}, {.kind = kind});
        Archive in(out.finished(), "a test");
        there.panel->archive(in);
        in.expect_end();
        there.show();
        CHECK(table_of(there.plots().plot(there.state.get())).rows == expected.rows);
    }
}

// Gauges, thermometers, stopwatches, counters and fluxes, against runs whose numbers are known by
// hand.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "panels/dials/dial_panel.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "scene/scene.h"
#include "support/scene_text.h"
#include "support/seen_panel.h"

using namespace carom;

namespace {

// The first panel of a scene's film after its first pass, and its states.
struct DialSeen {
    Scene scene;
    Simulation simulation;
    Particles particles;
    BoxedGas gas;
    std::unique_ptr<Panel> panel;
    std::vector<double> times = {};
    std::vector<std::shared_ptr<const PanelState>> states = {};

    explicit DialSeen(const std::string& text, int steps = 80)
        : scene(test::scene_from("title: T\n" + text)),
          simulation(scene.gas, scene.run),
          particles(simulation.particles()),
          gas(scene.gas.box, scene.run.events, particles, simulation.sample()),
          panel(make_panel({scene, particles, steps + 1, gas}, scene.film.panels.at(0))) {
        simulation.record_collisions(panel->surveys_collisions());
        const Simulation start = simulation;
        each_frame(steps, [&](const FrameInput& input) {
            panel->survey(input);
            times.push_back(input.tick.time);
        });
        panel->fix_axes();
        simulation = start;
        each_frame(steps, [&](const FrameInput& input) { states.push_back(panel->state(input)); });
    }

    template <class See>
    void each_frame(int steps, const See& see) {
        for (int i = 0; i <= steps; ++i) {
            Tick tick;
            tick.time = scene.run.until * i / steps;
            const AdvanceResult advanced = simulation.advance_to(tick.time);
            const Sample& sample = simulation.sample();
            see(FrameInput{tick, sample, speeds(sample), kinetic_energies(particles, sample),
                           advanced});
        }
    }
    const DialPanel& dial() const { return dynamic_cast<const DialPanel&>(*panel); }
    double reading(std::size_t frame, std::size_t line = 0) const {
        return dial().readings(*states.at(frame)).at(line).value;
    }
    double last(std::size_t line = 0) const { return reading(states.size() - 1, line); }
    const History& run() const {
        return dynamic_cast<const SeriesPanel&>(*panel).record().runs.front();
    }
};

bool is_near(double found, double exact, double error) {
    return std::abs(found - exact) <= error * std::abs(exact);
}
constexpr double rounding = 1e-12;

std::string film(const std::string& panel) {
    return "film: {seconds: 8, panels: [" + panel + "]}\n";
}

// Hits the right wall at 1, 5, ... 37 and the left one at 3, 7, ... 39, each time with 2 m v = 8;
// its centre is at 5 at 0, 2, 4 and so on, at first to the right.
std::string one_disk(const std::string& panel) {
    return "box: {size: [10, 4]}\n"
           "gas: [{name: a, count: 1, radius: 1, velocity: [4, 0], position: [5, 2]}]\n"
           "run: {until: 40}\n" +
           film(panel);
}

}  // namespace

TEST_CASE("a gauge shows the momentum over the time before the present and the length") {
    const DialSeen seen(
        one_disk("{kind: pressure, gauge: true, surfaces: [left, right], over: "
                 "{window: 4}}"));
    CHECK(is_near(seen.last(0), 8.0 / (4.0 * 4.0), rounding));
    CHECK(is_near(seen.last(1), 8.0 / (4.0 * 4.0), rounding));
    CHECK(std::isnan(seen.reading(0)));
    const DialSeen all(one_disk("{kind: pressure, gauge: true, over: {window: 4}}"));
    CHECK(is_near(all.last(), 16.0 / (4.0 * (4.0 + 4.0 + 10.0 + 10.0)), rounding));
    CHECK(all.panel->table(*all.states.back(), theme(ThemeKind::dark)).rows.size() == 1);
}

TEST_CASE("the scale of a dial holds its numbers but for rare high ones") {
    std::vector<double> line(1000, 2.0);
    CHECK(scale_of_readings({line}).high == 2.0);
    CHECK(scale_of_readings({line}).low == 0.0);
    line[3] = 50.0;
    CHECK(scale_of_readings({line}).high == 2.0);
    CHECK(scale_of_readings({line}).share(50.0) == 1.0);
    line[4] = -1.0;
    CHECK(scale_of_readings({line}).low == -2.0);
    CHECK(scale_of_readings({line}).share(0.0) == 0.5);
    CHECK(scale_of_readings({{NAN}}).high == 1.0);
}

TEST_CASE("a stopwatch starts at its event, and runs back with the velocities") {
    const std::string scene =
        "box: {size: [10, 4]}\npartitions: [{name: divider, x: 5}]\n"
        "gas: [{name: a, count: 1, radius: 1, velocity: [1, 0], position: [2, 2]}]\n"
        "run: {until: 50, events: [{at: 10, open: divider}, {at: 25, reverse: velocities}]}\n";
    // Frames are half a unit of time apart.
    const DialSeen seen(scene + film("{kind: stopwatch, since: divider}"), 100);
    CHECK(seen.reading(10) == 0.0);
    CHECK(seen.reading(20) == 0.0);
    CHECK(seen.reading(30) == 5.0);
    CHECK(seen.reading(50) == 15.0);
    CHECK(seen.reading(60) == 10.0);
    CHECK(seen.reading(80) == 0.0);
    CHECK(seen.reading(100) == 0.0);
    const DialSeen turned(scene + film("{kind: stopwatch, since: reversal}"), 100);
    CHECK(turned.reading(50) == 0.0);
    CHECK(turned.reading(100) == 25.0);
    const DialSeen all(scene + film("stopwatch"), 100);
    CHECK(all.reading(50) == 25.0);
    CHECK(all.reading(100) == 0.0);
}

TEST_CASE("a counter counts hits and crossings") {
    const DialSeen hits(one_disk("counter"));
    CHECK(hits.last(0) == 10.0);
    CHECK(hits.last(1) == 10.0);
    CHECK(hits.last(2) == 0.0);
    const DialSeen line(one_disk("{kind: counter, line: {x: 4.5}}"));
    CHECK(line.last(0) == 10.0);
    CHECK(line.last(1) == 10.0);
    CHECK(line.reading(4, 1) == 0.0);  // until 2: it is there at 2.125
    CHECK(line.reading(5, 1) == 1.0);
    CHECK(line.reading(5, 0) == 0.0);
    const DialSeen beside(one_disk("{kind: counter, line: {x: 4.5, between: [0, 1]}}"));
    CHECK(beside.last(0) == 0.0);
}

TEST_CASE("a disk that finds the gap of a partition crosses it") {
    // 70 on a way of 19 that goes over the line at 2 and at 15.5: 2, 15.5, 21, 34.5, 40, 53.5, 59.
    const DialSeen passes(
        "box: {size: [10, 4]}\npartitions: [{name: wall, x: 3, gaps: [[0, 1]]}]\n"
        "gas: [{name: a, count: 1, radius: 0.25, velocity: [0.7, 0], position: [1, 0.5]}]\n"
        "run: {until: 100}\n" +
        film("counter"));
    CHECK(passes.last(0) == 4.0);
    CHECK(passes.last(1) == 3.0);
}

TEST_CASE("a thrown disk crosses a height twice, with what energy gravity leaves it") {
    // It rises from 2 with v = 10, g = 2: up to 27, over 18 at 2 and at 8, with v = 6.
    const DialSeen seen(
        "box: {size: [10, 40]}\ngravity: [0, -2]\n"
        "gas: [{name: a, count: 1, radius: 1, velocity: [0, 10], position: [5, 2]}]\n"
        "run: {until: 9}\n" +
            film("{kind: flux, line: {y: 18}, carried: energy, over: start}"),
        9);
    CHECK(is_near(seen.run().y[0].back(), 0.5 * 36.0 / 9.0, rounding));
    CHECK(is_near(seen.run().y[1].back(), 0.5 * 36.0 / 9.0, rounding));
    CHECK(seen.run().y[0][1] == 0.0);
    CHECK(seen.run().y[1][7] == 0.0);
}

TEST_CASE("what goes over the end of a periodic box crosses there, once each time around") {
    const DialSeen seen(
        "box: {size: [10, 4], walls: {left: periodic, right: periodic}}\n"
        "gas: [{name: a, count: 1, radius: 1, velocity: [4, 0], position: [5, 2]}]\n"
        "run: {until: 40}\n" +
            film("{kind: counter, line: {x: 7}}"),
        3);
    CHECK(seen.last(0) == 16.0);
    CHECK(seen.last(1) == 0.0);
}

TEST_CASE("a thermometer is the mean over exact times in a region") {
    // Disk a is in [0, 5] half of the time, b always: 8 and 2 of energy, T = e in the plane.
    const std::string gas =
        "box: {size: [10, 10]}\n"
        "gas:\n"
        "  - {name: a, count: 1, radius: 1, velocity: [4, 0], position: [5, 2]}\n"
        "  - {name: b, count: 1, radius: 1, velocity: [0, 2], position: [2, 6]}\n"
        "run: {until: 4}\n";
    const DialSeen seen(gas + film("{kind: thermometer, over: start, regions: [{name: left, "
                                   "within: [0, 0, 5, 10]}, {name: right, within: [5, 0, 10, "
                                   "10]}]}"),
                        7);
    CHECK(std::isfinite(seen.last(0)));
    // No collision: a's row is 1 to 3, b goes from 6 up to 9, and down to 4 at 4.
    CHECK(is_near(seen.last(0), (2.0 * 8.0 + 4.0 * 2.0) / 6.0, rounding));
    CHECK(is_near(seen.last(1), 8.0, rounding));
    const DialSeen of(gas + film("{kind: thermometer, of: [a, b], over: now}"), 7);
    CHECK(is_near(of.last(0), 8.0, rounding));
    CHECK(is_near(of.last(1), 2.0, rounding));
}

TEST_CASE("in gravity the energy of a thermometer is integrated over the flight") {
    // From rest at 26 to the floor at 1 with g = 2 in 5: the mean of m v^2 / 2 is g^2 t^2 / 6.
    const DialSeen seen(
        "box: {size: [10, 40]}\ngravity: [0, -2]\n"
        "gas: [{name: a, count: 1, radius: 1, velocity: [0, 0], position: [5, 26]}]\n"
        "run: {until: 4.5}\n" +
            film("{kind: thermometer, over: start}"),
        2);
    CHECK(is_near(seen.last(), 4.0 * 4.5 * 4.5 / 6.0, rounding));
}

TEST_CASE("theory of a flux is that of the mean speed in a periodic gas") {
    const DialSeen seen(
        "seed: 3\nbox: {size: [40, 40], walls: periodic}\n"
        "gas: [{name: a, count: 100, radius: 0.5, temperature: {exact: 1}}]\n"
        "run: {until: 400}\n" +
            film("{kind: flux, line: {x: 20}, over: start}"),
        40);
    // sqrt(T / 2 pi m) 100 / 40, with the mean of |v| of 100 disks, which is less by 1 / 8 N.
    const double exact = 100.0 / 40.0 / std::sqrt(2.0 * std::numbers::pi);
    CHECK(is_near(seen.run().y.at(2).back(), exact, 0.005));
    // 399 crossings each way; they are correlated by less than their number: 4 standard deviations.
    CHECK(is_near(seen.run().y.at(0).back(), exact, 4.0 / std::sqrt(399.0)));
    CHECK(is_near(seen.run().y.at(1).back(), exact, 4.0 / std::sqrt(399.0)));
}

TEST_CASE("thermometers without room show their numbers inside their place") {
    const test::SeenPanel seen(
        test::scene_from("title: T\nbox: {size: [40, 40]}\n"
                         "gas: [{name: a, count: 30, radius: 0.3, temperature: 1}]\n"
                         "run: {until: 4}\nfilm: {seconds: 4, panels: [{kind: thermometer, of: "
                         "[0, 1, 2, 3, 4]}]}\n"),
        4);
    const auto state = seen.last_state();
    Canvas canvas({400, 300});
    canvas.fill_all(rgb(0x000000));
    const PixelView view = canvas.pixels();
    const std::uint32_t ground = view.data[0];
    DiskPainter disks;
    // 30 by 8 units: rows of words, without glasses.
    const DrawContext dc{{50.0, 100.0, 300.0, 80.0}, 10.0, theme(ThemeKind::dark), disks};
    seen.panel->draw_ground(canvas, dc);
    seen.panel->draw(canvas, dc, *state);
    int inside = 0, outside = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x) {
            const bool is_in = x >= 50 && x < 350 && y >= 100 && y < 180;
            const bool is_drawn = canvas.pixels().data[y * view.stride + x] != ground;
            (is_in ? inside : outside) += is_drawn ? 1 : 0;
        }
    CHECK(inside > 500);
    CHECK(outside == 0);
}

TEST_CASE("a flux past fixed disks has no theory") {
    const auto lines = [](const std::string& mass) {
        return DialSeen(
                   "box: {size: [40, 40], walls: periodic}\n"
                   "gas: [{name: a, count: 30, radius: 0.3, temperature: 1}, "
                   "{name: b, position: [20, 20], radius: 5, mass: " +
                       mass + "}]\nrun: {until: 4}\n" + film("{kind: flux, line: {x: 20}}"),
                   4)
            .run()
            .y.size();
    };
    CHECK(lines("infinite") == 2);
    CHECK(lines("9") == 4);
}

TEST_CASE("theory of a flux through a gap is that of each side, and elsewhere there is none") {
    const std::string gas =
        "gas: [{name: a, count: 200, radius: 0.1, temperature: {exact: 2}, mass: 3, position: "
        "{within: [0, 0, 20, 20]}}]\nrun: {until: 1}\n";
    const std::string panel = film("{kind: flux, over: start}");
    const auto with = [&](const std::string& more) {
        return DialSeen("seed: 3\nbox: {size: [40, 20]}\n" + more + gas + panel, 20);
    };
    const DialSeen gap = with("partitions: [{name: wall, x: 20, gaps: [[9.25, 10.75]]}]\n");
    // Of 200 some 7 leave in that time, which the tolerance allows.
    const double exact = 200.0 / (19.8 * 19.8) * 1.3 * std::sqrt(2.0 / (6.0 * std::numbers::pi));
    CHECK(gap.run().y.size() == 4);
    CHECK(is_near(gap.run().y[2].back(), exact, 0.05));
    CHECK(std::isnan(gap.run().y[3].back()));  // of the few on the right
    const DialSeen close = with("partitions: [{name: wall, x: 20, gaps: [[8, 12]]}]\n");
    CHECK(std::isnan(close.run().y.at(2).back()));  // a gap of more than a free path
    const DialSeen wide = with("partitions: [{name: wall, x: 20, gaps: [[3, 17]]}]\n");
    CHECK(wide.run().y.size() == 2);
    const auto explains_dashes = [](const DialSeen& seen) {
        const plot::Plot plot = dynamic_cast<const PlotPanel&>(*seen.panel).plot(nullptr);
        REQUIRE(plot.notes.size() == 1);
        return plot.notes[0].entries.at(0).words.at(0).pieces.at(0).markup.find("dashed") !=
               std::string::npos;
    };
    CHECK(explains_dashes(gap));
    CHECK_FALSE(explains_dashes(close));  // no dashed line is ever seen
    CHECK_FALSE(explains_dashes(wide));
    const DialSeen falls = with(
        "gravity: [0, -1]\npartitions: [{name: wall, x: 20, gaps: [[9, "
        "11]]}]\n");
    CHECK(falls.run().y.size() == 2);
}

TEST_CASE("dials of several runs stand side by side, and of several seeds there is a mean") {
    const auto run = [](int velocity) {
        return "box: {size: [10, 10]}\ngas: [{name: a, count: 1, radius: 1, velocity: [" +
               std::to_string(velocity) + ", 0], position: [5, 2]}]\nrun: {until: 4}\n" +
               film("thermometer");
    };
    DialSeen slow(run(2)), fast(run(4)), other(run(4));
    dynamic_cast<SharedPanel&>(*slow.panel).fix_axes_of_runs({fast.panel.get()}, {"slow", "fast"});
    const auto both = dynamic_cast<SharedPanel&>(*slow.panel)
                          .state_of_runs({slow.states.back(), fast.states.back()});
    const std::vector<DialPanel::Reading> readings = slow.dial().readings(*both);
    REQUIRE(readings.size() == 2);
    CHECK(readings[0].value == 2.0);
    CHECK(readings[0].line.name == "slow");
    CHECK(readings[1].value == 8.0);
    CHECK(slow.dial().accounts_of_runs(*both).at(1) == "temperature 8.00");
    DialSeen first(run(2));
    dynamic_cast<SharedPanel&>(*first.panel).fix_axes_of_runs({other.panel.get()}, {});
    CHECK(first.last() == 5.0);
    // Of 2 and 8: the root of the variance, 18, over 2.
    const DialPanel::Reading mean = first.dial().readings(*first.states.back()).at(0);
    CHECK(mean.error == 3.0);
    CHECK(first.dial().number(mean.value, mean.error) == "5.0 ± 3.0");
    CHECK(first.dial().account(*first.states.back()) ==
          "Temperature 5.0 ± 3.0 (mean over the last 0.2).");
    const Table table = first.dial().table(*first.states.back(), theme(ThemeKind::light));
    CHECK(column_names(table)[3] == "standard error");
    CHECK(std::get<double>(table.rows.at(0)[3]) == 3.0);
}

// Instruments at walls and partitions, against runs whose numbers are known by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "panels/plot/plot_panel.h"
#include "panels/plots/series_panel.h"
#include "panels/registry.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// The first panel of a scene's film, after its first pass over the whole run.
struct Seen {
    Scene scene;
    Simulation simulation;
    Particles particles;
    std::optional<EquilibriumGas> equilibrium = {};
    std::unique_ptr<Panel> panel;
    std::vector<double> times = {};
    std::vector<EnergyAccount> accounts = {};

    explicit Seen(const std::string& text, int steps = 80)
        : scene(test::scene_from("title: T\n" + text)),
          simulation(scene.gas, scene.run),
          particles(simulation.particles()),
          panel(make_panel({scene, particles, steps + 1, equilibrium}, scene.film.panels.at(0))) {
        simulation.record_collisions(panel->surveys_collisions());
        for (int i = 0; i <= steps; ++i) {
            const double time = scene.run.until * i / steps;
            const AdvanceResult advanced = simulation.advance_to(time);
            Tick tick;
            tick.time = time;
            const Sample& sample = simulation.sample();
            panel->survey(
                {tick, sample, speeds(sample), kinetic_energies(particles, sample), advanced});
            times.push_back(time);
            accounts.push_back(simulation.energy_account());
        }
        panel->fix_axes();
    }
    const SeriesRun& run() const {
        return dynamic_cast<const SeriesPanel&>(*panel).record().runs.front();
    }
    double last(std::size_t line) const { return run().lines.at(line).back(); }
    plot::Plot plot() const { return dynamic_cast<const PlotPanel&>(*panel).plot(nullptr); }
};

double error_of(double found, double exact) {
    return std::abs(found - exact) / std::max(1e-300, std::abs(exact));
}

// Hits the right wall at 1, 5, ... 37 and the left one at 3, 7, ... 39, each time with 2 m v = 8.
std::string one_disk(const std::string& box, const std::string& panel) {
    return "box: " + box +
           "\ngas: [{name: a, count: 1, radius: 1, velocity: [4, 0], position: [5, 2]}]\n"
           "run: {until: 40}\nfilm: {seconds: 8, panels: [" +
           panel + "]}\n";
}

// The mean of h where p(h) is proportional to h^N (E - F h)^b, by the midpoint rule.
double mean_height(double count, double energy, double force, double b) {
    constexpr int steps = 200'000;
    double sum = 0.0, weight = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double h = energy / force * (i + 0.5) / steps;
        const double p =
            std::pow(h * force / energy, count) * std::pow(1.0 - h * force / energy, b);
        sum += p * h;
        weight += p;
    }
    return sum / weight;
}

}  // namespace

TEST_CASE("the pressure on a wall is its momentum over time and length") {
    const double rounding = 1e-12;
    for (const std::string over : {"start", "{window: 4}"}) {
        CAPTURE(over);
        const Seen seen(
            one_disk("{size: [10, 4]}",
                     "{kind: pressure, surfaces: [left, right, top], over: " + over + "}"));
        CHECK(error_of(seen.last(0), 80.0 / (40.0 * 4.0)) < rounding);
        CHECK(error_of(seen.last(1), 80.0 / (40.0 * 4.0)) < rounding);
        CHECK(seen.last(2) == 0.0);
        CHECK(std::isnan(seen.run().lines[0][0]));
    }
}

TEST_CASE("the length of a wall beside one that moves is its mean over the time") {
    const Seen seen(one_disk("{size: [10, 4], walls: {top: {velocity: 0.1}}}",
                             "{kind: pressure, surfaces: right}"));
    CHECK(error_of(seen.last(0), 80.0 / (40.0 * 6.0)) < 1e-12);
}

TEST_CASE("on a partition counts what its sides leave, and gaps have no length") {
    const Seen seen(
        "box: {size: [20, 4]}\n"
        "partitions: [{name: divider, x: 10, gaps: [[0, 0.5]]}]\n"
        "gas:\n"
        "  - {name: a, count: 1, radius: 1, velocity: [4, 0], position: [5, 2]}\n"
        "  - {name: b, count: 1, radius: 1, velocity: [2, 0], position: [15, 2]}\n"
        "run: {until: 40}\nfilm: {seconds: 8, panels: [{kind: pressure, surfaces: "
        "divider}]}\n");
    // Disk a gives it 80 to the right; disk b, with period 8 and hits from 6 on, 5 times 4.
    CHECK(error_of(seen.last(0), (80.0 - 20.0) / (40.0 * 3.5)) < 1e-12);
    CHECK(seen.plot().y.low == 0.0);
}

TEST_CASE("parts of a box hold what is in them") {
    const auto in_parts = [](const std::string& panel) {
        return Seen(
            "box: {size: [20, 10]}\npartitions: [{name: divider, x: 8}]\n"
            "gas:\n"
            "  - {name: a, count: 3, mass: 2, radius: 0.5, velocity: [[1, 0], [0, 2], [3, "
            "0]], position: [[2, 2], [4, 6], [12, 5]]}\n"
            "  - {name: b, count: 1, radius: 0.5, mass: 6, velocity: [0, 1], position: [7, "
            "3]}\n"
            "run: {until: 0.01}\nfilm: {seconds: 8, panels: [" +
                panel + "]}\n",
            1);
    };
    const Seen count = in_parts("sides");
    CHECK(count.run().lines[0][0] == 3.0);
    CHECK(count.run().lines[1][0] == 1.0);
    const Seen energy = in_parts("{kind: sides, measure: mean-energy}");
    CHECK(error_of(energy.run().lines[0][0], (1.0 + 4.0 + 3.0) / 3.0) < 1e-14);
    CHECK(energy.run().lines[1][0] == 9.0);
    const Seen temperature = in_parts("{kind: sides, measure: temperature}");
    CHECK(error_of(temperature.run().lines[0][0], 2.0 * (1.0 + 4.0 + 3.0) / 6.0) < 1e-14);
    const Seen center = in_parts("{kind: sides, measure: center, component: y}");
    CHECK(error_of(center.run().lines[0][0], (2 * 2 + 2 * 6 + 6 * 3) / 10.0) < 1e-14);
    const Seen regions = in_parts(
        "{kind: sides, regions: [{name: low, within: [0, 0, 20, 4]}, {name: rest, within: [0, 4, "
        "20, 10]}, {name: empty, within: [15, 0, 20, 10]}]}");
    CHECK(regions.run().lines[0][0] == 2.0);
    CHECK(regions.run().lines[1][0] == 2.0);
    CHECK(regions.run().lines[2][0] == 0.0);
}

TEST_CASE("half of the particles is marked where a window in the middle lets all through") {
    const auto level = [](const std::string& rest) {
        return Seen("box: {size: [20, 10]}\npartitions: [{name: window, " + rest +
                        "}]\ngas: [{name: a, count: 4, radius: 0.2, speed: 1}]\n"
                        "run: {until: 1}\nfilm: {seconds: 8, panels: [sides]}\n",
                    2)
            .run()
            .level;
    };
    REQUIRE(level("x: 10, gaps: [[4, 6]]"));
    CHECK(level("x: 10, gaps: [[4, 6]]")->value == 2.0);
    CHECK_FALSE(level("x: 10"));
    CHECK_FALSE(level("x: 9, gaps: [[4, 6]]"));
    CHECK_FALSE(level("x: 10, passes: {to_right: {faster_than: 1}}"));
}

TEST_CASE("the energies of a gas under a piston add up to a level") {
    const Seen seen(
        "gravity: [0, -0.1]\n"
        "box: {size: [12, 14], walls: {top: {mass: 20, force: -3}}}\n"
        "gas: [{name: a, count: 20, radius: 0.4, temperature: 2}]\n"
        "run: {until: 30}\nfilm: {seconds: 8, panels: [energy-account]}\n");
    REQUIRE(seen.run().lines.size() == 3);
    for (std::size_t i = 0; i < seen.times.size(); ++i) {
        const EnergyAccount& account = seen.accounts[i];
        CHECK(error_of(seen.run().lines[0][i], account.kinetic) < 1e-13);
        CHECK(error_of(seen.run().lines[1][i], account.kinetic + account.potential) < 1e-13);
        CHECK(error_of(seen.run().lines[2][i], account.in_all()) < 1e-13);
        // The simulation keeps it to about 1e-12 in a million events; here are some thousand.
        CHECK(error_of(seen.run().lines[2][i], seen.run().lines[2][0]) < 1e-12);
    }
    const plot::Plot plot = seen.plot();
    const auto bands = std::ranges::count_if(
        plot.layers, [](const auto& layer) { return std::holds_alternative<plot::Band>(layer); });
    CHECK(bands == 3);
}

TEST_CASE("the mean place of a piston over an ideal gas is that of its exact distribution") {
    const Seen wire(
        "box: {length: 10, walls: {right: {mass: 3, force: -2}}}\n"
        "gas: [{name: a, count: 2, radius: 0.5, velocity: [1, -1], position: [2, 6]}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [piston]}\n");
    // E = 1 + 2 * (10 - 2): beads take 2 of the length.
    REQUIRE(wire.run().level);
    CHECK(error_of(wire.run().level->value, 2.0 + mean_height(2, 17.0, 2.0, 0.5)) < 1e-6);

    const Seen plane(
        "box: {size: [10, 14], walls: {bottom: {mass: 20, force: 3}}}\n"
        "gas: [{name: a, count: 20, radius: 0.01, temperature: {exact: 2}}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [{kind: piston, surfaces: bottom}]}\n");
    REQUIRE(plane.run().level);
    CHECK(error_of(plane.run().level->value,
                   14.0 - mean_height(20, 20 * 2.0 + 3.0 * 14.0, 3.0, 19.5)) < 1e-6);
    for (const double place : plane.run().lines[0]) CHECK(place < 14.0);

    const Seen driven(
        "box: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
        "gas: [{name: a, count: 20, radius: 0.01, temperature: 2}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [piston]}\n");
    CHECK_FALSE(driven.run().level);
    CHECK(error_of(driven.last(0), 10.0) < 1e-14);
}

TEST_CASE("pressure against area begins at the box, with the ideal gas from there") {
    const Seen seen(
        "box: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
        "gas: [{name: a, count: 20, radius: 0.01, temperature: {exact: 2}}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [pressure-volume]}\n");
    const plot::Plot plot = seen.plot();
    std::size_t found = 0;
    for (const auto& layer : plot.layers) {
        const auto* line = std::get_if<plot::Line>(&layer);
        if (line == nullptr || line->part != "theory") continue;
        const double start = 20 * 2.0 / 140.0, power = line->of == "adiabat" ? 2.0 : 1.0;
        for (std::size_t i = 0; i < line->x.size(); ++i)
            CHECK(error_of(line->y[i], start * std::pow(140.0 / line->x[i], power)) < 1e-12);
        ++found;
    }
    CHECK(found == 2);
    CHECK(plot.y.low == 0.0);
    CHECK(plot.x.low < 100.0);
    CHECK(plot.x.high > 140.0);
}

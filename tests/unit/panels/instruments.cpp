// Instruments, against runs whose numbers are known by hand.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "support/relative.h"
#include "support/seen_panel.h"
#include "support/share_of_cases.h"

using namespace carom;

namespace {

// The first panel of a scene's film, after its first pass over the whole run.
struct Seen : test::SeenPanel {
    explicit Seen(const std::string& text, int steps = 80)
        : SeenPanel(test::scene_from("title: T\n" + text), steps) {}
    const History& run() const { return series(); }
    double last(std::size_t line) const { return run().y.at(line).back(); }
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

// One disk among others that stand still flies pi A / P on average, where A is the area that its
// centre may reach and P its perimeter (Chernov, J. Stat. Phys. 88, 1 (1997)).
TEST_CASE("the mean free path so far of a disk among pegs goes to the exact one") {
    const double pi = std::numbers::pi, radius = 4.0, until = 40'000.0;
    const double exact = pi * (400.0 - pi * radius * radius) / (2.0 * pi * radius);
    const Seen seen(
        "box: {size: [20, 20], walls: periodic}\n"
        "obstacles: [{name: peg, disk: [10, 10], radius: 3}]\n"
        "gas: [{name: a, count: 1, radius: 1, velocity: [0.6, 0.8], position: [2, 3]}]\n"
        "run: {until: " +
        std::to_string(until) + "}\nfilm: {seconds: 8, panels: [mean-free-path]}\n");
    REQUIRE(seen.run().levels.size() == 1);
    CHECK(error_of(seen.run().levels.front().value, exact) < 1e-12);
    // Five standard errors of so many flights whose lengths scatter by their mean.
    CHECK(error_of(seen.last(0), exact) < 5.0 / std::sqrt(until / exact));
}

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
        CHECK(std::isnan(seen.run().y[0][0]));
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

TEST_CASE("of a gap only what lies between the walls is taken from the length") {
    const auto pressure = [](const std::string& gap, const std::string& velocity) {
        const Seen seen(one_disk("{size: [20, 20], walls: {top: {velocity: " + velocity +
                                     ", until: 10}}}\npartitions: [{name: part, x: 10, gaps: [" +
                                     gap + "]}]",
                                 "{kind: pressure, surfaces: part, over: {window: 20}}"));
        return seen.last(0);
    };
    // Five hits with 8 in the last 20, when the top has come from 20 to 10 or to 25.
    CHECK(error_of(pressure("[12, 18]", "-1"), 40.0 / (20.0 * 10.0)) < 1e-12);
    CHECK(error_of(pressure("[8, 18]", "-1"), 40.0 / (20.0 * 8.0)) < 1e-12);
    CHECK(error_of(pressure("[12, 18]", "0.5"), 40.0 / (20.0 * 19.0)) < 1e-12);
    CHECK(error_of(pressure("[12, 20]", "0.5"), 40.0 / (20.0 * 12.0)) < 1e-12);
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
    CHECK(count.run().y[0][0] == 3.0);
    CHECK(count.run().y[1][0] == 1.0);
    const Seen energy = in_parts("{kind: sides, measure: mean-energy}");
    CHECK(error_of(energy.run().y[0][0], (1.0 + 4.0 + 3.0) / 3.0) < 1e-14);
    CHECK(energy.run().y[1][0] == 9.0);
    const Seen temperature = in_parts("{kind: sides, measure: temperature}");
    CHECK(error_of(temperature.run().y[0][0], 2.0 * (1.0 + 4.0 + 3.0) / 6.0) < 1e-14);
    const Seen center = in_parts("{kind: sides, measure: center, component: y}");
    CHECK(error_of(center.run().y[0][0], (2 * 2 + 2 * 6 + 6 * 3) / 10.0) < 1e-14);
    const Seen regions = in_parts(
        "{kind: sides, regions: [{name: low, within: [0, 0, 20, 4]}, {name: rest, within: [0, 4, "
        "20, 10]}, {name: empty, within: [15, 0, 20, 10]}]}");
    CHECK(regions.run().y[0][0] == 2.0);
    CHECK(regions.run().y[1][0] == 2.0);
    CHECK(regions.run().y[2][0] == 0.0);
}

TEST_CASE("half of the particles is marked where a window in the middle lets all through") {
    const auto levels = [](const std::string& rest) {
        return Seen("box: {size: [20, 10]}\npartitions: [{name: window, " + rest +
                        "}]\ngas: [{name: a, count: 4, radius: 0.2, speed: 1}]\n"
                        "run: {until: 1}\nfilm: {seconds: 8, panels: [sides]}\n",
                    2)
            .run()
            .levels;
    };
    REQUIRE(levels("x: 10, gaps: [[4, 6]]").size() == 1);
    CHECK(levels("x: 10, gaps: [[4, 6]]")[0].value == 2.0);
    CHECK(levels("x: 10").empty());
    CHECK(levels("x: 9, gaps: [[4, 6]]").empty());
    CHECK(levels("x: 10, passes: {to_right: {faster_than: 1}}").empty());
    // Narrower than a disk; itself a source of heat; in motion.
    CHECK(levels("x: 10, gaps: [[4.85, 5.15]]").empty());
    CHECK(levels("x: 10, gaps: [[4, 6]], temperature: 4").empty());
    CHECK(levels("x: 10, gaps: [[4, 6]], velocity: 0.1, until: 1").empty());
    // Fixed disks are where they are, and take room on one side only.
    CHECK(Seen("box: {size: [20, 10]}\npartitions: [{name: window, x: 10, gaps: [[4, 6]]}]\n"
               "gas: [{name: a, count: 4, radius: 0.2, speed: 1}, "
               "{name: b, position: [3, 3], radius: 1, mass: infinite}]\n"
               "run: {until: 1}\nfilm: {seconds: 8, panels: [sides]}\n",
               2)
              .run()
              .levels.empty());
}

TEST_CASE("numbers and temperatures beside a window scatter as theory says" *
          doctest::skip(test::has_sanitizers)) {
    const auto deviations = [](const std::string& measure, double radius) {
        constexpr int steps = 12'000;
        const Seen seen(
            "box: {size: [24, 16]}\npartitions: [{name: window, x: 12, gaps: [[2, 14]]}]"
            "\ngas: [{name: a, count: 100, radius: " +
                std::to_string(radius) +
                ", position: lattice, temperature: {exact: 2}}]\n"
                "run: {until: 6000, equilibrate: 20}\n"
                "film: {seconds: 8, panels: [{kind: sides, measure: " +
                measure + "}]}\n",
            steps);
        const std::vector<double>& left = seen.run().y[0];
        double sum = 0.0, squares = 0.0;
        for (const double value : left) sum += value, squares += value * value;
        const double mean = sum / double(left.size());
        const ReferenceLevel& level = seen.run().levels.at(0);
        CHECK(error_of(mean, level.value) < 0.02);
        return std::pair{std::sqrt(squares / double(left.size()) - mean * mean), level.deviation};
    };
    // By Henderson's equation 0.202 of the variance is left at a packing of 0.346. Some 2000
    // independent values: 1.6 % of a deviation; the window and the sides take up to 6 % of the
    // fluid's own.
    struct Case {
        const char* measure;
        double radius, share;
    };
    for (const Case& one :
         {Case{"count", 0.01, 1.0}, {"count", 0.65, 0.202}, {"temperature", 0.4, 1.0}}) {
        const auto& [measure, radius, share] = one;
        CAPTURE(one.measure);
        CAPTURE(one.radius);
        const std::pair<double, double> both = deviations(measure, radius);
        const double found = both.first, exact = both.second;
        CAPTURE(found);
        CAPTURE(exact);
        CHECK(std::abs(found / exact - 1.0) < 0.12);
        const double of_points = measure == std::string("count") ? 5.0 : 2.0 * std::sqrt(2.0 / 202);
        CHECK(exact < 1.0001 * of_points);
        CHECK(std::abs(exact * exact / (of_points * of_points) - share) < 0.005);
    }
}

TEST_CASE("a pressure is compared with equations of state where these hold") {
    const auto names = [](const std::string& gas, const std::string& box) {
        const Seen seen("box: {" + box + "}\ngas: [" + gas +
                        "]\nrun: {until: 4}\nfilm: {seconds: 8, panels: [pressure]}\n");
        std::string all;
        for (const ReferenceLevel& level : seen.run().levels) all += level.name + ";";
        return all;
    };
    const std::string disks = "{name: a, count: 20, radius: 0.4, temperature: 1}";
    CHECK(names(disks, "size: [12, 9]") == "ideal gas;hard disks;");
    CHECK(names(disks + ", {name: b, count: 2, radius: 1, temperature: 1}", "size: [12, 9]") ==
          "ideal gas;");
    // Beyond a packing of 0.6 Henderson's equation is more than 1 % off.
    CHECK(names("{name: a, count: 144, radius: 0.43, position: lattice, temperature: 1}",
                "size: [12, 10.4], walls: periodic") == "ideal gas;Henderson;Kolafa–Rottner;");
    CHECK(names("{name: a, count: 9, radius: 0.1, temperature: 1}", "length: 9") ==
          "ideal gas;hard rods;");
    CHECK(names(disks, "size: [12, 9], walls: {left: {temperature: 1}}") == "");
}

TEST_CASE("levels that look alike share a label, and one with a deviation has a band") {
    const Seen seen(
        "box: {size: [40, 30]}\ngas: [{name: a, count: 20, radius: 0.4, temperature: 1}]"
        "\nrun: {until: 4}\nfilm: {seconds: 8, panels: [pressure]}\n");
    std::vector<std::string> labels;
    for (const plot::AnyLayer& layer : seen.plot().layers)
        if (const auto* level = std::get_if<plot::Level>(&layer))
            if (level->label) labels.push_back(level->label->words.front().pieces.front().markup);
    REQUIRE(labels.size() == 2);
    CHECK(labels[0].starts_with("ideal gas 0."));
    CHECK(labels[1].starts_with("hard disks 0."));

    const Seen window(
        "box: {size: [20, 10]}\npartitions: [{name: window, x: 10, gaps: [[4, 6]]}]\n"
        "gas: [{name: a, count: 16, radius: 0.001, speed: 1}]\n"
        "run: {until: 1}\nfilm: {seconds: 8, panels: [sides]}\n",
        2);
    const plot::Plot plot = window.plot();
    const auto band = std::ranges::find_if(
        plot.layers, [](const auto& layer) { return std::holds_alternative<plot::Band>(layer); });
    REQUIRE(band != plot.layers.end());
    CHECK(error_of(std::get<plot::Band>(*band).error[0], 2.0) < 1e-5);
    CHECK(std::get<plot::Band>(*band).y[0] == 8.0);
}

TEST_CASE("the energies of a gas under a piston add up to a level") {
    const Seen seen(
        "gravity: [0, -0.1]\n"
        "box: {size: [12, 14], walls: {top: {mass: 20, force: -3}}}\n"
        "gas: [{name: a, count: 20, radius: 0.4, temperature: 2}]\n"
        "run: {until: 30}\nfilm: {seconds: 8, panels: [energy-account]}\n");
    REQUIRE(seen.run().y.size() == 3);
    for (std::size_t i = 0; i < seen.times.size(); ++i) {
        const EnergyAccount& account = seen.accounts[i];
        CHECK(error_of(seen.run().y[0][i], account.kinetic) < 1e-13);
        CHECK(error_of(seen.run().y[1][i], account.kinetic + account.potential) < 1e-13);
        CHECK(error_of(seen.run().y[2][i], account.in_all()) < 1e-13);
        // The simulation keeps it to about 1e-12 in a million events; here are some thousand.
        CHECK(error_of(seen.run().y[2][i], seen.run().y[2][0]) < 1e-12);
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
    REQUIRE(wire.run().levels.size() == 1);
    CHECK(error_of(wire.run().levels[0].value, 2.0 + mean_height(2, 17.0, 2.0, 0.5)) < 1e-6);

    const Seen plane(
        "box: {size: [10, 14], walls: {bottom: {mass: 20, force: 3}}}\n"
        "gas: [{name: a, count: 20, radius: 0.01, temperature: {exact: 2}}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [{kind: piston, surfaces: bottom}]}\n");
    REQUIRE(plane.run().levels.size() == 1);
    CHECK(error_of(plane.run().levels[0].value,
                   14.0 - mean_height(20, 20 * 2.0 + 3.0 * 14.0, 3.0, 19.5)) < 1e-6);
    for (const double place : plane.run().y[0]) CHECK(place < 14.0);

    // One disk keeps the energy of its motion along the piston, a gas that may go round its
    // momentum.
    for (const std::string box : {"[10, 14], walls: {top: {mass: 20, force: -3}}",
                                  "[10, 14], walls: {left: periodic, right: periodic, "
                                  "top: {mass: 20, force: -3}}"}) {
        const bool is_round = box.find("periodic") != std::string::npos;
        const Seen unshared("box: {size: " + box +
                            "}\ngas: [{name: a, count: " + (is_round ? "20" : "1") +
                            ", radius: 0.1, velocity: [4, 1]}]\n"
                            "run: {until: 8}\nfilm: {seconds: 8, panels: [piston]}\n");
        CHECK(unshared.run().levels.empty());
    }

    const Seen driven(
        "box: {size: [10, 14], walls: {top: {velocity: -0.5}}}\n"
        "gas: [{name: a, count: 20, radius: 0.01, temperature: 2}]\n"
        "run: {until: 8}\nfilm: {seconds: 8, panels: [piston]}\n");
    CHECK(driven.run().levels.empty());
    CHECK(error_of(driven.last(0), 10.0) < 1e-14);
}

// Of a piston of some mass on 300 disks of mass 1, from 1 above its mean of 31: the mean of the
// times between crossings of the mean place, of six runs together; and what the panel says.
std::pair<double, double> period_of_piston(int mass, double radius, double until) {
    constexpr int steps = 300;
    std::vector<double> place(steps + 1, 0.0);
    double said = 0.0;
    for (int seed = 1; seed <= 6; ++seed) {
        const Seen seen(
            fmt::format("seed: {}\nbox: {{size: [64, 32], walls: {{top: {{mass: {}, force: "
                        "-20}}}}}}\ngas: [{{count: 300, radius: {}, temperature: {{exact: 2}}, "
                        "position: {{within: [0, 0, 64, 31]}}}}]\nrun: {{until: {}}}\n"
                        "film: {{seconds: 8, panels: [piston]}}\n",
                        seed, mass, radius, until),
            steps);
        const std::vector<double>& run = seen.run().y[0];
        for (std::size_t i = 0; i < place.size(); ++i)
            place[i] += run.at(i * (run.size() - 1) / steps) / 6.0;
        const auto& numbers = seen.run().numbers;
        said = numbers.empty() ? 0.0 : numbers[0][0].mean;
    }
    const double mean = std::accumulate(place.begin(), place.end(), 0.0) / (steps + 1.0);
    std::vector<double> down;
    for (std::size_t i = 1; i < place.size(); ++i)
        if (place[i - 1] > mean && place[i] <= mean)
            down.push_back(until / steps *
                           (double(i) - (mean - place[i]) / (place[i - 1] - place[i])));
    const double between =
        down.size() < 2 ? 0.0 : (down.back() - down.front()) / double(down.size() - 1);
    return {between, said};
}

TEST_CASE("a piston swings with the period of a column of gas that it closes") {
    // x tan x = 300 / M, omega = x sqrt(K / 300) with the adiabat's K = 2 F / h. Without the
    // inertia of the gas it would be 96, 55 and 30. What remains of the disorder of six runs moves
    // each crossing by a tenth of the amplitude, a sixtieth of a period: 8 % are three deviations
    // of the time between two.
    for (const auto& [mass, expected] : {std::pair{300, 111.3}, {100, 80.3}, {30, 67.1}}) {
        CAPTURE(mass);
        const auto [found, said] = period_of_piston(mass, 0.4, 2.5 * expected);
        CHECK(error_of(said, expected) < 0.01);
        CHECK(error_of(found, said) < 0.08);
    }
    CHECK(period_of_piston(30, 0.02, 10.0).second == 0.0);  // sound does not travel
    CHECK(period_of_piston(30'000, 0.02, 10.0).second > 900.0);
}

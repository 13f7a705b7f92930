// Runs of gases by name, against kinetic theory and textbooks.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "physics/units/unit_table.h"
#include "runs/run.h"
#include "scene/scene.h"
#include "support/figure_run.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

std::string scene_with(const std::string& gas, const char* box, const char* until,
                       const char* more = "") {
    return fmt::format(
        "title: T\nunits: real\nbox: {{{}, walls: periodic}}\ngas: [{}]\nrun: {{until: {}}}\n{}",
        box, gas, until, more);
}

RunReport run_of(const std::string& text, const Overrides& overrides = {}) {
    return run_physics(test::scene_from(text, overrides, Wanted::physics));
}

}  // namespace

TEST_CASE("a gas by name is the same run as with its numbers") {
    const char* cube = "size: [5 nm, 4 nm, 4 nm]";
    const std::string named = scene_with("{gas: krypton, count: 40, temperature: 300 K}", cube,
                                         "20 ps"),
                      written = scene_with(
                          "{count: 40, radius: 0.2055 nm, mass: 83.798 u, "
                          "temperature: 300 K}",
                          cube, "20 ps");
    CHECK(run_of(named).state == run_of(written).state);
}

// The virial pressure of 1000 atoms of helium at 300 K in 216 nm^3 against N k T Z / V with the
// virial coefficients of hard spheres, Z = 1 + 4 eta + 10 eta^2 + 18.364768 eta^3 + 28.2245 eta^4
// (Clisby and McCoy, J. Stat. Phys. 122, 15, 2006).
TEST_CASE("helium has the pressure of hard spheres of its diameter") {
    constexpr double count = 1000.0, volume = 216.0, d = 0.217;
    const double kt = in_base_units("300", *unit_named("K")).value();
    const double eta = count * std::numbers::pi / 6.0 * d * d * d / volume;
    const double z = 1.0 + eta * (4.0 + eta * (10.0 + eta * (18.364768 + eta * 28.2245)));
    // The centre of mass of a periodic box is at rest.
    const double expected = kt * (count * z - 1.0) / volume;
    const std::string text = scene_with("{gas: helium, count: 1000, temperature: {exact: 300 K}}",
                                        "size: [6 nm, 6 nm, 6 nm]", "20 ps");
    constexpr int runs = 8;
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < runs; ++k) {
        const RunReport report = run_of(text, {fmt::format("seed={}", k + 1)});
        const double found = report.summary.virial_pressure.value() / expected - 1.0;
        sum += found;
        squares += found * found;
    }
    const double mean = sum / runs;
    const double error = std::sqrt((squares / runs - mean * mean) / (runs - 1));
    CAPTURE(mean);
    CAPTURE(error);
    CHECK(error < 1e-3);  // the correction is a tenth
    // Eight runs: Student's t with 7 degrees of freedom exceeds 6 by chance in 1 of 2000 tests.
    CHECK(std::abs(mean) < 6.0 * error);
}

// Mean speeds of tables at 298.15 K, in m/s.
TEST_CASE("gases in a mixture have the mean speeds of textbooks") {
    const Scene scene =
        test::scene_from(scene_with("{gas: helium, count: 20000, temperature: {exact: 298.15 K}}, "
                                    "{gas: nitrogen, count: 20000, temperature: {exact: 298.15 K}}",
                                    "shape: [4, 3, 3], pressure: 1 bar", "1 ps"),
                         {}, Wanted::physics);
    const RunReport report = run_physics(scene);
    for (const auto& [species, expected] : {std::pair{0, 1255.8}, std::pair{1, 474.7}}) {
        const double speed =
            in_si(report.summary.species[static_cast<std::size_t>(species)].speed.value(),
                  quantities::speed);
        CAPTURE(speed);
        // With the energy fixed the mean of N speeds deviates by less than 0.42 / sqrt N.
        CHECK(std::abs(speed - expected) < 5.0 * 0.42 / std::sqrt(20000.0) * expected + 0.05);
    }
}

// Mean speeds of tables at 298.15 K, in m/s, in the caption of a mixture of noble gases.
TEST_CASE("the caption of a mixture of noble gases gives the mean speeds of textbooks") {
    constexpr int count = 2000;
    std::string gas;
    for (const char* name : {"helium", "neon", "argon", "krypton", "xenon"})
        gas += fmt::format("{}{{gas: {}, count: {}, temperature: {{exact: 298.15 K}}}}",
                           gas.empty() ? "" : ", ", name, count);
    const Scene scene = test::scene_from(
        scene_with(gas, "shape: [4, 3, 3], pressure: 20 bar", "10 ps",
                   "figures: [{name: speeds, kind: speed-histogram, at: 10 ps, of: [helium, neon, "
                   "argon, krypton, xenon]}]\n"),
        {}, Wanted::figures);
    const FigureRun run = test::run_of(scene);
    const std::string caption = words_of(run, run.figures().front()).caption;
    CAPTURE(caption);
    for (const auto& [name, expected] : {std::pair{"Helium", 1255.8},
                                         {"Neon", 559.3},
                                         {"Argon", 397.5},
                                         {"Krypton", 274.5},
                                         {"Xenon", 219.3}}) {
        const std::string before = fmt::format("{}: mean ", name);
        const std::size_t at = caption.find(before);
        REQUIRE(at != std::string::npos);
        const std::string rest = caption.substr(at + before.size());
        CHECK(rest.find("\u00A0m/s") < 6);
        // Speeds deviate by 0.42 of their mean; numbers have three digits.
        CHECK(std::abs(std::stod(rest) / expected - 1.0) <
              5.0 * 0.42 / std::sqrt(double(count)) + 0.005);
    }
}

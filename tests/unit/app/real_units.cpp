// Scenes in real units: that they are the same run as in reduced units, and what is given of it.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/report/run_facts.h"
#include "figures/figure_drawing.h"
#include "figures/figure_words.h"
#include "physics/units/unit_table.h"
#include "runs/json.h"
#include "runs/run.h"
#include "scene/scene.h"
#include "support/figure_run.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

const std::string real =
    "title: T\nunits: real\nbox: {size: [40 angstrom, 3 nm, 3000 pm]}\n"
    "gas: [{name: argon, count: 30, radius: 0.17 nm, mass: 39.948 u, temperature: 298.15 K}, "
    "{name: fast, count: 1, radius: {uniform: [0.1 nm, 0.2 nm]}, mass: 1e-25 kg, "
    "velocity: [400 m/s, 0, 0]}]\n"
    "run: {until: 0.01 ns, sample_every: 500 fs, "
    "events: [{at: 5 ps, heat: {of: argon, by: 3 zJ}}]}\n";

Scene scene_of(const std::string& text, const Overrides& overrides = {}) {
    return test::scene_from(text, overrides, Wanted::physics);
}

// The scene in nanometres, atomic mass units and picoseconds.
std::string reduced() {
    const auto in = [](const char* number, const char* unit) {
        return in_base_units(number, *unit_named(unit)).value();
    };
    return fmt::format(
        "title: T\nbox: {{size: [4, 3, 3]}}\n"
        "gas: [{{name: argon, count: 30, radius: 0.17, mass: 39.948, temperature: {}}}, "
        "{{name: fast, count: 1, radius: {{uniform: [0.1, 0.2]}}, mass: {}, "
        "velocity: [0.4, 0, 0]}}]\n"
        "run: {{until: 10, sample_every: 0.5, events: [{{at: 5, heat: {{of: argon, by: {}}}}}]}}\n",
        in("298.15", "K"), in("1e-25", "kg"), in("3", "zJ"));
}

}  // namespace

TEST_CASE("a scene in real units is the same run as with the numbers of reduced units") {
    const Scene scene = scene_of(real), same = scene_of(reduced());
    CHECK(scene.units == UnitSystem::real);
    CHECK(same.units == UnitSystem::reduced);
    const RunReport report = run_physics(scene), other = run_physics(same);
    CHECK(report.state == other.state);
    CHECK(report.summary.energy_final == other.summary.energy_final);
    CHECK(report.units == UnitSystem::real);
}

TEST_CASE("the command line gives numbers with units, too") {
    const Scene scene = scene_of(real, {"gas.0.temperature=400 K", "run.until=7 ps"});
    CHECK(scene.run.until == 7.0);
    const auto& temperature = std::get<Temperature>(scene.gas.species[0].velocity);
    CHECK(in_si(temperature.value, quantities::temperature) == doctest::Approx(400).epsilon(1e-15));
}

TEST_CASE("the numbers of a run in real units are given in the SI") {
    const Scene scene = scene_of(real);
    const RunReport report = run_physics(scene);
    const Json json = json_in(run_json(scene, report));
    const auto near = [](const Json& value, double expected) {
        CHECK(std::abs(value.get<double>() - expected) <= 8.0 * 0x1p-52 * std::abs(expected));
    };
    constexpr double u = 1.66053906892e-27, k = 1.380649e-23;  // CODATA 2022
    CHECK(json.at("units") == "SI");
    near(json.at("time"), 1e-11);
    near(json.at("temperature"), report.summary.temperature.value() * u * 1e6 / k);
    near(json.at("energy").at("initial"), report.summary.energy_initial.value() * u * 1e6);
    near(json.at("pressure").at("wall"), report.summary.wall_pressure.value() * u * 1e33);
    near(json.at("momentum").at("initial").at(0),
         report.summary.momentum_initial.at(0).value() * u * 1e3);
    near(json.at("species").at(0).at("mean_speed"), report.summary.species[0].speed.value() * 1e3);
    near(json.at("histograms").at("speed").at("edges").back(),
         report.summary.speeds.edges.back() * 1e3);
    CHECK(run_table(scene, report).find("\u00A0K\n") != std::string::npos);
    CHECK(!json_in(run_json(scene_of(reduced()), report)).contains("units"));
}

// The mean speeds of Maxwell's distribution at 298.15 K, sqrt(8 k T / pi m), in m/s, from CODATA's
// constants and the masses of the noble gases (IUPAC, 2021): 4.002602 u, 20.1797 u, 39.95 u.
TEST_CASE("a gas has the mean speed of textbooks at its temperature and mass") {
    for (const auto& [mass, expected] :
         {std::pair{"4.002602 u", 1255.8}, {"20.1797 u", 559.3}, {"39.95 u", 397.5}}) {
        const Scene scene = scene_of(fmt::format(
            "title: T\nunits: real\nbox: {{size: [60 nm, 60 nm, 60 nm]}}\n"
            "gas: [{{count: 40000, radius: 0.1 nm, mass: {}, temperature: {{exact: 298.15 K}}}}]\n"
            "run: {{until: 1 fs}}\n",
            mass));
        const RunReport report = run_physics(scene);
        const double speed = in_si(report.summary.species[0].speed.value(), quantities::speed);
        // The speeds scatter by sqrt(3 - 8/pi) kT/m, their mean over 40000 by 0.42 / 200 of it;
        // with the energy fixed by less. Five standard deviations, and the digits of the table.
        CAPTURE(speed);
        CHECK(std::abs(speed - expected) < 5.0 * 0.0021 * expected + 0.05);
    }
}

TEST_CASE("figures show their numbers with units in titles, tables, captions and all languages") {
    struct Shown {
        const char *kind, *column, *words;
    };
    const std::vector<Shown> kinds{{"speed-histogram", "speed from (m/s)", "m/s"},
                                   {"velocity-histogram", "velocity from (m/s)", "m/s"},
                                   {"energy-histogram", "energy from (zJ)", "zJ"},
                                   {"position-histogram", "position along x from (nm)", "nm"},
                                   {"temperature", "temperature (K)", "K"},
                                   {"pressure", "pressure (MPa)", "MPa"},
                                   {"particle-speed", "speed (m/s)", "m/s"},
                                   {"mean-free-path", "mean free path (nm)", "nm"},
                                   {"pair-correlation", "distance from (nm)", "pm"}};
    for (const char* language : {"en", "de"}) {
        std::string text = real + fmt::format("film: {{language: {}}}\nfigures:\n", language);
        for (const Shown& one : kinds)
            text += fmt::format("  - {{name: {0}, kind: {0}, at: 8 ps}}\n", one.kind);
        const Scene scene = test::scene_from(text, {}, Wanted::figures);
        const FigureRun run = test::run_of(scene);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            CAPTURE(kinds[k].kind);
            const Figure& figure = run.figures()[k];
            const std::string table = csv(table_of(figure));
            CAPTURE(table.substr(0, table.find('\n')));
            CHECK(table.find(kinds[k].column) < table.find('\n'));
            const FigureWords words = words_of(run, figure);
            CAPTURE(words.caption);
            CHECK(words.caption.find(std::string("\u00A0") + kinds[k].words) != std::string::npos);
            CHECK(words.caption.find("\u00A0ps") != std::string::npos);
            CHECK(words.caption.find("reduced") == std::string::npos);
        }
    }
}

// Gases by name in scenes, and boxes whose size follows from the pressure of the gas.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "physics/placement/draws.h"
#include "physics/theory/law.h"
#include "physics/units/gas_table.h"
#include "physics/units/unit_table.h"
#include "scene/describe.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

constexpr double pi = std::numbers::pi;

Scene scene_of(const std::string& text, const Overrides& overrides = {}) {
    return test::scene_from(text, overrides, Wanted::physics);
}

std::string real_scene(const std::string& gas, const std::string& box, const char* more = "") {
    return fmt::format("title: T\nunits: real\nbox: {{{}}}\ngas: [{}]\nrun: {{until: 1 ps}}\n{}",
                       box, gas, more);
}

double in_base(const char* number, const char* unit) {
    return in_base_units(number, *unit_named(unit)).value();
}

const char* in_cube = "size: [9 nm, 9 nm, 9 nm]";

// doctest::Approx adds 1 to the numbers that it compares.
double deviation(double value, double expected) { return std::abs(value / expected - 1.0); }

const char* errors_of(const std::string& text) {
    static std::string found;
    found.clear();
    try {
        scene_of(text);
    } catch (const SceneError& error) {
        for (const Diagnostic& one : error.diagnostics())
            found += one.message + " (" + one.hint + ")\n";
    }
    return found.c_str();
}

}  // namespace

TEST_CASE("a gas by name gives a species its mass, radius, name and colour") {
    const Scene scene =
        scene_of(real_scene("{gas: argon, count: 5, temperature: 300 K}, "
                            "{gas: carbon dioxide, count: 3, temperature: 300 K}",
                            in_cube));
    const Species& argon = scene.gas.species.at(0);
    CHECK(argon.name == "argon");
    CHECK(std::get<double>(argon.radius) == 0.181);
    CHECK(std::get<double>(std::get<ValueRule>(argon.mass)) == 39.95);
    CHECK(scene.looks.at(0).color == std::string(gas_named("argon")->color));
    const Species& dioxide = scene.gas.species.at(1);
    CHECK(dioxide.name == "carbon dioxide");
    CHECK(std::get<double>(dioxide.radius) == 0.228);
    CHECK(std::get<double>(std::get<ValueRule>(dioxide.mass)) == 44.009);
    CHECK(scene.named_gases.at(1) == gas_named("carbon dioxide"));
}

TEST_CASE("what a species gives itself replaces the value of its gas") {
    const std::string text = real_scene(
        "{gas: argon, name: heavy, mass: 50 u, color: \"#112233\", count: 2, temperature: 300 K}, "
        "{gas: neon, radius: 1 angstrom, density: 2 g/cm3, count: 2, temperature: 300 K}",
        in_cube);
    const Scene scene = scene_of(text);
    const Species &heavy = scene.gas.species.at(0), &neon = scene.gas.species.at(1);
    CHECK(heavy.name == "heavy");
    CHECK(std::get<double>(std::get<ValueRule>(heavy.mass)) == 50.0);
    CHECK(std::get<double>(heavy.radius) == 0.181);
    CHECK(scene.looks.at(0).color == "#112233");
    CHECK(std::get<double>(neon.radius) == 0.1);
    CHECK(std::holds_alternative<Density>(neon.mass));
    const Scene changed = scene_of(text, {"gas.0.gas=xenon", "gas.1.radius=0.2 nm"});
    CHECK(std::get<double>(changed.gas.species.at(0).radius) == 0.241);
    CHECK(std::get<double>(changed.gas.species.at(1).radius) == 0.2);
}

TEST_CASE("a gas by name is called so in the language of the film, and chosen by one name") {
    const Scene scene = test::scene_from(
        real_scene(
            "{gas: nitrogen, count: 9, temperature: 300 K}, "
            "{gas: helium, count: 9, temperature: 300 K}",
            in_cube,
            "film: {language: fr}\nfigures: [{name: f, kind: speed-histogram, of: nitrogen}]"),
        {}, Wanted::figures);
    CHECK(scene.gas.species.at(0).name == "azote");
    CHECK(scene.figures.at(0).panel.of.at(0).species == 0);
    CHECK(scene.description.find("Les molécules (azote) sont ici des sphères") !=
          std::string::npos);
}

TEST_CASE("descriptions say that molecules are spheres, not that atoms are") {
    const auto description = [](const char* gas) {
        return scene_of(real_scene(fmt::format("{{gas: {}, count: 9, temperature: 300 K}}", gas),
                                   in_cube))
            .description;
    };
    CHECK(description("argon").find("molecules") == std::string::npos);
    CHECK(description("methane").find("The molecules (methane) are spheres here") !=
          std::string::npos);
}

TEST_CASE("a box by its pressure has the volume of the virial series") {
    const double kt = in_base("300", "K"), bar = in_base("1", "bar");
    const Scene scene = scene_of(real_scene("{gas: xenon, count: 500, temperature: 300 K}",
                                            "shape: [4, 3, 2], pressure: 10 bar, walls: periodic"));
    const Vec size = scene.gas.box.size;
    CHECK(deviation(size[0] / size[1], 4.0 / 3.0) < 1e-15);
    CHECK(deviation(size[0] / size[2], 2.0) < 1e-15);
    const double volume = size[0] * size[1] * size[2];
    const double d = 0.482, packing = 500.0 * pi / 6.0 * d * d * d / volume;
    // Z = 1 + 4 eta + 10 eta^2 + 18.36 eta^3 (Clisby and McCoy, J. Stat. Phys. 122, 15, 2006); of
    // the energy of N particles one shares 3 degrees of freedom less, those of the centre of mass.
    const double z = 1.0 + packing * (4.0 + packing * (10.0 + packing * 18.364768));
    CAPTURE(packing);
    CHECK(packing > 0.01);
    // The next term is 28.2 eta^4; the equation of state is within 0.02 %, here far less.
    CHECK(deviation(kt * (500.0 * z - 1.0) / volume, 10.0 * bar) < 2e-6);
}

TEST_CASE("a box of a mixture has the volume of its second virial coefficient") {
    const double pressure = in_base("20", "bar");
    const Scene scene =
        scene_of(real_scene("{gas: helium, count: 300, temperature: 200 K}, "
                            "{gas: xenon, count: 100, temperature: 400 K}",
                            "shape: [1, 1, 1], pressure: 20 bar, walls: periodic"));
    const double volume = std::pow(scene.gas.box.size[0], 3), n = 400.0;
    // B = 2 pi / 3 sum of x_i x_j d_ij^3.
    double b = 0.0;
    const double x[] = {0.75, 0.25}, d[] = {0.217, 0.482};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            b += 2.0 * pi / 3.0 * x[i] * x[j] * std::pow(0.5 * (d[i] + d[j]), 3);
    // The momentum of each species is zero: in each direction it lacks the share of its mass in
    // the energy of one particle.
    const double helium = 300.0 * 4.0026, xenon = 100.0 * 131.29, all = helium + xenon;
    const double two_thirds_of_energy =
        in_base("200", "K") * (300.0 - helium / all) + in_base("400", "K") * (100.0 - xenon / all);
    const double kt = two_thirds_of_energy / (n - 1.0), nb = n / volume * b;
    CAPTURE(nb);
    CHECK(nb > 0.03);
    // The third virial term of hard spheres is at most 5/8 of nb^2.
    const double expected = (two_thirds_of_energy + n * kt * nb) / volume;
    CHECK(deviation(pressure, expected) < nb * nb);
}

TEST_CASE("a box of disks by its pressure has the area of the virial series") {
    const double kt = in_base("300", "K"), pressure = in_base("1", "mN/m");
    const Scene scene = scene_of(real_scene("{gas: argon, count: 400, temperature: 300 K}",
                                            "shape: [4, 3], pressure: 1 mN/m, walls: periodic"));
    const double area = scene.gas.box.size[0] * scene.gas.box.size[1];
    const double packing = 400.0 * pi / 4.0 * 0.362 * 0.362 / area;
    // Z = 1 + 2 eta + 3.128018 eta^2 + 4.257854 eta^3 + 5.336897 eta^4 (Clisby and McCoy 2006).
    const double z =
        1.0 + packing * (2.0 + packing * (3.128018 + packing * (4.257854 + packing * 5.336897)));
    CAPTURE(packing);
    CHECK(packing > 0.01);
    CHECK(deviation(kt * (400.0 * z - 1.0) / area, pressure) < 1e-5);
}

TEST_CASE("between walls the law of the pressure gives the pressure of the box") {
    for (const char* motion : {"temperature: {exact: 300 K}", "speed: 400 m/s"}) {
        CAPTURE(motion);
        const Scene scene =
            scene_of(real_scene(fmt::format("{{gas: argon, count: 200, {}}}", motion),
                                "shape: [4, 3, 3], pressure: 300 bar"));
        const auto [particles, start] = draw_gas(scene.gas);
        const Law found = law(BoxedGas(scene.gas.box, {}, particles, start), LawOf::pressure,
                              {.thermal = thermal_motion(scene.gas.box, particles, start)});
        REQUIRE(found);
        CHECK(deviation(found.value, in_base("300", "bar")) < 1e-9);
    }
}

// Mean free paths kT / (sqrt 2 pi d^2 p) of dilute gases, for the diameters of the table.
TEST_CASE("gases have the mean free paths of kinetic theory") {
    const double kt = in_base("298.15", "K"), bar = in_base("1", "bar");
    for (const NamedGas& gas : named_gases()) {
        CAPTURE(gas.name.english);
        const Scene scene = scene_of(
            real_scene(fmt::format("{{gas: {}, count: 2000, temperature: {{exact: 298.15 K}}}}",
                                   gas.name.english),
                       "shape: [1, 1, 1], pressure: 1 bar, walls: periodic"));
        const auto [particles, start] = draw_gas(scene.gas);
        const Law path = law(BoxedGas(scene.gas.box, {}, particles, start), LawOf::mean_free_path);
        REQUIRE(path);
        const double d = gas.diameter, packing = pi / 6.0 * d * d * d * bar / kt;
        const double expected = kt / (std::sqrt(2.0) * pi * d * d * bar);
        // Z / chi = 1 + 3/2 eta + ..., and finite numbers change it by about 1/N.
        CHECK(deviation(path.value, expected) < 2.0 * packing + 2.0 / 2000.0);
    }
}

TEST_CASE("gases and pressures that cannot be are refused") {
    using doctest::Contains;
    const char* cube = "shape: [1, 1, 1], pressure: 1 bar";
    CHECK(errors_of(real_scene("{gas: argn, count: 5, temperature: 300 K}", in_cube)) ==
          Contains("did you mean `argon`?"));
    CHECK(errors_of(real_scene("{gas: CO2, count: 5, temperature: 300 K}", in_cube)) ==
          Contains("did you mean `carbon dioxide`?"));
    CHECK(errors_of("title: T\nbox: {size: [9, 9]}\ngas: [{gas: argon, count: 5, speed: 1}]\n"
                    "run: {until: 1}\n") == Contains("a gas by name needs `units: real`"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, temperature: 300 K}, {gas: argon, count: 2, "
                               "temperature: 300 K}",
                               in_cube)) == Contains("the name `argon` is taken"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5}", cube)) == Contains("a gas at rest"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, mass: infinite, temperature: 300 K}",
                               cube)) == Contains("infinite"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, radius: {uniform: [1 angstrom, 2 "
                               "angstrom]}, temperature: 300 K}",
                               cube)) == Contains("needs a `radius` that is not drawn"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, temperature: 300 K}, {gas: neon, count: 5, "
                               "temperature: 300 K}",
                               "shape: [1, 1], pressure: 1 mN/m")) ==
          Contains("no equation of state for disks of several radii"));
    CHECK(errors_of(real_scene("{gas: argon, count: 500, temperature: 300 K}",
                               "shape: [1, 1, 1], pressure: 10 GPa")) == Contains("would freeze"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, temperature: 300 K}", "shape: [1, 1, 1]")) ==
          Contains("`shape` needs the `pressure`"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, temperature: 300 K}",
                               "size: [1 nm, 1 nm, 1 nm], pressure: 1 bar")) ==
          Contains("`pressure` needs the `shape`"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, temperature: 300 K}", "pressure: 1 bar")) ==
          Contains("needs `size`, `shape` or `length`"));
    CHECK(errors_of(real_scene("{gas: argon, count: 5, temperature: 300 K}",
                               "shape: [1, 1], pressure: 1 bar")) ==
          Contains("expected a pressure for `pressure`"));
}

TEST_CASE("a size on the command line takes the place of shape and pressure") {
    const std::string text = real_scene("{gas: argon, count: 5000, temperature: 300 K}",
                                        "shape: [1, 1, 1], pressure: 1 bar, walls: periodic");
    const Scene scene = scene_of(text, {"box.size=[90 nm, 80 nm, 70 nm]"});
    CHECK(scene.gas.box.size[1] == 80.0);
    CHECK(!scene.asked_pressure);
    // An eighth of the volume, and 1.7 % more since Z = 1 + 4 eta.
    const double ratio =
        scene_of(text, {"box.pressure=8 bar"}).gas.box.size[0] / scene_of(text).gas.box.size[0];
    CHECK(ratio > 0.5);
    CHECK(ratio < 0.5 * 1.01);
}

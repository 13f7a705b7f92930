// Gases by name, against the numbers from which their table is made and those of textbooks.
#include "physics/units/gas_table.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

using namespace carom;

namespace {

constexpr double u = 1.66053906892e-27, k = 1.380649e-23;  // CODATA 2022, in kg and J/K
constexpr double pi = std::numbers::pi;

const NamedGas& gas_of(const char* name) {
    const NamedGas* gas = gas_named(name);
    REQUIRE(gas != nullptr);
    return *gas;
}

}  // namespace

TEST_CASE("the diameter of a gas is that of hard spheres with its viscosity") {
    for (const NamedGas& gas : named_gases()) {
        CAPTURE(gas.name.english);
        // Chapman and Enskog, fourth approximation, solved for the diameter in nanometres.
        const double momentum = std::sqrt(gas.mass * u * k * temperature_of_viscosities / pi);
        const double diameter =
            1e9 * std::sqrt(1.016 * 5.0 / 16.0 * momentum / (1e-6 * gas.viscosity));
        CAPTURE(diameter);
        CHECK(std::abs(gas.diameter - diameter) <= 0.0005);  // rounded to picometres
    }
}

// Most probable, mean and root mean square speeds in m/s at 298.15 K, as tables of textbooks give
// them to one decimal: sqrt(2 k T / m), sqrt(8 k T / pi m), sqrt(3 k T / m).
TEST_CASE("the masses of gases give the speeds of textbooks") {
    struct Speeds {
        const char* gas;
        double most_probable, mean, root_mean_square;
    };
    for (const Speeds& one : {Speeds{"helium", 1113.0, 1255.8, 1363.1},
                              {"neon", 495.7, 559.3, 607.1},
                              {"argon", 352.3, 397.5, 431.5},
                              {"krypton", 243.2, 274.5, 297.9},
                              {"xenon", 194.3, 219.3, 238.0},
                              {"nitrogen", 420.7, 474.7, 515.2}}) {
        CAPTURE(one.gas);
        const double squared = k * 298.15 / (u * gas_of(one.gas).mass);
        CHECK(std::abs(std::sqrt(2.0 * squared) - one.most_probable) <= 0.05);
        CHECK(std::abs(std::sqrt(8.0 / pi * squared) - one.mean) <= 0.05);
        CHECK(std::abs(std::sqrt(3.0 * squared) - one.root_mean_square) <= 0.05);
    }
}

TEST_CASE("gases are found by their names, and only by these") {
    CHECK(gas_named("Argon") == nullptr);
    CHECK(gas_named("") == nullptr);
    std::set<std::string> names, symbols, colors;
    for (const NamedGas& gas : named_gases()) {
        CHECK(gas_named(gas.name.english) == &gas);
        names.emplace(gas.name.english);
        symbols.insert(plain_symbol(gas));
        colors.emplace(gas.color);
    }
    CHECK(names.size() == named_gases().size());
    CHECK(symbols.size() == named_gases().size());
    CHECK(colors.size() == named_gases().size());
    CHECK(plain_symbol(gas_of("sulphur hexafluoride")) == "SF6");
    CHECK(plain_symbol(gas_of("water vapour")) == "H2O");
    CHECK(plain_symbol(gas_of("methane")) == "CH4");
    CHECK(plain_symbol(gas_of("neon")) == "Ne");
}

TEST_CASE("the names of gases are translated") {
    CHECK(say(Language::german, gas_of("nitrogen").name) == "Stickstoff");
    CHECK(say(Language::french, gas_of("nitrogen").name) == "azote");
    CHECK(say(Language::spanish, gas_of("water vapour").name) == "vapor de agua");
}

// Units of measurement. Sizes are compared with the definitions of the units in the SI (BIPM, SI
// Brochure, 9th edition) and with the constants of CODATA 2022.
#include "physics/units/unit_table.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

using namespace carom;

namespace {

double base(const char* number, const char* unit) {
    const Unit* found = unit_named(unit);
    REQUIRE(found != nullptr);
    return in_base_units(number, *found).value();
}

// Equal but for the rounding of the few products and quotients that lead there.
void check_near(double value, double expected) {
    CAPTURE(value);
    CAPTURE(expected);
    CHECK(std::abs(value - expected) <= 4.0 * 0x1p-52 * std::abs(expected));
}

}  // namespace

TEST_CASE(
    "lengths, masses and times are counted in nanometres, atomic mass units and picoseconds") {
    CHECK(base("0.17", "nm") == 0.17);
    CHECK(base("1.7", "angstrom") == 0.17);
    CHECK(base("1.7", "Å") == 0.17);
    CHECK(base("170", "pm") == 0.17);
    CHECK(base("1.7e-10", "m") == 0.17);
    CHECK(base("+1.7E-4", "um") == 0.17);
    CHECK(base("1.7e-4", "µm") == 0.17);
    CHECK(base("39.948", "u") == 39.948);
    CHECK(base("60", "ps") == 60.0);
    CHECK(base("0.06", "ns") == 60.0);
    CHECK(base("60000", "fs") == 60.0);
    CHECK(base("-300", "m/s") == -0.3);
    CHECK(base("0.3", "km/s") == 0.3);
    CHECK(base("9.80665", "m/s2") == base("1", "g0"));
    CHECK(base("1", "m/s^2") == 1e-15);
    CHECK(base("0.025", "1/nm3") == base("2.5e25", "1/m³"));
}

TEST_CASE("units with measured or exact constants have the sizes of CODATA 2022") {
    // 1 u = 1.660 539 068 92e-27 kg; k = 1.380 649e-23 J/K; 1 eV = 1.602 176 634e-19 J;
    // N_A = 6.022 140 76e23/mol.
    check_near(base("1.66053906892e-27", "kg"), 1.0);
    check_near(base("1.66053906892e-24", "g"), 1.0);
    check_near(base("1.66053906892e-21", "J"), 1.0);
    check_near(base("1.66053906892", "zJ"), 1.0);
    check_near(base("1.66053906892e-12", "N"), 1.0);
    check_near(base("1.66053906892e6", "Pa"), 1.0);
    check_near(base("16.6053906892", "bar"), 1.0);
    check_near(base("1", "atm"), base("101325", "Pa"));
    check_near(base("300", "K"), base(fmt::format("{}", 300 * 1.380649e-23).c_str(), "J"));
    check_near(base("1", "eV"), base("1.602176634e-19", "J"));
    check_near(base("1", "kJ/mol"), base(fmt::format("{}", 1e3 / 6.02214076e23).c_str(), "J"));
    check_near(base("1", "mol/l"), base("6.02214076e26", "1/m3"));
    check_near(base("1", "g/cm3"), base("1000", "kg/m3"));
    // The temperature at which kT is one unit of energy, as in the design: 120.272 K.
    CHECK(1.0 / base("1", "K") == doctest::Approx(120.272).epsilon(5e-6));
}

TEST_CASE("every unit leads there and back, within the roundings of each way") {
    for (const Unit& unit : all_units())
        for (const double value : {1.0, 0.17, 298.15, 1234.5678901234567, 6.02e23, -3e-9}) {
            CAPTURE(unit.name);
            const double there = in_base_units(fmt::format("{}", value), unit).value();
            const double back = from_base_units(there, unit);
            // Each way there is one rounding of a decimal number, and one more of a product.
            const double roundings = unit.factor == 1.0 ? 2.0 : 4.0;
            CHECK(std::abs(back - value) <= roundings * 0x1p-53 * std::abs(value));
        }
}

TEST_CASE("every unit has a name of its own, a dimension and a factor of normal size") {
    for (const Unit& unit : all_units()) {
        CAPTURE(unit.name);
        CHECK(unit_named(unit.name) == &unit);
        CHECK(measures(unit, unit.quantity));
        CHECK(!unit.quantity.dimension.is_none());
        CHECK(unit.factor >= 0.1);
        CHECK(unit.factor < 10.0);
    }
    CHECK(unit_named("furlong") == nullptr);
    CHECK(unit_named("C") == nullptr);
    CHECK(!measures(*unit_named("K"), quantities::energy));
    CHECK(!measures(*unit_named("J"), quantities::temperature));
}

TEST_CASE("numbers in the SI are those of the definitions") {
    CHECK(in_si(1.0, quantities::length) == 1e-9);
    CHECK(in_si(60.0, quantities::time) == 6e-11);
    CHECK(in_si(0.4, quantities::speed) == 400.0);
    check_near(in_si(1.0, quantities::mass), 1.66053906892e-27);
    check_near(in_si(1.0, quantities::energy), 1.66053906892e-21);
    check_near(in_si(1.0, quantities::pressure(3)), 1.66053906892e6);
    check_near(in_si(base("300", "K"), quantities::temperature), 300.0);
    check_near(in_si(0.025, quantities::density(3)), 2.5e25);
    check_near(in_si(2.0, quantities::number / quantities::mass), 2.0 / 1.66053906892e-27);
    check_near(in_si(3.0, quantities::mass.root()), 3.0 * std::sqrt(1.66053906892e-27));
    CHECK(in_si(0.5, quantities::share) == 0.5);
    CHECK(in_si(2.0, quantities::length.logarithm()) == doctest::Approx(-7.0).epsilon(1e-15));
    CHECK(unit_text(quantities::temperature, UnitSystem::si) == "K");
    CHECK(unit_text(quantities::speed, UnitSystem::si) == "m/s");
    CHECK(unit_text(quantities::pressure(3), UnitSystem::si) == "Pa");
    CHECK(unit_text(quantities::count, UnitSystem::si) == "count");
}

TEST_CASE("the unit in which numbers are shown follows from the largest") {
    const auto shown = [](const Quantity& quantity, double largest) {
        const ShownUnit unit = shown_unit(quantity, UnitSystem::real, largest);
        return fmt::format("{:.6g} {}", largest * unit.factor, unit.name);
    };
    CHECK(shown(quantities::length, 12.0) == "12 nm");
    CHECK(shown(quantities::length, 0.17) == "170 pm");
    CHECK(shown(quantities::length, -2.5e3) == "-2.5 μm");
    CHECK(shown(quantities::length, 0.0) == "0 nm");
    CHECK(shown(quantities::time, 60.0) == "60 ps");
    CHECK(shown(quantities::time, 0.084) == "84 fs");
    CHECK(shown(quantities::time, 2e6) == "2 μs");
    CHECK(shown(quantities::speed, 0.3975) == "397.5 m/s");
    CHECK(shown(quantities::mass, 39.948) == "39.948 u");
    CHECK(shown(quantities::temperature, base("298.15", "K")) == "298.15 K");
    CHECK(shown(quantities::energy, base("4.1e-21", "J")) == "4.1 zJ");
    CHECK(shown(quantities::pressure(3), base("0.5", "bar")) == "50 kPa");
    CHECK(shown(quantities::pressure(3), base("1", "atm")) == "1.01325 bar");
    CHECK(shown(quantities::pressure(3), base("1", "bar")) == "1 bar");
    CHECK(shown(quantities::pressure(3), base("35", "Pa")) == "35 Pa");
    CHECK(shown(quantities::pressure(2), base("2e-3", "N/m")) == "2 mN/m");
    CHECK(shown(quantities::density(3), 0.025) == "0.025 1/nm³");
    CHECK(shown(quantities::force, base("3", "pN")) == "3 pN");
    CHECK(shown(quantities::entropy, 2.0) == "2 k");
    CHECK(shown(quantities::count, 2.0) == "2 count");
    CHECK(shown(quantities::length * quantities::speed, 3.0) == "3 nm²/ps");
    CHECK(shown(quantities::mass.root() * quantities::speed, 3.0) == "3 u^0.5 nm/ps");
    CHECK(shown_unit(quantities::length, UnitSystem::reduced, 0.17).name == "length");
    CHECK(shown_unit(quantities::length, UnitSystem::reduced, 0.17).factor == 1.0);
}

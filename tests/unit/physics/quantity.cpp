#include "physics/units/quantity.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

using namespace carom;
using quantities::content, quantities::density, quantities::pressure;

namespace {

std::string text(const Quantity& quantity) { return unit_text(quantity, UnitSystem::reduced); }
std::string name(const Quantity& quantity) {
    return unit_text(quantity, UnitSystem::reduced_names);
}

}  // namespace

TEST_CASE("products, quotients, powers and roots of quantities have their dimensions") {
    const Quantity &length = quantities::length, &mass = quantities::mass, &time = quantities::time,
                   &speed = quantities::speed;
    static_assert((quantities::length / quantities::time).dimension == quantities::speed.dimension);
    CHECK((length * mass / time).dimension == quantities::momentum.dimension);
    CHECK((mass * speed.squared()).dimension == quantities::energy.dimension);
    CHECK((mass.root() * mass.root()).dimension == mass.dimension);
    CHECK(speed.to_power(-1.0).dimension == (time / length).dimension);
    CHECK((speed / speed).dimension.is_none());
    CHECK((speed * quantities::number).dimension == speed.dimension);
    CHECK((length * time).kind == Quantity::Kind::derived);
    CHECK((length * time).word == Phrase{});
}

TEST_CASE("a word does not change what a quantity is, and a kind does") {
    const Quantity mean = quantities::speed.named(Phrase{"mean speed"});
    CHECK(mean.kind == Quantity::Kind::speed);
    CHECK(mean.dimension == quantities::speed.dimension);
    CHECK(mean.word == Phrase{"mean speed"});
    CHECK(quantities::energy.dimension == quantities::temperature.dimension);
    CHECK(quantities::energy != quantities::temperature.named(quantities::energy.word));
}

TEST_CASE("units in reduced units are powers of length, mass and time") {
    CHECK(text(quantities::length) == "length");
    CHECK(text(quantities::mass) == "mass");
    CHECK(text(quantities::time) == "time");
    CHECK(text(quantities::speed) == "length/time");
    CHECK(text(quantities::momentum) == "mass length/time");
    CHECK(text(quantities::energy) == "mass length^2/time^2");
    CHECK(text(quantities::temperature) == "mass length^2/time^2");
    CHECK(text(quantities::energy_current) == "mass length^2/time^3");
    CHECK(text(quantities::rate) == "1/time");
    CHECK(text(quantities::length.squared()) == "length^2");
    CHECK(text(quantities::length * quantities::speed) == "length^2/time");
    CHECK(text(quantities::speed.squared()) == "length^2/time^2");
    CHECK(text(quantities::mass.root() * quantities::speed) == "mass^0.5 length/time");
    CHECK(text(quantities::speed.squared().root()) == "length/time");
    CHECK(text(quantities::number / (quantities::length * quantities::time)) == "1/(length time)");
}

TEST_CASE("numbers without a dimension say what is counted") {
    CHECK(text(quantities::number) == "1");
    CHECK(text(quantities::entropy) == "1");
    CHECK(text(quantities::share) == "1");
    CHECK(text(quantities::per_cent) == "per cent");
    CHECK(text(quantities::count) == "count");
    CHECK(text(quantities::count_per_bin) == "count");
    CHECK(text(quantities::ordinal) == "number");
    CHECK(text(quantities::coefficient) == "number");
    CHECK(text(quantities::overlap) == "contact distances");
    CHECK(text(quantities::distance.logarithm()).empty());
}

TEST_CASE("pressure, density and content depend on the dimension of the box") {
    CHECK(text(pressure(1)) == "mass length/time^2");
    CHECK(text(pressure(2)) == "mass/time^2");
    CHECK(text(pressure(3)) == "mass/(length time^2)");
    CHECK(pressure(1).dimension == quantities::force.dimension);
    CHECK(text(density(1)) == "1/length");
    CHECK(text(density(2)) == "1/length^2");
    CHECK(text(density(3)) == "1/length^3");
    CHECK(text(content(1)) == "length");
    CHECK(text(content(2)) == "length^2");
    CHECK(text(content(3)) == "length^3");
    for (int d = 1; d <= 3; ++d) {
        CHECK((pressure(d) * content(d)).dimension == quantities::energy.dimension);
        CHECK((density(d) * content(d)).dimension.is_none());
    }
}

TEST_CASE("units by name are those of the numbers of runs") {
    CHECK(name(quantities::temperature) == "energy");
    CHECK(name(quantities::energy) == "energy");
    CHECK(name(quantities::speed) == "length/time");
    CHECK(name(quantities::momentum) == "momentum");
    CHECK(name(pressure(1)) == "force");
    CHECK(name(pressure(2)) == "energy/area");
    CHECK(name(pressure(3)) == "energy/volume");
    CHECK(name(quantities::rate) == "1/time");
    CHECK(name(quantities::length) == "length");
    CHECK(name(quantities::count).empty());
    CHECK(name(quantities::number).empty());
    CHECK(name(quantities::overlap) == "contact distances");
}

TEST_CASE("a unit that was written is read back as a quantity of that unit") {
    const auto is_read_back = [](const Quantity& quantity, UnitSystem units) {
        const std::string unit = unit_text(quantity, units);
        CAPTURE(unit);
        const std::optional<Quantity> back = quantity_with_unit(unit, units);
        REQUIRE(back);
        CHECK(back->dimension == quantity.dimension);
        CHECK(unit_text(*back, units) == unit);
    };
    for (const UnitSystem units :
         {UnitSystem::reduced, UnitSystem::reduced_names, UnitSystem::si}) {
        for (const Quantity& one :
             {quantities::length, quantities::mass, quantities::time, quantities::speed,
              quantities::momentum, quantities::energy, quantities::temperature, quantities::rate,
              quantities::energy_current, quantities::number, quantities::entropy,
              quantities::count, quantities::per_cent, quantities::overlap})
            is_read_back(one, units);
        for (int d = 1; d <= 3; ++d)
            for (const Quantity& one : {pressure(d), density(d), content(d)})
                is_read_back(one, units);
        CHECK(!quantity_with_unit("furlong", units));
    }
}

// The law by which small distances grow, against what was measured.
#include "physics/theory/error_growth.h"

#include <doctest/doctest.h>

#include <string>

#include "physics/placement/placement.h"
#include "physics/theory/law.h"
#include "support/csv.h"
#include "support/equal_disks.h"

using namespace carom;

TEST_CASE("the growth law lies above what was measured, and not far above") {
    int rows = 0;
    for (const auto& row : test::reference_rows("reversal_growth_rate.csv")) {
        const double packing = std::stod(row[0]), measured = std::stod(row[2]);
        CAPTURE(packing);
        const double law = bits_lost_per_collision(packing);
        CHECK(law > measured);
        CHECK(law < (packing < 0.45 ? 1.16 : 1.45) * measured);
        CHECK(law == doctest::Approx(std::stod(row[5])).epsilon(0.005));
        ++rows;
    }
    CHECK(rows == 21);
    CHECK(bits_lost_per_collision(0.0) == 0.0);
}

TEST_CASE("the law is for equal disks that move") {
    const Gas gas = test::equal_disks(0.3, 25);
    const auto [equal, start] = place(gas);
    const auto growth = [&start = start](const Box& box, const Particles& particles) {
        return law(BoxedGas(box, {}, particles, start), LawOf::error_growth);
    };
    CHECK(growth(gas.box, equal).value == doctest::Approx(bits_lost_per_collision(0.3)));
    Particles other = equal;
    other.radius[3] *= 0.9;
    CHECK(growth(gas.box, other).none->why == NoLaw::Why::unequal_radii);
    other = equal;
    other.inverse_mass[3] *= 2.0;
    CHECK(growth(gas.box, other).none->why == NoLaw::Why::unequal_masses);
    other = equal;
    other.radius.setZero();
    CHECK(growth(gas.box, other).none->why == NoLaw::Why::points);
}

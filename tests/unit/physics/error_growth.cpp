// The law by which small distances grow, against what was measured.
#include "physics/theory/error_growth.h"

#include <doctest/doctest.h>

#include <string>

#include "physics/placement/placement.h"
#include "physics/theory/law.h"
#include "support/csv.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

// Compares the law with each row of a file; `most` is the largest ratio of the law to what was
// measured at a packing fraction for a number of particles. Returns the number of rows.
template <typename Most>
int compare(int dimension, const std::string& file, const Most& most) {
    int rows = 0;
    for (const auto& row : test::reference_rows(file)) {
        const double packing = std::stod(row[0]), measured = std::stod(row[2]);
        CAPTURE(dimension);
        CAPTURE(packing);
        const double law = bits_lost_per_collision(dimension, packing);
        CHECK(law > measured);
        CHECK(law < most(packing, std::stoi(row[1])) * measured);
        CHECK(law == doctest::Approx(std::stod(row[5])).epsilon(0.005));
        ++rows;
    }
    CHECK(bits_lost_per_collision(dimension, 0.0) == 0.0);
    return rows;
}

}  // namespace

TEST_CASE("the growth law lies above what was measured, and not far above") {
    const auto of_disks = [](double packing, int) { return packing < 0.45 ? 1.16 : 1.45; };
    CHECK(compare(2, "reversal_growth_rate.csv", of_disks) == 21);
    const auto of_spheres = [](double, int count) { return count == 500 ? 1.15 : 1.4; };
    CHECK(compare(3, "reversal_growth_rate_spheres.csv", of_spheres) == 23);
}

TEST_CASE("the law is for equal particles that move") {
    const Gas gas = test::equal_disks(0.3, 25);
    const auto [equal, start] = place(gas);
    const auto growth = [&start = start](const Box& box, const Particles& particles) {
        return law(BoxedGas(box, {}, particles, start), LawOf::error_growth);
    };
    CHECK(growth(gas.box, equal).value == doctest::Approx(bits_lost_per_collision(2, 0.3)));
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

// What is checked of boxes of three lengths, and what is conserved in them.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "physics/exact_positions.h"
#include "physics/gas.h"
#include "physics/mechanics.h"
#include "physics/placement/placement.h"
#include "physics/simulation_checks.h"
#include "support/relative.h"
#include "support/space.h"

using namespace carom;
using test::relative;

namespace {

Gas checked_gas(const Vec& size, std::vector<Species> species, const Walls& walls = {}) {
    Gas gas;
    gas.box = test::space_of(size, walls);
    gas.species = std::move(species);
    return gas;
}

}  // namespace

TEST_CASE("boxes of three lengths, and their particles, pass the checks or are refused") {
    Gas gas = checked_gas({5.0, 6.0, 7.0}, {{.name = "", .count = 20}});
    auto [particles, start] = place(gas);
    CHECK_NOTHROW(check_box(gas.box));
    CHECK_NOTHROW(check_start(gas.box, particles, start));
    Sample overlapping = start;
    overlapping.position.row(1) = overlapping.position.row(0) + 0.5;
    CHECK_THROWS_AS(check_start(gas.box, particles, overlapping), std::invalid_argument);
    Sample flat = start;
    flat.velocity = flat.velocity.leftCols(2).eval();
    CHECK_THROWS_AS(check_start(gas.box, particles, flat), std::invalid_argument);
    Box box = gas.box;
    box.size[2] = 0.0;
    CHECK_THROWS_AS(check_box(box), std::invalid_argument);
    box = gas.box;
    box.surfaces.side_count = 4;
    CHECK_THROWS_AS(check_box(box), std::invalid_argument);
    box = gas.box;
    box.dimension = 4;
    CHECK_THROWS_AS(check_box(box), std::invalid_argument);
    box = {.dimension = 2, .size = {5.0, 5.0}};
    box.surfaces.side_count = 6;
    CHECK_THROWS_AS(check_box(box), std::invalid_argument);
}

TEST_CASE("momentum is conserved along each periodic axis of space that nothing blocks") {
    for (int axis = 0; axis < 3; ++axis)
        for (int other = 0; other < 3; ++other) {
            Box box =
                checked_gas({5.0, 5.0, 5.0}, {}, {Wall::periodic, Wall::periodic, Wall::periodic})
                    .box;
            CHECK(conserves_momentum(box, axis));
            box.surfaces.gravity[other] = 1.0;
            CHECK(conserves_momentum(box, axis) == (axis != other));
            box.surfaces.gravity = {};
            box.surfaces.partitions = {{.name = "", .axis = other, .at = 2.0}};
            CHECK(conserves_momentum(box, axis) == (axis != other));
            box.surfaces.partitions.clear();
            box.walls[static_cast<std::size_t>(other)] = Wall::solid;
            CHECK(conserves_momentum(box, axis) == (axis != other));
            box.surfaces.sides[static_cast<std::size_t>(2 * other + 1)] = Diffuse{};
            CHECK(!conserves_momentum(box, axis));
        }
    const auto [particles, start] = place(checked_gas(
        {9, 9, 9},
        {{.name = "", .count = 3, .mass = ValueRule{2.0}, .velocity = Velocity{{{1, 2, 3}}}}}));
    CHECK((momentum(particles, start) == Eigen::Array3d(6.0, 12.0, 18.0)).all());
    CHECK(kinetic_energies(particles, start).sum() == 3.0 * 14.0);
}

TEST_CASE("the return distance is that of the nearest image in space") {
    const Box box =
        checked_gas({10.0, 10.0, 10.0}, {}, {Wall::solid, Wall::solid, Wall::periodic}).box;
    Sample a{.position = Eigen::ArrayXXd::Constant(2, 3, 1.0)}, b = a;
    b.position.row(0) << 2.0, 3.0, 9.0;  // 1, 2 and -2 away
    const ReturnDistance distance = return_distance(box, a, b);
    CHECK(distance.largest == 3.0);
    CHECK(distance.root_mean_square == relative(std::sqrt(4.5), 1e-15));
}

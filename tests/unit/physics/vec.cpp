// Vectors and boxes in one, two and three dimensions, compared with Eigen and with numbers by hand.
#include "physics/vec.h"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "physics/box.h"
#include "physics/particles.h"
#include "util/random.h"

using namespace carom;

namespace {

Eigen::Array3d in_eigen(const Vec& a) { return {a[0], a[1], a[2]}; }
bool same(const Vec& a, const Eigen::Array3d& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

}  // namespace

TEST_CASE("vectors calculate as Eigen's do, bit for bit") {
    Random random(7, "vectors");
    const auto any = [&] {
        return Vec(random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.normal());
    };
    for (int k = 0; k < 1000; ++k) {
        const Vec a = any(), b = any();
        const Eigen::Array3d x = in_eigen(a), y = in_eigen(b);
        const double factor = random.normal();
        CHECK(same(a + b, x + y));
        CHECK(same(a - b, x - y));
        CHECK(same(-a, -x));
        CHECK(same(factor * a, factor * x));
        CHECK(same(a * factor, x * factor));
        CHECK(same(a / factor, x / factor));
        CHECK(same(lower(a, b), x.min(y)));
        CHECK(same(upper(a, b), x.max(y)));
        CHECK(same(abs(a), x.abs()));
        CHECK(dot(a, b) == (x[0] * y[0] + x[1] * y[1]) + x[2] * y[2]);
        CHECK(std::abs(dot(a, b) - x.matrix().dot(y.matrix())) < 1e-12);
        CHECK(std::abs(length(a) - x.matrix().norm()) < 1e-13);
        CHECK(longest(a, 3) == x.maxCoeff());
        CHECK(shortest(a, 3) == x.minCoeff());
        CHECK(longest(a, 1) == x[0]);
        CHECK(content_of(a, 2) == x[0] * x[1]);
        Vec sum = a;
        sum += b;
        sum *= factor;
        CHECK(same(sum, (x + y) * factor));
    }
    CHECK(is_finite(Vec(1.0, 2.0)));
    for (const int axis : {0, 1, 2}) {
        Vec a(1.0, 2.0, 3.0);
        a[axis] = std::numeric_limits<double>::infinity();
        CHECK_FALSE(is_finite(a));
    }
}

TEST_CASE("in a plane the third component is 0 and changes no bit of a sum") {
    Random random(8, "plane");
    for (int k = 0; k < 1000; ++k) {
        const Vec a(random.normal(), random.normal()), b(random.normal(), random.normal());
        CHECK(a[2] == 0.0);
        CHECK(dot(a, b) == a[0] * b[0] + a[1] * b[1]);
        CHECK(length(a) == std::sqrt(a[0] * a[0] + a[1] * a[1]));
    }
}

TEST_CASE("a row of particles is a vector, in any dimension") {
    for (const int dimension : {1, 2, 3}) {
        Eigen::ArrayXXd rows = Eigen::ArrayXXd::Zero(2, dimension);
        put({1.0, 2.0, 3.0}, rows, 1);
        CHECK(rows.row(0).isZero());
        const Vec read = vec_in(rows, 1);
        for (int axis = 0; axis < 3; ++axis)
            CHECK(read[axis] == (axis < dimension ? axis + 1.0 : 0.0));
    }
}

TEST_CASE("a box counts its sides, its size and its nearest images by its dimension") {
    Box box;
    box.size = {6.0, 5.0, 4.0};
    box.walls = {Wall::periodic, Wall::solid, Wall::periodic};
    for (const int dimension : {1, 2, 3}) {
        CAPTURE(dimension);
        box.dimension = dimension;
        CHECK(box.longest_side() == 6.0);
        CHECK(box.shortest_side() == 7.0 - dimension);
        CHECK(box.content() == (dimension == 1 ? 6.0 : dimension == 2 ? 30.0 : 120.0));
        CHECK(box.contains({{0.0, 0.0, 0.0}, {6.0, 5.0, 4.0}}));
        CHECK(box.contains({{0.0, 0.0, 0.0}, {6.0, 5.0, 4.1}}) == (dimension < 3));
        const Vec nearest = box.nearest({5.0, 4.0, 3.0});
        CHECK(nearest[0] == -1.0);
        CHECK(nearest[1] == 4.0);
        CHECK(nearest[2] == (dimension == 3 ? -1.0 : 3.0));
    }
}

TEST_CASE("partitions are numbered after four sides in a plane, after six in space") {
    for (const int sides : {4, 6}) {
        CAPTURE(sides);
        Surfaces surfaces;
        surfaces.side_count = sides;
        surfaces.sides[static_cast<std::size_t>(sides) - 1] = Bath{3.0};
        surfaces.partitions = {{.name = "wall", .axis = 1, .at = 2.0}};
        surfaces.obstacles = {{"peg", Obstacle::Ball{{1.0, 1.0}, 0.5}}};
        CHECK(surfaces.first_partition() == sides);
        CHECK(surfaces.first_obstacle() == sides + 1);
        CHECK(surfaces.count() == sides + 2);
        CHECK(surfaces.partition(sides)->name == "wall");
        CHECK(surfaces.partition(sides - 1) == nullptr);
        CHECK(surfaces.axis_of(sides) == 1);
        CHECK(surfaces.axis_of(sides - 1) == sides / 2 - 1);
        CHECK(surfaces.is_far_side(sides - 1));
        CHECK_FALSE(surfaces.is_far_side(sides - 2));
        CHECK_FALSE(surfaces.sides_reflect());
        const auto names = surfaces.names();
        REQUIRE(names.size() == static_cast<std::size_t>(sides) + 2);
        CHECK(names[static_cast<std::size_t>(sides) - 1] == (sides == 4 ? "top" : "front"));
        CHECK(names.back() == "peg");
    }
}

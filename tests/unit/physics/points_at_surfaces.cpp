// Points, of radius 0, reach walls, partitions and obstacles exactly where these are.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "physics/box.h"
#include "physics/events/event_loop.h"
#include "physics/particles.h"

using namespace carom;

namespace {

struct Points {
    Particles particles;
    Sample start;

    Points(std::vector<Vec> x, std::vector<Vec> v, int dimension) {
        const auto count = std::ssize(x);
        particles = {Eigen::ArrayXd::Zero(count), Eigen::ArrayXd::Ones(count),
                     Eigen::ArrayXi::Zero(count)};
        start = {0.0, Eigen::ArrayXXd(count, dimension), Eigen::ArrayXXd(count, dimension)};
        for (Eigen::Index i = 0; i < count; ++i) {
            put(x[static_cast<std::size_t>(i)], start.position, i);
            put(v[static_cast<std::size_t>(i)], start.velocity, i);
        }
    }
};

template <int dimension, class Scalar = double>
std::vector<Collision> collisions_until(double end, const Box& box, const Points& points,
                                        int bits = 53) {
    EventLoop<dimension, Scalar, true> loop(box, points.particles, {.bits = bits});
    loop.start(points.start);
    std::vector<Collision> all;
    loop.advance(end, &all);
    return all;
}

Box plane() { return {2, {10.0, 10.0}, {Wall::solid, Wall::solid}}; }

}  // namespace

TEST_CASE("a point on a line reaches walls that act at the time that its way takes") {
    Box box{1, {10.0, 0.0}, {Wall::solid, Wall::solid}};
    box.surfaces.sides[0] = Driven{0.0};
    box.surfaces.sides[1] = Driven{-0.25};
    const Points points({{2.0, 0.0}}, {{0.75, 0.0}}, 1);
    for (const auto& found : {collisions_until<1>(16.0, box, points),
                              collisions_until<1, Real>(16.0, box, points, 200)}) {
        REQUIRE(found.size() == 2);
        CHECK(found[0].time == 8.0);  // the wall is at 10 - 0.25 * 8
        CHECK(found[0].first_position[0] == 8.0);
        CHECK(found[0].first_after[0] == -1.25);
        CHECK(found[1].time == doctest::Approx(8.0 + 8.0 / 1.25).epsilon(4e-16));
        CHECK(found[1].first_position[0] == doctest::Approx(0.0));
    }
}

TEST_CASE("a point in a plane reaches partitions from both sides at their place") {
    Box box = plane();
    box.surfaces.partitions.push_back({.name = "middle", .axis = 0, .at = 5.0});
    const Points points({{2.0, 3.0}, {8.0, 4.0}}, {{1.0, 0.0}, {-1.5, 0.25}}, 2);
    const auto found = collisions_until<2>(60.0, box, points);
    REQUIRE(found.size() > 10);
    CHECK(found[0].time == 2.0);  // from the right
    CHECK(found[1].time == 3.0);  // from the left
    for (const Collision& one : found) {
        const double x = one.first_position[0];
        const double nearest = std::round(x / 5.0) * 5.0;
        if (one.first_before[0] != one.first_after[0]) CHECK(std::abs(x - nearest) < 1e-14);
        // none comes through
        CHECK(one.first_position[0] <= (one.first == 0 ? 5.0 : 10.0));
        CHECK(one.first_position[0] >= (one.first == 0 ? 0.0 : 5.0 - 1e-14));
    }
}

TEST_CASE("points pass a membrane once for each time they reach it") {
    Box box = plane();
    const Membrane::Speeds above_half{.faster_than = 0.5};
    box.surfaces.partitions.push_back({.name = "middle",
                                       .axis = 0,
                                       .at = 5.0,
                                       .behaviour = Membrane{{}, above_half, above_half}});
    const Points points({{2.0, 3.0}}, {{1.0, 0.5}}, 2);
    EventLoop<2, double, true> loop(box, points.particles, {});
    loop.start(points.start);
    loop.advance(100.0, nullptr);
    Sample end;
    loop.sample(100.0, end);
    CHECK(end.position(0, 0) == doctest::Approx(2.0));  // 102 along a box of 10, folded
    CHECK(end.velocity(0, 0) == 1.0);
    CHECK(loop.surfaces(100.0)[Surfaces{}.first_partition()].hits == 0);
    CHECK(loop.counts().wall == 15);  // 10 of the sides to the left and right, 5 of the others
}

TEST_CASE("a point reaches a round obstacle at its radius, and no gap opens at a corner") {
    Box box = plane();
    box.surfaces.obstacles.push_back({.name = "round", .shape = Obstacle::Ball{{7.0, 5.0}, 1.0}});
    box.surfaces.obstacles.push_back(
        {.name = "diamond",
         .shape = Obstacle::Lines{{{3.0, 4.0}, {4.0, 5.0}, {3.0, 6.0}, {2.0, 5.0}}, true}});
    const Points points({{4.5, 5.0}, {1.0, 5.0}, {3.0, 1.0}}, {{1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}},
                        2);
    const auto found = collisions_until<2>(6.0, box, points);
    REQUIRE(found.size() >= 3);
    CHECK(found[0].time == doctest::Approx(1.0).epsilon(1e-14));  // at a corner of the diamond
    CHECK(found[0].first_after[0] == doctest::Approx(-1.0));
    CHECK(found[1].time == 1.5);
    CHECK(found[1].first_after[0] == -1.0);
}

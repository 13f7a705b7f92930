// Disks and spheres that have found their places, against a look at all of them.
#include "physics/placement/placed_particles.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "util/random.h"

using namespace carom;

namespace {

struct Body {
    Vec centre;
    double radius;
};

std::optional<std::int32_t> first_overlapped(const Box& box, const std::vector<Body>& bodies,
                                             const Body& asked) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const double contact = (bodies[i].radius + asked.radius) * (1.0 - touching_tolerance);
        if (square(box.nearest(bodies[i].centre - asked.centre)) < contact * contact)
            return static_cast<std::int32_t>(i);
    }
    return {};
}

Box box_of(int dimension, const Vec& size, const Walls& walls) {
    Box box{dimension, size, walls};
    if (dimension == 3) box.surfaces.side_count = 6;
    return box;
}

template <int dimension>
void check_overlaps(double size, double across, Random& random) {
    const Box box = box_of(dimension, {size, 0.75 * size, dimension == 3 ? 0.8 * size : 0.0},
                           {Wall::periodic, Wall::solid, Wall::periodic});
    Eigen::ArrayXd radii(300);
    for (double& radius : radii) radius = random.uniform() < 0.02 ? 2.0 : 0.05;
    PlacedParticles<dimension> placed(box, radii);
    std::vector<Body> bodies;
    int overlapped = 0;
    for (const double radius : radii) {
        Body body{{across * (random.uniform() - 0.5), 0.7 * across * random.uniform()}, radius};
        if (dimension == 3) body.centre[2] = 0.2 * across * (random.uniform() - 0.5);
        for (const int axis : {0, 2})  // on both sides of the border
            if (body.centre[axis] < 0.0) body.centre[axis] += box.size[axis];
        const auto expected = first_overlapped(box, bodies, body);
        CHECK(placed.overlapped(body.centre, radius) == expected);
        CHECK(placed.is_free(body.centre, radius) == !expected);
        overlapped += expected.has_value();
        placed.add(static_cast<std::int32_t>(bodies.size()), body.centre, radius);
        bodies.push_back(body);
    }
    if (across == 10.0) CHECK(overlapped > 20);
}

template <int dimension>
void check_much_larger(Wall wall) {
    const Box box = box_of(dimension, {10.0, 10.0, 10.0}, {wall, Wall::periodic, wall});
    PlacedParticles<dimension> placed(box, Eigen::ArrayXd::Constant(20, 0.1));
    placed.add(7, {5.0, 5.0, dimension == 3 ? 5.0 : 0.0}, 0.1);
    for (const double radius : {8.0, 1e10, 1e200}) {  // beyond the integers too
        CAPTURE(radius);
        CHECK(placed.overlapped({1.0, 1.0, dimension == 3 ? 1.0 : 0.0}, radius) == 7);
    }
}

// In a row, or side by side `in_row` at a time and, in space, as many of these rows on each other.
template <int dimension>
void check_in_a_corner(std::int32_t in_row) {
    constexpr std::int32_t count = 20'000;
    const Box box = box_of(dimension, {1e6, 1e6, 1e6}, {});
    PlacedParticles<dimension> placed(box, Eigen::ArrayXd::Constant(count, 0.4));
    for (std::int32_t i = 0; i < count; ++i) {
        const std::int32_t row = i / in_row;
        const Vec place(1.0 + i % in_row, dimension == 2 ? 1.0 + row : 1.0 + row % in_row,
                        dimension == 2 ? 0.0 : 1.0 + row / in_row);
        CHECK_FALSE(placed.overlapped(place, 0.4));
        placed.add(i, place, 0.4);
    }
    // A cell has the room of ten disks a unit apart, squared, or of a few spheres; and shares its
    // list with others.
    CHECK(placed.compared() < 100 * count);
}

}  // namespace

TEST_CASE(
    "overlaps are found in boxes of any size, where others are close together and far apart") {
    Random random(5, "places");
    for (const double size : {12.0, 400.0, 1e6, 1e12})
        for (const double across : {10.0, size}) {
            CAPTURE(size);
            CAPTURE(across);
            check_overlaps<2>(size, across, random);
            check_overlaps<3>(size, across, random);
        }
}

TEST_CASE("a particle much larger than a periodic box overlaps all others") {
    for (const Wall wall : {Wall::periodic, Wall::solid}) {
        check_much_larger<2>(wall);
        check_much_larger<3>(wall);
    }
}

TEST_CASE("particles in one corner of a huge box are compared with those beside them only") {
    for (const std::int32_t in_row : {20'000, 140}) check_in_a_corner<2>(in_row);
    for (const std::int32_t in_row : {20'000, 140, 27}) check_in_a_corner<3>(in_row);
}

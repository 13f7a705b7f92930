// The faces, edges and corners of surfaces in space: their distances from random points, and the
// times at which spheres reach them, against distances from the bodies that they bound.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "physics/box.h"
#include "physics/multiprecision/multiprecision.h"
#include "physics/surfaces/barrier.h"
#include "physics/surfaces/barrier_contact.h"
#include "physics/surfaces/sheet.h"
#include "support/relative.h"
#include "support/space.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

Box box_with(const std::array<Wall, 3>& walls) { return test::space_of({8.0, 7.0, 6.0}, walls); }

// The distance of a number from an interval.
double outside(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }

// A sheet of unit squares, each of which is solid or not.
struct Squares {
    std::array<int, 2> count;
    std::array<bool, 2> is_periodic;
    std::vector<bool> open = std::vector<bool>(static_cast<std::size_t>(count[0] * count[1]));

    auto at(int i, int j) { return open[static_cast<std::size_t>(j * count[0] + i)]; }

    // The distance within the sheet to the nearest solid square or one of its images. Beyond a wall
    // the outermost squares go on.
    double distance(double x, double y) {
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < count[0]; ++i)
            for (int j = 0; j < count[1]; ++j) {
                if (at(i, j)) continue;
                const auto along = [&](double place, int k, std::size_t axis) {
                    const int last = count[axis] - 1;
                    const double length = count[axis];
                    double least_along = std::numeric_limits<double>::infinity();
                    if (!is_periodic[axis])
                        return outside(place, k == 0 ? -1e9 : k, k == last ? 1e9 : k + 1);
                    for (const double shift : {-length, 0.0, length})
                        least_along =
                            std::min(least_along, outside(place, k + shift, k + 1 + shift));
                    return least_along;
                };
                least = std::min(least, std::hypot(along(x, i, 0), along(y, j, 1)));
            }
        return least;
    }
};

// Rectangles with whole corners that do not overlap; some touch each other or the sides.
std::vector<Gap> random_gaps(Squares& squares, Random& random) {
    std::vector<Gap> gaps;
    for (int tries = 0; tries < 6; ++tries) {
        std::array<int, 2> low{}, high{};
        for (std::size_t a = 0; a < 2; ++a) {
            const auto count = static_cast<std::uint64_t>(squares.count[a]);
            low[a] = static_cast<int>(random.below(count));
            high[a] = low[a] + 1 + static_cast<int>(random.below(3));
            high[a] = std::min(high[a], squares.count[a]);
        }
        bool is_free = true;
        for (int i = low[0]; i < high[0]; ++i)
            for (int j = low[1]; j < high[1]; ++j) is_free = is_free && !squares.at(i, j);
        if (!is_free) continue;
        for (int i = low[0]; i < high[0]; ++i)
            for (int j = low[1]; j < high[1]; ++j) squares.at(i, j) = true;
        gaps.emplace_back(std::array<double, 2>{double(low[0]), double(low[1])},
                          std::array<double, 2>{double(high[0]), double(high[1])});
    }
    return gaps;
}

double distance_of_cuboid(const Obstacle::Cuboid& cuboid, const Box& box, const Vec& x) {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        double least = std::numeric_limits<double>::infinity();
        for (const double shift : {-1.0, 0.0, 1.0}) {
            if (shift != 0.0 && !box.is_periodic(axis)) continue;
            const double by = shift * box.length(axis);
            least =
                std::min(least, outside(x[axis], cuboid.low[axis] + by, cuboid.high[axis] + by));
        }
        square += least * least;
    }
    return std::sqrt(square);
}

double least_distance(const std::vector<Barrier<3>>& barriers, const Vec& x,
                      std::int32_t from_surface) {
    double least = std::numeric_limits<double>::infinity();
    for (const Barrier<3>& barrier : barriers)
        if (barrier.surface >= from_surface) least = std::min(least, distance_from(barrier, x));
    return least;
}

Vec random_place(const Box& box, Random& random) {
    Vec x;
    for (int axis = 0; axis < 3; ++axis) x[axis] = random.uniform(0.0, box.length(axis));
    return x;
}

Wall random_wall(Random& random) { return random.below(2) == 0 ? Wall::solid : Wall::periodic; }

}  // namespace

TEST_CASE("faces, edges and corners are as far away as the partition that they make up") {
    Random random(1, "partitions");
    int nearest_edges = 0, nearest_corners = 0;
    for (int k = 0; k < 300; ++k) {
        const Box plain = box_with({random_wall(random), random_wall(random), random_wall(random)});
        const auto axis = static_cast<std::size_t>(random.below(3));
        const auto along = other_axes(axis);
        Squares squares{
            {static_cast<int>(plain.length(along[0])), static_cast<int>(plain.length(along[1]))},
            {plain.is_periodic(along[0]), plain.is_periodic(along[1])}};
        Partition partition{.name = "sheet", .axis = static_cast<int>(axis), .at = 2.5};
        partition.gaps = random_gaps(squares, random);
        Box box = plain;
        box.surfaces.partitions.push_back(partition);
        const auto barriers = barriers_of<3>(box, 10.0);
        const bool is_all_open = std::ranges::all_of(squares.open, [](bool open) { return open; });
        for (int n = 0; n < 200; ++n) {
            const Vec x = random_place(box, random);
            double apart = std::abs(x[axis] - 2.5);
            if (box.is_periodic(axis)) apart = std::min(apart, box.length(axis) - apart);
            const double expected =
                is_all_open ? std::numeric_limits<double>::infinity()
                            : std::hypot(apart, squares.distance(x[along[0]], x[along[1]]));
            const double found = least_distance(barriers, x, box.surfaces.first_partition());
            if (is_all_open)
                CHECK(found == expected);
            else
                CHECK(found == doctest::Approx(expected).epsilon(1e-14));
            for (const Barrier<3>& barrier : barriers) {
                if (distance_from(barrier, x) > found) continue;
                nearest_edges += barrier.kind == Barrier<3>::Kind::edge;
                nearest_corners += barrier.kind == Barrier<3>::Kind::round;
            }
        }
    }
    CHECK(nearest_edges > 1000);
    CHECK(nearest_corners > 100);
}

// By counting: rectangles do not overlap, and each side of a solid square at an open one belongs to
// one rim.
TEST_CASE("a sheet is covered once, and each rim is there once") {
    Random random(2, "sheets");
    for (int k = 0; k < 500; ++k) {
        Squares squares{{8, 6}, {random.below(2) == 0, random.below(2) == 0}};
        const auto gaps = random_gaps(squares, random);
        const Sheet sheet(
            {Sheet::Axis{8.0, squares.is_periodic[0]}, Sheet::Axis{6.0, squares.is_periodic[1]}},
            gaps);
        // How many intervals, or their images, lie over the square number `at`.
        const auto covers = [](double low, double high, int at, int count, bool is_periodic) {
            int times = 0;
            for (const int turn : {-1, 0, 1}) {
                if (turn != 0 && (!is_periodic || std::isinf(low))) continue;
                const double middle = at + 0.5 + turn * count;
                times += low < middle && middle < high ? 1 : 0;
            }
            return times;
        };
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 6; ++j) {
                int times = 0;
                for (const auto& piece : sheet.pieces)
                    times += covers(piece.low[0], piece.high[0], i, 8, squares.is_periodic[0]) *
                             covers(piece.low[1], piece.high[1], j, 6, squares.is_periodic[1]);
                CHECK(times == (squares.at(i, j) ? 0 : 1));
            }
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 6; ++j)
                for (const std::size_t across : {0U, 1U}) {  // the side below, or to the left
                    const int k_across = across == 0 ? i : j;
                    const int last = (across == 0 ? 8 : 6) - 1;
                    if (k_across == 0 && !squares.is_periodic[across]) continue;
                    const int before = k_across == 0 ? last : k_across - 1;
                    const bool is_rim = squares.at(i, j) != (across == 0 ? squares.at(before, j)
                                                                         : squares.at(i, before));
                    int times = 0;
                    for (const auto& rim : sheet.rims)
                        if (rim.axis != across && rim.at == k_across)
                            times += across == 0
                                         ? covers(rim.low, rim.high, j, 6, squares.is_periodic[1])
                                         : covers(rim.low, rim.high, i, 8, squares.is_periodic[0]);
                    CHECK(times == (is_rim ? 1 : 0));
                }
    }
}

TEST_CASE("gaps that touch are one opening, and one that spans a periodic side has no rim there") {
    const Sheet sheet(
        {Sheet::Axis{8.0, true}, Sheet::Axis{6.0, false}},
        {{{0.0, 1.0}, {2.0, 3.0}}, {{6.0, 1.0}, {8.0, 3.0}}, {{6.0, 3.0}, {8.0, 6.0}}});
    // From x = 6 to 10 and y = 1 to 3, and from x = 6 to 8 and y = 3 to beyond the wall.
    CHECK(sheet.corners.size() == 4);
    double length = 0.0;
    for (const auto& rim : sheet.rims)
        length += std::min(rim.high, 6.0 + 100.0 * (rim.axis == 0)) - rim.low;
    CHECK(length == 4.0 + 2.0 + 2.0 + 3.0 + 5.0);
}

TEST_CASE("a cuboid is as far away as its barriers, also across periodic sides") {
    Random random(3, "cuboids");
    for (int k = 0; k < 300; ++k) {
        Box box = box_with({random_wall(random), random_wall(random), random_wall(random)});
        Obstacle::Cuboid cuboid;
        for (int axis = 0; axis < 3; ++axis) {
            const double length = box.length(axis);
            cuboid.low[axis] = random.uniform(-0.5 * length, length);
            const bool is_whole = box.is_periodic(axis) && random.below(4) == 0;
            cuboid.high[axis] =
                cuboid.low[axis] + (is_whole ? length : random.uniform(0.1, 0.9) * length);
        }
        box.surfaces.obstacles = {{"block", cuboid}};
        const auto barriers = barriers_of<3>(box, 10.0);
        for (int n = 0; n < 200; ++n) {
            const Vec x = random_place(box, random);
            const double expected = distance_of_cuboid(cuboid, box, x);
            const auto number = box.surfaces.first_obstacle();
            if (expected > 0.0)
                CHECK(least_distance(barriers, x, number) ==
                      doctest::Approx(expected).epsilon(1e-13));
            const double wall = least_distance(barriers, x, 0);
            const bool is_in_the_way = surface_in_the_way(box, barriers, x, 0.3).has_value();
            CHECK(is_in_the_way == (expected == 0.0 || wall < 0.3));
        }
    }
}

TEST_CASE("a cuboid that goes around a periodic box has neither ends nor corners") {
    for (const double length : {5.0, 6.0}) {
        Box box = box_with({Wall::solid, Wall::solid, Wall::periodic});
        box.surfaces.obstacles = {
            {"pole", Obstacle::Cuboid{{1.0, 1.0, 0.5}, {2.0, 2.0, 0.5 + length}}}};
        std::array<int, 3> counts{};
        for (const Barrier<3>& barrier : barriers_of<3>(box, -1.0))
            if (barrier.surface == box.surfaces.first_obstacle())
                ++counts[static_cast<std::size_t>(barrier.kind)];
        CHECK(counts == (length < 6.0 ? std::array{6, 12, 8} : std::array{4, 4, 0}));
    }
}

namespace {

// How the centre of a sphere moves.
struct Flight {
    Vec x, v, a;
    Vec at(double t) const { return x + t * v + 0.5 * t * t * a; }
};

template <typename Scalar>
Scalar first_time(const std::vector<Barrier<3>>& barriers, const Flight& flight, double radius,
                  std::int32_t from_surface, int bits) {
    Scalar first = never<double>;
    for (const Barrier<3>& barrier : barriers) {
        if (barrier.surface < from_surface) continue;
        BarrierMotion<Scalar, 3> m{.x = {}, .v = {}, .a = {}, .radius = radius};
        for (std::size_t k = 0; k < 3; ++k) {
            m.x[k] = as_precise_as(first, flight.x[k]) - barrier.place[k];
            m.v[k] = as_precise_as(first, flight.v[k]);
            m.a[k] = as_precise_as(first, flight.a[k]);
        }
        const Scalar time = time_to_barrier(barrier, m, 0.0, bits);
        if (time < first) first = time;
    }
    return first;
}

}  // namespace

// The truth is found in steps that are too short to reach the surface: the distance from it divided
// by a bound on the speed. No contact deeper than `shallow` is missed.
TEST_CASE("spheres that fly and fall reach cuboids and rims at the first time they touch them") {
    constexpr double shallow = 1e-7, end = 6.0;
    Random random(4, "flights");
    int contacts = 0, misses = 0, falls = 0;
    for (int k = 0; k < 3000; ++k) {
        Box box = box_with({Wall::solid, Wall::solid, Wall::solid});
        Squares squares{{7, 6}, {false, false}};
        const bool is_partition = k % 2 == 0;
        Obstacle::Cuboid cuboid{{2.0, 2.0, 2.0}, {5.0, 4.5, 3.0}};
        if (is_partition)
            box.surfaces.partitions = {
                {.name = "window", .axis = 0, .at = 4.0, .gaps = random_gaps(squares, random)}};
        else
            box.surfaces.obstacles = {{"block", cuboid}};
        const double radius = random.uniform(0.1, 1.2);
        const auto distance = [&](const Vec& x) {
            return is_partition ? std::hypot(x[0] - 4.0, squares.distance(x[1], x[2]))
                                : distance_of_cuboid(cuboid, box, x);
        };
        Flight flight{random_place(box, random), {}, {}};
        if (!(distance(flight.x) > radius + 1e-3)) continue;
        for (int axis = 0; axis < 3; ++axis) flight.v[axis] = random.uniform(-1.5, 1.5);
        const auto kind = random.below(4);
        if (kind == 0) flight.a = {0.0, -1.0, 0.0};
        if (kind == 1)
            for (int axis = 0; axis < 3; ++axis) flight.a[axis] = random.uniform(-1.0, 1.0);
        if (kind == 2) flight.v[static_cast<int>(random.below(3))] = 0.0;
        const auto barriers = barriers_of<3>(box, 0.0);
        const double time =
            first_time<double>(barriers, flight, radius, box.surfaces.first_partition(), 53);
        const double until = std::min(time, end);
        bool is_early = false;
        for (double t = 0.0; t < until - 1e-6;) {
            const double room = distance(flight.at(t)) - radius;
            if (room < -shallow) is_early = true;
            if (is_early) break;
            const double fastest = length(flight.v) + length(flight.a) * end;
            t += std::max(room, 0.5 * shallow) / fastest;
        }
        CHECK_FALSE(is_early);
        if (time < end) {
            ++contacts;
            falls += square(flight.a) > 0.0;
            CHECK(std::abs(distance(flight.at(time)) - radius) <
                  1e-13 * (10.0 + length(flight.at(time))));
            // 160 bits give the same time, to what a rounded position can shift it.
            if (k % 8 > 1) continue;
            const auto precise = static_cast<double>(
                first_time<Real>(barriers, flight, radius, box.surfaces.first_partition(), 160));
            const double slow =
                std::abs(distance(flight.at(time + 1e-6)) - distance(flight.at(time))) / 1e-6;
            if (slow > 1e-2) CHECK(time == relative(precise, 1e-12));
        } else {
            ++misses;
        }
    }
    CHECK(contacts > 500);
    CHECK(falls > 200);
    CHECK(misses > 100);
}

// Beside the end of a shelf edge the sphere is too near to the line of the edge while it falls past
// its end; it touches the edge itself only on its way down, after the turning point.
TEST_CASE("a sphere that passes the line of an edge beyond its end may fall back to the edge") {
    Barrier<3> edge{.kind = Barrier<3>::Kind::edge, .axis = 2};
    edge.from[0] = 0.0;
    edge.to[0] = 10.0;
    // Thrown up from below, 1 beside the line in z < 0; at z > 0 it comes down again.
    BarrierMotion<double, 3> m{
        .x = {0.0, -2.0, -1.0}, .v = {0.0, 4.0, 0.5}, .a = {0.0, -2.0, 0.0}, .radius = 0.5};
    // -2 + 4 t - t^2 = -0.5 at t = 2 - sqrt(2.5), where z < 0; = 0.5 on the way down at 2 +
    // sqrt(1.5).
    CHECK(edge_time(edge, m, 0.0, 53) == relative(2.0 + std::sqrt(1.5), 1e-15));
    m.v[2] = 4.0;  // now z > 0 at the first time: -1 + 4 t = 0.68
    CHECK(edge_time(edge, m, 0.0, 53) == relative(2.0 - std::sqrt(2.5), 1e-14));
    m.v[2] = 0.1;  // z < 0 both times
    CHECK(edge_time(edge, m, 0.0, 53) == never<double>);
    m.a[1] = 0.0;
    m.v[2] = 4.0;  // straight: at t = 1.5 / 4
    CHECK(edge_time(edge, m, 0.0, 53) == relative(0.375, 1e-15));
}

#include "draw/raster/simplified_path.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "util/random.h"

using namespace carom;

namespace {

using Path = std::vector<Point>;

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double distance(const Point& at, const Point& from, const Point& to) {
    const double dx = to.x - from.x, dy = to.y - from.y, squared = dx * dx + dy * dy;
    if (squared == 0.0) return distance(at, from);
    const double share =
        std::clamp(((at.x - from.x) * dx + (at.y - from.y) * dy) / squared, 0.0, 1.0);
    return distance(at, {from.x + share * dx, from.y + share * dy});
}

bool is_same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

// Where each point of the simple path is in the other, in order.
std::vector<std::size_t> places(const Path& path, const Path& simple) {
    std::vector<std::size_t> all;
    std::size_t k = 0;
    for (const Point& point : simple) {
        while (k < path.size() && !is_same(path[k], point)) ++k;
        REQUIRE(k < path.size());
        all.push_back(k++);
    }
    return all;
}

// The farthest that a point lies from the line that is drawn in its place.
double farthest(const Path& path, const Path& simple) {
    const std::vector<std::size_t> at = places(path, simple);
    double most = 0.0;
    for (std::size_t j = 0; j + 1 < at.size(); ++j)
        for (std::size_t k = at[j]; k <= at[j + 1]; ++k)
            most = std::max(most, distance(path[k], path[at[j]], path[at[j + 1]]));
    return most;
}

Path random_path(Random& random, double step, double turn) {
    Path path;
    double angle = random.uniform(0, 7), x = 0, y = 0;
    for (int i = 0; i < 300; ++i) {
        path.push_back({x, y});
        angle += turn * random.normal();
        const double along = step * random.uniform(0, 2);
        x += along * std::cos(angle);
        y += along * std::sin(angle);
    }
    return path;
}

}  // namespace

TEST_CASE("a simplified path passes all points within the tolerance") {
    Random random(5, "paths");
    std::size_t points = 0, corners = 0;
    for (int round = 0; round < 300; ++round) {
        const double tolerance = std::pow(10.0, random.uniform(-3, 1));
        const Path path = random_path(random, std::pow(10.0, random.uniform(-2, 1)),
                                      std::pow(10.0, random.uniform(-3, 1)));
        const Path simple = simplified(path, tolerance);
        CHECK(is_same(simple.front(), path.front()));
        CHECK(is_same(simple.back(), path.back()));
        REQUIRE(farthest(path, simple) <= tolerance * (1 + 1e-9));
        points += path.size();
        corners += simple.size();
    }
    CHECK(corners < points / 2);
}

TEST_CASE("the corners of a path stay as it grows") {
    Random random(6, "paths");
    const Path path = random_path(random, 0.3, 0.2);
    Path before;
    for (std::size_t count = 1; count <= path.size(); ++count) {
        const Path now = simplified({path.data(), count}, 0.1);
        REQUIRE(now.size() >= before.size());
        for (std::size_t k = 0; k + 1 < before.size(); ++k) REQUIRE(is_same(now[k], before[k]));
        before = now;
    }
}

TEST_CASE("straight lines, circles, spikes and points are left with what shows") {
    Path line, circle;
    for (int i = 0; i <= 1000; ++i) {
        line.push_back({0.5 * i, 30.0 + 0.02 * (i % 2)});
        circle.push_back({100 * std::cos(0.006 * i), 100 * std::sin(0.006 * i)});
    }
    CHECK(simplified(line, 0.1).size() == 2);
    // A chord of length l is l^2 / (8 r) from the circle: at least 6 / sqrt(8 * 0.1 / 100) of them,
    // and at most twice as many as the cone is narrower than the chord allows.
    const std::size_t chords = simplified(circle, 0.1).size();
    CHECK(chords >= 67);
    CHECK(chords <= 134);

    const Path spike = {{0, 0}, {5, 0}, {9, 0}, {3, 0}, {20, 0}};
    const Path left = simplified(spike, 0.1);
    REQUIRE(left.size() == 4);
    CHECK(left[1].x == 9);
    CHECK(left[2].x == 3);

    CHECK(simplified({}, 0.1).empty());
    CHECK(simplified(Path{{1, 2}}, 0.1).size() == 1);
    CHECK(simplified(Path(9, {1, 2}), 0.1).size() == 2);  // a dot, as it was
}

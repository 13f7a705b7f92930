// Arrows: where their corners are, how short ones shrink, and how cut ones look.
#include "draw/arrow.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace carom;

namespace {

const ArrowStyle style{.shaft = 4.0,
                       .head_length = 12.0,
                       .head_width = 10.0,
                       .edge = 1.0,
                       .color = rgb(0xFF0000),
                       .edge_color = rgb(0x0000FF)};

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

int count(const Canvas& canvas, std::uint32_t color, const Rect& in) {
    const PixelView view = canvas.pixels();
    int found = 0;
    for (int y = static_cast<int>(in.y); y < static_cast<int>(in.bottom()); ++y)
        for (int x = static_cast<int>(in.x); x < static_cast<int>(in.right()); ++x)
            found += (view.data[y * view.stride + x] & 0xFFFFFF) == color;
    return found;
}

}  // namespace

TEST_CASE("an arrow points in any direction and ends exactly at its tip") {
    for (int k = 0; k < 12; ++k) {
        const double angle = 0.1 + 0.5 * k;
        const Point from{30.0, 40.0};
        const Point to{from.x + 50.0 * std::cos(angle), from.y + 50.0 * std::sin(angle)};
        const auto corners = arrow_outline(from, to, style);
        CHECK(distance(corners[3], to) < 1e-12);
        // The two ends of the shaft lie on either side of the start, the wings of the neck.
        CHECK(distance(corners[0], from) == doctest::Approx(2.0));
        CHECK(distance(corners[6], from) == doctest::Approx(2.0));
        CHECK(distance(corners[0], corners[6]) == doctest::Approx(4.0));
        CHECK(distance(corners[2], corners[4]) == doctest::Approx(10.0));
        const Point neck{0.5 * (corners[2].x + corners[4].x), 0.5 * (corners[2].y + corners[4].y)};
        CHECK(distance(neck, to) == doctest::Approx(12.0));
        CHECK(distance(neck, from) == doctest::Approx(38.0));
    }
}

TEST_CASE("a short arrow has a smaller head, and none is longer than it says") {
    const auto corners = arrow_outline({0, 0}, {10, 0}, style);
    CHECK(corners[3].x == 10.0);
    CHECK(corners[2].x == doctest::Approx(4.0));  // six tenths are head
    CHECK(corners[4].y - corners[2].y == doctest::Approx(5.0));
    for (const Point& corner : corners) CHECK(corner.x >= 0.0);
}

TEST_CASE("an arrow is drawn with its edge, and not at all where it would be a dot") {
    Canvas canvas({100, 60});
    draw_arrow(canvas, {10, 30}, {80, 30}, style);
    const int area = count(canvas, 0xFF0000, {0, 0, 100, 60});
    CHECK(area == doctest::Approx(4.0 * 58.0 + 0.5 * 12.0 * 10.0).epsilon(0.1));
    CHECK(count(canvas, 0x0000FF, {0, 0, 100, 60}) > 50);
    CHECK(count(canvas, 0xFF0000, {81, 0, 19, 60}) == 0);
    Canvas empty({100, 60});
    draw_arrow(empty, {10, 30}, {12, 30}, style);
    draw_arrow(empty, {10, 30}, {10, 30}, style);
    CHECK(count(empty, 0x000000, {0, 0, 100, 60}) == 6000);
}

TEST_CASE("an arrow ends at the bounds, in its own direction, and is marked as cut") {
    const Rect bounds{0, 0, 80, 60};
    Canvas whole({140, 60}), cut({140, 60});
    draw_arrow_within(whole, bounds, {20, 30}, {80, 30}, style);
    draw_arrow_within(cut, bounds, {20, 30}, {120, 30}, style);
    CHECK(count(cut, 0xFF0000, {81, 0, 59, 60}) == 0);
    CHECK(count(cut, 0xFF0000, {73, 28, 6, 4}) > 0);  // the tip is there
    CHECK(count(cut, 0xFF0000, {0, 0, 140, 60}) < count(whole, 0xFF0000, {0, 0, 140, 60}) - 10);
    Canvas slanted({140, 60});
    draw_arrow_within(slanted, bounds, {20, 50}, {140, 20}, style);  // a rise of 1 in 4: at 80, 35
    CHECK(count(slanted, 0xFF0000, {70, 34, 9, 6}) > 0);
    CHECK(count(slanted, 0xFF0000, {81, 0, 59, 60}) == 0);
}

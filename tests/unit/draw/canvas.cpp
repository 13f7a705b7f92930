#include "draw/canvas.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "draw/disks/disks.h"
#include "draw/text.h"
#include "support/pixels.h"
#include "util/diagnostics.h"
#include "util/random.h"

using namespace carom;
using test::pixels_of;

namespace {

std::uint32_t at(const Canvas& canvas, int x, int y) {
    const PixelView pixels = canvas.pixels();
    return pixels.data[y * pixels.stride + x];
}

// The sum of coverages of a white shape on black, in pixels.
double area_of(const Canvas& canvas) {
    double sum = 0;
    for (int y = 0; y < canvas.size().height; ++y)
        for (int x = 0; x < canvas.size().width; ++x) sum += at(canvas, x, y) & 0xFF;
    return sum / 255.0;
}

constexpr Color white = rgb(0xFFFFFF);

}  // namespace

TEST_CASE("a canvas starts black and takes the colours it is given") {
    Canvas canvas({40, 30});
    CHECK((at(canvas, 39, 29) & 0xFFFFFF) == 0);
    canvas.fill_all(rgb(0x102030));
    canvas.fill({10, 5, 4, 3}, rgb(0xFF8001));
    CHECK(at(canvas, 0, 0) == 0xFF102030U);
    CHECK(at(canvas, 10, 5) == 0xFFFF8001U);
    CHECK(at(canvas, 13, 7) == 0xFFFF8001U);
    CHECK(at(canvas, 14, 7) == 0xFF102030U);
    canvas.fill({0, 0, 40, 30}, with_alpha(white, 0.5));
    CHECK((at(canvas, 0, 0) & 0xFF) == doctest::Approx(0x30 + (255 - 0x30) / 2.0).epsilon(0.01));
}

TEST_CASE("shapes have the area that geometry gives them") {
    // Cairo's GRAY antialiasing has 15 x 17 samples a pixel or better: 1 % holds for these sizes.
    const auto drawn = [](auto&& draw) {
        Canvas canvas({100, 100});
        draw(canvas);
        return area_of(canvas);
    };
    const double pi = std::numbers::pi;
    CHECK(drawn([](Canvas& c) {
              c.fill_circle({50.3, 49.6}, 20.5, white);
          }) == doctest::Approx(pi * 20.5 * 20.5).epsilon(0.01));
    CHECK(drawn([](Canvas& c) {
              c.stroke_circle({50, 50}, 30, 4, white);
          }) == doctest::Approx(2 * pi * 30 * 4).epsilon(0.01));
    CHECK(drawn([](Canvas& c) {
              c.stroke_rect({20, 20, 60, 40}, 2, white);
          }) == doctest::Approx(62 * 42 - 58 * 38));
    CHECK(drawn([](Canvas& c) {
              c.stroke_line({20, 30}, {80, 30}, 2, white);
          }) == doctest::Approx(120));
    const std::array<Point, 3> corner = {{{20, 80}, {20, 20}, {80, 20}}};
    CHECK(drawn([&](Canvas& c) { c.fill_polygon(corner, white); }) ==
          doctest::Approx(1800).epsilon(0.01));
    // Two strokes that share a square, a round join and two round caps.
    CHECK(drawn([&](Canvas& c) { c.stroke_path(corner, 6, white); }) ==
          doctest::Approx(2 * 60 * 6 - 9 + 0.75 * 0 + pi * 9 * 1.25).epsilon(0.01));
    CHECK(drawn([](Canvas& c) {
              c.stroke_line({0, 10}, {100, 10}, 2, white, 10);
          }) == doctest::Approx(100).epsilon(0.01));
}

TEST_CASE("a dash is forgotten by the next line") {
    Canvas canvas({100, 20});
    canvas.stroke_line({0, 5}, {100, 5}, 2, white, 10);
    canvas.fill_all(rgb(0));
    canvas.stroke_line({0, 5}, {100, 5}, 2, white);
    CHECK(area_of(canvas) == doctest::Approx(200));
}

TEST_CASE("a clip holds until it is released") {
    Canvas canvas({20, 20});
    canvas.clip_to({5, 5, 10, 10});
    canvas.fill_all(white);
    CHECK(area_of(canvas) == doctest::Approx(100));
    canvas.release_clip();
    canvas.fill_all(white);
    CHECK(area_of(canvas) == doctest::Approx(400));
}

TEST_CASE("a canvas is restored to a layer, at first whole, then where it was drawn on") {
    Canvas layer({33, 7});
    layer.fill_all(rgb(0x0A0B0C));
    PixelView own = layer.pixels();
    own.data[6 * own.stride + 32] = 0xFF010203U;
    layer.pixels_changed();
    layer.fill({0, 0, 1, 1}, white);
    Canvas canvas({33, 7});
    canvas.restore(layer);
    CHECK(at(canvas, 32, 6) == 0xFF010203U);
    CHECK(at(canvas, 0, 0) == 0xFFFFFFFFU);
    CHECK(at(canvas, 1, 1) == 0xFF0A0B0CU);
    Canvas moved = std::move(canvas);
    CHECK(at(moved, 32, 6) == 0xFF010203U);

    PixelView behind = moved.pixels();
    behind.data[3 * behind.stride + 5] = behind.data[3 * behind.stride + 20] = 0xFF00FF00U;
    moved.pixels_changed();
    moved.touch({5.0, 3.0, 1.0, 1.0});
    moved.restore(layer);
    CHECK(at(moved, 5, 3) == 0xFF0A0B0CU);
    CHECK(at(moved, 20, 3) == 0xFF00FF00U);  // not told of
    moved.fill_all(white);
    moved.restore(layer);
    CHECK(at(moved, 20, 3) == 0xFF0A0B0CU);
    moved.touch({-50.0, -50.0, 5.0, 5.0});  // wholly outside
    moved.touch({-50.0, -50.0, 500.0, 500.0});
    moved.restore(layer);
    CHECK(pixels_of(moved) == pixels_of(layer));
}

// Something of one of thirteen kinds, somewhere on 120 by 90 pixels, in part or wholly outside.
void draw_something(Canvas& canvas, DiskPainter& disks, int kind, std::uint64_t seed) {
    Random random(seed, "canvas");
    const auto place = [&] { return Point{random.uniform(-30, 150), random.uniform(-30, 120)}; };
    const Point a = place(), b = place();
    const double width = random.uniform(0.05, 9.0), side = random.uniform(0.01, 40.0);
    const std::array path{a, b, place(), place()};
    const Rect rect{a.x, a.y, side, random.uniform(0.01, 40.0)};
    const std::array dashes{2.0, 1.5};
    const Color color = random.uniform(0, 1) < 0.5 ? white : with_alpha(white, 0.3);
    const TextStyle style{.size = side, .color = color};
    const bool clipped = random.uniform(0, 1) < 0.2;
    if (clipped) canvas.clip_to({20.5, 20.5, 60, 40});
    if (kind == 0) canvas.fill(rect, color);
    if (kind == 1) canvas.fill_circle(a, side, color);
    if (kind == 2) canvas.fill_circles(std::array{Circle{a, side, color}}, rect);
    if (kind == 3) canvas.stroke_circle(a, side, width, color);
    if (kind == 4) canvas.stroke_rect(rect, width, color);
    if (kind == 5) canvas.stroke_line(a, b, width, color);
    if (kind == 6) canvas.stroke_path(path, width, color);
    if (kind == 7) canvas.stroke_path(path, width, color, dashes);
    if (kind == 8) canvas.stroke_line(a, b, width, color, 2.0);
    if (kind == 9) canvas.fill_polygon(path, color);
    if (kind == 10) draw_text(canvas, a, "Åjg{[", style);
    if (kind == 11) draw_text(canvas, a, "<u>Å</u> <span foreground='red'>g</span>", style);
    if (kind == 12)
        disks.draw(canvas,
                   std::array{Disk{float(a.x), float(a.y), float(side), 0xFFFFFF},
                              Disk{float(b.x), float(b.y), float(width), 0xFF8800}},
                   {5, 5, 100, 70});
    if (clipped) canvas.release_clip();
}

TEST_CASE("whatever was drawn goes when a canvas is restored, and does not tell afterwards") {
    Canvas layer({120, 90});
    layer.fill_all(rgb(0x203040));
    layer.fill({10, 10, 50, 50}, rgb(0x708090));
    Canvas worn({120, 90});
    worn.restore(layer);
    DiskPainter disks;
    Random kinds(7, "kinds");
    for (std::uint64_t round = 0; round < 4000; ++round) {
        const int kind = static_cast<int>(kinds.uniform(0, 13));
        CAPTURE(kind);
        Canvas fresh({120, 90});
        fresh.restore(layer);
        draw_something(worn, disks, kind, round);
        draw_something(fresh, disks, kind, round);
        REQUIRE(pixels_of(worn) == pixels_of(fresh));
        worn.restore(layer);
        REQUIRE(pixels_of(worn) == pixels_of(layer));
    }
}

TEST_CASE("a canvas names boxes outside of which it is as its last picture was") {
    Canvas layer({120, 90});
    layer.fill_all(rgb(0x203040));
    Canvas canvas({120, 90});
    CHECK(canvas.picture() != layer.picture());
    CHECK_FALSE(canvas.changes_since(0));
    canvas.restore(layer);
    DiskPainter disks;
    Random kinds(8, "kinds");
    int changed = 0;
    for (std::uint64_t round = 0; round < 1000; ++round) {
        draw_something(canvas, disks, static_cast<int>(kinds.uniform(0, 13)), round);
        const std::vector<std::uint32_t> before = pixels_of(canvas);
        const std::uint64_t picture = canvas.picture();
        CHECK_FALSE(canvas.changes_since(picture));  // it may be drawn on since it was seen
        canvas.restore(layer);
        REQUIRE(canvas.picture() != picture);
        draw_something(canvas, disks, static_cast<int>(kinds.uniform(0, 13)), round + 5000);
        const auto boxes = canvas.changes_since(picture);
        REQUIRE(boxes);
        std::vector<std::uint32_t> outside = pixels_of(canvas);
        changed += outside != before;
        for (const PixelBounds& box : *boxes)
            for (int y = box.top; y < box.bottom; ++y)
                for (int x = box.left; x < box.right; ++x) {
                    const auto k = std::size_t(120 * y + x);
                    outside.at(k) = before.at(k);
                }
        REQUIRE(outside == before);
        canvas.restore(layer);
        CHECK_FALSE(canvas.changes_since(picture));  // two pictures ago
    }
    CHECK(changed > 500);
    const std::uint64_t picture = canvas.picture();
    canvas.restore(layer);
    canvas.fill_all(white);
    CHECK_FALSE(canvas.changes_since(picture));
}

TEST_CASE("impossible sizes are errors, not crashes") {
    CHECK_THROWS_AS(Canvas({0, 10}), SystemError);
    CHECK_THROWS_AS(Canvas({10, -1}), SystemError);
    CHECK_THROWS_AS(Canvas({100000, 10}), SystemError);
}

TEST_CASE("a PNG says its size and is complete") {
    const std::vector<std::uint8_t> png = Canvas({300, 5}).file();
    REQUIRE(png.size() > 45);
    const std::uint8_t head[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13, 'I',
                                 'H',  'D', 'R', 0,   0,    1,    44,   0,    0, 0, 5, 8,  2};
    CHECK(std::memcmp(png.data(), head, sizeof head) == 0);
    CHECK(std::memcmp(png.data() + png.size() - 8, "IEND", 4) == 0);
}

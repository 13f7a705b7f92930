#include "draw/raster/tapers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/pixels.h"
#include "util/random.h"

using namespace carom;
using test::pixels_of;

namespace {

constexpr Rect everywhere = {0, 0, 1e6, 1e6};
const Color white = rgb(0xFFFFFF);

int level(const Canvas& canvas, int x, int y, int channel = 0) {
    const PixelView pixels = canvas.pixels();
    return static_cast<int>(pixels.data[y * pixels.stride + x] >> 8 * channel & 0xFF);
}

// Whether a point is nearer to the line than half of its width there.
bool is_inside(const Taper& taper, double x, double y) {
    const double dx = taper.to.x - taper.from.x, dy = taper.to.y - taper.from.y;
    const double squared = dx * dx + dy * dy;
    const double along = (x - taper.from.x) * dx + (y - taper.from.y) * dy;
    const double at = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
    const double width = taper.width_at_start + at * (taper.width_at_end - taper.width_at_start);
    return std::hypot(x - taper.from.x - at * dx, y - taper.from.y - at * dy) < 0.5 * width;
}

// The share of a pixel inside a line, by 16 x 16 samples.
double sampled_coverage(const Taper& taper, int x, int y) {
    constexpr int samples = 16;
    int inside = 0;
    for (int i = 0; i < samples * samples; ++i)
        inside +=
            is_inside(taper, x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples);
    return inside / static_cast<double>(samples * samples);
}

std::vector<Taper> random_tapers(int count, double least_width, PixelSize size) {
    Random random(7, "lines of a test");
    std::vector<Taper> tapers(static_cast<std::size_t>(count));
    const auto place = [&] {
        return Point{random.uniform(-20, size.width + 20), random.uniform(-20, size.height + 20)};
    };
    const auto color = [&] { return rgb(static_cast<std::uint32_t>(random.below(1 << 24))); };
    for (Taper& taper : tapers)
        taper = {
            place(), place(), random.uniform(least_width, 12.0), random.uniform(least_width, 12.0),
            color(), color()};
    return tapers;
}

}  // namespace

TEST_CASE("a line may end, or lie, far outside of the picture") {
    Canvas canvas({20, 20});
    const auto drawn = [&](Point from, Point to) {
        canvas.fill({0, 0, 20, 20}, rgb(0));
        const Taper taper{from, to, 4.0, 4.0, white, white};
        draw_tapers(canvas, {&taper, 1}, everywhere);
        return pixels_of(canvas);
    };
    const std::vector<std::uint32_t> empty = [&] {
        canvas.fill({0, 0, 20, 20}, rgb(0));
        return pixels_of(canvas);
    }();
    for (const double far : {1e12, -1e12}) {
        CHECK(drawn({far, 0.0}, {2.0 * far, 20.0}) == empty);
        CHECK(drawn({0.0, far}, {20.0, 2.0 * far}) == empty);
        CHECK(drawn({10.0, 10.0}, {10.0, far}) != empty);
        CHECK(level(canvas, 10, far > 0.0 ? 15 : 5) == 255);
        CHECK(level(canvas, 10, far > 0.0 ? 5 : 15) == 0);
    }
}

TEST_CASE("coverages of a line are those of samples") {
    const PixelSize size{60, 50};
    for (Taper taper : random_tapers(60, 2.0, size)) {
        taper.color_at_start = taper.color_at_end = white;
        Canvas canvas(size);
        draw_tapers(canvas, {&taper, 1}, everywhere);
        double farthest = 0.0, sum = 0.0;
        int edges = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const double share = sampled_coverage(taper, x, y);
                const double off = std::abs(level(canvas, x, y) / 255.0 - share);
                farthest = std::max(farthest, off);
                if (share == 0.0 || share == 1.0) continue;
                sum += off;
                ++edges;
            }
        // An edge at 45 degrees leaves a pixel within 0.71 of it rather than 0.5, where its
        // coverage differs by 0.06; round ends of a width of 2 bend within a pixel.
        CHECK(farthest < 0.15);
        if (edges > 20) CHECK(sum / edges < 0.04);
    }
}

TEST_CASE("a line thinner than a pixel keeps its share of light") {
    for (const double width : {0.2, 0.5, 0.9}) {
        Canvas canvas({60, 20});
        const Taper taper{{10.0, 10.3}, {50.0, 10.3}, width, width, white, white};
        draw_tapers(canvas, {&taper, 1}, everywhere);
        double sum = 0.0;
        for (int y = 0; y < 20; ++y) sum += level(canvas, 30, y) / 255.0;
        CHECK(std::abs(sum - width) < 0.01);
    }
}

TEST_CASE("colour and width change evenly along a line") {
    Canvas canvas({120, 40});
    const Taper taper{{10, 20}, {110, 20}, 4, 24, rgb(0x204060), rgb(0xE0A080)};
    draw_tapers(canvas, {&taper, 1}, everywhere);
    for (int x = 12; x < 108; ++x) {
        const double at = (x + 0.5 - 10.0) / 100.0;
        // In the middle of a row of pixels the colour is that of the place, rounded.
        for (const auto [channel, start, end] :
             {std::array{0, 0x60, 0x80}, std::array{1, 0x40, 0xA0}, std::array{2, 0x20, 0xE0}})
            CHECK(std::abs(level(canvas, x, 20, channel) - (start + at * (end - start))) <= 1.0);
        double light = 0.0;
        for (int y = 0; y < 40; ++y) light += level(canvas, x, y, 2) / (0x20 + at * 0xC0);
        CHECK(std::abs(light - (4.0 + 20.0 * at)) < 0.15);
    }
}

TEST_CASE("an opacity changes evenly along a line, over what is there") {
    Canvas canvas({120, 40});
    canvas.fill_all(rgb(0x404040));
    const Taper taper{{10, 20}, {110, 20}, 24, 24, white, white, 0.8, 0.0};
    draw_tapers(canvas, {&taper, 1}, everywhere);
    for (int x = 12; x < 108; ++x) {
        const double opacity = 0.8 * (1.0 - (x + 0.5 - 10.0) / 100.0);
        CHECK(std::abs(level(canvas, x, 20) - (0x40 + opacity * (0xFF - 0x40))) <= 1.0);
    }
}

TEST_CASE("where joined lines overlap, the most opaque one counts") {
    const PixelSize size{140, 140};
    std::vector<Taper> bent = random_tapers(5, 12.0, size);
    for (std::size_t k = 0; k < bent.size(); ++k) {
        Taper& taper = bent[k];
        taper.color_at_start = taper.color_at_end = white;
        taper.is_joined = k > 0;
        taper.width_at_start = 30.0, taper.width_at_end = 20.0;
        if (k > 0) taper.from = bent[k - 1].to;
        taper.opacity_at_start = 0.6 - 0.1 * static_cast<double>(k);
        taper.opacity_at_end = taper.opacity_at_start - 0.1;
    }
    Canvas all(size);
    draw_tapers(all, bent, everywhere);
    std::vector<int> most(140 * 140);
    for (Taper taper : bent) {
        taper.is_joined = false;
        Canvas alone(size);
        draw_tapers(alone, {&taper, 1}, everywhere);
        for (int i = 0; i < 140 * 140; ++i)
            most[std::size_t(i)] = std::max(most[std::size_t(i)], level(alone, i % 140, i / 140));
    }
    for (int i = 0; i < 140 * 140; ++i)
        CHECK(std::abs(level(all, i % 140, i / 140) - most[std::size_t(i)]) <= 3);  // one a line
}

TEST_CASE("lines of one width look as Cairo strokes them") {
    const PixelSize size = {300, 200};
    Canvas ours(size), cairos(size);
    std::vector<Taper> tapers = random_tapers(40, 1.0, size);
    for (Taper& taper : tapers) {
        taper.width_at_end = taper.width_at_start;
        taper.color_at_end = taper.color_at_start;
        cairos.stroke_path(std::array{taper.from, taper.to}, taper.width_at_start,
                           taper.color_at_start);
    }
    draw_tapers(ours, tapers, everywhere);
    double sum = 0.0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const int off = std::abs(level(ours, x, y, channel) - level(cairos, x, y, channel));
                CHECK(off < 64);
                sum += off;
            }
    CHECK(sum / (3.0 * size.width * size.height) < 1.0);
}

TEST_CASE("the clip cuts lines, and what is not finite is left out") {
    const PixelSize size = {90, 70};
    const Rect clip{13, 9, 50, 41};
    const std::vector<Taper> tapers = random_tapers(30, 0.5, size);
    Canvas whole(size), cut(size);
    draw_tapers(whole, tapers, everywhere);
    draw_tapers(cut, tapers, clip);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const bool is_in = x >= 13 && x < 63 && y >= 9 && y < 50;
            CHECK(level(cut, x, y) == (is_in ? level(whole, x, y) : 0));
        }
    Canvas none(size);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinite = std::numeric_limits<double>::infinity();
    for (const Point& point : {Point{nan, 5}, Point{5, infinite}, Point{-infinite, nan}}) {
        const Taper taper{{20, 20}, point, 3, 3, white, white};
        draw_tapers(none, {&taper, 1}, everywhere);
    }
    const Taper of_no_width{{5, 5}, {50, 50}, 0, 0, white, white};
    draw_tapers(none, {&of_no_width, 1}, everywhere);
    CHECK(pixels_of(none) == pixels_of(Canvas(size)));
}

TEST_CASE("a canvas is restored where lines were drawn, and only colours change in an opaque one") {
    const PixelSize size = {200, 150};
    Canvas ground(size), canvas(size);
    ground.fill_all(rgb(0x102030));
    canvas.restore(ground);
    const std::vector<Taper> tapers = random_tapers(3, 0.5, size);
    draw_tapers(canvas, tapers, everywhere);
    CHECK(pixels_of(canvas) != pixels_of(ground));
    canvas.restore(ground);
    CHECK(pixels_of(canvas) == pixels_of(ground));

    Canvas seen_through(size, Backdrop::transparent);
    draw_tapers(seen_through, tapers, everywhere);
    for (const std::uint32_t pixel : pixels_of(seen_through))
        for (int channel = 0; channel < 3; ++channel)
            CHECK((pixel >> 8 * channel & 0xFF) <= pixel >> 24);
}

TEST_CASE("in a document a line is strokes of its colours") {
    Canvas page({100, 100}, VectorFormat::svg, {"T", "D"});
    const Taper taper{{10, 20}, {90, 20}, 2, 8, rgb(0x000000), rgb(0x0C0C0C)};
    draw_tapers(page, {&taper, 1}, {0, 0, 100, 100});
    const std::vector<std::uint8_t> bytes = page.file();
    const std::string text(bytes.begin(), bytes.end());
    std::size_t strokes = 0;
    for (std::size_t at = text.find("stroke-width"); at != std::string::npos;
         at = text.find("stroke-width", at + 1))
        ++strokes;
    CHECK(strokes == 4);  // 12 levels in steps of 3
}

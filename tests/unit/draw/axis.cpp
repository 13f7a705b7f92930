#include "draw/axis.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

std::vector<std::string> labels(double low, double high, int most = 5) {
    std::vector<std::string> all;
    for (const TickMark& mark : ticks(low, high, most)) all.push_back(mark.label);
    return all;
}
using Labels = std::vector<std::string>;

}  // namespace

TEST_CASE("the title of a level axis stands in the row of its labels, which give way to it") {
    struct Case {
        const char* title;
        std::size_t labels;  // that stay, of five
    };
    for (const auto& [title, labels] :
         {Case{"t", 5}, Case{"speed", 4}, Case{"elapsed time", 3},
          Case{"a long quantity of all", 2}, Case{"collisions of each particle, mean", 0}}) {
        CAPTURE(title);
        Canvas canvas({500, 100});
        AxisStyle style;
        style.label.size = style.title.size = 20;
        const TextLog log;
        const Rect area{100, 0, 300, 40};
        draw_x_axis(canvas, area, {0, 2, 100, 400}, title, style);
        const auto words = std::ranges::find(log.lines, title, &DrawnLine::markup);
        REQUIRE(words != log.lines.end());
        std::size_t seen = 0;
        for (const DrawnLine& line : log.lines) {
            if (line.ink.width <= 0.0 || line.markup == title) continue;
            ++seen;
            CHECK((line.ink.right() < words->ink.x || line.ink.x > words->ink.right()));
        }
        CHECK(seen == labels);
        CHECK(words->ink.right() <= area.right() + 0.6 * style.label.size);
        CHECK(words->ink.bottom() <= area.bottom() + x_axis_space(style) + 0.3 * style.title.size);
    }
}

TEST_CASE("ticks are round and equally precise") {
    CHECK(labels(0, 1) == Labels{"0.00", "0.25", "0.50", "0.75", "1.00"});
    CHECK(labels(0, 3) == Labels{"0", "1", "2", "3"});
    CHECK(labels(0, 6) == Labels{"0", "2", "4", "6"});
    CHECK(labels(0, 30) == Labels{"0", "10", "20", "30"});
    CHECK(labels(-1, 1) == Labels{"−1.0", "−0.5", "0.0", "0.5", "1.0"});
    CHECK(labels(2.1, 3.9) == Labels{"2.5", "3.0", "3.5"});
    CHECK(labels(0, 40000) ==
          Labels{"0", "10\u2009000", "20\u2009000", "30\u2009000", "40\u2009000"});
    CHECK(labels(0, 3e7) ==
          Labels{"0", "1\u2009×\u200910⁷", "2\u2009×\u200910⁷", "3\u2009×\u200910⁷"});
    CHECK(labels(0, 3e-7) ==
          Labels{"0", "1\u2009×\u200910⁻⁷", "2\u2009×\u200910⁻⁷", "3\u2009×\u200910⁻⁷"});
    CHECK(labels(0, 1e7) == Labels{"0", "0.25\u2009×\u200910⁷", "0.50\u2009×\u200910⁷",
                                   "0.75\u2009×\u200910⁷", "1.00\u2009×\u200910⁷"});
}

TEST_CASE("ticks lie inside the range, as many as asked for at most") {
    for (double high = 0.0113; high < 2e5; high *= 1.37) {
        for (const int most : {2, 3, 5, 8}) {
            CAPTURE(high);
            const std::vector<TickMark> marks = ticks(0, high, most);
            CHECK(static_cast<int>(marks.size()) <= most);
            if (most == 5) CHECK(marks.size() >= 3);
            CHECK(marks.front().value == 0.0);
            CHECK(marks.back().value <= high * (1 + 1e-6));
        }
    }
    CHECK(ticks(1, 1).empty());
    CHECK(ticks(2, 1).empty());
    CHECK(ticks(0, 1.0 / 0.0).empty());
}

TEST_CASE("a range of a few numbers far from 0, or of the smallest ones, has few ticks or none") {
    for (const auto& [low, high] : {std::pair{1.0, std::nextafter(1.0, 2.0)},
                                    {1e15, 1e15 + 0.25},
                                    {0.0, 1e-310},
                                    {-1e-320, 1e-320},
                                    {1e300, std::nextafter(1e300, 1e301)}})
        for (const bool whole : {false, true}) {
            CAPTURE(low);
            CAPTURE(high);
            CHECK(ticks(low, high, 5, whole).size() <= 5);
        }
}

TEST_CASE("powers of ten stand at round exponents, two of them at least") {
    const auto exponents = [](double low, double high, int most = 5) {
        std::vector<int> all;
        for (const TickMark& mark : decade_ticks(low, high, most))
            all.push_back(static_cast<int>(mark.value));
        return all;
    };
    using Exponents = std::vector<int>;
    CHECK(exponents(-27, 2) == Exponents{-20, -10, 0});
    CHECK(exponents(-133, 1) == Exponents{-100, -50, 0});
    CHECK(exponents(-77, 0) == Exponents{-60, -40, -20, 0});
    CHECK(exponents(-98, 0) == Exponents{-80, -60, -40, -20, 0});
    CHECK(exponents(-110, 0) == Exponents{-100, -75, -50, -25, 0});
    CHECK(exponents(-307, 2) == Exponents{-300, -200, -100, 0});
    CHECK(exponents(-3, 1) == Exponents{-3, -2, -1, 0, 1});
    CHECK(exponents(-19, -11, 2) == Exponents{-18, -16, -14, -12});  // one of 5 is too few
    CHECK(exponents(-4.5, -3.5) == Exponents{-4});
    CHECK(decade_ticks(-27, 2).front().label == "10\u207B\u00B2\u2070");
    CHECK(decade_ticks(0, 5, 6).back().label == "100\u2009000");
    CHECK(decade_ticks(0, 300).back().label == "10\u00B3\u2070\u2070");
    for (int low = -500; low < 0; low += 7)
        for (int high = low + 2; high < 300; high += 11) {
            const std::size_t count = exponents(low, high).size();
            CHECK(count >= 2);
            CHECK(count <= 6);
        }
}

TEST_CASE("a rounded end of an axis is a tick itself") {
    for (double value = 0.00123; value < 1e6; value *= 1.17) {
        const double end = round_up_for_axis(value);
        CAPTURE(value);
        CHECK(end >= value * (1 - 1e-9));
        CHECK(end <= 1.5 * value);
        CHECK(ticks(0, end).back().value == relative(end, 1e-12));
    }
    CHECK(round_up_for_axis(1.0) == relative(1.0, 1e-12));
    CHECK(round_up_for_axis(0.29) == relative(0.3, 1e-12));
    CHECK(round_up_for_axis(8.1) == relative(10, 1e-12));
}

TEST_CASE("where nothing was seen, an axis ends at 1") {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double value : {0.0, -2.0, infinite, -infinite, std::nan("")})
        CHECK(round_up_for_axis(value) == 1.0);
}

namespace {

AxisStyle plain_style(double size) {
    AxisStyle style;
    style.line_width = 2;
    style.label.size = style.title.size = size;
    style.label.color = style.title.color = style.line = rgb(0xFFFFFF);
    return style;
}

// Runs of columns with ink between two rows.
int count_runs(const Canvas& canvas, int top, int bottom, int gap) {
    const PixelView pixels = canvas.pixels();
    int runs = 0, empty = gap;
    for (int x = 0; x < pixels.width; ++x) {
        bool has_ink = false;
        for (int y = top; y < bottom; ++y)
            has_ink |= (pixels.data[y * pixels.stride + x] & 0xFF) > 40;
        if (has_ink && empty >= gap) ++runs;
        empty = has_ink ? 0 : empty + 1;
    }
    return runs;
}

}  // namespace

TEST_CASE("labels of a narrow axis are thinned until they stand apart") {
    for (const double width : {90.0, 150.0, 500.0}) {
        Canvas canvas({700, 100});
        const AxisStyle style = plain_style(20);
        draw_x_axis(canvas, {100, 0, width, 40}, {0, 40000, 100, 100 + width}, "", style);
        const int runs = count_runs(canvas, 52, 100, 10);  // half an em, less than a thin space
        CAPTURE(width);
        CHECK(runs == (width == 90.0 ? 2 : width == 150.0 ? 2 : 5));
    }
}

TEST_CASE("an axis keeps to the space it asks for") {
    Canvas canvas({400, 300});
    const AxisStyle style = plain_style(20);
    const Rect area{120, 60, 220, 150};
    const Scale x{0, 3, 120, 340}, y{0, 12000, 210, 60};
    draw_x_axis(canvas, area, x, "speed", style);
    draw_y_axis(canvas, area, y, style);
    const PixelView pixels = canvas.pixels();
    int left = 400, bottom = 0;
    for (int row = 0; row < 300; ++row)
        for (int column = 0; column < 400; ++column)
            if ((pixels.data[row * pixels.stride + column] & 0xFF) > 40) {
                left = std::min(left, column);
                bottom = std::max(bottom, row);
            }
    CHECK(left >= 120 - y_axis_space(y, style) - 1);
    CHECK(left <= 120 - y_axis_space(y, style) + 4);
    // The descender of "p" hangs below the space, which ends on a baseline.
    CHECK(bottom <= 210 + x_axis_space(style) + 0.3 * style.title.size);
}

TEST_CASE("the lines of an axis are crisp wherever they lie") {
    Canvas canvas({400, 300});
    AxisStyle style = plain_style(20);
    style.line_width = 2.7;
    style.label.color = style.title.color = rgb(0x000000);
    const Rect area{120.3, 60.6, 220.2, 150.9};
    draw_x_axis(canvas, area, {0, 3.1, 120.3, 340.5}, "", style);
    draw_y_axis(canvas, area, {0, 13, 211.5, 60.6}, style);
    const PixelView pixels = canvas.pixels();
    int grey = 0, bright = 0;
    for (int i = 0; i < pixels.stride * pixels.height; ++i) {
        const std::uint32_t level = pixels.data[i] & 0xFF;
        bright += level == 255;
        grey += level > 0 && level < 255;
    }
    CHECK(grey == 0);
    CHECK(bright > 3 * (220 + 150));
}

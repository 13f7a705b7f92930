// What a plot shows of data beyond its axes: arrows where lines are cut, bars that fade out; and
// that no line of its grid runs through words.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/text.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/layers.h"
#include "support/svg_picture.h"

using namespace carom;
using namespace carom::plot;

namespace {

constexpr double unit = 20.0;
constexpr std::array themes{ThemeKind::light, ThemeKind::dark, ThemeKind::print};

// A plot of 0 to 1 both ways, drawn in a theme.
struct DrawnPlot {
    test::SvgPicture picture;
    Rect area;

    explicit DrawnPlot(const Plot& plot, ThemeKind kind = ThemeKind::dark) {
        DiskPainter disks;
        const DrawContext dc{{20, 20, 560, 360}, unit, theme(kind), disks};
        Canvas canvas({600, 400}, VectorFormat::svg, {"T", ""});
        draw_plot(canvas, dc, plot, DrawnPart::still);
        draw_plot(canvas, dc, plot, DrawnPart::changing);
        const std::vector<std::uint8_t> file = canvas.file();
        picture = test::svg_picture(std::string(file.begin(), file.end()));
        LabelPlacer placer({});
        area = frame_of(plot, dc, placer).area;
    }

    double x(double share) const { return area.x + share * area.width; }
    double y(double share) const { return area.bottom() - share * area.height; }
};

bool has_paint(const test::Shape& shape, Color color) {
    const std::uint32_t pixel = to_pixel(color);
    return std::abs(shape.paint[0] - double(pixel >> 16 & 0xFF)) <= 1.0 &&
           std::abs(shape.paint[1] - double(pixel >> 8 & 0xFF)) <= 1.0 &&
           std::abs(shape.paint[2] - double(pixel & 0xFF)) <= 1.0;
}

// The tips of the arrows of a colour that touch the upper or the lower edge.
std::vector<test::Spot> tips(const DrawnPlot& drawn, Color color) {
    std::vector<test::Spot> all;
    for (const test::Shape& shape : drawn.picture.shapes) {
        std::vector<test::Spot> corners = shape.corners();
        if (corners.size() > 3 && corners.front().x == corners.back().x) corners.pop_back();
        if (shape.is_stroke || corners.size() != 3 || !has_paint(shape, color)) continue;
        const auto at_edge = std::ranges::find_if(corners, [&](const test::Spot& at) {
            return std::abs(at.y - drawn.area.y) < 0.1 ||
                   std::abs(at.y - drawn.area.bottom()) < 0.1;
        });
        if (at_edge != corners.end()) all.push_back(*at_edge);
    }
    return all;
}

Polyline line_through(std::vector<double> x, std::vector<double> y) {
    Polyline line;
    line.x = column("x", std::move(x));
    line.y = column("y", std::move(y));
    line.stroke = {.role = {Role::Of::accent}};
    return line;
}

Bars bars_of(std::vector<double> values, std::vector<std::string> taller) {
    Bars bars;
    std::vector<double> from, to;
    const auto count = static_cast<double>(values.size());
    for (double i = 0.0; i < count; ++i) from.push_back(i / count), to.push_back((i + 1.0) / count);
    bars.from = column("from", from);
    bars.to = column("to", to);
    bars.value = column("value", std::move(values));
    bars.taller = std::move(taller);
    return bars;
}

}  // namespace

TEST_CASE("a line beyond the axes is cut at their ends with an arrow, and not drawn along them") {
    for (const ThemeKind kind : themes) {
        CAPTURE(static_cast<int>(kind));
        Plot plot{.titles = {"Cut"}};
        plot.layers.emplace_back(
            line_through({0.0, 0.2, 0.4, 0.6, 0.8, 1.0}, {0.5, 2.5, 2.5, -1.5, -1.5, 0.5}));
        const DrawnPlot drawn(plot, kind);
        const Color color = theme(kind).accent;
        // Where straight lines between those points meet 1 and 0.
        const std::vector<test::Spot> expected{{drawn.x(0.05), drawn.y(1.0)},
                                               {drawn.x(0.475), drawn.y(1.0)},
                                               {drawn.x(0.525), drawn.y(0.0)},
                                               {drawn.x(0.95), drawn.y(0.0)}};
        const std::vector<test::Spot> found = tips(drawn, color);
        REQUIRE(found.size() == expected.size());
        for (const test::Spot& at : expected)
            CHECK(std::ranges::count_if(found, [&](const test::Spot& tip) {
                      return std::abs(tip.x - at.x) < 0.5 && std::abs(tip.y - at.y) < 0.5;
                  }) == 1);
        int pieces = 0;
        for (const test::Shape& shape : drawn.picture.shapes) {
            if (!shape.is_stroke || !has_paint(shape, color)) continue;
            ++pieces;
            const test::Edges edges = shape.pieces.front().edges();
            CHECK(edges.height() > 0.1 * drawn.area.height);
            CHECK(edges.top >= drawn.area.y);
            CHECK(edges.bottom <= drawn.area.bottom());
        }
        CHECK(pieces == 3);
    }
}

TEST_CASE("a line that goes to and fro at the end of an axis has one arrow there") {
    Plot plot{.titles = {"To and fro"}};
    std::vector<double> x, y;
    for (int i = 0; i < 20; ++i) {
        x.push_back(0.5 + 1e-3 * i);
        y.push_back(i % 2 == 0 ? 0.9 : 1.1);
    }
    plot.layers.emplace_back(line_through(x, y));
    CHECK(tips(DrawnPlot(plot), theme(ThemeKind::dark).accent).size() == 1);
}

TEST_CASE("a level beyond the axis is an arrow at its end of the plot") {
    for (const double value : {1.5, -0.5}) {
        Plot plot{.titles = {"Level"}};
        Level level;
        level.value = value;
        level.stroke.role = {Role::Of::accent};
        plot.layers.emplace_back(level);
        const DrawnPlot drawn(plot);
        const std::vector<test::Spot> found = tips(drawn, theme(ThemeKind::dark).accent);
        REQUIRE(found.size() == 1);
        CHECK(found.front().y == doctest::Approx(drawn.y(value > 1.0 ? 1.0 : 0.0)));
        CHECK(found.front().x > drawn.x(0.9));
    }
}

TEST_CASE("a bar beyond the axis fades out upward, with its number inside the plot") {
    const std::vector<std::string> none(5);
    for (const ThemeKind kind : themes)
        for (const std::size_t tall : {0U, 2U, 4U}) {
            CAPTURE(tall);
            std::vector<std::string> numbers = none;
            numbers[tall] = "4321";
            std::vector<double> values(5, 0.3);
            values[tall] = 7.0;
            Plot plot{.titles = {"Bars"}};
            plot.layers.emplace_back(bars_of(values, numbers));
            const TextLog log;
            const DrawnPlot drawn(plot, kind);
            const double left = drawn.x(0.2 * double(tall)), right = left + 0.2 * drawn.area.width;
            // The pieces of the bar from its solid part up, each fainter than the one below.
            std::vector<test::Shape> pieces;
            for (const test::Shape& shape : drawn.picture.shapes)
                if (const auto rect = shape.is_stroke ? std::nullopt : shape.rectangle())
                    if (std::abs(rect->left - left) < 1.0 && std::abs(rect->right - right) < 1.0)
                        pieces.push_back(shape);
            REQUIRE(pieces.size() > 5);
            for (std::size_t i = 1; i < pieces.size(); ++i) {
                CHECK(pieces[i].paint[3] < pieces[i - 1].paint[3]);
                CHECK(pieces[i].rectangle()->bottom ==
                      doctest::Approx(pieces[i - 1].rectangle()->top));
            }
            CHECK(pieces.back().rectangle()->top == doctest::Approx(drawn.area.y).epsilon(0.02));
            CHECK(pieces.back().paint[3] < 0.1);
            const auto number = std::ranges::find_if(log.lines, [](const DrawnLine& line) {
                return line.markup.find("4321") != std::string::npos;
            });
            REQUIRE(number != log.lines.end());
            CHECK(number->ink.y >= drawn.area.y);
            CHECK(number->ink.x >= drawn.area.x);
            CHECK(number->ink.right() <= drawn.area.right());
            CHECK((number->ink.right() <= left || number->ink.x >= right));
        }
}

TEST_CASE("the number of a bar beyond the axis has a place among bars that leave none") {
    Plot plot{.titles = {"Bars"}};
    plot.layers.emplace_back(bars_of({0.99, 0.99, 3.0, 0.99, 0.99}, {"", "", "4321", "", ""}));
    const TextLog log;
    const DrawnPlot drawn(plot);
    CHECK(log.left_out.empty());
    CHECK(std::ranges::any_of(log.lines, [&](const DrawnLine& line) {
        return line.markup.find("4321") != std::string::npos && line.ink.y >= drawn.area.y;
    }));
}

TEST_CASE("no line of the grid runs through the letters of words in a plot") {
    for (const ThemeKind kind : themes) {
        CAPTURE(static_cast<int>(kind));
        Plot plot{.titles = {"Grid"}};
        Label label;
        label.words = {"mm"};
        label.anchors = {{.at = {0.5, 0.5}, .offset = {0.0, 0.3}}};  // over the tick at 0.5
        label.still = true;
        plot.layers.emplace_back(label);
        DiskPainter disks;
        const DrawContext dc{{20, 20, 560, 360}, unit, theme(kind), disks};
        Canvas canvas({600, 400});
        canvas.fill_all(dc.theme.page);
        const TextLog log;
        draw_plot(canvas, dc, plot, DrawnPart::still);
        const auto words = std::ranges::find(log.lines, "mm", &DrawnLine::markup);
        REQUIRE(words != log.lines.end());
        LabelPlacer placer({});
        const Rect area = frame_of(plot, dc, placer).area;
        const std::uint32_t grid = to_pixel(dc.theme.grid) & 0xFFFFFF;
        const PixelView view = canvas.pixels();
        const auto grid_from = [&](double from, double to) {
            int count = 0;
            for (int y = int(area.y); y < int(area.bottom()); ++y)
                for (int x = int(from); x < int(to); ++x)
                    if (std::abs(y - words->ink.y - 0.5 * words->ink.height) < 10.0)
                        count += (view.data[y * view.stride + x] & 0xFFFFFF) == grid;
            return count;
        };
        CHECK(grid_from(area.x + 5.0, words->ink.x - 8.0) > 20);
        // The edges of letters may have this shade by chance.
        CHECK(grid_from(words->ink.x - 2.0, words->ink.right() + 2.0) < 0.1 * words->ink.width);
    }
}

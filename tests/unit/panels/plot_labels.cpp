// Words in a plot keep clear of one another, also of those of the other part.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/text.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/layers.h"
#include "panels/plot/plot_panel.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using namespace carom::plot;

TEST_CASE("words that change lie on no words that stand still") {
    const auto at_height = [](double height) {
        return Anchor{
            .at = {1.0, height}, .x_is_share = true, .offset = {-0.4, 1.2}, .align = Align::right};
    };
    Plot plot{.titles = {"Labels"}};
    Level level;
    level.value = 0.5;
    level.still = true;
    Label name;
    name.words = {"stands still"};
    name.anchors = {at_height(0.5)};
    level.label = name;
    plot.layers.emplace_back(level);
    Label changing;
    changing.words = {"changes"};
    changing.anchors = {at_height(0.5), at_height(0.9)};
    plot.layers.emplace_back(changing);

    DiskPainter disks;
    const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
    Canvas canvas({600, 400});
    const TextLog log;
    draw_plot(canvas, dc, plot, DrawnPart::still);
    draw_plot(canvas, dc, plot, DrawnPart::changing);
    const auto rect_of = [&](const char* words) {
        const auto line = std::ranges::find(log.lines, words, &DrawnLine::markup);
        REQUIRE(line != log.lines.end());
        return line->ink;
    };
    const Rect still = rect_of("stands still"), moved = rect_of("changes");
    CHECK(moved.bottom() <= still.y);
}

namespace {

// A plot from 0 to 1 along both axes, its words as they are drawn, and where data are.
struct DrawnPlot {
    DiskPainter disks;
    DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
    std::vector<DrawnLine> lines;
    std::vector<std::string> left_out, in_keys;

    explicit DrawnPlot(const Plot& plot, const Plot* now = nullptr) {
        Canvas canvas({600, 400});
        const TextLog log;
        draw_plot(canvas, dc, plot, DrawnPart::still);
        if (now != nullptr) draw_arriving_names(canvas, dc, with_fixed_names(plot, dc), *now);
        lines = log.lines;
        left_out = log.left_out;
        in_keys = log.in_keys;
    }
    std::optional<Rect> words(const std::string& with) const {
        for (const DrawnLine& line : lines)
            if (line.markup.find(with) != std::string::npos) return line.ink;
        return {};
    }
    double x(const Plot& plot, double value) const { return frame(plot).first(value); }
    double y(const Plot& plot, double value) const { return frame(plot).second(value); }

  private:
    std::pair<Scale, Scale> frame(const Plot& plot) const {
        LabelPlacer placer({});
        const Frame found = frame_of(plot, dc, placer);
        return {found.x_scale, found.y_scale};
    }
};

Level level_at(double value, const char* words) {
    Level level;
    level.value = value;
    level.still = true;
    name_level(level, {words});
    return level;
}

Polyline line_through(std::vector<double> x, std::vector<double> y) {
    Polyline line;
    line.x = column("x", std::move(x));
    line.y = column("y", std::move(y));
    line.head = plot::Dot{};
    return line;
}

}  // namespace

TEST_CASE("a level is named at the right end of its line, on the side that is free") {
    const auto off_line = [](double height_of_curve) {
        Plot plot{.titles = {"Level"}};
        plot.layers.emplace_back(level_at(0.5, "level 0.5"));
        plot.layers.emplace_back(line_through({0.0, 1.0}, {height_of_curve, height_of_curve}));
        const DrawnPlot drawn(plot);
        const auto words = drawn.words("level 0.5");
        REQUIRE(words);
        CHECK(drawn.in_keys.empty());
        CHECK(drawn.x(plot, 1.0) - words->right() < 1.0 * drawn.dc.unit);
        return (0.5 * (words->y + words->bottom()) - drawn.y(plot, 0.5)) / drawn.dc.unit;
    };
    CHECK(off_line(0.9) > -1.5);
    CHECK(off_line(0.9) < -0.5);
    CHECK(off_line(0.55) < 1.5);
    CHECK(off_line(0.55) > 0.5);
}

TEST_CASE("the words of two levels are nearest to their own") {
    Plot plot{.titles = {"Levels"}};
    plot.layers.emplace_back(level_at(0.50, "lower"));
    plot.layers.emplace_back(level_at(0.56, "upper"));
    const DrawnPlot drawn(plot);
    const auto lower = drawn.words("lower"), upper = drawn.words("upper");
    REQUIRE(lower);
    REQUIRE(upper);
    CHECK(lower->y > drawn.y(plot, 0.50));
    CHECK(upper->bottom() < drawn.y(plot, 0.56));
}

TEST_CASE("a level that has no room beside its line is named in a key, and the log says so") {
    Plot plot{.titles = {"Level"}};
    plot.layers.emplace_back(level_at(0.5, "level 0.5"));
    Band band;
    band.x = column("x", {0.0, 1.0});
    band.y = column("y", {0.5, 0.5});
    band.error = column("error", {0.3, 0.3});
    plot.layers.emplace_back(band);
    const DrawnPlot drawn(plot);
    const auto words = drawn.words("level 0.5");
    REQUIRE(words);
    CHECK(words->bottom() < drawn.y(plot, 0.8));
    CHECK(drawn.in_keys == std::vector<std::string>{"level 0.5"});
    CHECK(drawn.left_out.empty());
}

TEST_CASE("the name of a growing line is seen once the line has come to it") {
    const auto drawn_when = [](double at, std::size_t end) {
        Plot plot{.titles = {"Line"}};
        std::vector<double> x, y;
        for (int i = 0; i <= 100; ++i) {
            x.push_back(0.01 * i);
            y.push_back(0.5);
        }
        plot.layers.emplace_back(line_through(x, y));
        Label name;
        name.still = true;
        name.words = {named("its name", {.of = Role::Of::ink})};
        name.anchors = {{.at = {at, 0.5}, .offset = {0.0, -0.5}}};
        name.line = 0;
        name.is_name = true;
        name.swatch = Stroke{};
        plot.layers.emplace_back(name);
        Plot now = plot;
        std::get<Polyline>(now.layers[0]).shown.end = end;
        const DrawnPlot drawn(plot, &now);
        const auto words = drawn.words("its name");
        if (words) CHECK(words->x == doctest::Approx(drawn.x(plot, at)).epsilon(0.02));
        return words.has_value();
    };
    CHECK_FALSE(drawn_when(0.1, 0));
    CHECK_FALSE(drawn_when(0.1, 10));
    CHECK(drawn_when(0.1, 20));
    CHECK(drawn_when(0.1, 101));
    CHECK(drawn_when(0.6, 20));  // as a key, since the line will come late
}

TEST_CASE("the name of a growing line is nearer to it than to other lines") {
    Plot plot{.titles = {"Lines"}};
    plot.layers.emplace_back(line_through({0.0, 1.0}, {0.5, 0.5}));
    plot.layers.emplace_back(line_through({0.0, 0.5, 0.55, 1.0}, {0.68, 0.68, 1.0, 1.0}));
    Label name;
    name.still = name.is_name = true;
    name.words = {"its name"};
    for (const double at : {0.1, 0.6})
        name.anchors.push_back({.at = {at, 0.5}, .offset = {0.0, -1.1}});
    name.line = 0;
    name.swatch = Stroke{};
    plot.layers.emplace_back(name);
    const DrawnPlot drawn(plot, &plot);
    const auto words = drawn.words("its name");
    REQUIRE(words);
    CHECK(words->x > drawn.x(plot, 0.5));
}

TEST_CASE("a plot without titles has none") {
    DiskPainter disks;
    const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
    CHECK(fitting_title(dc, {}).empty());
    Canvas canvas({600, 400});
    const TextLog log;
    draw_plot(canvas, dc, Plot{}, DrawnPart::still);
    CHECK(std::ranges::none_of(log.lines, [](const DrawnLine& line) {
        return line.ink.width > 0.0 && line.ink.y < 40.0;  // above the plot
    }));
}

TEST_CASE("words that are named far from their level have a swatch of its line before them") {
    const auto darkest_left_of_words = [](bool has_swatch) {
        Plot plot{.titles = {"Sample"}};
        Label label;
        label.words = {"level"};
        label.anchors = {
            {.at = {0.5, 0.6}, .x_is_share = true, .y_is_share = true, .has_swatch = has_swatch}};
        label.swatch = Stroke{.width = 0.1};
        label.still = true;
        plot.layers.emplace_back(label);
        DiskPainter disks;
        const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
        Canvas canvas({600, 400});
        canvas.fill_all(dc.theme.page);
        TextLog log;
        draw_plot(canvas, dc, plot, DrawnPart::still);
        const auto words = std::ranges::find(log.lines, "level", &DrawnLine::markup);
        REQUIRE(words != log.lines.end());
        const PixelView view = canvas.pixels();
        std::uint32_t darkest = 0xFF;
        for (auto y = int(words->ink.y); y < int(words->ink.bottom()); ++y)
            for (auto x = int(words->ink.x) - 36; x < int(words->ink.x) - 8; ++x)
                darkest = std::min(darkest, view.data[y * view.stride + x] & 0xFF);
        return darkest;
    };
    CHECK(darkest_left_of_words(true) < 0x90);
    CHECK(darkest_left_of_words(false) > 0xE0);
}

TEST_CASE("words about a point near a side stay within the plot") {
    const auto ink_at = [](double x) {
        Plot plot{.titles = {"Centred"}};
        Label label;
        label.words = {"contact at 0.00"};
        label.anchors = {{.at = {x, 0.5}, .y_is_share = true, .align = Align::center}};
        label.still = true;
        plot.layers.emplace_back(label);
        DiskPainter disks;
        const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
        Canvas canvas({600, 400});
        TextLog log;
        draw_plot(canvas, dc, plot, DrawnPart::still);
        const auto words = std::ranges::find(log.lines, "contact at 0.00", &DrawnLine::markup);
        REQUIRE(words != log.lines.end());
        return std::pair{words->ink.x, words->ink.right()};
    };
    const auto [left, left_end] = ink_at(0.0);
    const auto [middle, middle_end] = ink_at(0.5);
    const auto [right, right_end] = ink_at(1.0);
    const double half = 0.5 * (middle_end - middle);
    const double whole = right_end - left;  // of the plot
    CHECK(left_end - left == doctest::Approx(2.0 * half));
    CHECK(0.5 * (middle + middle_end) == doctest::Approx(left + 0.5 * whole).epsilon(0.01));
    CHECK(whole < 560.0);
    CHECK(whole > 440.0);  // with half of the words outside on either side it would be more
    CHECK(right_end <= 580.0);
    CHECK(left >= 20.0);
}

TEST_CASE("words lie beside the lines of reversals and events, or are left out") {
    const auto drawn = [](double width_of_plot) {
        Plot plot{.titles = {"Labels"}};
        Marker line;
        line.value = 0.5;
        line.still = true;
        plot.layers.emplace_back(line);
        Label words;
        words.still = true;
        words.words = {"velocities reversed"};
        words.anchors = {{.at = {0.5, 0.5}, .align = Align::center},
                         {.at = {0.5, 0.5}, .offset = {0.4, 0.0}}};
        plot.layers.emplace_back(words);
        DiskPainter disks;
        const DrawContext dc{{20, 20, width_of_plot, 360}, 20, theme(ThemeKind::light), disks};
        Canvas canvas({800, 400});
        TextLog log;
        draw_plot(canvas, dc, plot, DrawnPart::still);
        const auto found = std::ranges::find(log.lines, "velocities reversed", &DrawnLine::markup);
        LabelPlacer placer({});
        if (found != log.lines.end()) CHECK(found->ink.x > frame_of(plot, dc, placer).x(0.5));
        CHECK((found == log.lines.end()) == (log.left_out.size() == 1));
        return found != log.lines.end();
    };
    CHECK(drawn(700.0));
    CHECK_FALSE(drawn(300.0));
}

namespace {

const std::string two_species =
    "title: T\nbox: {size: [60, 40]}\ngas: [{name: light, count: 160, radius: 0.3, mass: 1, "
    "temperature: 2}, {name: heavy, count: 60, radius: 0.6, mass: 12, temperature: 2}]\n"
    "run: {until: 20}\nfilm: {fps: 1, seconds: 10, size: ";

// A word in a colour of its own, as names of lines are set.
std::vector<DrawnLine> named(const TextLog& log, const std::string& name) {
    std::vector<DrawnLine> lines;
    for (const DrawnLine& line : log.lines)
        if (line.markup.ends_with(">" + name + "</span>")) lines.push_back(line);
    return lines;
}

bool has_title_with(const TextLog& log, const std::string& one, const std::string& other) {
    return std::ranges::any_of(log.lines, [&](const DrawnLine& line) {
        return line.markup.find(one) != std::string::npos &&
               line.markup.find(other) != std::string::npos;
    });
}

}  // namespace

TEST_CASE("species are named at their lines and humps in these colours, not in the title") {
    for (const std::string panel : {"speed-histogram", "temperature"})
        for (const std::string rest :
             {"[1920, 1080], template: lecture", "[1080, 1920], template: portrait",
              "[1920, 1080], template: lecture, theme: print",
              "[1920, 1080], template: lecture, theme: light, language: de"}) {
            CAPTURE(panel);
            CAPTURE(rest);
            const test::Shot shot(test::scene_from(
                two_species + rest + ", panels: [{kind: " + panel + ", of: [light, heavy]}]}\n"));
            const PanelSet::Placed& placed = shot.panels->panels().back();
            const Grid grid(shot.scene.film.layout, shot.scene.film.size);
            DiskPainter disks;
            const auto draw = [&](const Rect& area) {
                const DrawContext dc{area, grid.unit(), theme_of(shot.scene.film.theme), disks};
                Canvas canvas({shot.scene.film.size.width, shot.scene.film.size.height});
                placed.panel->draw_ground(canvas, dc);
                placed.panel->draw(canvas, dc, *shot.frames.back().states.back());
            };
            const Rect place = grid.place(placed.slot);
            {
                const TextLog log;
                draw(place);
                const std::vector<DrawnLine> light = named(log, "light"),
                                             heavy = named(log, "heavy");
                REQUIRE(light.size() == 1);
                REQUIRE(heavy.size() == 1);
                const auto color_of = [](const DrawnLine& line) {
                    return line.markup.substr(line.markup.rfind("foreground"), 20);
                };
                CHECK(color_of(light[0]) != color_of(heavy[0]));
                CHECK(!has_title_with(log, "light", "heavy"));
                const double top = place.y + 1.6 * grid.unit();
                for (const Rect& ink : {light[0].ink, heavy[0].ink}) CHECK(ink.y > top);
                // At the same temperature heavier disks are slower.
                if (panel == "speed-histogram") CHECK(heavy[0].ink.x < light[0].ink.x);
            }
            if (rest.find("theme") != std::string::npos) continue;
            // Without room beside the lines, the title says it, if it has room.
            const TextLog log;
            draw({place.x, place.y, place.width, 6.0 * grid.unit()});
            CHECK(named(log, "light").empty());
            CHECK(has_title_with(log, "light", "heavy"));
        }
}

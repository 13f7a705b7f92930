// Words in a plot keep clear of one another, also of those of the other part.
#include <doctest/doctest.h>

#include <algorithm>

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
    draw_plot(canvas, dc, plot, Part::still);
    draw_plot(canvas, dc, plot, Part::changing);
    const auto rect_of = [&](const char* words) {
        const auto line = std::ranges::find(log.lines, words, &DrawnLine::markup);
        REQUIRE(line != log.lines.end());
        return line->ink;
    };
    const Rect still = rect_of("stands still"), moved = rect_of("changes");
    CHECK(moved.bottom() <= still.y);
}

TEST_CASE("a plot without titles has none") {
    DiskPainter disks;
    const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
    CHECK(fitting_title(dc, {}).empty());
    Canvas canvas({600, 400});
    const TextLog log;
    draw_plot(canvas, dc, Plot{}, Part::still);
    CHECK(std::ranges::none_of(log.lines, [](const DrawnLine& line) {
        return line.ink.width > 0.0 && line.ink.y < 40.0;  // above the plot
    }));
}

TEST_CASE("words that are named far from their level have a sample of its line before them") {
    const auto darkest_left_of_words = [](bool has_sample) {
        Plot plot{.titles = {"Sample"}};
        Label label;
        label.words = {"level"};
        label.anchors = {
            {.at = {0.5, 0.6}, .x_is_share = true, .y_is_share = true, .has_sample = has_sample}};
        label.sample = Stroke{.width = 0.1};
        label.still = true;
        plot.layers.emplace_back(label);
        DiskPainter disks;
        const DrawContext dc{{20, 20, 560, 360}, 20, theme(ThemeKind::light), disks};
        Canvas canvas({600, 400});
        canvas.fill_all(dc.theme.page);
        TextLog log;
        draw_plot(canvas, dc, plot, Part::still);
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
        draw_plot(canvas, dc, plot, Part::still);
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
        draw_plot(canvas, dc, plot, Part::still);
        const auto found = std::ranges::find(log.lines, "velocities reversed", &DrawnLine::markup);
        LabelPlacer placer({});
        if (found != log.lines.end()) CHECK(found->ink.x > frame_of(plot, dc, placer).x(0.5));
        CHECK((found == log.lines.end()) == (log.left_out.size() == 1));
        return found != log.lines.end();
    };
    CHECK(drawn(700.0));
    CHECK_FALSE(drawn(300.0));
}

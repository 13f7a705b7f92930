// Words in a plot keep clear of one another, also of those of the other part.
#include <doctest/doctest.h>

#include <algorithm>

#include "draw/canvas.h"
#include "draw/disks.h"
#include "draw/text.h"
#include "panels/plot/draw_plot.h"

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
            {.at = {0.5, 0.5}, .x_is_share = true, .y_is_share = true, .has_sample = has_sample}};
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

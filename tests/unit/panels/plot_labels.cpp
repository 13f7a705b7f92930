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

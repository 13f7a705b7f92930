// What comes and goes in a film's picture: when, where, and what else is seen then.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "panels/frame.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

TEST_CASE("a caption that comes or goes is whole in a still") {
    const Shot film(
        test::scene_from("title: T\nbox: {size: [40, 30]}\ngas: [{count: 4, speed: 1}]\n"
                         "run: {until: 4, events: [{at: 2, caption: words}]}\n"
                         "film: {seconds: 8, fps: 30, panels: [], size: [480, 480], "
                         "monitors: [time]}\n"));  // no other numbers stand in its line
    FramePainter painter(*film.panels);
    const std::vector<CaptionSpan> spans = caption_schedule(film.scene);
    const auto coming = static_cast<std::size_t>(spans[0].first);
    const auto brightest = [](const Canvas& canvas, const Rect& line) {
        std::uint32_t most = 0;
        const PixelView view = canvas.pixels();
        for (int y = static_cast<int>(line.y); y < line.bottom(); ++y)
            for (int x = static_cast<int>(line.x); x < line.right(); ++x)
                most = std::max(most, view.data[y * view.stride + x] & 0xFF);
        return most;
    };
    const Rect line =
        Grid(film.scene.film.layout, {480, 480}).place(*film.scene.film.layout.caption);
    const std::uint32_t whole = brightest(painter.paint(film.frames[coming + 10]), line);
    CHECK(brightest(painter.paint(film.frames[coming]), line) < whole / 2);
    Canvas still({480, 480});
    painter.paint_on(still, film.frames[coming]);
    CHECK(brightest(still, line) == whole);
    painter.paint_on(still, film.frames[coming - 1]);
    CHECK(brightest(still, line) < whole / 2);
}

TEST_CASE("the subtitle stands at the captions' place for four seconds, and never with a caption") {
    struct Case {
        std::string events;
        double at, first_caption;  // simulated time at which the subtitle ends; seconds of film
    };
    constexpr double never = 99.0;
    for (const Case& expected :
         {Case{"", never, never},
          Case{", events: [{at: 0, caption: words}]", never, 4.0},     // it waits
          Case{", events: [{at: 1, caption: words}]", 1.0, never}}) {  // it ends the subtitle
        CAPTURE(expected.events);
        const Shot film(test::scene_from(
            "title: T\nsubtitle: What is seen\nbox: {size: [40, 30]}\ngas: [{count: 4, speed: "
            "1}]\nrun: {until: 6" +
            expected.events +
            "}\nfilm: {seconds: 12, fps: 10, panels: [], size: [640, "
            "360]}\n"));
        FramePainter painter(*film.panels);
        const Rect place = Grid(film.scene.film.layout, film.scene.film.size)
                               .place(*film.scene.film.layout.caption);
        double last_subtitle = -1.0, first_caption = never, until = 4.0;
        for (const FrameData& frame : film.frames) {
            const TextLog log;
            painter.paint(frame);
            const double seconds = frame.tick.frame / 10.0;
            if (frame.tick.time >= expected.at) until = std::min(until, seconds);
            for (const DrawnLine& line : log.lines) {
                const bool is_subtitle = line.markup == "What is seen";
                if (!is_subtitle && line.markup != "words") continue;
                if (is_subtitle) CHECK(first_caption == never);
                if (is_subtitle) last_subtitle = seconds;
                if (!is_subtitle) first_caption = std::min(first_caption, seconds);
                CHECK(line.ink.x >= place.x - 1.0);
                CHECK(line.ink.y >= place.y);
                CHECK(line.ink.bottom() <= place.bottom());
            }
        }
        const double caption = expected.at < never ? until : expected.first_caption;
        CHECK(std::abs(last_subtitle + 0.1 - until) < 0.15);
        CHECK(std::abs(first_caption - caption) < 0.15);
    }
}

TEST_CASE(
    "a panel over the gas comes with the first collision, near the box's lower right corner") {
    // Two disks that meet at 1: 8 apart, less their diameters.
    const auto shot = [](const std::string& size) {
        return Shot(test::scene_from(
            "title: T\nbox: {size: " + size +
            "}\ngas: [{name: a, count: 1, radius: 1, position: [4, 10], velocity: [3, 0]}, {name: "
            "b, count: 1, radius: 1, position: [12, 10], velocity: [-3, 0]}]\n"
            "run: {until: 3}\nfilm: {seconds: 8, fps: 10, size: [1280, 720], theme: dark, panels: "
            "[speed-histogram]}\n"));
    };
    const Shot wide = shot("[44, 20]");
    CHECK(wide.scene.film.template_name == "hero");
    const PanelSet::Placed& panel = wide.panels->panels().back();
    REQUIRE(panel.is_over_box());
    for (const FrameData& frame : wide.frames) {
        CAPTURE(frame.tick.time);
        const double opacity = panel.opacity(wide.scene.film, frame.tick);
        if (frame.tick.time < 1.0) CHECK(opacity == 0.0);
        if (frame.tick.time > 1.5) CHECK(opacity == 1.0);
    }
    // Its plate lies in the box; a narrower box takes it along, and beside one that leaves room it
    // stands free.
    const auto place_in = [](const Shot& film) {
        const Grid grid(film.scene.film.layout, film.scene.film.size);
        const Rect box = film.panels->boxes(grid).front();
        const Slot& slot = film.panels->panels().back().slot;
        const Slot plate{slot.x - grid.width_of(plate_margin),
                         slot.y - grid.height_of(plate_margin),
                         slot.width + grid.width_of(2.0 * plate_margin),
                         slot.height + grid.height_of(2.0 * plate_margin)};
        return std::pair{box, grid.place(plate)};
    };
    const Shot narrower = shot("[34, 20]");
    for (const Shot* film : {&wide, &narrower}) {
        const auto [box, plate] = place_in(*film);
        CHECK(plate.x > box.x + 0.4 * box.width);
        CHECK(plate.y > box.y + 0.3 * box.height);
        CHECK(plate.right() <= box.right());
        CHECK(plate.bottom() <= box.bottom());
        CHECK(plate.right() > box.right() - 20.0);
        CHECK(plate.bottom() > box.bottom() - 20.0);
    }
    const Shot square = shot("[20, 20]");
    const auto [box, plate] = place_in(square);
    CHECK(plate.x > box.right());
    CHECK(plate.right() <= 1280.0 - 2.0 * 20.0 + 1.0);  // the margin of the page
    CHECK(plate.y == doctest::Approx(box.y));
}

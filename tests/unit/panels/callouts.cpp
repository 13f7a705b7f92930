// Where the words of callouts and remarks stand in a film.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "panels/callouts/callout.h"
#include "panels/frame.h"
#include "panels/gas/marks/view_map.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/plot_panel.h"
#include "panels/plot_callouts.h"
#include "support/scene_text.h"
#include "support/shot.h"
#include "support/svg_picture.h"

using namespace carom;
using test::Shot;

namespace {

std::vector<DrawnLine> lines_of(FramePainter& painter, const FrameData& frame, const Scene& scene) {
    const TextLog log;
    Canvas page({scene.film.size.width, scene.film.size.height}, VectorFormat::svg, {"T", ""});
    painter.paint_on(page, frame);
    return log.lines;
}

bool meet(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

Rect box_of(const Shot& shot) {
    return shot.panels->boxes(Grid(shot.scene.film.layout, shot.scene.film.size)).front();
}

}  // namespace

TEST_CASE("the words of a callout stand still when others come and go") {
    const auto inks = [](const std::string& callouts, const std::string& words) {
        const Shot shot(test::scene_from(
            "title: T\nbox: {size: [10, 10]}\ngas: [{name: a, position: [[3, 5], [4, 5]], radius: "
            "0.3, velocity: [0, 0]}, {name: b, position: [[8, 1]], radius: 0.3, velocity: [0.01, "
            "0]}]\nrun: {until: 12}\nfilm: {fps: 10, seconds: 16, size: [640, 360], template: "
            "minimal, callouts: [" +
            callouts + "]}\n"));
        FramePainter painter(*shot.panels);
        std::vector<Rect> all;
        for (const FrameData& frame : shot.frames)
            for (const DrawnLine& line : lines_of(painter, frame, shot.scene))
                if (line.markup == words) all.push_back(line.ink);
        return all;
    };
    const std::string first = "{at: 2, for: 4, points_to: 0, text: the first words}";
    const std::string second = "{at: 4, for: 6, points_to: 1, text: the second words}";
    const std::vector<Rect> before = inks(first + ", " + second, "the first words");
    const std::vector<Rect> after = inks(first + ", " + second, "the second words");
    REQUIRE(before.size() == 40);
    REQUIRE(after.size() == 60);
    for (const Rect& ink : after) {
        CHECK(ink.x == doctest::Approx(after.front().x));
        CHECK(ink.y == doctest::Approx(after.front().y));
    }
    CHECK(!meet(before.front(), after.front()));
    CHECK(meet(before.front(), inks(second, "the second words").front()));
}

TEST_CASE("plates find their places in order of time, against those seen with them") {
    const std::vector<Showing> times{{20, 39}, {0, 9}, {5, 24}, {50, 59}};
    std::vector<std::size_t> asked;
    const auto places =
        places_in_time(times, std::vector<std::size_t>{0},
                       [&](std::size_t k, std::span<const Rect> others) -> std::optional<Rect> {
                           asked.push_back(k);
                           return Rect{0.0, static_cast<double>(others.size()), 1.0, 1.0};
                       });
    CHECK(asked == std::vector<std::size_t>{1, 2, 0});
    CHECK(places[0]->y == 1.0);
    CHECK(places[2]->y == 1.0);
    CHECK(!places[3]);
}

TEST_CASE("across a periodic side a callout stands by the image that the camera shows") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 20], walls: periodic}\ngas: [{position: [[0.5, 10], [18.9, "
        "10]], radius: 0.3, velocity: [0, 0]}]\nrun: {until: 4}\nfilm: {fps: 10, seconds: 4, size: "
        "[640, 360], template: minimal, camera: [{at: 0, follow: 0, width: 5}], callouts: [{at: 1, "
        "points_to: 1, text: it}]}\n");
    const Shot shot(scene);
    FramePainter painter(*shot.panels);
    const Rect box = box_of(shot);
    int seen = 0;
    for (const DrawnLine& line : lines_of(painter, shot.frames[20], shot.scene)) {
        if (line.markup != "it") continue;
        ++seen;
        CHECK(line.ink.right() < box.x + 0.5 * box.width);
    }
    CHECK(seen == 1);
}

TEST_CASE("remarks and callouts leave the map of the camera's view free") {
    for (const std::string size : {"[640, 360]", "[1920, 1080]"}) {
        CAPTURE(size);
        const Shot shot(test::scene_from(
            "title: T\nbox: {size: [10, 10]}\ngas: [{name: a, count: 30, radius: 0.3, temperature: "
            "1}, "
            "{name: b, position: [[1.2, 1.2]], radius: 0.1, velocity: [0, 0], mass: infinite}]\n"
            "run: {until: 10}\nfilm: {fps: 10, seconds: 6, size: " +
            size +
            ", flashes: true, camera: [{at: 0, view: [1, 1, 6, 6]}], callouts: [{at: 3, points_to: "
            "30, "
            "text: in the corner}]}\n"));
        FramePainter painter(*shot.panels);
        const FrameData& frame = shot.frames[30];
        const Rect box = box_of(shot);
        const double unit = Grid(shot.scene.film.layout, shot.scene.film.size).unit();
        DiskPainter disks;
        const DrawContext dc{box, unit, theme(ThemeKind::dark), disks};
        const ViewMap map = view_map(dc, box, 1.0, box.width / 5.0);
        int words = 0;
        for (const DrawnLine& line : lines_of(painter, frame, shot.scene)) {
            if (line.markup == "1") continue;  // the length of its bar
            words += line.markup == "in the corner" ||
                     line.markup.find("collisions flash") != std::string::npos;
            CHECK_MESSAGE(!meet(line.ink, map.plate), line.markup);
        }
        CHECK(words == 2);
    }
}

TEST_CASE("a remark that has no room beside the map stands above it, and others above that") {
    DiskPainter disks;
    const DrawContext dc{{0, 0, 400, 300}, 20.0, theme(ThemeKind::dark), disks};
    const ViewMap map = view_map(dc, dc.area, 1.0, 20.0);
    Remarks remarks(dc, dc.area, map);
    remarks.add({"short"});
    remarks.add({"words as long as the picture"});
    remarks.add({"last"});
    Canvas canvas({400, 300});
    const TextLog log;
    remarks.draw(canvas);
    REQUIRE(log.lines.size() == 3);
    for (const DrawnLine& line : log.lines) CHECK(!meet(line.ink, map.plate));
    CHECK(log.lines[0].ink.y > map.plate.y);
    CHECK(log.lines[1].ink.bottom() < map.plate.y);
    CHECK(log.lines[2].ink.bottom() < log.lines[1].ink.y);
}

TEST_CASE("callouts to a plot have places of their own, and those beyond its axes none") {
    const std::string on = "for: 8, points_to: {panel: speed-histogram, x: ";
    const Shot shot(test::scene_from(
        "title: T\nbox: {size: [10, 10]}\ngas: [{count: 40, radius: 0.3, temperature: 1}]\n"
        "run: {until: 10}\nfilm: {fps: 10, seconds: 12, size: [1280, 720], panels: "
        "[speed-histogram], callouts: [{at: 1, " +
        on + "0.3}, text: slow ones}, {at: 1, " + on + "1}, text: likely}, {at: 1, " + on +
        "50}, text: never}]}\n"));
    FramePainter painter(*shot.panels);
    std::vector<Rect> slow, likely;
    PlotCallouts callouts(*shot.panels);
    for (const FrameData& frame : shot.frames) {
        callouts.see(frame);
        for (const DrawnLine& line : lines_of(painter, frame, shot.scene)) {
            CHECK(line.markup != "never");
            if (line.markup == "slow ones") slow.push_back(line.ink);
            if (line.markup == "likely") likely.push_back(line.ink);
        }
    }
    REQUIRE(slow.size() == 80);
    REQUIRE(likely.size() == 80);
    for (std::size_t i = 0; i < slow.size(); ++i) {
        CHECK(!meet(slow[i], likely[i]));
        CHECK(likely[i].y == doctest::Approx(likely[0].y));
    }
    CHECK(callouts.never_shown() == std::vector<std::string>{"“never”"});
}

TEST_CASE("a callout to a plot stands where nothing is ever drawn, without a frame") {
    for (const std::string theme : {"dark", "light", "print"}) {
        const Shot shot(test::scene_from(
            "title: T\nbox: {size: [20, 20]}\ngas: [{count: 200, radius: 0.2, temperature: 1}]\n"
            "run: {until: 10}\nfilm: {fps: 4, seconds: 10, size: [1920, 1080], template: lecture, "
            "theme: " +
            theme +
            ", panels: [speed-histogram], callouts: [{at: 1, for: 9, points_to: {panel: "
            "speed-histogram, x: 2.2}, text: these}]}\n"));
        FramePainter painter(*shot.panels);
        const PanelSet::Placed& placed = shot.panels->panels().back();
        const Grid grid(shot.scene.film.layout, shot.scene.film.size);
        DiskPainter disks;
        const DrawContext dc{grid.place(placed.slot), grid.unit(), theme_of(shot.scene.film.theme),
                             disks};
        int seen = 0;
        for (const FrameData& frame : shot.frames) {
            const TextLog log;
            Canvas page({1920, 1080}, VectorFormat::svg, {"T", ""});
            painter.paint_on(page, frame);
            const auto words = std::ranges::find(log.lines, "these", &DrawnLine::markup);
            if (words == log.lines.end()) continue;
            ++seen;
            const auto& panel = dynamic_cast<const PlotPanel&>(*placed.panel);
            const plot::Plot plot = panel.plot(frame.states.back().get());
            for (double x = 0.0; x < 3.0; x += 0.01) {
                const auto top = plot::place_in(dc, plot, x, {});
                const auto foot = plot::place_in(dc, plot, x, 0.0);
                if (top && top->y < foot->y)
                    CHECK(!meet(words->ink, {top->x, top->y, 0.5, foot->y - top->y}));
            }
            const std::vector<std::uint8_t> file = page.file();
            for (const test::Shape& shape :
                 test::svg_picture(std::string(file.begin(), file.end())).shapes) {
                const auto frame_of = shape.is_stroke ? shape.rectangle() : std::nullopt;
                CHECK(!(frame_of && frame_of->width() < 400.0 && frame_of->left < words->ink.x &&
                        frame_of->right > words->ink.right() && frame_of->top < words->ink.y &&
                        frame_of->bottom > words->ink.bottom()));
            }
        }
        CHECK(seen > 30);
    }
}

TEST_CASE("words over the gas have ground of the page's colour, and never lie on their subject") {
    const Shot shot(test::scene_from(
        "title: T\nbox: {size: [10, 10]}\ngas: [{count: 60, radius: 0.4, temperature: 1, color: "
        "\"#ffffff\"}]\nrun: {until: 8}\nfilm: {fps: 10, seconds: 8, size: [1280, 720], template: "
        "minimal, theme: dark, color_by: species, callouts: [{at: 2, for: 5, points_to: 7, text: "
        "it is this one}]}\n"));
    FramePainter painter(*shot.panels);
    int seen = 0;
    for (const FrameData& frame : shot.frames) {
        const TextLog log;
        const Canvas& picture = painter.paint(frame);
        const auto words = std::ranges::find(log.lines, "it is this one", &DrawnLine::markup);
        if (words == log.lines.end() || frame.tick.time < 3.0 || frame.tick.time > 6.0) continue;
        ++seen;
        // Between the letters nothing is nearly as light as the disks there.
        const PixelView view = picture.pixels();
        int gray = 0, all = 0;
        for (int y = int(words->ink.y) - 2; y < int(words->ink.y); ++y)
            for (int x = int(words->ink.x); x < int(words->ink.right()); ++x, ++all)
                gray += (view.data[y * view.stride + x] & 0xFF) > 0x60;
        CHECK(all > 100);
        CHECK(gray < 0.02 * all);
    }
    CHECK(seen >= 20);
}

TEST_CASE("a callout goes with its panel, and none is about a panel that is not there") {
    const auto scene = [](const std::string& at) {
        return test::scene_from(
            "title: T\nbox: {size: [10, 10]}\ngas: [{count: 40, radius: 0.3, temperature: 1}]\n"
            "run: {until: 10}\nfilm: {fps: 10, seconds: 12, size: [640, 360], panels: [{kind: "
            "speed-histogram, show: {from: 3, until: 6}}], callouts: [{for: 20, at: " +
            at + ", points_to: {panel: speed-histogram, x: 1}, text: here}]}\n");
    };
    const Shot shot(scene("4"));
    FramePainter painter(*shot.panels);
    for (const FrameData& frame : shot.frames)
        CHECK(
            std::ranges::count(lines_of(painter, frame, shot.scene), "here", &DrawnLine::markup) ==
            (frame.tick.time >= 4.0 && frame.tick.time < 6.0));
    CHECK_THROWS_AS(scene("2"), SceneError);
    CHECK_THROWS_AS(scene("6"), SceneError);
}

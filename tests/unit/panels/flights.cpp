// Paths have their corners where velocities change, not at the frames before and after.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "panels/frame.h"
#include "panels/layout.h"
#include "panels/plot/plot_panel.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

using Pairs = std::vector<std::pair<double, double>>;

// The points of the first panel's path at the end of a film of five frames a second.
Pairs path_of(const std::string& scene, const std::string& panel) {
    const test::Shot film(test::scene_from(
        "title: T\n" + scene + "\nfilm: {seconds: 6, fps: 5, panels: [" + panel + "]}\n"));
    Pairs path;
    const Table table = film.panels->panels().back().panel->table(*film.frames.back().states.back(),
                                                                  theme(ThemeKind::light));
    for (const std::vector<TableCell>& row : table.rows)
        if (std::get<std::string>(row[0]) == "path")
            path.emplace_back(std::get<double>(row[3]), std::get<double>(row[4]));
    return path;
}

bool has(const Pairs& path, double x, double y) {
    for (const auto& [a, b] : path)
        if (std::abs(a - x) < 1e-9 && std::abs(b - y) < 1e-9) return true;
    return false;
}

// Bead 0 comes to bead 1, which rests at 6, at time 3.3, and takes its place; bead 1 meets the wall
// at time 7.3: both between two frames.
const std::string two_beads =
    "box: {length: 10}\ngas: [{position: [2.7, 6], velocity: [1, 0]}]\nrun: {until: 9}";

}  // namespace

TEST_CASE("positions of two beads turn where they collide, and where one meets a wall") {
    const Pairs path = path_of(two_beads, "{kind: positions, of: [0, 1]}");
    CHECK(has(path, 6.0, 6.0));
    CHECK(has(path, 6.0, 10.0));
    for (const auto& [first, second] : path)  // nothing lies on a short cut
        CHECK((std::abs(second - 6.0) < 1e-9 || std::abs(first - 6.0) < 1e-9));
}

TEST_CASE("a bead's velocity jumps where it collides") {
    const Pairs path = path_of(two_beads, "{kind: phase, of: [0]}");
    CHECK(has(path, 6.0, 1.0));
    CHECK(has(path, 6.0, 0.0));
}

TEST_CASE("around a ring a corner lies where the bead is seen") {
    // They meet at 0.9 after bead 0 has gone around, at time 2.15.
    const Pairs path = path_of(
        "box: {length: 10, walls: periodic}\ngas: [{position: [8.75, 0.9], velocity: [1, 0]}]\n"
        "run: {until: 5}",
        "{kind: positions, of: [0, 1]}");
    CHECK(has(path, 0.9, 0.9));
}

TEST_CASE("at a reversal a velocity jumps to its opposite") {
    const Pairs path = path_of(
        "box: {length: 10}\ngas: [{position: [1, 9], velocity: [1, 0]}]\n"
        "run: {until: 6, events: [{at: 3, reverse: velocities}]}",
        "{kind: phase, of: [0]}");
    CHECK(has(path, 4.0, 1.0));
    CHECK(has(path, 4.0, -1.0));
}

TEST_CASE("a disk that lies on the floor does not fall between two frames") {
    // Disk 1 bounces beside disk 0, which lies: at each of its bounces disk 0 is looked at.
    const Pairs path = path_of(
        "box: {size: [10, 10]}\ngravity: [0, -1]\n"
        "gas: [{radius: 0.5, position: [[2, 0.5], [7, 3]], velocity: [[0, 0], [0, 0]]}]\n"
        "run: {until: 9}",
        "{kind: positions, of: [0, 1], component: y}");
    CHECK(path.size() > 20);
    CHECK(has(path, 0.5, 0.5));  // disk 1 on the floor, too
    for (const auto& [lying, bouncing] : path) CHECK(lying == 0.5);
}

TEST_CASE("heat between two frames makes a velocity jump") {
    // The fourth frame is at 0.931: heat at 0.9 doubles the velocity at the place 3.8.
    const Pairs path = path_of(
        "box: {length: 10}\ngas: [{position: [2], velocity: [2], mass: 1}]\n"
        "run: {until: 9, events: [{at: 0.9, heat: {by: 6}}]}",
        "{kind: phase, of: [0]}");
    CHECK(has(path, 3.8, 2.0));
    CHECK(has(path, 3.8, 4.0));
}

TEST_CASE("in print the paths of two are whole lines") {
    const test::Shot film(test::scene_from(
        "title: T\nbox: {length: 20}\ngas: [{position: [2, 18], velocity: [1, -1]}]\n"
        "run: {until: 5}\nfilm: {seconds: 4, fps: 20, theme: print, "
        "panels: [{kind: phase, of: [0, 1]}]}\n"));
    const Grid grid(film.scene.film.layout, film.scene.film.size);
    DiskPainter disks;
    const DrawContext dc{grid.place(shared_slots(film.scene.film.layout.panels, 1).front()),
                         grid.unit(), theme(ThemeKind::print), disks};
    const Rect plot = plot_area(dc);
    FramePainter painter(*film.panels);
    const PixelView view = painter.paint(film.frames.back()).pixels();
    // At velocity -1, which is a share of the axis that the panel chose: some row is whole.
    int longest = 0;
    for (int y = static_cast<int>(plot.y + 0.55 * plot.height); y < plot.bottom() - 3; ++y) {
        int run = 0;
        for (int x = static_cast<int>(plot.x) + 3; x < plot.right(); ++x) {
            const bool page_pixel =
                (view.data[y * view.stride + x] & 0xFFFFFF) == (to_pixel(dc.theme.page) & 0xFFFFFF);
            run = page_pixel ? 0 : run + 1;
            longest = std::max(longest, run);
        }
    }
    CHECK(longest > 0.2 * plot.width);
}

// A bead that comes back to every state many times, for 400 frames: five strokes of one path.
TEST_CASE("a path in phase space is faint, and its last 300 frames the stronger the later") {
    const test::Shot film(test::scene_from(
        "title: T\nbox: {length: 10}\ngas: [{position: [1], velocity: [2]}]\nrun: {until: 80}\n"
        "film: {seconds: 8, fps: 50, panels: [{kind: phase, of: [0]}]}\n"));
    const auto& panel = dynamic_cast<const PlotPanel&>(*film.panels->panels().back().panel);
    const auto strokes = [&](std::size_t frame) {
        std::vector<plot::Polyline> lines;
        for (const plot::AnyLayer& layer :
             panel.plot(film.frames.at(frame).states.back().get()).layers)
            if (const auto* line = std::get_if<plot::Polyline>(&layer); line && !line->of.empty())
                lines.push_back(*line);
        return lines;
    };
    const std::size_t last = film.frames.size() - 1;
    const std::vector<plot::Polyline> lines = strokes(last);
    REQUIRE(lines.size() == 5);
    CHECK(lines[0].part == "path");
    CHECK(lines[0].shown.first == 0);
    CHECK(lines[0].stroke.fade == 0.8);
    for (std::size_t k = 1; k < lines.size(); ++k) {
        CHECK(lines[k].part.empty());  // in the table once
        CHECK(lines[k].stroke.fade == doctest::Approx(0.8 - 0.2 * static_cast<double>(k)));
        // The path as it was so many frames ago is all that it leaves out.
        CHECK(lines[k].shown.first == strokes(last - 75 * (5 - k))[0].shown.end);
        CHECK(lines[k].shown.end == lines[0].shown.end);
    }
    for (const plot::Polyline& line : strokes(40)) CHECK(line.shown.first == 0);
}

TEST_CASE(
    "the axis of a velocity reaches to what it has between frames, and nothing is drawn beyond") {
    // The middle bead moves for 2e-4 units of time alone, at 5.
    const test::Shot film(test::scene_from(
        "title: T\nbox: {length: 20}\n"
        "gas: [{position: [3, 10, 11.001], radius: 0.5, velocity: [5, 0, 0]}]\nrun: {until: 30}\n"
        "film: {seconds: 8, template: data, panels: [{kind: phase, of: [1]}]}\n"));
    const Grid grid(film.scene.film.layout, film.scene.film.size);
    DiskPainter disks;
    const PanelSet::Placed& placed = film.panels->panels().back();
    const Theme& theme = theme_of(film.scene.film.theme);
    const DrawContext dc{grid.place(placed.slot), grid.unit(), theme, disks};
    const auto at =
        placed.panel->place_of(dc, *film.frames.back().states.back(), {.x = 10, .y = 5});
    REQUIRE(at);
    CHECK(at->y > plot_area(dc).y);
    FramePainter painter(*film.panels);
    const PixelView view = painter.paint(film.frames.back()).pixels();
    for (int y = 0; y < static_cast<int>(plot_area(dc).y) - 2; ++y)
        CHECK((view.data[y * view.stride + static_cast<int>(at->x)] & 0xFFFFFF) ==
              (to_pixel(theme.page) & 0xFFFFFF));
}

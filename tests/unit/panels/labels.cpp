// Labels on labels: every panel in every template, with 1, 30 and 30,000 particles and numbers of
// 1e-9 and 1e9. No two texts touch, and no text touches a curve, a bar or another shape; the
// pictures are read back from SVG. Texts over the gas may lie on its disks.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "draw/text.h"
#include "panels/dials/dial_panel.h"
#include "panels/layout.h"
#include "panels/plot/draw_plot.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/layers.h"
#include "panels/plot/plot_panel.h"
#include "support/scene_text.h"
#include "support/share_of_cases.h"
#include "support/shot.h"
#include "support/touching.h"

using namespace carom;

namespace {

/// The sizes of a scene's numbers.
struct Size {
    int count = 30;
    double length = 1, time = 1, mass = 1;
};

// What a group of panels needs of a scene.
struct World {
    const char* name;
    enum { closed, periodic, divided, piston, wire, pair } kind;
    std::vector<std::string> panels;
    int least = 1, most = 100'000;  ///< particles
};

const std::vector<World>& worlds() {
    static const std::vector<World> all{
        {"closed",
         World::closed,
         {"speed-histogram",
          "energy-histogram",
          "velocity-histogram",
          "{kind: position-histogram, component: y}",
          "energy-by-species",
          "speed-classes",
          "temperature",
          "entropy",
          "{kind: entropy, space: both}",
          "pressure",
          "{kind: pressure, gauge: true}",
          "thermometer",
          "return-distance",
          "{kind: profile, component: y}",
          "phase",
          "{kind: phase, component: y}",
          "{kind: positions, of: [0, 1]}",
          "monitors",
          "{kind: text, words: \"Watch the red disk.\"}",
          "{kind: velocity-histogram, fit: true, over: start}",
          "{kind: velocity-histogram, fit: true, range: [-0.5 V, 0.5 V]}",
          "{kind: velocity-histogram, range: [-0.5 V, 0.5 V]}",
          "{kind: speed-histogram, range: [0, 0.5 V]}",
          "{kind: speed-histogram, of: [light, heavy]}",
          "{kind: velocity-histogram, of: [light, heavy], fit: true}",
          "{kind: speed-histogram, over: {window: 5 T}}",
          "{kind: speed-histogram, title: How fast the disks are}"}},
        {"periodic",
         World::periodic,
         {"mean-squared-displacement", "velocity-autocorrelation", "pair-correlation", "free-path",
          "{kind: free-path, log: true}", "free-time", "orientational-order",
          "{kind: flux, line: {x: 30 L}, over: {window: 5 T}}"}},
        {"divided",
         World::divided,
         {"sides", "{kind: sides, measure: temperature}", "counter", "flux",
          "{kind: stopwatch, since: wall}",
          "{kind: thermometer, regions: [{name: left, within: [0, 0, 30 L, 40 L]}, {name: right, "
          "within: [30 L, 0, 60 L, 40 L]}]}",
          "{kind: pressure, surfaces: [left, right]}", "{kind: entropy, space: positions}"}},
        {"piston",
         World::piston,
         {"piston", "piston-histogram", "pressure-volume", "energy-account", "temperature"}},
        {"wire",
         World::wire,
         {"phase", "{kind: positions, of: [0, 1]}", "velocity-histogram", "free-path", "entropy"},
         1,
         1000},
        {"pair", World::pair, {"single-collision", "contact-time"}, 2, 2}};
    return all;
}

std::string replaced(std::string text, const std::string& unit, double value) {
    for (std::size_t at = text.find(unit); at != std::string::npos; at = text.find(unit)) {
        std::size_t from = at;
        while (from > 0 && text.find_first_of("-.0123456789", from - 1) == from - 1) --from;
        const double number = std::stod(text.substr(from, at - from)) * value;
        text.replace(from, at + unit.size() - from, fmt::format("{:.9g}", number));
    }
    return text;
}

std::string scene_of(const World& world, const Size& size, const std::string& film) {
    const double v = size.length / size.time;
    const double radius = std::min(1.0, std::sqrt(2400.0 * 0.1 / size.count / 3.14159));
    const double until = size.count > 1000 ? 0.4 : 20.0;
    const int light = (size.count + 1) / 2, heavy = size.count / 2;
    const auto species = [&](const char* name, int count, const std::string& more) {
        return count == 0 ? std::string()
                          : fmt::format("  - {{name: {}, count: {}, radius: {:.9g}, {}}}\n", name,
                                        count, radius * size.length, more);
    };
    const auto speed = [&](double mass, const char* more) {
        return fmt::format("mass: {:.9g}, speed: {:.9g}{}", mass * size.mass, v, more);
    };
    std::string text = "title: A gas\n", box, gas, run, more;
    switch (world.kind) {
        case World::closed:
            box = "{size: [60 L, 40 L]}";
            gas = species("light", light, speed(1.0, "")) + species("heavy", heavy, speed(2.0, ""));
            run = fmt::format(", events: [{{at: {:.9g}, reverse: velocities}}]",
                              0.5 * until * size.time);
            break;
        case World::periodic:
            box = "{size: [60 L, 40 L], walls: periodic}";
            gas = species(
                "gas", size.count,
                fmt::format("mass: {:.9g}, temperature: {:.9g}", size.mass, size.mass * v * v));
            break;
        case World::divided:
            box = "{size: [60 L, 40 L]}";
            more = "partitions: [{name: wall, x: 30 L, gaps: [[10 L, 30 L]]}]\n";
            gas = species("gas", size.count, speed(1.0, ", position: {side: left, of: wall}"));
            run = fmt::format(", events: [{{at: {:.9g}, open: wall}}]", 0.5 * until * size.time);
            break;
        case World::piston:
            box = fmt::format(
                "{{size: [60 L, 40 L], walls: {{top: {{mass: {:.9g}, force: {:.9g}}}}}}}",
                20.0 * size.mass, -0.02 * size.count * size.mass * v / size.time);
            gas = species("gas", size.count, speed(1.0, ""));
            break;
        case World::wire:
            box = "{length: 60 L}";
            gas = fmt::format("  - {{name: gas, count: {}, {}}}\n", size.count, speed(1.0, ""));
            break;
        case World::pair:
            box = "{size: [24 L, 18 L]}";
            gas = fmt::format(
                "  - {{name: moving, position: [4 L, 9 L], radius: 2 L, mass: {0:.9g}, "
                "velocity: [{1:.9g}, 0]}}\n"
                "  - {{name: at rest, position: [13 L, 7 L], radius: 2 L, mass: "
                "{0:.9g}}}\n",
                size.mass, v);
            break;
    }
    text += "box: " + box + "\n" + more + "gas:\n" + gas +
            fmt::format("run: {{until: {:.9g}, sample_every: {:.9g}{}}}\n", until * size.time,
                        until * size.time / (size.count > 1000 ? 4 : 40), run) +
            "film: " + film + "\n";
    text = replaced(text, " L", size.length);
    text = replaced(text, " T", size.time);
    return replaced(text, " V", v);
}

// Whether a panel shows two particles, or a species that one particle leaves empty.
bool needs_two(const std::string& panel) {
    return panel.find("heavy") != std::string::npos || panel.find("[0, 1]") != std::string::npos;
}

std::string near(const std::vector<DrawnLine>& lines, const test::Edges& box) {
    std::string best = "?";
    double most = 0.0;
    for (const DrawnLine& line : lines) {
        const double both =
            test::overlap(box, {line.ink.x, line.ink.y, line.ink.right(), line.ink.bottom()});
        if (both > most) most = both, best = line.markup;
    }
    return best;
}

test::Paint paint_of(Color color) {
    return {255.0 * color.red, 255.0 * color.green, 255.0 * color.blue, 1.0};
}

std::vector<std::string> collisions_of_words(const test::Shot& shot, std::size_t frame) {
    FramePainter painter(*shot.panels);
    Canvas canvas({shot.scene.film.size.width, shot.scene.film.size.height}, VectorFormat::svg, {});
    const TextLog log;
    painter.paint_on(canvas, shot.frames[frame]);
    const std::vector<std::uint8_t> bytes = canvas.file();
    const std::string document(bytes.begin(), bytes.end());
    const test::SvgPicture picture = test::svg_picture(document);
    const Theme& theme = theme_of(shot.scene.film.theme);
    test::Look look{{paint_of(theme.page), paint_of(theme.ground), paint_of(theme.grid)}, {}};
    const Grid grid(shot.scene.film.layout, shot.scene.film.size);
    for (const Rect& box : shot.panels->boxes(grid))
        look.gases.push_back({box.x, box.y, box.right(), box.bottom()});
    for (const PanelSet::Placed& placed : shot.panels->panels())  // a needle passes over numbers
        if (const Rect dial = grid.place(placed.slot); dynamic_cast<DialPanel*>(placed.panel.get()))
            look.gases.push_back({dial.x, dial.y, dial.right(), dial.bottom()});
    std::vector<std::string> found;
    for (const test::Touching& one : test::touching(picture, look))
        found.push_back(
            one.is_text
                ? fmt::format("\"{}\" on \"{}\" by {:.1f}", near(log.lines, one.text),
                              near(log.lines, one.other), test::overlap(one.text, one.other))
                : fmt::format("\"{}\" [{:.0f} {:.0f} {:.0f} {:.0f}] on a shape [{:.0f} {:.0f} "
                              "{:.0f} {:.0f}]",
                              near(log.lines, one.text), one.text.left, one.text.top,
                              one.text.right, one.text.bottom, one.other.left, one.other.top,
                              one.other.right, one.other.bottom));
    return found;
}

}  // namespace

namespace {

/// A template, and how many panels it has places for.
using Places = std::pair<std::string, std::size_t>;

const std::vector<Places> all_templates{
    {"data", 4}, {"lecture", 3}, {"portrait", 2}, {"square", 2}, {"side-by-side", 2}};

void check_panels(const World& world, const Size& size, const std::string& name, std::size_t first,
                  std::size_t end) {
    std::string list;
    for (std::size_t i = first; i < end; ++i)
        if (size.count > 1 || !needs_two(world.panels[i]))
            list += (list.empty() ? "" : ", ") + world.panels[i];
    const std::string text =
        scene_of(world, size,
                 fmt::format("{{template: {}, fps: {}, seconds: 1, panels: [{}]}}", name,
                             size.count > 1000 ? 3 : 10, list));
    CAPTURE(text);
    const test::Shot shot(test::scene_from(text));
    for (const std::size_t frame : {std::size_t{0}, shot.frames.size() - 1})
        for (const std::string& words : collisions_of_words(shot, frame)) {
            CAPTURE(frame);
            FAIL_CHECK(words);
        }
}

// In every `share`-th picture of those that there are, from number `from` on.
void check_words(Size size, const std::vector<Places>& templates, int share = 1, int from = 0) {
    int number = 0;
    for (const World& world : worlds()) {
        size.count = std::clamp(size.count, world.least, world.most);
        for (const auto& [name, places] : templates)
            for (std::size_t first = 0; first < world.panels.size(); first += places)
                if (number++ % share == from % share)
                    check_panels(world, size, name, first,
                                 std::min(first + places, world.panels.size()));
    }
}

constexpr int many = 30'000;

}  // namespace

TEST_CASE("no words of any panel touch words, curves or bars") {
    check_words({30}, all_templates, test::every_nth(1, 4));
#ifndef CAROM_SANITIZERS  // which take ten times as long
    // Each panel in each template with one or two of these sizes; the slow tests see all of them.
    const int share = test::every_nth(3, 3);
    int from = 0;
    for (const Size& size : {Size{1}, Size{30, 1, 1e-9, 1e-9}, Size{30, 1, 1e9, 1},
                             Size{30, 1e-9, 1, 1e9}, Size{30, 1e9, 1, 1e-9}})
        check_words(size, all_templates, share, from++);
    check_words({many}, {{"data", 4}});
#endif
}

// Takes minutes, since 30,000 disks are read back from each picture: unit_panels --no-skip.
TEST_CASE("no words of any panel touch with very many particles in any template" *
          doctest::skip()) {
    check_words({many}, all_templates);
}

TEST_CASE("names stand off the highest bar and the number of it") {
    const test::Shot shot(
        test::scene_from("title: T\nbox: {size: [60, 40]}\ngas:\n"
                         "  - {name: moving, count: 30, radius: 0.5, speed: 1}\n"
                         "  - {name: at rest, count: 3, radius: 0.5}\n"
                         "run: {until: 20}\nfilm: {fps: 10, seconds: 2, panels: "
                         "[speed-histogram]}\n"));
    CHECK(collisions_of_words(shot, 0).empty());
}

TEST_CASE("a curve of the theory stays within its axes") {
    const test::Shot shot(
        test::scene_from("title: T\nbox: {size: [4, 400]}\ngravity: [0, -0.01]\n"
                         "gas: [{count: 60, radius: 0.2, temperature: 1}]\n"
                         "run: {until: 20}\nfilm: {fps: 10, seconds: 2, panels: [{kind: profile, "
                         "component: y}]}\n"));
    const auto& panel = dynamic_cast<const PlotPanel&>(*shot.panels->panels().back().panel);
    const Grid grid(shot.scene.film.layout, shot.scene.film.size);
    DiskPainter disks;
    const DrawContext dc{grid.place(shot.panels->panels().back().slot), grid.unit(),
                         theme_of(shot.scene.film.theme), disks};
    Canvas canvas({shot.scene.film.size.width, shot.scene.film.size.height}, VectorFormat::svg, {});
    panel.draw_ground(canvas, dc);
    panel.draw(canvas, dc, *shot.frames.back().states.back());
    const std::vector<std::uint8_t> bytes = canvas.file();
    plot::LabelPlacer placer({});
    const Rect area =
        plot::frame_of(panel.plot(shot.frames.back().states.back().get()), dc, placer).area;
    std::size_t curves = 0;
    for (const test::Shape& shape : test::svg_picture({bytes.begin(), bytes.end()}).shapes) {
        std::size_t points = 0;
        for (const test::Outline& piece : shape.pieces) points += piece.points.size();
        if (points < 10) continue;
        ++curves;
        const test::Edges ink = test::ink_of(shape);
        const double line = 0.5 * grid.unit();
        CHECK(ink.left >= area.x - line);
        CHECK(ink.right <= area.right() + line);
        CHECK(ink.top >= area.y - line);
        CHECK(ink.bottom <= area.bottom() + line);
    }
    CHECK(curves > 0);
}

TEST_CASE("the lines of two runs show the same numbers, off the colour bar") {
    const auto names_under_boxes = [](const std::string& film) {
        const test::Shot shot(
            test::scene_from("title: T\nbox: {size: [60, 40]}\n"
                             "gas: [{count: 30, radius: 0.5, temperature: 1}]\nrun: {until: 20}\n"
                             "film: {fps: 10, seconds: 2, panels: [], " +
                             film + "}\n"));
        CHECK(collisions_of_words(shot, 0).empty());
        CHECK(collisions_of_words(shot, shot.frames.size() - 1).empty());
        FramePainter painter(*shot.panels);
        const TextLog log;
        painter.paint(shot.frames.front());
        std::array<std::size_t, 2> found{};
        for (const DrawnLine& line : log.lines) {
            if (line.markup == "mean speed" || line.markup == "mean energy") ++found[0];
            if (line.markup == "collisions") ++found[1];
        }
        return found;
    };
    const std::string beside = "beside: {own_label: a, label: one with a long name, set: seed=7}";
    const auto wide = names_under_boxes("template: side-by-side, " + beside +
                                        ", monitors: [collisions, mean-speed, time]");
    CHECK(wide[0] % 2 == 0);
    CHECK(wide[1] == 2);
    const auto tall = names_under_boxes("template: side-by-side, size: [1080, 1920], " + beside +
                                        ", monitors: [collisions, mean-energy, time]");
    CHECK(tall[0] % 2 == 0);
    CHECK(tall[1] == 2);
}

// Surfaces that act, as panels see them.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "draw/text.h"
#include "panels/archived.h"
#include "panels/frame.h"
#include "panels/gas/flights.h"
#include "panels/plot/plot_panel.h"
#include "panels/recording.h"
#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_view.h"
#include "stats/pressure.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"
#include "util/archive.h"

using namespace carom;

namespace {

// A gas on the left of a piston that nothing else pushes; a window and a peg on its right.
Scene gas_with_piston(const std::string& film = "size: [640, 360]") {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 30, radius: 0.3, speed: 2, "
        "position: {within: [0, 0, 8, 10]}}]\nrun: {until: 3}\n"
        "film: {seconds: 2, fps: 10, panels: [], " +
        film + "}\n");
    Surfaces& surfaces = scene.gas.box.surfaces;
    surfaces.partitions.push_back({.name = "piston", .at = 9.0, .behaviour = Piston{20.0}});
    surfaces.partitions.push_back({.name = "window", .at = 15.0, .gaps = {{4.0, 6.0}}});
    surfaces.obstacles.push_back({"peg", Obstacle::Ball{{18.0, 5.0}, 1.0}});
    return scene;
}

bool is_same(const SurfaceState& a, const SurfaceState& b) {
    return a.hits == b.hits && a.impulse == b.impulse && a.work == b.work && a.heat == b.heat &&
           a.is_open == b.is_open && a.behaviour.index() == b.behaviour.index() &&
           a.motion.has_value() == b.motion.has_value() &&
           (!a.motion ||
            (a.motion->place == b.motion->place && a.motion->velocity == b.motion->velocity));
}

std::vector<SurfaceState> frame_of(const Recording& run, int wanted) {
    std::vector<SurfaceState> states;
    run.play(run.ticks().size(), [&](const Tick& tick, const Sample&, const AdvanceResult& its) {
        if (tick.frame == wanted) states = its.surfaces;
    });
    return states;
}

}  // namespace

TEST_CASE("every frame of a recording has the surfaces as they are then") {
    const Scene scene = gas_with_piston();
    const Simulation start(scene.gas, scene.run);
    Simulation simulation = start;
    std::vector<double> places;
    const auto see = [&](const Tick& tick, const Sample&, const AdvanceResult& advanced) {
        simulation.advance_to(tick.time);
        const std::vector<SurfaceState> expected = simulation.surfaces();
        REQUIRE(advanced.surfaces.size() == 7);
        for (std::size_t k = 0; k < expected.size(); ++k)
            CHECK(is_same(advanced.surfaces[k], expected[k]));
        places.push_back(advanced.surfaces[4].motion->place);
    };
    Recording run(start, timeline(scene), {}, see);
    CHECK(places.front() == 9.0);
    CHECK(places.back() > 9.5);
    const std::vector<SurfaceState> last = frame_of(run, 19);
    CHECK(last.at(4).motion->place == places.back());

    Archive written;
    run.archive(written, scene.gas.box, start.particles(), scene.run);
    Archive read(written.finished(), "a run");
    Recording again;
    again.archive(read, scene.gas.box, start.particles(), scene.run);
    const std::vector<SurfaceState> found = frame_of(again, 19);
    REQUIRE(found.size() == last.size());
    for (std::size_t k = 0; k < last.size(); ++k) CHECK(is_same(found[k], last[k]));
    CHECK(std::get<Piston>(found[4].behaviour).mass == 20.0);
}

TEST_CASE("a box with nothing but walls that reflect has no states of surfaces") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 3, speed: 2}]\nrun: {until: 1}\n"
        "film: {seconds: 1, fps: 10, panels: []}\n");
    const Recording run(
        Simulation(scene.gas, scene.run), timeline(scene), {},
        [](const Tick&, const Sample&, const AdvanceResult& its) { CHECK(its.surfaces.empty()); });
}

TEST_CASE("the chevrons of joined sides stay within the place of the gas") {
    for (const std::string walls : {"periodic", "{left: periodic, right: periodic}", "solid"}) {
        CAPTURE(walls);
        const Scene scene = test::scene_from("title: T\nbox: {size: [20, 10], walls: " + walls +
                                             "}\ngas: [{count: 3}]\nrun: {until: 1}\n");
        const Simulation simulation(scene.gas, scene.run);
        const BoxedGas none;
        const SurfaceView view(PanelContext{scene, simulation.particles(), 30, none});
        constexpr double unit = 10.0;
        const Rect place{100.0, 50.0, 400.0, 200.0};  // of the shape of the box
        const BoxMap map = view.map_in(place, unit, false);
        const std::array joined{scene.gas.box.is_periodic(0), scene.gas.box.is_periodic(1)};
        const double line = SurfaceSize::line * unit + 1e-9;  // walls are drawn around the box
        for (const std::vector<Point>& stroke : outline_of_box(map.frame, joined, unit))
            for (const Point& at : stroke) {
                CHECK(at.x >= place.x - line);
                CHECK(at.x <= place.right() + line);
                CHECK(at.y >= place.y - line);
                CHECK(at.y <= place.bottom() + line);
            }
        if (walls == "solid") CHECK(map.frame.width == doctest::Approx(place.width));
    }
}

namespace {

// Where the gas of a shot is, and the colour of the picture at a place of the scene in a frame.
struct Seen {
    const test::Shot& shot;
    FramePainter painter{*shot.panels};

    static BoxMap map_of(const test::Shot& shot, const Region& extent) {
        const Grid grid(shot.scene.film.layout, shot.scene.film.size);
        const Rect whole =
            shot.panels->gas().frame_in(grid.place(shot.scene.film.layout.gas), grid.unit());
        // The only margins here are those of a piston on the right, whose force is shown.
        const double margin =
            (SurfaceSize::bar + SurfaceSize::hatch + SurfaceSize::arrow) * grid.unit();
        const double above = SurfaceSize::label * grid.unit();
        const double scale = (whole.width - margin) / (extent.high[0] - extent.low[0]);
        return {{whole.x, whole.y + above, whole.width - margin, whole.height - above},
                extent.low,
                scale};
    }
    std::uint32_t at(std::size_t frame, Point pixel) {
        const PixelView view = painter.paint(shot.frames.at(frame)).pixels();
        return view.data[static_cast<int>(pixel.y) * view.stride + static_cast<int>(pixel.x)];
    }
};

Scene pushed_gas() {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 20, radius: 0.2, speed: 1, "
        "position: {within: [0, 0, 5, 10]}}]\nrun: {until: 4}\n"
        "film: {seconds: 4, fps: 5, panels: [], size: [960, 540]}\n");
    scene.gas.box.surfaces.sides[1] = Piston{100.0, -100.0};
    return scene;
}

}  // namespace

TEST_CASE("a piston is where it is, and what it has left is no box any more") {
    const test::Shot shot(pushed_gas());
    Seen seen{shot};
    const Theme& theme = theme_of(shot.scene.film.theme);
    const BoxMap map = Seen::map_of(shot, {{0.0, 0.0}, {20.0, 10.0}});
    const Point left_behind = map.pixel({19.5, 5.0}), kept = map.pixel({11.5, 5.0});
    CHECK(seen.at(0, left_behind) == to_pixel(theme.ground));
    CHECK(seen.at(0, kept) == to_pixel(theme.ground));
    const double time = shot.frames[19].tick.time;
    const double place = 20.0 - 0.5 * time * time;
    CHECK(seen.at(19, left_behind) == to_pixel(theme.page));
    CHECK(seen.at(19, kept) == to_pixel(theme.ground));
    const double unit = Grid(shot.scene.film.layout, shot.scene.film.size).unit();
    const Point face = map.pixel({place, 7.0});
    CHECK(seen.at(19, {face.x - 2.0, face.y}) == to_pixel(theme.ground));
    CHECK(seen.at(19, {face.x + 0.3 * unit, face.y}) == to_pixel(theme.muted));
}

TEST_CASE("a box that grows is drawn as large as it gets") {
    Scene scene = pushed_gas();
    scene.gas.box.surfaces.sides[1] = Driven{2.0};
    const test::Shot shot(scene);
    Seen seen{shot};
    const Theme& theme = theme_of(scene.film.theme);
    const Region extent{{0.0, 0.0}, {20.0 + 2.0 * shot.frames[19].tick.time, 10.0}};
    BoxMap map = Seen::map_of(shot, extent);
    map.frame.y -= SurfaceSize::label * Grid(scene.film.layout, scene.film.size).unit();
    CHECK(seen.at(0, map.pixel({26.5, 3.0})) == to_pixel(theme.page));
    CHECK(seen.at(19, map.pixel({26.5, 3.0})) == to_pixel(theme.ground));
}

TEST_CASE("all kinds of surfaces look different, without colour too") {
    const std::vector<Behaviour> kinds{Reflecting{},
                                       Piston{50.0},
                                       Piston{50.0, 5.0},
                                       Driven{0.5},
                                       Driven{0.0},
                                       Bath{2.0},
                                       Membrane{.species = {0}},
                                       Membrane{.upward = {1.0}, .downward = {0.0, 2.0}}};
    std::vector<std::vector<std::uint32_t>> pictures;
    for (const bool is_open : {false, true})
        for (const Behaviour& kind : kinds) {
            if (is_open && !std::holds_alternative<Reflecting>(kind)) continue;
            Scene scene = gas_with_piston("size: [640, 360], theme: print");
            scene.gas.box.surfaces.partitions[0].behaviour = kind;
            scene.gas.box.surfaces.partitions[0].is_open = is_open;
            const test::Shot shot(scene, 1);
            FramePainter painter(*shot.panels);
            pictures.push_back(test::pixels_of(painter.paint(shot.frames[0])));
        }
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) CHECK(pictures[i] != pictures[j]);
}

TEST_CASE("what is written on surfaces lies in the picture, and on nothing else that is written") {
    for (const std::string name : {"lecture", "square", "minimal", "portrait"}) {
        CAPTURE(name);
        Scene scene = gas_with_piston("size: [960, 540], template: " + name);
        Surfaces& surfaces = scene.gas.box.surfaces;
        surfaces.sides = {Bath{2.0}, Bath{1.5}, Bath{1.0}, Piston{200.0, -5.0}};
        for (int k = 0; k < 4; ++k)
            surfaces.partitions.push_back({.name = "m",
                                           .at = 10.0 + 0.5 * k,
                                           .behaviour = Membrane{.upward = {1.0 + 0.01 * k}}});
        surfaces.partitions.push_back({.name = "p", .at = 10.2, .behaviour = Bath{0.25}});
        const test::Shot shot(scene, 1);
        FramePainter painter(*shot.panels);
        TextLog log;
        painter.paint(shot.frames[0]);
        std::size_t marks = 0;
        for (const DrawnLine& line : log.lines)
            marks +=
                line.markup.find(" = ") != std::string::npos && !line.markup.starts_with("t = ");
        CHECK(marks == 6);
        for (std::size_t i = 0; i < log.lines.size(); ++i) {
            const Rect& a = log.lines[i].ink;
            CAPTURE(log.lines[i].markup);
            CHECK_FALSE(log.lines[i].is_cut);
            CHECK(a.x >= 0.0);
            CHECK(a.y >= 0.0);
            CHECK(a.right() <= 960.0);
            for (std::size_t j = 0; j < i; ++j) {
                const Rect& b = log.lines[j].ink;
                CAPTURE(log.lines[j].markup);
                CHECK((a.right() <= b.x || b.right() <= a.x || a.bottom() <= b.y ||
                       b.bottom() <= a.y));
            }
        }
    }
}

TEST_CASE("surfaces are in the account and in the table of the gas") {
    Scene scene = gas_with_piston();
    Surfaces& surfaces = scene.gas.box.surfaces;
    surfaces.sides[0] = Bath{2.0};
    surfaces.partitions.push_back({.name = "door", .at = 17.0, .is_open = true});
    surfaces.partitions.push_back(
        {.name = "demon", .at = 19.5, .behaviour = Membrane{{0}, {1.5}, {0.0, 0.5}}});
    surfaces.gravity = {0.0, -0.5};
    const test::Shot shot(scene, 1);
    const Panel& gas = shot.panels->gas();
    CHECK(gas.account(*shot.frames[0].states[0]) ==
          "The left wall is a heat bath of temperature 2. The partition “piston” is a piston of "
          "mass 20, at x = 9.00. The partition “window” stands still, at x = 15.0. The partition "
          "“door” "
          "is open. The partition “demon” lets a through, at x = 19.5.");
    const Table table = gas.table(*shot.frames[0].states[0], theme_of(scene.film.theme));
    std::string labels;
    for (const auto& row : table.rows)
        if (std::get<std::string>(row[0]) == "surface")
            labels += std::get<std::string>(row[7]) + "; ";
    CHECK(labels ==
          "left, T = 2; piston, M = 20; window; door, open; "
          "demon, lets a through, → v > 1.5, ← v < 0.5; ");
}

TEST_CASE("axes of positions are as wide as the box gets") {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 20, radius: 0.2, speed: 1}]\n"
        "run: {until: 4}\nfilm: {seconds: 4, fps: 5, size: [960, 540], panels: "
        "[{kind: position-histogram}, {kind: phase}]}\n");
    scene.gas.box.surfaces.sides[1] = Driven{2.0};
    const test::Shot shot(scene);
    const auto& panels = shot.panels->panels();
    for (const std::size_t k : {panels.size() - 2, panels.size() - 1}) {
        const auto& panel = static_cast<const PlotPanel&>(*panels.at(k).panel);
        CHECK(panel.plot(nullptr).x.high >= 27.5);
    }
}

TEST_CASE("a gas that a partition parts, or a side squeezes, has no one pressure") {
    const Box plain{.size = {20.0, 10.0}};
    CHECK(has_one_pressure(plain, {}));
    Box box = plain;
    box.surfaces.partitions.push_back({.name = "door", .at = 10.0});
    std::vector<SurfaceState> states(5);
    CHECK_FALSE(has_one_pressure(box, states));
    states[4].is_open = true;
    CHECK(has_one_pressure(box, states));
    states[2].motion = {0.0, 1.0};
    CHECK_FALSE(has_one_pressure(box, states));
    box = plain;
    box.surfaces.gravity = {0.0, -1.0};
    CHECK_FALSE(has_one_pressure(box, std::vector<SurfaceState>(4)));
}

TEST_CASE("events of surfaces are marked on time axes, and one bath is a level of temperature") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10], walls: {left: {temperature: 2}}}\npartitions: [{name: "
        "door, x: 10}]\ngas: [{name: a, count: 20, radius: 0.2, speed: 1}]\n"
        "run: {until: 4, events: [{at: 1, open: door}, {at: 1, heat: {of: all, by: 5}}, {at: 3, "
        "heat: {of: all, by: -5}}]}\n"
        "film: {seconds: 1, fps: 5, size: [960, 540], panels: [temperature]}\n");
    Run quiet;  // what happens is told by the scene
    quiet.until = 4.0;
    const Simulation start(scene.gas, quiet);
    PanelSet panels(scene, start.particles(), Simulation(start).sample());
    panels.record(start, timeline(scene), [](const Tick&, const Sample&, const AdvanceResult&) {});
    panels.fix_axes();
    const auto& panel = static_cast<const PlotPanel&>(*panels.panels().back().panel);
    std::string marks;
    const plot::Plot plot = panel.plot(nullptr);
    for (const plot::AnyLayer& layer : plot.layers) {
        if (const auto* marker = std::get_if<plot::Marker>(&layer))
            marks += marker->of + " " + std::to_string(static_cast<int>(marker->value)) + "; ";
        if (const auto* level = std::get_if<plot::Level>(&layer))
            CHECK((level->of == "bath" && level->value == 2.0));
    }
    CHECK(marks == "opened, heated 1; cooled 3; ");
}

TEST_CASE("words on events lie on nothing, or are left out") {
    // At 10 there is no room for words between the events, at 8 there is on the left.
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [40, 30]}\npartitions: [{name: door, x: 20}]\n"
        "gas: [{count: 20, radius: 0.4, temperature: 1, position: {side: left, of: door}}]\n"
        "run: {until: 40, events: [{at: 8, open: door}, {at: 10, move: right, velocity: -0.3}, "
        "{at: 13, move: right, velocity: 0}, {at: 16, wall: top, temperature: 2}]}\n"
        "film: {seconds: 1, fps: 5, size: [3100, 1080], template: data, panels: [temperature, "
        "entropy, "
        "pressure]}\n");
    const test::Shot shot(scene);
    const TextLog log;
    FramePainter(*shot.panels).paint(shot.frames.back());
    const auto drawn = [&](const char* word) {
        return std::ranges::count_if(log.lines,
                                     [&](const DrawnLine& line) { return line.markup == word; });
    };
    CHECK(drawn("opened") == 3);
    CHECK(drawn("T = 2") == 4);  // and at the wall
    CHECK(drawn("moved") == 0);
    CHECK(drawn("stopped") == 0);
}

TEST_CASE("a particle that falls has its corners where it collides") {
    Box box{.size = {20.0, 10.0}};
    box.surfaces.gravity = {0.0, -2.0};
    Flights flights(box, Run{}, 1, {0});
    const Eigen::ArrayXd none;
    const auto see = [&](double time, double y, double v,
                         const std::vector<Collision>& collisions) {
        Tick tick{};
        tick.time = time;
        Sample sample{time, Eigen::ArrayXXd(1, 2), Eigen::ArrayXXd(1, 2)};
        sample.position << 1.0, y;
        sample.velocity << 0.0, v;
        AdvanceResult advanced;
        advanced.collisions = collisions;
        return flights.see({tick, sample, none, none, advanced});
    };
    see(0.0, 4.0, 0.0, {});
    Collision bounce{};
    bounce.time = 2.0;
    bounce.first = 0;
    bounce.second = Side::bottom;
    bounce.first_position = {1.0, 0.0};
    bounce.first_before = {0.0, -4.0};
    bounce.first_after = {0.0, 4.0};
    const auto corners = see(3.0, 3.0, 2.0, {bounce});
    REQUIRE(corners.size() == 1);
    CHECK(corners[0].place[0] == 0.0);
    CHECK(corners[0].before[0] == doctest::Approx(-4.0));
    CHECK(corners[0].after[0] == 4.0);
}

TEST_CASE("the ends of a wire are drawn where they are, and as what they do") {
    Scene scene = test::scene_from(
        "title: T\nbox: {length: 12}\ngas: [{name: a, count: 5, radius: 0.2, speed: 1}]\n"
        "run: {until: 4}\nfilm: {seconds: 4, fps: 5, size: [960, 540], panels: []}\n");
    Simulation simulation(scene.gas, scene.run);
    Surfaces& surfaces = scene.gas.box.surfaces;
    surfaces.sides = {Bath{2.0}, Piston{5.0, -1.0}, Reflecting{}, Reflecting{}};
    surfaces.gravity = {-0.5, 0.0};
    PanelSet panels(scene, simulation.particles(), simulation.sample());
    std::vector<FrameData> frames;
    const std::vector<Tick> ticks = timeline(scene);
    const auto each = [&](const auto& see) {
        for (const Tick& tick : ticks) {
            AdvanceResult advanced;
            advanced.surfaces.resize(4);
            for (std::size_t k = 0; k < 4; ++k) advanced.surfaces[k].behaviour = surfaces.sides[k];
            advanced.surfaces[1].motion = {12.0 + tick.time, 1.0};
            see(tick, simulation.sample(), advanced);
        }
    };
    each([&](const auto&... input) { panels.survey(input...); });
    panels.fix_axes();
    each([&](const auto&... input) { frames.push_back(panels.frame_data(input...)); });
    CHECK(panels.gas().account(*frames.back().states[0]) ==
          "The left end is a heat bath of temperature 2. The right end is a piston of mass 5, "
          "pushed by a force of −1, at x = 16.0.");
    FramePainter painter(panels);
    TextLog log;
    const std::vector<std::uint32_t> first = test::pixels_of(painter.paint(frames.front()));
    std::string marks;
    for (const DrawnLine& line : log.lines)
        if (line.markup.find(" = ") != std::string::npos && !line.markup.starts_with("t = "))
            marks += line.markup + "; ";
    CHECK(marks == "T = 2; M = 5, F = −1; ");
    const PixelView last = painter.paint(frames.back()).pixels();
    // The end is at the right of the plot at last, and was at three quarters of the way.
    const Theme& theme = theme_of(scene.film.theme);
    const Grid grid(scene.film.layout, scene.film.size);
    const Rect area = grid.place(scene.film.layout.gas);
    const double u = grid.unit(), width = area.width - 6.6 * u;
    const auto pixel = [&](const auto& pixels, double place) {
        const double x = area.x + 3.4 * u + place / 16.0 * width + 0.25 * u;
        return pixels[static_cast<std::size_t>(area.y + 2.0 * u) * 960 +
                      static_cast<std::size_t>(x)];
    };
    CHECK(pixel(first, 12.0) == to_pixel(theme.muted));
    CHECK(pixel(first, 16.0) == to_pixel(theme.page));
    CHECK(pixel(last.data, 16.0) == to_pixel(theme.muted));
    CHECK(pixel(last.data, 12.0) == to_pixel(theme.page));
}

TEST_CASE("a narrow box has as many words on its surfaces as it has room for") {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [5, 16]}\ngas: [{name: a, count: 5, radius: 0.2, speed: 1}]\n"
        "run: {until: 4}\nfilm: {seconds: 4, fps: 5, size: [960, 540], template: lecture, "
        "panels: [{kind: pressure}]}\n");
    scene.gas.box.surfaces.sides = {Bath{2.0}, Bath{1.5}, Reflecting{}, Piston{200.0, -0.5}};
    const test::Shot shot(scene, 1);
    TextLog log;  // from the first on, as some is drawn once for all frames
    FramePainter painter(*shot.panels);
    painter.paint(shot.frames[0]);
    std::string marks;
    for (const DrawnLine& line : log.lines) {
        if (line.markup.find(" = ") != std::string::npos && !line.markup.starts_with("t = "))
            marks += line.markup + "; ";
        CAPTURE(line.markup);
        CHECK_FALSE(line.is_cut);
        CHECK(line.ink.x >= 0.0);
    }
    CHECK(marks == "F = −0.5; T = 1.5; T = 2; ");
    CHECK(std::ranges::any_of(log.lines, [](const DrawnLine& line) {
        return line.markup == "not defined for this gas";
    }));
}

TEST_CASE("a piston that is held is hatched, in the box and on a wire, and said to be held") {
    for (const std::string box : {"size: [20, 10]", "length: 20"}) {
        CAPTURE(box);
        Scene scene = test::scene_from(
            "title: T\nbox: {" + box +
            "}\ngas: [{name: a, count: 3, radius: 0.2, speed: 1}]\n"
            "run: {until: 4}\nfilm: {seconds: 4, fps: 5, size: [960, 540], panels: []}\n");
        Simulation simulation(scene.gas, scene.run);
        scene.gas.box.surfaces.sides[1] = Piston{5.0, -1.0};
        PanelSet panels(scene, simulation.particles(), simulation.sample());
        AdvanceResult advanced;
        advanced.surfaces.resize(4);
        advanced.surfaces[1].behaviour = scene.gas.box.surfaces.sides[1];
        advanced.surfaces[1].motion = {20.0, 0.0};
        panels.survey({}, simulation.sample(), advanced);
        panels.fix_axes();
        FramePainter painter(panels);
        std::vector<std::vector<std::uint32_t>> pictures;
        for (const bool is_held : {false, true}) {
            advanced.surfaces[1].is_held = is_held;
            const FrameData frame = panels.frame_data({}, simulation.sample(), advanced);
            pictures.push_back(test::pixels_of(painter.paint(frame)));
            const std::string account = panels.gas().account(*frame.states[0]);
            CHECK((account.find(", held, at x = 20.0.") != std::string::npos) == is_held);
        }
        CHECK(pictures[0] != pictures[1]);
    }
}

TEST_CASE("a side that is joined to the opposite one is dashed, with the same chevrons as that") {
    const Rect room{100.0, 50.0, 600.0, 300.0};
    const double unit = 20.0;
    const auto lines_of = [&](std::array<bool, 2> joined) {
        return outline_of_box(room, joined, unit);
    };
    CHECK(lines_of({false, false}).size() == 4);
    for (const bool is_across : {true, false}) {
        CAPTURE(is_across);
        std::vector<std::vector<Point>> first, second;  // of the side, and of the opposite one
        std::size_t chevrons = 0;
        double drawn = 0.0;
        for (const std::vector<Point>& line : lines_of({is_across, !is_across})) {
            const auto along = [&](const Point& at) { return is_across ? at.y : at.x; };
            const auto aside = [&](const Point& at) { return is_across ? at.x : at.y; };
            if (line.size() == 2 && aside(line[0]) != aside(line[1])) continue;  // a wall
            const bool is_first = aside(line[line.size() / 2]) < (is_across ? 400.0 : 200.0);
            if (is_first && line.size() == 3) ++chevrons;
            if (is_first && line.size() == 2) drawn += std::abs(along(line[0]) - along(line[1]));
            std::vector<Point> shifted = line;  // onto the other side
            const double across = is_across ? room.width + SurfaceSize::line * unit : 0.0;
            const double up = is_across ? 0.0 : room.height + SurfaceSize::line * unit;
            if (is_first)
                for (Point& at : shifted) at = {at.x + across, at.y + up};
            (is_first ? first : second).push_back(shifted);
        }
        CHECK(chevrons == (is_across ? 1 : 2));
        const double length = is_across ? room.height : room.width;
        CHECK(drawn > 0.4 * length);
        CHECK(drawn < 0.75 * length);
        REQUIRE(first.size() == second.size());
        for (std::size_t k = 0; k < first.size(); ++k)
            for (std::size_t i = 0; i < first[k].size(); ++i) {
                CHECK(first[k][i].x == doctest::Approx(second[k][i].x));
                CHECK(first[k][i].y == doctest::Approx(second[k][i].y));
            }
    }
}

// What a film shows for a while, or lays over the gas.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "panels/callouts/callout.h"
#include "panels/callouts/fade.h"
#include "panels/gas/camera.h"
#include "panels/gas/marks/spotlights.h"
#include "panels/gas/particle_panel.h"
#include "panels/plots/histogram_panel.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::pixels_of;
using test::Shot;

namespace {

Scene scene_of(const std::string& film,
               const std::string& gas = "{count: 40, radius: 0.5, speed: 1}") {
    return test::scene_from("title: T\nbox: {size: [40, 30]}\ngas: [" + gas +
                            "]\nrun: {until: 4}\nfilm: {size: [480, 270], fps: 10, seconds: 8, " +
                            film + "}\n");
}

// The way of the camera over a film.
std::vector<std::optional<CameraView>> way_of(const Scene& scene) {
    const StartedScene started = start_scene(scene);
    const Particles particles = started.simulation.particles();
    const BoxedGas none;
    const PanelContext context{scene, particles, frame_count(scene.film), none};
    Camera camera(context);
    Simulation run = started.simulation;
    std::vector<std::optional<CameraView>> way;
    const std::vector<Tick> ticks = timeline(scene);
    for (const Tick& tick : ticks) {
        const AdvanceResult advanced = run.advance_to(tick.time);
        const Sample sample = run.sample();
        const Eigen::ArrayXd speed = speeds(sample);
        camera.survey({tick, sample, speed, speed, advanced});
    }
    camera.fix_way({{0.0, 0.0}, scene.gas.box.size});
    for (std::size_t i = 0; i < ticks.size(); ++i) way.push_back(camera.next());
    return way;
}

}  // namespace

TEST_CASE("a panel is there from its time to its end, and its place stays free without it") {
    const Shot shot(scene_of(
        "panels: [temperature, {kind: speed-histogram, show: {from: 1, until: 3}}, entropy]"));
    const Shot always(scene_of("panels: [temperature, speed-histogram, entropy]"));
    const Shot never(
        scene_of("panels: [temperature, {kind: speed-histogram, show: {from: 3.999}}, entropy]"));
    FramePainter painter(*shot.panels), whole(*always.panels), without(*never.panels);
    double last = 0.0;
    for (const FrameData& frame : shot.frames) {
        const auto k = static_cast<std::size_t>(frame.tick.frame);
        const auto& panels = shot.panels->panels();
        const double seen = panels[panels.size() - 2].opacity(shot.scene.film, frame.tick);
        const bool there = frame.tick.time >= 1.0 && frame.tick.time < 3.0;
        CHECK((seen > 0.0) == there);
        CHECK(std::abs(seen - last) < 0.25);
        last = seen;
        CHECK(panels[panels.size() - 3].opacity(shot.scene.film, frame.tick) == 1.0);
        const auto pixels = pixels_of(painter.paint(frame));
        if (seen == 1.0) CHECK(pixels == pixels_of(whole.paint(always.frames[k])));
        if (seen == 0.0 && frame.tick.time < 3.9)
            CHECK(pixels == pixels_of(without.paint(never.frames[k])));
    }
}

TEST_CASE("what fades is mixed with what was there before") {
    Canvas canvas({8, 8}, Backdrop::transparent);
    canvas.fill({0, 0, 8, 8}, Color{1.0, 1.0, 1.0, 1.0});
    Fade fade(canvas, {2, 2, 4, 4});
    canvas.fill({2, 2, 4, 4}, Color{0.0, 0.0, 0.0, 1.0});
    fade.leave(0.25);
    const PixelView pixels = canvas.pixels();
    CHECK((pixels.data[3 * pixels.stride + 3] & 0xFF) == 191);
    CHECK((pixels.data[1 * pixels.stride + 1] & 0xFF) == 255);
}

TEST_CASE("a spotlight dims all others to 35 %, and two that follow one another leave no gap") {
    const Scene scene =
        scene_of("spotlight: [{from: 1, to: 2, of: [0, 3]}, {from: 2, to: 3, of: [0, 5]}]");
    const Particles particles = start_scene(scene).simulation.particles();
    const BoxedGas none;
    const Spotlights lights({scene, particles, frame_count(scene.film), none});
    for (const Tick& tick : timeline(scene)) {
        const std::vector<float> light = lights.light(tick);
        if (tick.time < 1.0 || tick.time >= 3.0) {
            CHECK(light.empty());
            continue;
        }
        REQUIRE(light.size() == 40);
        CHECK(light[0] == 1.0F);
        CHECK(std::ranges::min(light) >= 0.349F);
        if (tick.time > 1.3 && tick.time < 1.7) {
            CHECK(light[3] == 1.0F);
            CHECK(light[5] == doctest::Approx(0.35));
            CHECK(lights.rings(tick).size() == 2);
        }
    }
    const Tick moment{.time = 1.5};
    CHECK(Spotlights({scene, particles, 80, none, false}).light(moment)[7] ==
          doctest::Approx(0.35));
}

TEST_CASE("in a still a spotlight and a callout are whole from their first frame on") {
    const Shot shot(
        scene_of("spotlight: [{from: 1, to: 3, of: [3]}], callouts: [{at: 1, points_to: 3, text: "
                 "this one}]"));
    const std::unique_ptr<PanelSet> panels = shot.read_panels();
    int faint = 0, with_spotlight = 0;
    shot.runs.front().play(shot.frames.size(), [&](const Tick& tick, const Sample& sample,
                                                   const AdvanceResult& advanced) {
        const FrameData still = panels->frame_data(tick, sample, advanced, true);
        const auto& gas = dynamic_cast<const ParticleState&>(*still.states[0]);
        const auto& moving = dynamic_cast<const ParticleState&>(
            *shot.frames[static_cast<std::size_t>(tick.frame)].states[0]);
        REQUIRE(gas.callouts.size() == moving.callouts.size());
        REQUIRE(gas.light.size() == moving.light.size());
        for (std::size_t i = 0; i < gas.callouts.size(); ++i) {
            CHECK(gas.callouts[i].share == 1.0);
            faint += moving.callouts[i].share < 0.5;
        }
        if (gas.light.empty()) return;
        ++with_spotlight;
        CHECK(gas.light[7] == doctest::Approx(0.35));
        CHECK(gas.rings.front().share == 1.0);
    });
    CHECK(faint > 0);
    CHECK(with_spotlight > 0);
}

TEST_CASE("what comes and goes in one pause is there at its time") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 4, radius: 0.5, speed: 1}]\n"
        "run: {until: 4, events: [{at: 1, pause: 3}]}\nfilm: {fps: 10, seconds: 8}\n");
    const Showing shown = showing(timeline(scene), scene.film, {1.0, {}}, 1.0);
    CHECK(shown.last == shown.first + 9);
    CHECK(shown.holds(1.0));
    CHECK(!shown.holds(0.99));
    CHECK(!shown.holds(1.2));
}

TEST_CASE("the camera eases from view to view, and a particle that it follows is in the middle") {
    const Scene scene = scene_of(
        "camera: [{at: 1, view: [10, 10, 20, 17.5], over: 0.8}, {at: 2, follow: 0, width: 8}, {at: "
        "3.4, view: "
        "box, over: 0.8}]",
        "{count: 40, radius: 0.5, speed: 3}");
    const auto way = way_of(scene);
    const std::vector<Tick> ticks = timeline(scene);
    Simulation run = start_scene(scene).simulation;
    double last = 40.0;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        run.advance_to(ticks[i].time);
        const double width = way[i] ? way[i]->width : 40.0;
        CHECK(std::abs(std::log(width / last)) < 0.7);  // never a jump
        last = width;
        if (ticks[i].time < 1.0) CHECK(!way[i]);
        if (ticks[i].phase == Phase::moving && ticks[i].time > 1.9 && ticks[i].time < 2.0) {
            CHECK(way[i]->width == doctest::Approx(10.0));
            CHECK(way[i]->middle[0] == doctest::Approx(15.0));
            CHECK(way[i]->middle[1] == doctest::Approx(13.75));
        }
        if (ticks[i].time > 3.1 && ticks[i].time < 3.4) {
            CHECK(way[i]->width == doctest::Approx(8.0));
            CHECK(way[i]->middle[0] == run.sample().position(0, 0));
            CHECK(way[i]->middle[1] == run.sample().position(0, 1));
        }
    }
    CHECK(!way.back());
}

TEST_CASE("in a periodic box the camera follows a particle through the sides without a jump") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [40, 30], walls: periodic}\n"
        "gas: [{radius: 0.5, position: [[30, 15]], velocity: [[10, 2]]}]\nrun: {until: 9}\n"
        "film: {fps: 10, seconds: 12, camera: [{at: 0.5, follow: 0, width: 10}, {at: 5, view: "
        "box}]}\n");
    const auto way = way_of(scene);
    const std::vector<Tick> ticks = timeline(scene);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        if (!way[i] || !way[i - 1]) continue;
        const Vec moved = scene.gas.box.nearest(way[i]->middle - way[i - 1]->middle);
        CHECK(longest(abs(moved), 2) < 6.0);
        CHECK(way[i]->middle[0] >= 0.0);
        CHECK(way[i]->middle[0] < 40.0);
    }
    CHECK(!way.back());
}

TEST_CASE("where a wall moves the camera shows all of the part that is asked for") {
    const auto seen = [](const std::string& view) {
        const Shot shot(
            test::scene_from("title: T\nbox: {size: [10, 10], walls: {right: {velocity: 1}}}\n"
                             "gas: [{count: 4, radius: 0.3, temperature: 1}]\nrun: {until: 10}\n"
                             "film: {fps: 10, seconds: 2, camera: [{at: 0, view: " +
                             view + "}]}\n"));
        return *dynamic_cast<const ParticleState&>(*shot.frames.back().states[0]).view;
    };
    const CameraView high = seen("[2, 1, 4, 9]");  // of a box that becomes 20 by 10
    CHECK(high.width == doctest::Approx(16.0));
    CHECK(high.middle[0] == doctest::Approx(3.0));
    CHECK(high.middle[1] == doctest::Approx(5.0));
    const CameraView beyond = seen("[12, 1, 18, 9]");
    CHECK(beyond.middle[0] == doctest::Approx(15.0));
    CHECK_THROWS_AS(seen("[12, 1, 21, 9]"), SceneError);
}

TEST_CASE("the camera shows the part of a wire that is asked for, where an end moves") {
    const Shot shot(
        test::scene_from("title: T\nbox: {length: 10, walls: {right: {velocity: 1}}}\n"
                         "gas: [{count: 4, radius: 0.3, temperature: 1}]\nrun: {until: 10}\n"
                         "film: {fps: 10, seconds: 2, camera: [{at: 0, view: [12, 18]}]}\n"));
    const CameraView view = *dynamic_cast<const ParticleState&>(*shot.frames.back().states[0]).view;
    CHECK(view.width == doctest::Approx(6.0));
    CHECK(view.middle[0] == doctest::Approx(15.0));
}

TEST_CASE("between two views one point of the picture stands still") {
    const CameraView a{{20.0, 15.0}, 40.0}, b{{10.0, 12.0}, 8.0};
    // A point x is at share (x - middle) / width + 1/2: the same in both.
    const double still = (10.0 * 40.0 - 20.0 * 8.0) / 32.0;
    for (const double share : {0.1, 0.5, 0.9}) {
        const CameraView view = between(a, b, share);
        CHECK((still - view.middle[0]) / view.width ==
              doctest::Approx((still - a.middle[0]) / a.width));
    }
    CHECK(between(a, b, 0.5).width == doctest::Approx(std::sqrt(320.0)));
}

TEST_CASE("a callout stands clear of its particle on all of its way, and inside of the picture") {
    DiskPainter disks;
    const DrawContext dc{{0, 0, 600, 400}, 20.0, theme(ThemeKind::dark), disks};
    const CalloutPlate plate = callout_plate(dc, "this one was fast", 340.0);
    std::vector<Point> way;
    for (int i = 0; i < 60; ++i) way.push_back({60.0 + 5.0 * i, 200.0 + 100.0 * std::sin(0.2 * i)});
    const Rect place = free_place(dc, dc.area, plate, way, 15.0, {});
    for (const Point& at : way) {
        const double x = at.x - std::clamp(at.x, place.x, place.right());
        const double y = at.y - std::clamp(at.y, place.y, place.bottom());
        CHECK(std::hypot(x, y) > 15.0);
    }
    CHECK(place.x >= 0.0);
    CHECK(place.right() <= 600.0);
    const std::vector<Rect> taken{place};
    const Rect other = free_place(dc, dc.area, plate, way, 15.0, taken);
    const bool apart = other.x >= place.right() || other.right() <= place.x ||
                       other.y >= place.bottom() || other.bottom() <= place.y;
    CHECK(apart);
}

TEST_CASE("a callout points to the top of its bar, as high as it is then") {
    const Shot shot(
        scene_of("panels: [speed-histogram], callouts: [{at: 1, points_to: {panel: "
                 "speed-histogram, x: 1.01}, text: here}]"));
    DiskPainter disks;
    const DrawContext dc{{0, 0, 400, 300}, 12.0, theme(ThemeKind::dark), disks};
    const Panel& panel = *shot.panels->panels().back().panel;
    const PanelState &first = *shot.frames.front().states.back(),
                     &last = *shot.frames.back().states.back();
    const auto top = [&](const PanelState& state, double x) {
        return panel.place_of(dc, state, {0, x, {}})->y;
    };
    const auto level = [&](double y) { return panel.place_of(dc, first, {0, 0.75, y})->y; };
    // All begin at speed 1: below it a bar rises where there are particles at the end.
    const auto& histogram = dynamic_cast<const HistogramPanel&>(panel);
    int risen = 0;
    for (const plot::AnyLayer& layer : histogram.plot(&last).layers)
        if (const auto* bars = std::get_if<plot::Bars>(&layer))
            for (std::size_t k = 0; k < bars->value.size(); ++k) {
                const double x = 0.5 * (bars->from[k] + bars->to[k]);
                if (bars->to[k] > 0.9 || x <= 0.0) continue;
                CHECK(top(first, x) == doctest::Approx(level(0.0)));
                CHECK((top(last, x) < top(first, x) - 1.0) == (bars->value[k] > 0.0));
                risen += bars->value[k] > 0.0;
            }
    CHECK(risen > 0);
    CHECK(level(2.0) < level(1.0));
    CHECK(!panel.place_of(dc, first, {0, 1e6, {}}));
    CHECK(!shot.panels->panels()[1].panel->place_of(dc, *shot.frames[0].states[1], {0, 1.0, {}}));
}

TEST_CASE("films with everything over the gas are drawn, in a plane and on a line, as stills too") {
    const std::string over =
        "spotlight: [{from: 0.5, of: 0}], callouts: [{at: 0.5, points_to: 1, text: this one, for: "
        "9}], "
        "camera: [{at: 1, follow: 1, width: 5}]";
    const std::string line =
        "title: T\nbox: {length: 20, walls: periodic}\ngas: [{count: 6, radius: 0.3, speed: 1}]\n"
        "run: {until: 4}\nfilm: {size: [480, 270], fps: 10, seconds: 8, " +
        over + "}\n";
    for (const Scene& scene : {scene_of(over), test::scene_from(line)}) {
        const Shot shot(scene);
        FramePainter painter(*shot.panels);
        const FrameData& frame = shot.frames[50];
        const auto pixels = pixels_of(painter.paint(frame));
        CHECK(pixels != pixels_of(painter.paint(shot.frames[10])));
        CHECK(pixels == pixels_of(painter.paint(frame)));
        TextLog log;
        Canvas page({480, 270}, VectorFormat::svg, {"T", ""});
        painter.paint_on(page, frame);
        CHECK(std::ranges::count(log.lines, "this one", &DrawnLine::markup) == 1);
    }
}

// Whose trails a film shows, and how long they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "panels/chosen.h"
#include "panels/frame.h"
#include "panels/layout.h"
#include "panels/line/world_lines.h"
#include "panels/surfaces/surface_sizes.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

namespace {

Scene scene_of(const std::string& trails, const std::string& box = "size: [64, 48]") {
    return test::scene_from("title: T\nbox: {" + box +
                            "}\ngas: [{name: a, count: 5, speed: 1}, {name: b, count: 4, "
                            "speed: 1}, {name: c, count: 3, speed: 1, trail: 7}]\nrun: {until: 3}\n"
                            "film: {seconds: 3, fps: 10, size: [640, 360], panels: [], " +
                            trails + "}\n");
}

std::string trails_of(const std::string& trails) {
    const Scene scene = scene_of(trails);
    const Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    const PanelContext context{scene, simulation.particles(), 30, none};
    std::string seconds;
    for (Eigen::Index i = 0; i < 12; ++i) {
        const auto asked = asked_trail(context.scene, context.particles, i);
        seconds += asked ? std::to_string(static_cast<int>(*asked)) : "-";
    }
    return seconds;
}

}  // namespace

TEST_CASE("trails are of species and single particles, and a species' own trail wins") {
    CHECK(trails_of("theme: dark") == "---------777");
    CHECK(trails_of("trails: {of: b, seconds: 2}") == "-----2222777");
    CHECK(trails_of("trails: {of: 3}") == "---1-----777");
    CHECK(trails_of("trails: {of: [0, b, 10], seconds: 3}") == "3----3333777");
    CHECK(trails_of("trails: {of: all, seconds: 0}") == "000000000777");
}

TEST_CASE("a trail is drawn behind the particle that has one, and nowhere else") {
    const Shot with(scene_of("trails: {of: 3, seconds: 2}")),
        without(scene_of("trails: {of: 3, seconds: 0}"));
    FramePainter painter(*with.panels), plain(*without.panels);
    CHECK(test::pixels_of(painter.paint(with.frames.back())) !=
          test::pixels_of(plain.paint(without.frames.back())));
}

TEST_CASE("on a wire a bead with a trail stands out") {
    const Scene scene = scene_of("trails: {of: 3}", "length: 64");
    const Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    const PanelContext context{scene, simulation.particles(), 30, none};
    for (Eigen::Index i = 0; i < 12; ++i) CHECK(stands_out(context, i) == (i == 3 || i >= 9));
}

namespace {

// The pixels of the last frame's trail: where it differs from the frame without one, as shares of
// the way from the ground to white, one row from left to right; less than 0 where there is none.
std::vector<double> row_of_trail(const std::string& gas, const std::string& walls) {
    const auto shot = [&](const std::string& seconds) {
        return Shot(test::scene_from(
            "title: T\nbox: {size: [64, 48], walls: " + walls + "}\ngas: " + gas +
            "\nrun: {until: 3}\nfilm: {seconds: 4, fps: 20, size: [1280, "
            "720], template: lecture, panels: [temperature], trails: {of: 0, seconds: " +
            seconds + "}}\n"));
    };
    const Shot with = shot("2"), without = shot("0.05");
    FramePainter painter(*with.panels), plain(*without.panels);
    const PixelView view = painter.paint(with.frames.back()).pixels();
    const PixelView ground = plain.paint(without.frames.back()).pixels();
    const Grid grid(with.scene.film.layout, with.scene.film.size);
    const Rect place = grid.place(with.scene.film.layout.gas);
    const double margin = walls == "periodic" ? SurfaceSize::chevron * grid.unit() : 0.0;
    const Rect area{place.x + margin, place.y + margin, place.width - 2.0 * margin,
                    place.height - 2.0 * margin};
    const double scale = std::min(area.width / 64.0, area.height / 48.0);
    const int y = static_cast<int>(area.y + area.height / 2.0);
    std::vector<double> row;
    for (int x = static_cast<int>(area.x) + 1; x < static_cast<int>(area.x + 64.0 * scale) - 1;
         ++x) {
        const std::uint32_t pixel = view.data[y * view.stride + x];
        const bool differs = pixel != ground.data[y * ground.stride + x];
        row.push_back(differs ? static_cast<double>(pixel >> 8 & 0xFF) / 255.0 : -1.0);
    }
    return row;
}

}  // namespace

TEST_CASE("a trail is one line that grows brighter, however short its steps are") {
    double last = 0.0;
    int seen = 0;
    for (const double light :
         row_of_trail("[{count: 1, radius: 0.5, position: [20, 24], velocity: [6, 0]}]", "solid")) {
        if (light < 0.0) continue;
        CHECK(light >= last - 0.005);  // a step in one of 255 at most
        last = light;
        ++seen;
    }
    CHECK(seen > 100);
    CHECK(last > 0.6);
}

TEST_CASE("a trail goes up to the periodic side that its particle went through, and on behind it") {
    const std::vector<double> row =
        row_of_trail("[{count: 1, radius: 0.5, position: [10, 24], velocity: [20, 0]}]",
                     "periodic");  // ends at 6
    CHECK(row.front() >= 0.0);
    CHECK(row.back() >= 0.0);
    CHECK(row[row.size() / 4] < 0.0);
}

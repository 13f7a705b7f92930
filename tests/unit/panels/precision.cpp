// A film whose gas has enough bits to come home shows the way back as the mirror of the way out.
#include "panels/precision.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/load.h"
#include "support/resources.h"
#include "support/shot.h"

using namespace carom;

namespace {

Scene reversed_gas(const std::string& precision) {
    return load_scene_text(
        "title: There and back\nbox: {size: [24, 18]}\n"
        "gas: [{count: 60, radius: 0.6, speed: 3}]\n"
        "run: {until: 60, precision: " +
            precision +
            ", events: [{at: 30, reverse: velocities}]}\n"
            "film: {seconds: 4, size: [320, 180], template: minimal}\n",
        "test", test::resources());
}

// The part of the picture where the gas is.
std::vector<std::uint32_t> gas_of(const test::Shot& shot, const FrameData& frame) {
    FramePainter painter(*shot.panels);
    const PixelView view = painter.paint(frame).pixels();
    const Rect box = shot.panels->gas().frame_in(
        Grid(shot.scene.film.layout, shot.scene.film.size).place(shot.scene.film.layout.gas), 1.0);
    std::vector<std::uint32_t> pixels;
    for (int y = static_cast<int>(box.y); y < static_cast<int>(box.y + box.height); ++y)
        for (int x = static_cast<int>(box.x); x < static_cast<int>(box.x + box.width); ++x)
            pixels.push_back(view.data[y * view.stride + x]);
    return pixels;
}

}  // namespace

TEST_CASE("the way back is the way out, frame by frame, to the last pixel") {
    const Scene scene = start_scene(reversed_gas("auto")).scene;
    REQUIRE(scene.run.bits.has_value());
    CHECK(*scene.run.bits >= 128);
    const test::Shot shot(scene);
    const auto first = gas_of(shot, shot.frames.front());
    CHECK(first == gas_of(shot, shot.frames.back()));
    int compared = 0;
    for (std::size_t k = 0; k < shot.frames.size(); k += 6) {
        const double time = shot.frames[k].tick.time;
        if (time >= 30.0) break;
        const auto mirror = std::ranges::find_if(shot.frames, [&](const FrameData& frame) {
            return std::abs(frame.tick.time - (60.0 - time)) < 1e-9;
        });
        REQUIRE(mirror != shot.frames.end());
        const auto there = gas_of(shot, shot.frames[k]);
        CHECK(there == gas_of(shot, *mirror));
        if (time > 0.0) CHECK(there != first);
        ++compared;
    }
    CHECK(compared >= 5);
}

TEST_CASE("with doubles the last frame does not show the first") {
    const test::Shot shot(reversed_gas("double"));
    CHECK(gas_of(shot, shot.frames.front()) != gas_of(shot, shot.frames.back()));
}

TEST_CASE("what no bits can do is refused where it is written") {
    const auto message = [](const std::string& run) {
        const Scene scene =
            load_scene_text("title: A gas\nbox: {size: [60, 60]}\ngas: [{count: 16, speed: 1}]\n" +
                                run + "film: {seconds: 9}\n",
                            "test", test::resources());
        try {
            StartedScene started = start_scene(scene);
            with_places_of_errors(scene, [&] { started.simulation.advance_to(scene.run.until); });
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    const std::string too_long =
        message("run: {until: 4e5, precision: auto, events: [{at: 2e5, reverse: velocities}]}\n");
    CHECK(too_long.starts_with("test:4:30: error: a return after "));
    CHECK(too_long.find(" collisions of each particle takes some ") != std::string::npos);
    CHECK(too_long.find(" bits; the limit is 16384") != std::string::npos);
    CHECK(too_long.find("hint: reverse ") != std::string::npos);
    const std::string overlap = message(
        "run: {until: 9, events: [{at: 2, reverse: velocities}, "
        "{at: 2, nudge: {particle: 3, by: [-59.9, 0]}}]}\n");
    CHECK(overlap.starts_with("test:4:71: error: the nudge at time 2 would push particle 3 into "));
}

// What a film shows for a while, or lays over the gas.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "panels/fade.h"
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
        const double seen = shot.panels->panels()[3].opacity(shot.scene.film, frame.tick);
        const bool there = frame.tick.time >= 1.0 && frame.tick.time < 3.0;
        CHECK((seen > 0.0) == there);
        CHECK(std::abs(seen - last) < 0.25);
        last = seen;
        CHECK(shot.panels->panels()[2].opacity(shot.scene.film, frame.tick) == 1.0);
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

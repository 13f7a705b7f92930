// The cost of trails of all disks: a frame with trails against the same frame without.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "bench/measured.h"
#include "panels/frame.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "support/shot.h"

using namespace carom;

namespace {

constexpr int disks = 1000, frames = 60;

Scene scene_of(double seconds_of_trail) {
    return load_scene_text(
        fmt::format("title: Trails\nbox: {{size: [114, 86]}}\n"
                    "gas: [{{count: {}, radius: 0.5, temperature: 1}}]\nrun: {{until: 40}}\n"
                    "film: {{seconds: 10, panels: [], trails: {{seconds: {}}}}}\n",
                    disks, seconds_of_trail),
        "bench", scene_resources());
}

// CPU milliseconds for drawing a frame: the minimum of the frames in which all trails have full
// length.
double frame_ms(FramePainter& painter, const test::Shot& film) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const FrameData& frame : film.frames) {
        const double begin = test::cpu_seconds();
        painter.paint(frame);
        if (frame.tick.frame >= frames / 2)
            lowest = std::min(lowest, 1e3 * (test::cpu_seconds() - begin));
    }
    return lowest;
}

}  // namespace

int main() {
    constexpr double most = 12.0, most_microseconds = 5.0;
    const test::Shot with(scene_of(1.0), frames), without(scene_of(0.0), frames);
    FramePainter painter(*with.panels), plain(*without.panels);
    const double trails = frame_ms(painter, with), none = frame_ms(plain, without);
    const double each = 1e3 * (trails - none) / disks;
    fmt::print(
        "A frame of {} disks at 1080p: {:.2f} ms; with a trail of a second behind each: {:.2f} ms, "
        "{:.1f} times as much (at most {}); {:.1f} microseconds a trail (at most {})\n",
        disks, none, trails, trails / none, most, each, most_microseconds);
    return trails <= most * none && each <= most_microseconds ? 0 : 1;
}

// The cost of a still of a large gas, relative to the run that its axes need, both including
// placement: at most twice the time, for a million disks also without `--quick`, and bounded
// memory. Also checks that colours by mass cost about as much as colours by speed if each disk has
// a mass of its own. Fails if a bound is exceeded.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "bench/process_cost.h"
#include "films/render.h"
#include "runs/own_files.h"
#include "runs/run.h"
#include "scene/load.h"
#include "scene/scene.h"

using namespace carom;

namespace {

constexpr double most_of_bare = 2.0, most_bytes = 400.0, most_of_speed = 1.2;

Scene scene_of(std::int64_t count, const std::string& mass, const std::string& film) {
    const double side = std::sqrt(static_cast<double>(count) * 2.6);  // packing 0.3
    const std::string text = fmt::format(
        "title: T\nbox: {{size: [{0}, {0}]}}\ngas:\n"
        "  - {{name: gas, count: {1}, radius: 0.5, temperature: 1, mass: {2}}}\n"
        "run: {{until: 2}}\nfilm: {{{3}}}\n",
        side, count, mass, film);
    return load_scene_text(text, "bench", scene_resources());
}

test::Cost cost_of_still(const Scene& scene, bool is_quick) {
    return test::cost_of([&] {
        const double begin = test::cpu_seconds();
        Progress silent(Progress::Form::silent, "");
        draw_still_alone(scene, 0.0, is_quick, "", output_format("png"), silent);
        return begin;
    });
}

test::Cost cost_of_bare(Scene scene) {
    scene.run.sample_every = scene.run.until;
    return test::cost_of([&] {
        const double begin = test::cpu_seconds();
        run_physics(scene);
        return begin;
    });
}

bool still_is_cheap(std::int64_t count) {
    const Scene scene = scene_of(count, "1", "seconds: 10");
    const test::Cost bare = cost_of_bare(scene), quick = cost_of_still(scene, true),
                     whole = cost_of_still(scene, false);
    const double ratio = quick.seconds / bare.seconds,
                 ratio_of_whole = whole.seconds / bare.seconds,
                 bytes = std::max(quick.bytes, whole.bytes) / static_cast<double>(count);
    fmt::print(
        "{} disks: run {:.2f} s, still --quick {:.2f} s, still {:.2f} s; ratios {:.2f} and "
        "{:.2f} (at most {}), {:.0f} bytes a particle (at most {})\n",
        count, bare.seconds, quick.seconds, whole.seconds, ratio, ratio_of_whole, most_of_bare,
        bytes, most_bytes);
    const bool is_large = count >= 1'000'000;  // with fewer the program itself dominates
    return ratio <= most_of_bare &&
           (!is_large || (ratio_of_whole <= most_of_bare && bytes <= most_bytes));
}

bool masses_cost_as_speeds(int rounds) {
    const auto scene = [](const std::string& by) {
        return scene_of(40'000, "{uniform: [1, 3]}", "seconds: 2, color_by: " + by);
    };
    test::Cost speed, mass;
    for (int k = 0; k < rounds; ++k) {
        speed.keep_better(cost_of_still(scene("speed"), false));
        mass.keep_better(cost_of_still(scene("mass"), false));
    }
    const double ratio = mass.seconds / speed.seconds;
    fmt::print("color_by: speed {:.2f} s, mass {:.2f} s; ratio {:.2f} (at most {})\n",
               speed.seconds, mass.seconds, ratio, most_of_speed);
    return ratio <= most_of_speed;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const bool cheap = still_is_cheap(quick ? 100'000 : 1'000'000);
    return masses_cost_as_speeds(quick ? 2 : 5) && cheap ? 0 : 1;
}

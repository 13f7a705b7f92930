// The cost of sound in a film: the CPU time of whole films with sound against the same films
// without, with few collisions and with many.
// --quick: one run of each instead of three.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "bench/measured.h"
#include "films/render.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "support/files.h"
#include "util/progress.h"

using namespace carom;

namespace {

// A gas of packing fraction 0.3; each disk has about 9 collisions in a second of film.
Scene scene_of(int disks, const char* sound) {
    const double width = std::sqrt(disks * 0.785398 / 0.3 * 4.0 / 3.0);
    return load_scene_text(
        fmt::format("title: A gas\nbox: {{size: [{}, {}]}}\ngas: [{{count: {}, radius: 0.5, "
                    "temperature: 1}}]\nrun: {{until: 50}}\nfilm: {{seconds: 10, sound: {}}}\n",
                    width, 0.75 * width, disks, sound),
        "bench", scene_resources());
}

double cpu_seconds_of(const Scene& scene) {
    const test::TemporaryFolder folder;
    Progress silent(Progress::Form::silent, "");
    const double begin = test::cpu_seconds();
    render(scene, {.output = folder.path() / "film.mp4", .threads = 1}, silent);
    return test::cpu_seconds() - begin;
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 && std::strcmp(argv[1], "--quick") == 0 ? 1 : 3;
    constexpr double most = 1.1;
    bool good = true;
    for (const int disks : {10, 1000, 10'000}) {
        double with = std::numeric_limits<double>::infinity(), without = with;
        for (int i = 0; i < runs; ++i) {
            without = std::min(without, cpu_seconds_of(scene_of(disks, "none")));
            with = std::min(with, cpu_seconds_of(scene_of(disks, "collisions")));
        }
        fmt::print(
            "{:>6} disks: a film takes {:.2f} s of CPU, with sound {:.3f} times (at most {})\n",
            disks, without, with / without, most);
        good &= with <= most * without;
    }
    return good ? 0 : 1;
}

// The cost of a film of a long run relative to its bare simulation: the wall and CPU time of the
// first pass, which processes the run and stores it in a file, and of the second pass, which
// replays it.
// --quick: 20,000 disks instead of 100,000.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "bench/measured.h"
#include "films/first_pass.h"
#include "panels/recording.h"
#include "physics/simulation.h"
#include "runs/own_files.h"
#include "scene/load.h"
#include "scene/time/timeline.h"
#include "util/progress.h"
#include "util/stopwatch.h"

using namespace carom;

namespace {

// A gas of packing fraction 0.3 with about 90 collisions per disk, 300 frames and the usual panels.
Scene scene_of(int disks) {
    const double width = std::sqrt(disks * 0.785398 / 0.3 * 4.0 / 3.0);
    return load_scene_text(
        fmt::format("title: A long run\nbox: {{size: [{}, {}]}}\ngas: [{{count: {}, radius: 0.5, "
                    "temperature: 1}}]\nrun: {{until: 80}}\nfilm: {{seconds: 10}}\n",
                    width, 0.75 * width, disks),
        "bench", scene_resources());
}

struct Seconds {
    double wall, cpu;
};

template <class Work>
Seconds seconds_of(const Work& work) {
    const Stopwatch watch;
    const double begin = test::cpu_seconds();
    work();
    return {watch.wall(), test::cpu_seconds() - begin};
}

Seconds median(std::vector<Seconds> all) {
    const auto middle = [&](double Seconds::*which) {
        std::ranges::sort(all, {}, which);
        return all[all.size() / 2].*which;
    };
    return {middle(&Seconds::wall), middle(&Seconds::cpu)};
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    const Scene scene = scene_of(quick ? 20'000 : 100'000);
    constexpr int runs = 5;
    constexpr double most_wall = 1.2, most_again = 0.2;
    Progress silent(Progress::Form::silent, "");
    std::vector<Seconds> bare, first, again;
    bool good = true;
    for (int i = 0; i < runs; ++i) {
        bare.push_back(seconds_of([&] {
            Simulation simulation(scene.gas, scene.run);
            for (const Tick& tick : timeline(scene)) simulation.advance_to(tick.time);
        }));
        FilmPlan plan;
        first.push_back(seconds_of(
            [&] { plan = prepare(scene, {.output = "film.mp4", .threads = 2}, silent); }));
        again.push_back(seconds_of([&] {
            FilmFrames(plan).go_to(plan.frames_to_play(),
                                   [](const FrameData&, const AdvanceResult&) {});
        }));
        good &= plan.passes.size() == 1;
    }
    const Seconds of_bare = median(bare), of_first = median(first), of_again = median(again);
    fmt::print(
        "A run of {} disks: {:.1f} s alone. Seen by panels, and kept in a file, on two cores: wall "
        "{:.2f} times (at most {}), CPU {:.2f} times; simulated {}. The frames once more for "
        "drawing: {:.2f} times (at most {})\n",
        scene.gas.species.front().count, of_bare.wall, of_first.wall / of_bare.wall, most_wall,
        of_first.cpu / of_bare.cpu, good ? "once" : "more than once", of_again.cpu / of_bare.cpu,
        most_again);
    good &= of_first.wall <= most_wall * of_bare.wall && of_again.cpu <= most_again * of_bare.cpu;
    return good ? 0 : 1;
}

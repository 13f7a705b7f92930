// The cost of the samples of a run in addition to its physics, from 10^4 to 10^6 disks: with a
// thousand samples, as for a scene without a film, at most twice the time of two samples. Also the
// peak memory of `carom run`. Fails if a bound is exceeded.
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bench/process_cost.h"
#include "runs/run.h"
#include "scene/scene.h"
#include "support/equal_disks.h"
#include "support/files.h"

using namespace carom;

namespace {

constexpr double most_of_bare = 2.0;
constexpr double most_bytes = 180.0;  // 17 of them are the program and its libraries

Scene scene_of(std::int64_t count, double until, double samples) {
    Scene scene;
    scene.gas = test::equal_disks(0.3, count);
    scene.gas.box.walls = {Wall::solid, Wall::solid};
    scene.run.until = until;
    scene.run.sample_every = until / samples;
    return scene;
}

// The cost of the run from time 0 on.
test::Cost cost_of(const Scene& scene) {
    return test::cost_of([&] {
        double begin = 0.0;
        run_physics(scene, {}, {.started = [&] { begin = test::cpu_seconds(); }});
        return begin;
    });
}

bool samples_are_cheap(std::int64_t count, double until, int rounds) {
    test::Cost bare, usual;
    for (int k = 0; k < rounds; ++k) {
        bare.keep_better(cost_of(scene_of(count, until, 1)));
        usual.keep_better(cost_of(scene_of(count, until, 1000)));
    }
    const double ratio = usual.seconds / bare.seconds;
    fmt::print("{:9} {:6} {:10.2f} {:14.2f} {:8.2f} (at most {})\n", count, until, bare.seconds,
               usual.seconds, ratio, most_of_bare);
    return ratio <= most_of_bare;
}

// Peak memory of the program per disk, for a million disks at packing fraction 0.3, placed at
// random.
double bytes_of_a_disk() {
    const test::TemporaryFolder folder;
    const auto scene = folder.write("scene.yaml",
                                    "title: A gas\nbox: {size: [1618, 1618]}\n"
                                    "gas: [{count: 1e6, radius: 0.5, temperature: 1}]\n"
                                    "run: {until: 2}\n");
    const std::vector<std::string> command{test::carom_program(), "run", scene.string(), "--quiet"};
    return test::cost_of_program(command).bytes / 1e6;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const int rounds = quick ? 1 : 5;
    fmt::print("    disks  until   2 samples   1001 samples    ratio\n");
    bool good = true;
    for (const double until : {20.0, 200.0})
        good = samples_are_cheap(10'000, until, rounds) && good;
    for (const double until : {2.0, 20.0}) good = samples_are_cheap(100'000, until, rounds) && good;
    good = samples_are_cheap(1'000'000, 2.0, quick ? 1 : 3) && good;
    const double bytes = bytes_of_a_disk();
    fmt::print("memory of `carom run` at its peak, 10^6 disks: {:.0f} bytes a disk (at most {})\n",
               bytes, most_bytes);
    return good && bytes <= most_bytes ? 0 : 1;
}

// What the samples of a run cost beside its physics, from 10^4 to 10^6 disks: with a thousand
// samples, as a scene without a film has them, at most twice the time of two. And the memory of the
// process at its peak. Fails if not.
#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "bench/process_cost.h"
#include "runs/run.h"
#include "support/equal_disks.h"

using namespace carom;

namespace {

constexpr double most_of_bare = 2.0;
constexpr double most_bytes = 240.0;  // some 50 of them are the program and its libraries

Scene scene_of(std::int64_t count, double until, double samples) {
    Scene scene;
    scene.gas = test::equal_disks(0.3, count);
    scene.gas.box.walls = {Wall::solid, Wall::solid};
    scene.run.until = until;
    scene.run.sample_every = until / samples;
    return scene;
}

// From time 0 on.
test::Cost cost_of(const Scene& scene) {
    return test::cost_of([&] {
        double begin = 0.0;
        run_physics(scene, {}, {.started = [&] { begin = test::cpu_seconds(); }});
        return begin;
    });
}

// And the bytes that each particle takes.
bool samples_are_cheap(std::int64_t count, double until, int rounds, double& bytes) {
    test::Cost bare, usual;
    for (int k = 0; k < rounds; ++k) {
        bare.keep_better(cost_of(scene_of(count, until, 1)));
        usual.keep_better(cost_of(scene_of(count, until, 1000)));
    }
    bytes = usual.bytes / static_cast<double>(count);
    const double ratio = usual.seconds / bare.seconds;
    fmt::print("{:9} {:6} {:10.2f} {:14.2f} {:8.2f} (at most {})\n", count, until, bare.seconds,
               usual.seconds, ratio, most_of_bare);
    return ratio <= most_of_bare;
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
    const int rounds = quick ? 1 : 5;
    fmt::print("    disks  until   2 samples   1001 samples    ratio\n");
    bool good = true;
    double bytes = 0.0;
    for (const double until : {20.0, 200.0})
        good = samples_are_cheap(10'000, until, rounds, bytes) && good;
    for (const double until : {2.0, 20.0})
        good = samples_are_cheap(100'000, until, rounds, bytes) && good;
    good = samples_are_cheap(1'000'000, 2.0, quick ? 1 : 3, bytes) && good;
    fmt::print(
        "memory of the process at its peak, 10^6 disks: {:.0f} bytes a particle (at most "
        "{})\n",
        bytes, most_bytes);
    return good && bytes <= most_bytes ? 0 : 1;
}

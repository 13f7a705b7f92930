// A run that was recorded in memory, in a file or not at all shows the same frames.
#include "panels/recording.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "panels/archived.h"
#include "physics/simulation.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "support/scene_text.h"
#include "util/archive.h"

using namespace carom;

namespace {

constexpr Recording::Room in_file{.memory = 20'000, .file = 1 << 30},
    nowhere{.memory = 0, .file = 0};

Scene scene_of(const std::string& box) {
    return test::scene_from("title: T\nbox: {" + box +
                            "}\ngas: [{count: 30, radius: 0.1, speed: 1}]\nrun: {until: 6, events: "
                            "[{at: 2, reverse: velocities}, {at: 3, pause: 0.5}]}\n"
                            "film: {size: [320, 180], fps: 10, seconds: 4, panels: []}\n");
}

// All that a viewer is shown, as bytes.
struct Seen {
    std::vector<std::string> frames;
    void operator()(const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
        Archive archive;
        Tick its_tick = tick;
        Sample its_sample = sample;
        AdvanceResult its = advanced;
        its.return_distance.reset();  // of the first pass only
        std::vector<Collision> collisions(advanced.collisions.begin(), advanced.collisions.end());
        archive(its_tick, its_sample, its, collisions);
        frames.push_back(archive.finished());
    }
};

Recording record(const Scene& scene, const Recording::Room& room, Seen& seen, bool aside) {
    return {Simulation(scene.gas, scene.run), timeline(scene),
            Recording::Wanted{.collisions = true, .aside = aside}, std::ref(seen), room};
}

std::vector<std::string> shown(const Recording& recording) {
    Seen seen;
    recording.play(recording.ticks().size(), std::ref(seen));
    return seen.frames;
}

}  // namespace

TEST_CASE("frames from memory, a file and a second run are those of the first, bit for bit") {
    for (const char* box : {"size: [12, 9]", "length: 40"})
        for (const bool aside : {false, true})
            for (const Recording::Room& room : {Recording::Room{}, in_file, nowhere}) {
                CAPTURE(box);
                CAPTURE(room.memory);
                const Scene scene = scene_of(box);
                Seen seen;
                const Recording recording = record(scene, room, seen, aside);
                REQUIRE(seen.frames.size() == recording.ticks().size());
                CHECK(recording.is_kept() == (room.memory > 0));
                CHECK((shown(recording) == seen.frames));
                CHECK((shown(recording) == seen.frames));
            }
}

TEST_CASE("parts of a recording in a file are read from it, and written whole") {
    const Scene scene = scene_of("size: [12, 9]");
    Seen seen;
    const Recording recording = record(scene, in_file, seen, false);
    const std::size_t size = recording.ticks().size();
    for (std::size_t first = 0; first < size; first += 3) {
        const std::size_t end = std::min(size, first + 5);
        Recording part = recording.part(first, end);
        const std::vector<std::string> frames(seen.frames.begin() + std::ptrdiff_t(first),
                                              seen.frames.begin() + std::ptrdiff_t(end));
        CHECK((shown(part) == frames));
        Archive written;
        const Simulation start(scene.gas, scene.run);
        part.archive(written, scene.gas.box, start.particles(), scene.run);
        Archive read(written.finished(), "a part");
        Recording again;
        again.archive(read, scene.gas.box, start.particles(), scene.run);
        read.expect_end();
        CHECK(again.is_kept());
        CHECK((shown(again) == frames));
    }
}

TEST_CASE("a run that has no room in its file is simulated again") {
    const Scene scene = scene_of("size: [12, 9]");
    Seen seen;
    const Recording recording = record(scene, {.memory = 20'000, .file = 10'000}, seen, false);
    CHECK_FALSE(recording.is_kept());
    CHECK((shown(recording) == seen.frames));
}

TEST_CASE("what a viewer throws ends the recording, on its own thread too") {
    const Scene scene = scene_of("size: [12, 9]");
    for (const bool aside : {false, true}) {
        int seen = 0;
        const auto refuse = [&](const Tick&, const Sample&, const AdvanceResult&) {
            if (++seen == 5) throw std::runtime_error("five");
        };
        const auto record_it = [&] {
            Recording(Simulation(scene.gas, scene.run), timeline(scene),
                      Recording::Wanted{.aside = aside}, refuse);
        };
        CHECK_THROWS_WITH(record_it(), "five");
        CHECK(seen == 5);
    }
}

// Surfaces that act, as panels see them.
#include <doctest/doctest.h>

#include <vector>

#include "panels/archived.h"
#include "panels/recording.h"
#include "support/scene_text.h"
#include "util/archive.h"

using namespace carom;

namespace {

// A gas on the left of a piston that nothing else pushes; a window and a peg on its right.
Scene gas_with_piston(const std::string& film = "size: [640, 360]") {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 30, radius: 0.3, speed: 2, "
        "position: {within: [0, 0, 8, 10]}}]\nrun: {until: 3}\n"
        "film: {seconds: 2, fps: 10, panels: [], " +
        film + "}\n");
    Surfaces& surfaces = scene.gas.box.surfaces;
    surfaces.partitions.push_back({.name = "piston", .at = 9.0, .behaviour = Piston{20.0}});
    surfaces.partitions.push_back({.name = "window", .at = 15.0, .gaps = {{4.0, 6.0}}});
    surfaces.obstacles.push_back({"peg", Obstacle::Disk{{18.0, 5.0}, 1.0}});
    return scene;
}

bool is_same(const SurfaceState& a, const SurfaceState& b) {
    return a.hits == b.hits && (a.impulse == b.impulse).all() && a.work == b.work &&
           a.heat == b.heat && a.is_open == b.is_open &&
           a.behaviour.index() == b.behaviour.index() &&
           a.motion.has_value() == b.motion.has_value() &&
           (!a.motion ||
            (a.motion->place == b.motion->place && a.motion->velocity == b.motion->velocity));
}

std::vector<SurfaceState> frame_of(const Recording& run, int wanted) {
    std::vector<SurfaceState> states;
    run.play(run.ticks().size(), [&](const Tick& tick, const Sample&, const AdvanceResult& its) {
        if (tick.frame == wanted) states = its.surfaces;
    });
    return states;
}

}  // namespace

TEST_CASE("every frame of a recording has the surfaces as they are then") {
    const Scene scene = gas_with_piston();
    const Simulation start(scene.gas, scene.run);
    Simulation simulation = start;
    std::vector<double> places;
    const auto see = [&](const Tick& tick, const Sample&, const AdvanceResult& advanced) {
        simulation.advance_to(tick.time);
        const std::vector<SurfaceState> expected = simulation.surfaces();
        REQUIRE(advanced.surfaces.size() == 7);
        for (std::size_t k = 0; k < expected.size(); ++k)
            CHECK(is_same(advanced.surfaces[k], expected[k]));
        places.push_back(advanced.surfaces[4].motion->place);
    };
    Recording run(start, timeline(scene), {}, see);
    CHECK(places.front() == 9.0);
    CHECK(places.back() > 9.5);
    const std::vector<SurfaceState> last = frame_of(run, 19);
    CHECK(last.at(4).motion->place == places.back());

    Archive written;
    run.archive(written, {});
    Archive read(written.finished(), "a run");
    Recording again;
    again.archive(read, {});
    const std::vector<SurfaceState> found = frame_of(again, 19);
    REQUIRE(found.size() == last.size());
    for (std::size_t k = 0; k < last.size(); ++k) CHECK(is_same(found[k], last[k]));
    CHECK(std::get<Piston>(found[4].behaviour).mass == 20.0);
}

TEST_CASE("a box with nothing but walls that reflect has no states of surfaces") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 3, speed: 2}]\nrun: {until: 1}\n"
        "film: {seconds: 1, fps: 10, panels: []}\n");
    const Recording run(
        Simulation(scene.gas, scene.run), timeline(scene), {},
        [](const Tick&, const Sample&, const AdvanceResult& its) { CHECK(its.surfaces.empty()); });
}

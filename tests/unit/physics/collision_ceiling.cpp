// A run whose collisions follow ever faster ends at its ceiling, at the same collision on any way
// there, with what is seen of them.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/collision_error.h"
#include "support/bodies.h"
#include "support/checkpoint.h"

using namespace carom;
using test::Disk;

namespace {

constexpr double fixed = 0.0;  // the inverse of an infinite mass

struct Case {
    std::string about;
    Box box;
    std::vector<Disk> disks;
    int bits = bits_of_double;
};

Box room(int dimension) { return {dimension, {20.0, dimension == 1 ? 0.0 : 10.0}, {}}; }

Box with_obstacle() {
    Box box = room(2);
    box.surfaces.obstacles = {{"post", Obstacle::Ball{{2.0, 2.0}, 1.0}}};
    return box;
}

// Between two posts a disk has 1/512 of room and a speed of 1: it meets one of them every 1/512.
// Another flies from wall to wall.
const std::vector<Disk> trapped{{5, 5, 0, 0, 1, fixed},
                                {7 + 1.0 / 512, 5, 0, 0, 1, fixed},
                                {15, 8, 0.25, 0, 0.5},
                                {6 + 0.5 / 512, 5, 1, 0, 0}};

const std::vector<Case> cases{{"disks", room(2), trapped},
                              {"beads", room(1), trapped},
                              {"beside an obstacle", with_obstacle(), trapped},
                              {"disks of many bits", room(2), trapped, 128},
                              {"beads of many bits", room(1), trapped, 128}};

Run run_of(const Case& its) {
    Run run;
    run.bits = its.bits;
    run.most_collisions = 10'000;
    return run;
}

// What a run says that is advanced in steps, and saved and read back at some time.
TooManyCollisions error_of(const Case& its, double step, std::optional<double> saved = {}) {
    const Run run = run_of(its);
    Simulation simulation = test::simulation_of(its.box, its.disks, run);
    try {
        for (double time = step; time <= 100.0; time += step) {
            simulation.advance_to(time);
            if (saved && time >= *saved) {
                simulation = test::restored(simulation, run, test::written(simulation));
                saved.reset();
            }
        }
    } catch (const TooManyCollisions& error) {
        return error;
    }
    return TooManyCollisions({});
}

}  // namespace

TEST_CASE("a trapped disk ends the run at the ceiling, with its rate, its number and its place") {
    for (const Case& its : cases) {
        CAPTURE(its.about);
        const TooManyCollisions error = error_of(its, 100.0);
        const std::string what = error.what();
        CAPTURE(what);
        // 512 collisions in a unit of time, and those of the other with the walls
        CHECK(what.starts_with("at time 19.5"));
        CHECK(what.find("the run has had 10000 collisions, the most that it may have") !=
              std::string::npos);
        CHECK(what.find("a rate of 512") != std::string::npos);
        CHECK(what.find(its.box.dimension == 1 ? "particle 3, at x = 6"
                                               : "particle 3, at (6, 5)") != std::string::npos);
        CHECK(error.particle() == 3);
        CHECK(error.hint().find("`run.most_collisions`") != std::string::npos);
    }
}

TEST_CASE("the ceiling is at the same collision in steps, and in a run that goes on elsewhere") {
    for (const Case& its : cases) {
        CAPTURE(its.about);
        const std::string whole = error_of(its, 100.0).what();
        CHECK(error_of(its, 0.125).what() == whole);
        CHECK(error_of(its, 0.125, 10.0).what() == whole);
    }
}

TEST_CASE("fixed time steps have the ceiling too") {
    Run run;
    run.time_step = 1.0 / 512;
    run.most_collisions = 100;
    Simulation simulation = test::simulation_of(
        room(2), {{5, 5, 0, 0, 1, fixed}, {7.25, 5, 0, 0, 1, fixed}, {6.125, 5, 1, 0, 0.0625}},
        run);
    CHECK_THROWS_AS(simulation.advance_to(1000.0), TooManyCollisions);
}

TEST_CASE("the ceiling grows with the number of particles, and a run may name another") {
    CHECK(collision_ceiling(Run{}, 10) == 1'000'000'000);
    CHECK(collision_ceiling(Run{}, 2'000'000) == 10'000'000'000);
    Run run;
    run.most_collisions = 7;
    CHECK(collision_ceiling(run, 2'000'000) == 7);
}

TEST_CASE("a run may have just as many collisions as its ceiling says") {
    Run run;
    run.most_collisions = 3;
    // It meets the walls at 1, 3, 5 and 7.
    const auto advanced = [&](double time) {
        Simulation one = test::simulation_of({2, {4.0, 4.0}, {}}, {{2, 2, 1, 0, 1}}, run);
        return one.advance_to(time).counts.wall;
    };
    CHECK(advanced(6.0) == 3);
    CHECK_THROWS_AS(advanced(8.0), TooManyCollisions);
}

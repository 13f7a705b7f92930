// Surfaces in the reports of a run, and in the words beside a film.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "app/report/run_facts.h"
#include "app/report/surfaces_csv.h"
#include "films/words/film_text.h"
#include "panels/recording.h"
#include "runs/json.h"
#include "runs/run.h"
#include "scene/describe.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "support/process.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// A disk between two walls and a heavy piston that moves by 1 a unit of time; the disk stands.
Scene drifting_piston() {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{name: a, count: 1, radius: 0.5, position: [[2, "
        "5]], velocity: [[0, 1]]}]\nrun: {until: 4, sample_every: 1}\n"
        "film: {seconds: 4, fps: 10, size: [320, 180], panels: []}\n");
    Surfaces& surfaces = scene.gas.box.surfaces;
    surfaces.partitions.push_back(
        {.name = "piston", .at = 10.0, .behaviour = Piston{4.0, 0.0, 1.0}});
    surfaces.obstacles.push_back({"a, peg", Obstacle::Ball{{17.0, 5.0}, 1.0}});
    return scene;
}

}  // namespace

TEST_CASE("a run reports what its surfaces have done, and where the energy is") {
    const Scene scene = drifting_piston();
    const RunReport report = run_physics(scene);
    const Json json = Json::parse(run_json(scene, report));
    const Json& surfaces = json.at("surfaces");
    REQUIRE(surfaces.size() == 6);
    std::string names;
    for (const Json& surface : surfaces) names += surface.at("name").get<std::string>() + "; ";
    CHECK(names == "left; right; bottom; top; piston; a, peg; ");
    // The disk of mass 1 meets the top at 4.5.
    CHECK(surfaces[3].at("hits") == 0);
    CHECK(surfaces[0].at("position").is_null());
    CHECK(surfaces[5].at("position").is_null());
    const Json& position = surfaces[4].at("position");  // 10, 11, 12, 13, 14
    CHECK(position.at("mean").get<double>() == doctest::Approx(12.0));
    CHECK(position.at("deviation").get<double>() == doctest::Approx(std::sqrt(2.0)));
    CHECK(position.at("last").get<double>() == doctest::Approx(14.0));
    const Json& account = json.at("energy").at("account");
    CHECK(account.at("kinetic") == 0.5);
    CHECK(account.at("pistons") == 2.0);
    for (const char* name : {"potential", "work", "heat"}) CHECK(account.at(name) == 0.0);
    CHECK(account.at("relative_error").get<double>() < 1e-12);
    CHECK(json.at("energy").at("largest_relative_error").is_null());
    CHECK(json.at("pressure").at("wall").is_null());
    CHECK(json.at("pressure").at("virial").is_null());
    const std::string table = run_table(scene, report);
    CHECK(table.find("kinetic 0.5, pistons 2 at the end") != std::string::npos);
    CHECK(table.find("12 ± 1.4142, 14 at the end") != std::string::npos);
}

TEST_CASE("a run beside surfaces in which an infinite mass moves has no error of the energy") {
    Scene scene = drifting_piston();
    scene.gas.species[0].mass = Infinite{};
    const RunReport report = run_physics(scene);
    const Json json = Json::parse(run_json(scene, report));
    CHECK(json.at("energy").at("account").at("relative_error").is_null());
    const std::string table = run_table(scene, report);
    CHECK(table.find("relative error") == std::string::npos);
    CHECK(table.find("at the end; not conserved: an infinite mass moves") != std::string::npos);
}

TEST_CASE("the pressure in a report counts from when the last partition has opened") {
    Scene scene = drifting_piston();
    Surfaces& surfaces = scene.gas.box.surfaces;
    surfaces.obstacles.clear();
    surfaces.partitions = {{.name = "door", .at = 10.0}};
    scene.run.until = 40.0;
    // The disk of mass 1 meets the bottom and the top, 9 apart, with momentum 2 at 4.5, 13.5, ...
    scene.run.events = {{11.5, SetOpen{4, true}}};
    const RunReport report = run_physics(scene);
    CHECK(report.summary.pressure_since == 11.5);
    // At 13.5, 22.5 and 31.5; both ends and both sides are 60 long.
    CHECK(*report.summary.wall_pressure == doctest::Approx(3 * 2.0 / (60.0 * 28.5)));
    CHECK(Json::parse(run_json(scene, report)).at("pressure").at("since") == 11.5);
    CHECK(run_table(scene, report).find("on the walls, from time 11.5 on") != std::string::npos);
    scene.run.events.clear();
    CHECK_FALSE(run_physics(scene).summary.wall_pressure);
}

TEST_CASE("a gas that is crushed on the way is reported at the surface that does it") {
    const std::string text =
        "title: T\nbox: {size: [6, 2]}\npartitions: [{name: plate, x: 0.5, velocity: 0.5}]\n"
        "gas: [{count: 8, radius: 0.3, speed: 0.1, position: {side: right, of: plate}}]\n"
        "run: {until: 10, sample_every: 1}\n"
        "film: {seconds: 4, fps: 10, size: [320, 180], panels: []}\n";
    const Scene scene = test::scene_from(text);
    try {
        run_physics(scene);
        FAIL("eight disks have no room between the plate and the wall");
    } catch (const SceneError& error) {
        REQUIRE(error.diagnostics().size() == 1);
        const Diagnostic& found = error.diagnostics().front();
        CHECK(found.span.line == 3);
        CHECK(found.message.starts_with("`plate` crushes the gas at time 7."));
        CHECK(found.message.find(", where it is at x = 4.") != std::string::npos);
        CHECK_FALSE(found.hint.empty());
    }
}

TEST_CASE("a plain box has no surfaces in its report") {
    Scene scene = drifting_piston();
    scene.gas.box.surfaces = {};
    const RunReport report = run_physics(scene);
    const Json json = Json::parse(run_json(scene, report));
    CHECK_FALSE(json.contains("surfaces"));
    CHECK_FALSE(json.at("energy").contains("account"));
    CHECK_FALSE(json.at("pressure").at("wall").is_null());
}

TEST_CASE("the table of surfaces has a row for each surface and sample") {
    const Scene scene = drifting_piston();
    const test::TemporaryFolder folder;
    const std::string path = (folder.path() / "surfaces.csv").string();
    Output output(path);
    SurfacesCsv table(scene.gas.box, output);
    run_physics(scene, {.sample = [&](const Particles&, const Sample& sample,
                                      const std::vector<SurfaceState>& states) {
                    table.add(sample.time, states);
                }});
    output.commit();
    const std::string text = test::contents(path);
    CHECK(text.starts_with(
        "time,surface,position,velocity,hits,impulse_x,impulse_y,work,heat\n0,left,,,0,0,0,0,0\n"));
    CHECK(text.find("\n3,piston,13,1,0,0,0,0,0\n3,\"a, peg\",,,0,0,0,0,0\n") != std::string::npos);
    CHECK(std::ranges::count(text, '\n') == 1 + 5 * 6);
}

TEST_CASE("a line has a left and a right end in reports, and no bottom and top") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {length: 20, walls: {right: {mass: 4}}}\ngas: [{name: a, count: 1, radius: "
        "0.5, position: [5], velocity: [-1]}]\nrun: {until: 8, sample_every: 8}\n"
        "film: {seconds: 4, fps: 10, size: [320, 180], panels: []}\n");
    const test::TemporaryFolder folder;
    const std::string path = (folder.path() / "surfaces.csv").string();
    Output output(path);
    SurfacesCsv table(scene.gas.box, output);
    const RunReport report =
        run_physics(scene, {.sample = [&](const Particles&, const Sample& sample,
                                          const std::vector<SurfaceState>& states) {
                        table.add(sample.time, states);
                    }});
    output.commit();
    const Json surfaces = Json::parse(run_json(scene, report)).at("surfaces");
    REQUIRE(surfaces.size() == 2);
    CHECK(surfaces[0].at("name") == "left");
    CHECK(surfaces[0].at("impulse") == Json::array({-2.0}));
    CHECK(surfaces[1].at("name") == "right");
    CHECK(surfaces[1].at("position").at("last") == 20.0);
    const std::string text = test::contents(path);
    CHECK(std::ranges::count(text, '\n') == 1 + 2 * 2);
    CHECK(text.find("top") == std::string::npos);
}

TEST_CASE("events of surfaces are named in descriptions and beside the film") {
    Scene scene = drifting_piston();
    scene.gas.box.surfaces.partitions.push_back({.name = "door", .at = 15.0});
    const std::int32_t door = 5;
    scene.run.events = {{1.0, SetOpen{door, true}},
                        {2.0, SetOpen{door, false}},
                        {2.0, MoveSurface{door, -0.5}},
                        {2.0, MoveSurface{1, 0.0}},
                        {2.0, HoldPiston{4}},
                        {3.0, ReleasePiston{4}},
                        {3.0, ChangeSurface{1, Bath{4.0}}},
                        {3.0, Heat{std::nullopt, -2.5}}};
    CHECK(
        words_of_events({Language::english}, scene.run, scene.gas) ==
        "At time 1: The partition “door” opens. At time 2: The partition “door” closes. At time "
        "2: The partition “door” moves at velocity −0.5. At time 2: The right wall stands still "
        "from now "
        "on. At time 2: The partition “piston” is held. At time 3: The partition “piston” is "
        "released. At time 3: The right wall becomes a heat bath of temperature 4. At time 3: The "
        "gas loses the energy 2.5.");
    CHECK(words_of_surface_event({Language::english}, {0.0, Heat{0, Temperature{3.0}}},
                                 scene.gas) == "“a” is brought to temperature 3");
    CHECK(words_of_surface_event({Language::english}, {0.0, ReverseVelocities{}}, scene.gas) == "");

    const Scene still = drifting_piston();
    Scene told = scene;  // what happens is told by the scene, what is seen by the simulation
    const Simulation start(still.gas, still.run);
    const std::vector<Tick> ticks = timeline(told);
    const FrameSpan span{0, frame_count(told.film)};
    FilmTextMaker maker(told, span, ticks, start.particles());
    AdvanceResult advanced;
    advanced.surfaces.resize(7);
    advanced.surfaces[4].motion = {12.5, 1.0};
    advanced.surfaces[5].is_open = true;
    Simulation copy = start;
    for (const Tick& tick : ticks) maker.see(tick, copy.sample(), advanced);
    const FilmText text = maker.text();
    CHECK(text.chapters.find("The partition “door” opens") != std::string::npos);
    CHECK(text.descriptions.find(
              "The partition “door” closes. The partition “door” moves at velocity −0.5.") !=
          std::string::npos);
    CHECK(text.transcript.find("The right wall becomes a heat bath of temperature 4.") !=
          std::string::npos);
    CHECK(text.transcript.find(
              "moves at velocity 1.00, at x = 12.5. The partition “door” is open.") !=
          std::string::npos);
}

// Walls that act, partitions, obstacles and gravity, and the events that change them: what their
// keys mean. What is wrong in them is in tests/scenes_bad.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <limits>
#include <string>

#include "physics/reversal/mirrored_events.h"
#include "physics/surfaces/surface_problem.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& rest, const std::string& box = "size: [64, 48]") {
    return test::scene_from(
        "title: T\nbox: {" + box +
        "}\ngas:\n  - {name: small, count: 4, radius: 0.5, speed: 1, position: "
        "{within: [1, 1, 9, 9]}}\n  - {name: large, count: 4, radius: 1, speed: "
        "1, position: {within: [1, 40, 18, 47]}}\n" +
        rest);
}

Surfaces surfaces_of_scene(const std::string& keys, const std::string& box = "size: [64, 48]") {
    return scene_of(keys + "\nrun: {until: 9}\n", box).gas.box.surfaces;
}

std::vector<RunEvent> events_of(const std::string& events) {
    return scene_of(
               "partitions: [{name: divider, x: 32}, {name: lid, y: 20, mass: 3}]\n"
               "obstacles: [{name: peg, disk: [50, 30], radius: 2}]\n"
               "run: {until: 90, events: [" +
               events + "]}\n")
        .run.events;
}

template <typename Action>
const Action& action_of(const std::vector<RunEvent>& events, std::size_t k) {
    return std::get<Action>(events.at(k).action);
}

}  // namespace

TEST_CASE("a scene without surfaces has a plain box") {
    CHECK(surfaces_of_scene("").are_plain());
    CHECK(surfaces_of_scene("", "size: [64, 48], walls: periodic").are_plain());
    CHECK(surfaces_of_scene("", "size: [64, 48], walls: {left: periodic, right: periodic}")
              .are_plain());
}

TEST_CASE("each wall is solid, a bath, a piston or driven") {
    const Surfaces surfaces = surfaces_of_scene(
        "",
        "size: [64, 48], walls: {left: solid, right: {temperature: 2}, top: {mass: 200, force: "
        "-5, velocity: 3}, bottom: {velocity: 0.5, until: 10}}");
    CHECK(std::holds_alternative<Reflecting>(surfaces.sides[0]));
    CHECK(std::get<Bath>(surfaces.sides[1]).temperature == 2.0);
    CHECK(std::get<Driven>(surfaces.sides[2]).velocity == 0.5);
    CHECK(std::get<Driven>(surfaces.sides[2]).until == 10.0);
    const Piston piston = std::get<Piston>(surfaces.sides[3]);
    CHECK(piston.mass == 200.0);
    CHECK(piston.force == -5.0);
    CHECK(piston.velocity == 3.0);
    CHECK(std::get<Driven>(
              surfaces_of_scene("", "size: [64, 48], walls: {right: {velocity: -1}}").sides[1])
              .until == std::numeric_limits<double>::infinity());
}

TEST_CASE("partitions stand at x or lie at y, and are named by their order unless they say") {
    const auto partitions =
        surfaces_of_scene(
            "partitions: [{x: 32}, {name: lid, y: 20, mass: 3, force: 1}, {x: 30, gaps: "
            "[[1, 2], [5, 9.5]], open: true}]")
            .partitions;
    REQUIRE(partitions.size() == 3);
    CHECK(partitions[0].name == "partition 1");
    CHECK(partitions[0].axis == 0);
    CHECK(partitions[0].at == 32.0);
    CHECK(std::holds_alternative<Reflecting>(partitions[0].behaviour));
    CHECK_FALSE(partitions[0].is_open);
    CHECK(partitions[1].name == "lid");
    CHECK(partitions[1].axis == 1);
    CHECK(partitions[1].at == 20.0);
    CHECK(std::get<Piston>(partitions[1].behaviour).mass == 3.0);
    CHECK(partitions[2].name == "partition 3");
    CHECK(partitions[2].gaps == std::vector<Gap>{{1.0, 2.0}, {5.0, 9.5}});
    CHECK(partitions[2].is_open);
}

TEST_CASE("a membrane passes the species listed, a demon speeds to each side") {
    const auto partitions =
        surfaces_of_scene(
            "partitions: [{x: 32, passes: [large]}, {x: 40, passes: {to_right: "
            "{faster_than: 1.2}, to_left: {slower_than: 0.8}}}, {y: 30, passes: "
            "{to_bottom: {faster_than: 1, slower_than: 2}}}]")
            .partitions;
    const auto membrane = std::get<Membrane>(partitions.at(0).behaviour);
    CHECK(membrane.species == std::vector<std::int32_t>{1});
    CHECK_FALSE(membrane.upward.admits(5.0));
    CHECK_FALSE(membrane.downward.admits(5.0));
    const auto demon = std::get<Membrane>(partitions.at(1).behaviour);
    CHECK(demon.species.empty());
    CHECK(demon.upward.admits(1.3));
    CHECK_FALSE(demon.upward.admits(1.1));
    CHECK(demon.downward.admits(0.7));
    CHECK_FALSE(demon.downward.admits(0.9));
    const auto falling = std::get<Membrane>(partitions.at(2).behaviour);
    CHECK_FALSE(falling.upward.admits(1.5));
    CHECK(falling.downward.admits(1.5));
    CHECK_FALSE(falling.downward.admits(2.5));
}

TEST_CASE("obstacles are disks, rectangles, polygons and segments") {
    const auto obstacles =
        surfaces_of_scene(
            "obstacles: [{disk: [50, 20], radius: 3}, {name: block, rectangle: [30, "
            "10, 34, 20]}, {polygon: [[40, 0], [50, 0], [45, 9]]}, {segment: [[40, "
            "30], [48, 34]]}]")
            .obstacles;
    REQUIRE(obstacles.size() == 4);
    CHECK(obstacles[0].name == "obstacle 1");
    const auto disk = std::get<Obstacle::Ball>(obstacles[0].shape);
    CHECK(disk.center[0] == 50.0);
    CHECK(disk.radius == 3.0);
    CHECK(obstacles[1].name == "block");
    const auto block = std::get<Obstacle::Lines>(obstacles[1].shape);
    CHECK(block.is_closed);
    REQUIRE(block.corners.size() == 4);
    CHECK(block.corners[2] == Vec(34.0, 20.0));
    CHECK(std::get<Obstacle::Lines>(obstacles[2].shape).is_closed);
    const auto segment = std::get<Obstacle::Lines>(obstacles[3].shape);
    CHECK_FALSE(segment.is_closed);
    CHECK(segment.corners.size() == 2);
}

TEST_CASE("gravity is a vector, on a wire a number") {
    CHECK(surfaces_of_scene("gravity: [0.5, -1]").gravity == Vec(0.5, -1.0));
    const Scene wire = test::scene_from(
        "title: T\nbox: {length: 9, walls: {right: {temperature: 3}}}\ngravity: -2\n"
        "gas: [{count: 4, speed: 1}]\nrun: {until: 4}\n");
    CHECK(wire.gas.box.surfaces.gravity == Vec(-2.0, 0.0));
    CHECK(std::get<Bath>(wire.gas.box.surfaces.sides[1]).temperature == 3.0);
}

TEST_CASE("sides and partitions may be diffuse, from the start or by an event") {
    const Surfaces surfaces = surfaces_of_scene("partitions: [{x: 20, diffuse: true}]",
                                                "size: [64, 48], walls: {left: diffuse}");
    CHECK(std::holds_alternative<Diffuse>(surfaces.sides[0]));
    CHECK(only_reflects(surfaces.sides[1]));
    CHECK(std::holds_alternative<Diffuse>(surfaces.partitions.at(0).behaviour));
    const Surfaces all = surfaces_of_scene("", "size: [64, 48], walls: diffuse");
    for (const Behaviour& side : all.numbered_sides()) CHECK(std::holds_alternative<Diffuse>(side));
    const auto events = events_of(
        "{at: 1, wall: left, diffuse: true}, {at: 2, wall: divider, diffuse: true}, {at: 3, wall: "
        "left, solid: true}");
    CHECK(std::holds_alternative<Diffuse>(action_of<ChangeSurface>(events, 0).behaviour));
    CHECK(std::holds_alternative<Diffuse>(action_of<ChangeSurface>(events, 1).behaviour));
    CHECK(only_reflects(action_of<ChangeSurface>(events, 2).behaviour));
}

TEST_CASE("events name the surfaces that they change") {
    const auto events = events_of(
        "{at: 1, open: divider}, {at: 2, close: divider}, {at: 3, move: right, velocity: -0.2}, "
        "{at: 4, hold: lid}, {at: 5, release: lid, mirror: false}, {at: 6, wall: right, "
        "temperature: 4}, {at: 7, wall: top, solid: true}, {at: 8, wall: left, mass: 2, force: 1}");
    REQUIRE(events.size() == 8);
    CHECK(action_of<SetOpen>(events, 0).surface == 4);
    CHECK(action_of<SetOpen>(events, 0).is_open);
    CHECK_FALSE(action_of<SetOpen>(events, 1).is_open);
    CHECK(action_of<MoveSurface>(events, 2).surface == 1);
    CHECK(action_of<MoveSurface>(events, 2).velocity == -0.2);
    CHECK(action_of<HoldPiston>(events, 3).surface == 5);
    CHECK(events[3].is_mirrored);
    CHECK(action_of<ReleasePiston>(events, 4).surface == 5);
    CHECK_FALSE(events[4].is_mirrored);
    CHECK(std::get<Bath>(action_of<ChangeSurface>(events, 5).behaviour).temperature == 4.0);
    CHECK(action_of<ChangeSurface>(events, 6).surface == 3);
    CHECK(std::holds_alternative<Reflecting>(action_of<ChangeSurface>(events, 6).behaviour));
    CHECK(std::get<Piston>(action_of<ChangeSurface>(events, 7).behaviour).force == 1.0);
}

TEST_CASE("heat is of all or of a species, an energy or a temperature that it comes to") {
    const auto events = events_of(
        "{at: 1, heat: {by: -5}}, {at: 2, heat: {of: all, by: 5}}, {at: 3, heat: {of: large, to: "
        "{temperature: 3}}}");
    CHECK_FALSE(action_of<Heat>(events, 0).species.has_value());
    CHECK(std::get<double>(action_of<Heat>(events, 0).amount) == -5.0);
    CHECK_FALSE(action_of<Heat>(events, 1).species.has_value());
    CHECK(action_of<Heat>(events, 2).species == 1);
    CHECK(std::get<Temperature>(action_of<Heat>(events, 2).amount).value == 3.0);
}

TEST_CASE("each surface has its place in the file, sides that are not written that of the box") {
    const Scene scene = scene_of(
        "partitions: [{x: 32}]\nobstacles:\n  - {disk: [50, 20], radius: 3}\nrun: {until: 9}\n",
        "size: [64, 48], walls: {right: {temperature: 2}}");
    REQUIRE(scene.surface_places.size() == 6);
    CHECK(scene.surface_places[0].span.line == 2);
    CHECK(scene.surface_places[0].span.column == 6);
    CHECK(scene.surface_places[1].span.column > 30);
    CHECK(scene.surface_places[4].span.line == 6);
    CHECK(scene.surface_places[5].span.line == 8);
}

TEST_CASE("species may begin on one side of a partition") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [64, 48]}\npartitions: [{name: divider, x: 20}, {name: shelf, y: "
        "30}]\ngas:\n"
        "  - {name: a, count: 4, radius: 0.5, speed: 1, position: {side: left, of: divider}}\n"
        "  - {name: b, count: 4, radius: 0.5, speed: 1, position: {side: right, of: divider}}\n"
        "  - {name: c, count: 4, radius: 0.5, speed: 1, position: {side: top, of: shelf}}\n"
        "run: {until: 9}\n");
    const auto region = [&](std::size_t s) {
        const Region& its = std::get<WithinRegion>(scene.gas.species.at(s).position).region;
        return std::array{its.low[0], its.low[1], its.high[0], its.high[1]};
    };
    CHECK(region(0) == std::array{0.0, 0.0, 20.0, 48.0});
    CHECK(region(1) == std::array{20.0, 0.0, 64.0, 48.0});
    CHECK(region(2) == std::array{0.0, 30.0, 64.0, 48.0});
}

TEST_CASE("where there is one partition, its side needs no name") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [64, 48]}\npartitions: [{x: 20}]\n"
        "gas: [{count: 4, radius: 0.5, speed: 1, position: {side: right}}]\nrun: {until: 9}\n");
    CHECK(std::get<WithinRegion>(scene.gas.species.at(0).position).region.low[0] == 20.0);
}

TEST_CASE("the description says what surfaces there are and what happens to them") {
    const std::string said =
        scene_of(
            "gravity: [0, -2]\n"
            "partitions:\n"
            "  - {name: divider, x: 32, open: true}\n"
            "  - {name: window, x: 40, gaps: [[1, 2], [5, 9]]}\n"
            "  - {name: skin, y: 30, passes: [large]}\n"
            "  - {name: demon, x: 50, passes: {to_right: {faster_than: 2}, to_left: "
            "{slower_than: 1}}}\n"
            "obstacles: [{name: peg, disk: [60, 20], radius: 2}]\n"
            "run: {until: 9, events: [{at: 1, open: divider}, {at: 2, move: right, velocity: "
            "3}, {at: 3, wall: top, mass: 5}, {at: 4, heat: {of: small, by: -5}}]}\n",
            "size: [64, 48], walls: {left: {temperature: 2}, top: {mass: 20, force: -3}, "
            "bottom: {velocity: 0.5, until: 4}}")
            .description;
    for (const char* part :
         {" in a box of 64 by 48 and collide elastically. The left wall is a heat bath of "
          "temperature 2. The lower wall moves at velocity 0.5 until time 4. The upper wall is a "
          "piston of mass 20, pushed by a force of −3.",
          " The partition “divider” at x = 32 divides the box; it is open at the start.",
          " The partition “window” at x = 40 divides the box and has 2 gaps.",
          " The partition “skin” at y = 30 lets large through.",
          " The partition “demon” at x = 50 lets particles faster than 2 to the right and "
          "particles slower than 1 to the left through.",
          " An obstacle stands in the box: peg. Gravity pulls down with acceleration 2.",
          " At time 1: The partition “divider” opens. At time 2: The right wall moves at "
          "velocity 3. At time 3: The upper wall becomes a piston of mass 5. At time 4: “small” "
          "loses the energy 5."}) {
        CAPTURE(said);
        CAPTURE(part);
        CHECK(said.find(part) != std::string::npos);
    }
}

TEST_CASE("events come again after a reversal, as far as the run lasts and they are mirrored") {
    Run run;
    run.until = 50;
    run.events = {{2, SetOpen{4, true}},
                  {5, HoldPiston{5}},
                  {8, ReleasePiston{5}, false},
                  {20, ReverseVelocities{}},
                  {37, SetOpen{4, true}}};
    const auto mirrored = mirrored_events(run);
    REQUIRE(mirrored.size() == 2);
    CHECK(mirrored[0].at == 35.0);
    CHECK(mirrored[0].event == 1);
    CHECK(mirrored[0].is_undone);
    CHECK(mirrored[1].at == 38.0);
    CHECK(mirrored[1].event == 0);

    // A second reversal: what was undone is done again, and what was still ahead is past.
    run.events = {{2, SetOpen{4, true}},
                  {5, HoldPiston{5}},
                  {20, ReverseVelocities{}},
                  {36, ReverseVelocities{}}};
    const auto again = mirrored_events(run);
    REQUIRE(again.size() == 2);
    CHECK(again[0].at == 35.0);
    CHECK(again[0].is_undone);
    CHECK(again[1].at == 37.0);
    CHECK(again[1].event == 1);
    CHECK_FALSE(again[1].is_undone);
}

TEST_CASE("the description says what happens on the way back") {
    const std::string said =
        scene_of(
            "partitions: [{name: divider, x: 32}, {name: lid, y: 20, mass: 3}]\n"
            "run: {until: 40, events: [{at: 2, open: divider}, {at: 5, hold: lid}, {at: 6, "
            "heat: {by: 3}, mirror: false}, {at: 20, reverse: velocities}]}\n")
            .description;
    CAPTURE(said);
    CHECK(said.find("At time 35, on the way back: The partition “lid” is released. At time 38, on "
                    "the way back: The partition “divider” closes.") != std::string::npos);
    CHECK(said.find("The energy goes back") == std::string::npos);
    CHECK(said.ends_with(
        "At time 34: The gas no longer retraces its path, as what happened at time 6 is "
        "not undone."));
}

TEST_CASE("a run with an event that is not undone may end there, not before") {
    const auto ending = [](int until) {
        return fmt::format(
            "partitions: [{{name: divider, x: 32}}]\nrun: {{until: {}, events: [{{at: 5, open: "
            "divider, mirror: false}}, {{at: 20, reverse: velocities}}]}}\n",
            until);
    };
    CHECK_NOTHROW(scene_of(ending(35)));
    CHECK_THROWS_WITH_AS(
        scene_of(ending(34)),
        doctest::Contains("the gas returns to the event after which it no longer retraces its path "
                          "at 35, but the run ends at 34"),
        SceneError);
}

TEST_CASE("on a line only the ends and gravity act") {
    Box box{.dimension = 1, .size = {9.0, 0.0}};
    box.surfaces.sides[0] = Bath{2.0};
    box.surfaces.gravity = {1.0, 0.0};
    CHECK(surface_problems(box, {}).empty());
    box.surfaces.sides[3] = Bath{2.0};
    box.surfaces.partitions = {{.name = "divider", .at = 3.0}};
    const auto problems = surface_problems(box, {});
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].kind == SurfaceProblem::Kind::not_on_line);
    CHECK(problems[0].surface == 3);
    CHECK(to_text(problems[1], box).message == "`divider` has no meaning on a line");
}

TEST_CASE("what a scene cannot write is a problem too") {
    Box box{.size = {9.0, 9.0}};
    box.surfaces.sides[1] = Bath{-1.0};
    Run run;
    run.events = {{1.0, SetOpen{7, true}}, {2.0, HoldPiston{-1}}};
    const auto problems = surface_problems(box, run);
    REQUIRE(problems.size() == 3);
    CHECK(problems[0].kind == SurfaceProblem::Kind::not_finite);
    CHECK(problems[0].surface == 1);
    CHECK(problems[1].kind == SurfaceProblem::Kind::no_surface);
    CHECK(problems[1].event == 0);
    CHECK(problems[2].event == 1);
    for (const SurfaceProblem& problem : problems) CHECK(!to_text(problem, box).message.empty());
}

TEST_CASE("what a wall has once forgotten stays forgotten; what it forgets later does not matter") {
    Box box{.size = {9.0, 9.0}};
    Run run;
    run.events = {{1.0, ChangeSurface{1, Bath{2.0}}},
                  {2.0, ChangeSurface{1, Reflecting{}}},
                  {3.0, ReverseVelocities{}}};
    const auto problems = surface_problems(box, run);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].kind == SurfaceProblem::Kind::forgets_heat);
    CHECK(problems[0].surface == 1);
    CHECK(problems[0].event == 2);
    run.events = {{3.0, ReverseVelocities{}}, {4.0, ChangeSurface{1, Bath{2.0}}}};
    CHECK(surface_problems(box, run).empty());
    // A membrane that lets whole species through remembers, one that looks at speeds does not.
    box.surfaces.partitions = {{.name = "skin", .at = 3.0, .behaviour = Membrane{{0}}}};
    CHECK(surface_problems(box, run).empty());
    box.surfaces.partitions[0].behaviour = Membrane{{0}, {}, {0.0, 1.0}};
    CHECK(surface_problems(box, run).size() == 1);
    box.surfaces.partitions[0].behaviour = Diffuse{};
    REQUIRE(surface_problems(box, run).size() == 1);
    CHECK(surface_problems(box, run)[0].kind == SurfaceProblem::Kind::forgets_direction);
}

// Scenes of boxes with three lengths: what their keys mean. What is wrong in them is in
// tests/scenes_bad.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <limits>
#include <set>
#include <string>

#include "panels/registry.h"
#include "scene/describe.h"
#include "scene/load.h"
#include "scene/manual/starter.h"
#include "scene/numbers/known_numbers.h"
#include "scene/scene.h"
#include "support/resources.h"

using namespace carom;

namespace {

const std::string room = "size: [30, 22, 20]";

Scene read(const std::string& text) { return load_scene_text(text, "test", test::resources()); }

// A scene of this box and gas; `rest` gives at least `run`.
Scene scene_of(const std::string& box, const std::string& gas, const std::string& rest) {
    return read("title: T\nbox: {" + box + "}\ngas: [" + gas + "]\n" + rest + "\n");
}

Scene with_gas(const std::string& gas, const std::string& box = room) {
    return scene_of(box, gas, "run: {until: 4}");
}

Box with_keys(const std::string& keys, const std::string& box = room) {
    return scene_of(box, "{name: small, count: 4, radius: 0.5}, {name: large, count: 1}",
                    keys + "\nrun: {until: 9}")
        .gas.box;
}

// The first panel of a film in a box with a partition at z = 8 that has a gap.
PanelSpec panel(const std::string& written) {
    return scene_of(room, "{count: 20, radius: 0.5, speed: 1}",
                    "partitions: [{name: floor, z: 8, gaps: [[2, 2, 9, 9]]}]\nrun: {until: 9}\n"
                    "film: {panels: [" +
                        written + "]}")
        .film.panels.at(0);
}

std::array<double, 6> ends_of(const Region& region) {
    return {region.low[0],  region.low[1],  region.low[2],
            region.high[0], region.high[1], region.high[2]};
}

std::string error_in(const std::string& text) {
    try {
        read(text);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("three lengths make a box of spheres with six sides") {
    const Box box = with_gas("{count: 4, speed: 1}").gas.box;
    CHECK(box.dimension == 3);
    CHECK(box.size == Vec(30.0, 22.0, 20.0));
    CHECK(box.walls == Walls{Wall::solid, Wall::solid, Wall::solid});
    CHECK(box.surfaces.side_count == 6);
    CHECK(box.surfaces.names() ==
          std::vector<std::string>{"left", "right", "bottom", "top", "back", "front"});
    CHECK(box.surfaces.are_plain());
    const Box plane = with_gas("{count: 4, speed: 1}", "size: [30, 22]").gas.box;
    CHECK(plane.dimension == 2);
    CHECK(plane.surfaces.side_count == 4);
}

TEST_CASE("sides are given one by one, periodic ones in pairs") {
    const auto walls = [](const std::string& written) {
        return with_gas("{count: 4, speed: 1}", room + ", walls: " + written).gas.box;
    };
    CHECK(walls("periodic").walls == Walls{Wall::periodic, Wall::periodic, Wall::periodic});
    CHECK(walls("{back: periodic, front: periodic}").walls ==
          Walls{Wall::solid, Wall::solid, Wall::periodic});
    const Box acting = walls("{left: {temperature: 2}, back: {mass: 9, force: 3}, front: diffuse}");
    CHECK(acting.walls == Walls{Wall::solid, Wall::solid, Wall::solid});
    CHECK(std::get<Bath>(acting.surfaces.sides[0]).temperature == 2.0);
    CHECK(std::get<Piston>(acting.surfaces.sides[4]).force == 3.0);
    CHECK(std::holds_alternative<Diffuse>(acting.surfaces.sides[5]));
    CHECK(only_reflects(acting.surfaces.sides[1]));
    const Surfaces diffuse = walls("diffuse").surfaces;
    for (const Behaviour& side : diffuse.numbered_sides())
        CHECK(std::holds_alternative<Diffuse>(side));
}

TEST_CASE("places, velocities and regions have three components") {
    const Scene scene = with_gas(
        "{name: list, position: [[2, 3, 4], [12, 13, 14]], velocity: [[1, 2, 3], [0, 0, -1]], "
        "radius: 0.5}, {name: one, position: [20, 8, 9], velocity: [-1, 2.5, 4]}, "
        "{name: part, count: 3, position: {within: [1, 2, 3, 9, 10, 11]}, velocity: [0, 0, 2]}, "
        "{name: rest, count: 2, density: 3, speed: 1}");
    const auto& species = scene.gas.species;
    CHECK(species[0].count == 2);
    CHECK(std::get<Places>(species[0].position).values.at(1) == Vec(12.0, 13.0, 14.0));
    CHECK(std::get<Velocity>(species[0].velocity).values.at(1) == Vec(0.0, 0.0, -1.0));
    CHECK(species[1].count == 1);
    CHECK(std::get<Places>(species[1].position).values.at(0) == Vec(20.0, 8.0, 9.0));
    CHECK(std::get<Velocity>(species[1].velocity).values.at(0) == Vec(-1.0, 2.5, 4.0));
    CHECK(ends_of(std::get<WithinRegion>(species[2].position).region) ==
          std::array{1.0, 2.0, 3.0, 9.0, 10.0, 11.0});
    CHECK(std::get<Velocity>(species[2].velocity).values.at(0) == Vec(0.0, 0.0, 2.0));
    CHECK(std::get<double>(std::get<Density>(species[3].mass).value) == 3.0);
    CHECK(with_keys("gravity: [0, -1, 0.5]").surfaces.gravity == Vec(0.0, -1.0, 0.5));
}

TEST_CASE("the letters of a word stand half way between back and front") {
    const auto places = [](const std::string& within) {
        const Scene scene = with_gas("{radius: 0.2, position: {text: GAS, within: " + within + "}}",
                                     "size: [60, 22, 20]");
        return std::get<Places>(scene.gas.species.at(0).position).values;
    };
    const std::vector<Vec> whole = places("[0, 0, 0, 60, 22, 20]");
    CHECK(whole.size() > 50);
    for (const Vec& place : whole) CHECK(place[2] == 10.0);
    for (const Vec& place : places("[0, 0, 12, 60, 22, 20]")) CHECK(place[2] == 16.0);
    // In x and y the word is that of the plane.
    const Scene plane =
        with_gas("{radius: 0.2, position: {text: GAS, within: [0, 0, 60, 22]}}", "size: [60, 22]");
    const auto& flat = std::get<Places>(plane.gas.species.at(0).position).values;
    REQUIRE(flat.size() == whole.size());
    for (std::size_t k = 0; k < flat.size(); ++k) CHECK(flat[k] == whole[k] - Vec(0.0, 0.0, 10.0));
}

TEST_CASE("partitions stand across any axis, and their gaps are rectangles") {
    const Surfaces surfaces =
        with_keys(
            "partitions: [{name: window, x: 15, gaps: [[8, 9, 14, 15], [1, 2, 3, 4]]}, {y: 11, "
            "mass: 3}, {name: sheet, z: 8, open: true}]")
            .surfaces;
    const auto& partitions = surfaces.partitions;
    REQUIRE(partitions.size() == 3);
    CHECK(partitions[0].axis == 0);
    CHECK(partitions[0].at == 15.0);
    CHECK(partitions[0].gaps ==
          std::vector<Gap>{Gap({8.0, 9.0}, {14.0, 15.0}), Gap({1.0, 2.0}, {3.0, 4.0})});
    CHECK(partitions[1].name == "partition 2");
    CHECK(partitions[1].axis == 1);
    CHECK(std::get<Piston>(partitions[1].behaviour).mass == 3.0);
    CHECK(partitions[2].axis == 2);
    CHECK(partitions[2].at == 8.0);
    CHECK(partitions[2].is_open);
    CHECK(surfaces.names().at(6) == "window");
}

TEST_CASE("species may begin behind or before a partition") {
    const Scene scene = scene_of(room,
                                 "{name: a, count: 2, position: {side: back}}, "
                                 "{name: b, count: 2, position: {side: front, of: sheet}}",
                                 "partitions: [{name: sheet, z: 8}]\nrun: {until: 4}");
    const auto region = [&](std::size_t s) {
        return ends_of(std::get<WithinRegion>(scene.gas.species.at(s).position).region);
    };
    CHECK(region(0) == std::array{0.0, 0.0, 0.0, 30.0, 22.0, 8.0});
    CHECK(region(1) == std::array{0.0, 0.0, 8.0, 30.0, 22.0, 20.0});
}

TEST_CASE("a demon passes particles to the front and to the back") {
    const auto partitions =
        with_keys(
            "partitions: [{z: 8, passes: {to_front: {faster_than: 1.2}, to_back: {slower_than: "
            "0.8}}}, {x: 9, passes: [large]}, {y: 3, passes: {to_top: {faster_than: 2}}}]")
            .surfaces.partitions;
    const auto demon = std::get<Membrane>(partitions.at(0).behaviour);
    CHECK(demon.upward.admits(1.3));
    CHECK_FALSE(demon.upward.admits(1.1));
    CHECK(demon.downward.admits(0.7));
    CHECK_FALSE(demon.downward.admits(0.9));
    CHECK(std::get<Membrane>(partitions.at(1).behaviour).species == std::vector<std::int32_t>{1});
    CHECK(std::get<Membrane>(partitions.at(2).behaviour).upward.admits(3.0));
}

TEST_CASE("obstacles are spheres and cuboids") {
    const auto obstacles =
        with_keys(
            "obstacles: [{name: ball, sphere: [10, 11, 12], radius: 3}, {cuboid: [20, 0, 5, 26, 8, "
            "17]}]")
            .surfaces.obstacles;
    REQUIRE(obstacles.size() == 2);
    CHECK(obstacles[0].name == "ball");
    const auto ball = std::get<Obstacle::Ball>(obstacles[0].shape);
    CHECK(ball.center == Vec(10.0, 11.0, 12.0));
    CHECK(ball.radius == 3.0);
    CHECK(obstacles[1].name == "obstacle 2");
    const auto block = std::get<Obstacle::Cuboid>(obstacles[1].shape);
    CHECK(block.low == Vec(20.0, 0.0, 5.0));
    CHECK(block.high == Vec(26.0, 8.0, 17.0));
}

TEST_CASE("events change the back and the front, and move a particle by three lengths") {
    const auto events =
        scene_of(room, "{count: 4, radius: 0.5, speed: 1}",
                 "partitions: [{name: sheet, z: 8}]\nrun: {until: 90, precision: 200, events: ["
                 "{at: 1, wall: front, temperature: 4}, {at: 2, move: back, velocity: 0.1}, "
                 "{at: 3, open: sheet}, {at: 4, nudge: {particle: 3, by: [0, 1e-20, "
                 "-1.000000000000000000001e-20]}}]}")
            .run.events;
    REQUIRE(events.size() == 4);
    CHECK(std::get<ChangeSurface>(events[0].action).surface == 5);
    CHECK(std::get<MoveSurface>(events[1].action).surface == 4);
    CHECK(std::get<SetOpen>(events[2].action).surface == 6);
    CHECK(std::get<Perturbation>(events[3].action).by ==
          Displacement{"0", "1e-20", "-1.000000000000000000001e-20"});
}

TEST_CASE("panels measure at the back and the front, in regions, and across planes") {
    const auto measured = [](const std::string& written) {
        const PanelSpec spec = panel(written);
        return kind_of(panel_kinds(), spec.kind)->measured_at(spec);
    };
    CHECK(measured("{kind: pressure, surfaces: [back, front]}").surfaces == SurfaceNumbers{4, 5});
    CHECK(measured("{kind: flux, surfaces: floor}").surfaces == SurfaceNumbers{6});
    const auto regions =
        measured("{kind: sides, regions: [{name: a, within: [1, 2, 3, 4, 5, 6]}]}").regions;
    CHECK(ends_of(regions.at(0).region) == std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
    CHECK(panel("{kind: flux, line: {z: 5}}").kind == "flux");
    CHECK(panel("{kind: flux, line: {x: 5, between: [1, 2, 9, 8]}}").kind == "flux");
}

TEST_CASE("a component is along x, y or z, or two or all three of them") {
    CHECK(axis_of(panel("{kind: profile, component: z}")) == 2);
    CHECK(axis_of(panel("{kind: profile, component: y}")) == 1);
    CHECK(axis_of(panel("profile")) == 0);
    CHECK(panel("{kind: velocity-histogram, component: z}").component == Component::z);
    CHECK(panel("{kind: velocity-histogram, component: all}").component == Component::both);
    const PanelSpec flat = panel("{kind: speed-histogram, component: xz}");
    CHECK(axes_of(*flat.component, 3) == std::vector{0, 2});
    CHECK(axes_of(Component::z, 3) == std::vector{2});
    CHECK(axes_of(Component::both, 3) == std::vector{0, 1, 2});
    CHECK(axes_of(Component::both, 2) == std::vector{0, 1});
}

TEST_CASE("three kinds of panel have no meaning in space, and no film has them by itself") {
    std::set<std::string> flat;
    for (const PanelKind& kind : panel_kinds())
        if (!kind.in_space_instead.empty()) flat.insert(kind.name);
    CHECK(flat == std::set<std::string>{"collision-map", "contact-time", "single-collision"});
    for (const std::string& kind : flat) {
        const std::string refused = error_in("title: T\nbox: {" + room +
                                             "}\ngas: [{count: 2, speed: 1}]\nrun: {until: 9}\n"
                                             "film: {panels: [" +
                                             kind + "]}\n");
        CAPTURE(refused);
        CHECK(refused.find("no meaning in a box with three lengths") != std::string::npos);
    }
    const Scene usual = scene_of(room, "{count: 2, speed: 1}", "run: {until: 9}\nfilm: {fps: 24}");
    CHECK(!usual.film.panels.empty());
    for (const PanelSpec& spec : usual.film.panels) CHECK(!flat.contains(spec.kind));
}

TEST_CASE("views and parts of the picture have six ends") {
    const Film film =
        scene_of(
            room, "{count: 4, radius: 0.5, speed: 1}",
            "run: {until: 9}\nfilm: {seconds: 9, panels: [], fade_out: {within: [0, 0, 0, 5, 5, "
            "5]}, camera: [{at: 2, view: [1, 2, 3, 11, 12, 13]}]}")
            .film;
    CHECK(ends_of(film.fade_out.value().within) == std::array{0.0, 0.0, 0.0, 5.0, 5.0, 5.0});
    CHECK(ends_of(std::get<Region>(film.camera.at(0).view.value())) ==
          std::array{1.0, 2.0, 3.0, 11.0, 12.0, 13.0});
}

TEST_CASE("words ask for numbers of the back and the front") {
    const Scene scene =
        scene_of(room, "{count: 4, radius: 0.5, speed: 1}",
                 "run: {until: 9, events: [{at: 1, caption: 'It is {pressure.front}'}]}\n"
                 "film: {seconds: 9, panels: []}");
    REQUIRE(scene.numbers.size() == 1);
    REQUIRE(scene.numbers[0].reader.has_value());
    const PanelSpec& spec = scene.numbers[0].reader->instrument;
    CHECK(kind_of(panel_kinds(), spec.kind)->measured_at(spec).surfaces == SurfaceNumbers{5});
    std::set<std::string> names;
    for (const KnownNumber& number : known_numbers(scene, panel_kinds())) names.insert(number.name);
    for (const char* name : {"pressure.back", "pressure.front", "pressure.left"})
        CHECK(names.contains(name));
}

TEST_CASE("a box of spheres is described as one") {
    const auto said = [](const std::string& walls, const std::string& keys = "") {
        return scene_of(room + ", walls: " + walls, "{count: 4, radius: 0.5, speed: 1}",
                        keys + "run: {until: 9}")
            .description;
    };
    CHECK(said("solid") ==
          "4 spheres, at speed 1, start in a box of 30 by 22 by 20 with solid walls and collide "
          "elastically.");
    CHECK(said("periodic") ==
          "4 spheres, at speed 1, start in a periodic box of 30 by 22 by 20 and collide "
          "elastically. What leaves on one side enters on the opposite side.");
    CHECK(said("{left: periodic, right: periodic, back: periodic, front: periodic}") ==
          "4 spheres, at speed 1, start in a box of 30 by 22 by 20, periodic along x and z, and "
          "collide elastically. What leaves on a periodic side enters on the opposite side.");
    CHECK(said("{back: {temperature: 2}, front: {mass: 3}}",
               "gravity: [0, 0, -2]\npartitions: [{name: sheet, z: 8, passes: {to_front: "
               "{faster_than: 2}, to_back: {slower_than: 1}}}]\n") ==
          "4 spheres, at speed 1, start in a box of 30 by 22 by 20 and collide elastically. The "
          "back wall is a heat bath of temperature 2. The front wall is a piston of mass 3. The "
          "partition “sheet” at z = 8 lets particles faster than 2 to the front and particles "
          "slower than 1 to the back through. Gravity pulls to the back with acceleration 2.");
    CHECK(said("solid", "gravity: [1, -2, 0.5]\n")
              .ends_with(" Gravity pulls with acceleration (1; −2; 0.5)."));
    CHECK(said("solid", "gravity: [0, -2, 0]\n")
              .ends_with(" Gravity pulls down with acceleration 2."));
}

TEST_CASE("all four languages have words for space") {
    Scene scene =
        scene_of(room + ", walls: {back: periodic, front: periodic, left: {temperature: 2}}",
                 "{count: 4, radius: 0.5, speed: 1}", "gravity: [0, 0, 1]\nrun: {until: 9}");
    std::set<std::string> all;
    for (const auto language :
         {Language::english, Language::german, Language::french, Language::spanish}) {
        scene.film.language = language;
        all.insert(describe(scene));
    }
    CHECK(all.size() == 4);
    scene.film.language = Language::german;
    CHECK(describe(scene) ==
          "4 Kugeln, mit Geschwindigkeit 1, starten in einem Kasten von 30 mal 22 mal 20, "
          "periodisch längs z, und stoßen elastisch. Was auf einer periodischen Seite austritt, "
          "tritt auf der gegenüberliegenden wieder ein. Die linke Wand ist ein Wärmebad der "
          "Temperatur 2. Die Schwerkraft zieht mit der Beschleunigung 1 nach vorn.");
    CHECK(name_of_surface(Language::spanish, 4, scene.gas) == "La pared trasera");
    CHECK(name_of_surface(Language::french, 5, scene.gas) == "La paroi avant");
    CHECK(particles_counted(Language::french, 1, 3) == "1 sphère");
    CHECK(words_of({Language::english}, Perturbation{2, {"0.003", "0", "0.004"}}) ==
          "Particle 2 is moved by 0.00500");
}

TEST_CASE("the scene to start from reads as one of space with three lengths and places") {
    std::string text = starter_scene(panel_kinds(), "schema.json", "scene.yaml");
    const auto replace = [&](const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        REQUIRE(at != std::string::npos);
        text.replace(at, from.size(), to);
    };
    replace("size: [64, 48]", "size: [64, 48, 30]");
    const Scene scene = read(text);
    CHECK(scene.gas.box.dimension == 3);
    CHECK(!scene.film.panels.empty());
}

TEST_CASE("numbers in space have the limits of all numbers") {
    CHECK(with_gas("{count: 4, speed: 1}", "size: [1e12, 1e12, 1e12]").gas.box.size[2] == 1e12);
    const auto refused = [](const std::string& box, const std::string& gas,
                            const std::string& keys = "") {
        return error_in("title: T\nbox: {" + box + "}\ngas: [" + gas + "]\n" + keys +
                        "run: {until: 4}\n");
    };
    for (const char* size : {"[1, 2, 0]", "[1, 2, 1e13]", "[1, 2, -3]", "[1, 2, .nan]", "[1, 2, x]",
                             "[1, 2, 1e-13]", "[1, 2, 3, 4]", "[[1, 2], [2, 3], [4, 5]]"}) {
        CAPTURE(size);
        CHECK(!refused(fmt::format("size: {}", size), "{count: 4}").empty());
    }
    std::string gaps;
    for (int k = 0; k < 101; ++k) gaps += fmt::format("[{0}e-2, 1, {0}.5e-2, 2], ", k + 1);
    CHECK(refused(room, "{count: 4}", "partitions: [{x: 5, gaps: [" + gaps + "]}]\n")
              .find("the limit is 100 gaps of a partition") != std::string::npos);
    CHECK(!refused(room, "{count: 2000001, radius: 1e-6}").empty());
}

TEST_CASE("the command line can give a box a third length") {
    const std::string text =
        "title: T\nbox: {size: [30, 22]}\ngas: [{count: 4, speed: 1}]\nrun: {until: 4}\n";
    const Scene deep = load_scene_text(text, "test", test::resources(), {"box.size=[9, 8, 7]"});
    CHECK(deep.gas.box.dimension == 3);
    CHECK(load_scene_text(text, "test", test::resources(), {"box.size=[9, 8]"}).gas.box.dimension ==
          2);
}

TEST_CASE("no run of space is compared with one of a plane") {
    const std::string scene =
        "title: T\nbox: {size: [30, 22]}\ngas: [{count: 4, speed: 1}]\nrun: {until: 4}\n";
    CHECK_THROWS_AS(
        load_scene_text(scene + "figures: [{name: a, kind: temperature, compare: [{label: p}, "
                                "{label: s, set: {box.size: [9, 8, 7]}}]}]\n",
                        "test", test::resources()),
        SceneError);
}

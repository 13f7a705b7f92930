// What a scene says of a gas's equilibrium before anything is drawn, against what theory says of
// the drawn particles.

#include "support/equilibrium.h"

#include <doctest/doctest.h>

#include <string>

#include "physics/simulation.h"
#include "physics/theory/law.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

Scene scene_of(const std::string& box, const std::string& gas) {
    return test::scene_from("title: T\nbox: {" + box + "}\ngas: [" + gas + "]\nrun: {until: 1}\n",
                            {}, Wanted::physics);
}

// What theory says of the particles themselves.
bool has_equilibrium(const Gas& gas) {
    Run run;
    run.until = 1.0;
    Simulation simulation(gas, run);
    return test::equilibrium(gas.box, simulation.particles(), simulation.sample()).has_value();
}

struct Case {
    std::string box, gas;
};

const std::string plane = "size: [20, 20]";
const std::string torus = "size: [20, 20], walls: periodic";
const std::string tube = "size: [20, 20], walls: {left: periodic, right: periodic}";
const std::string wire = "length: 20";
const std::string ring = "length: 20, walls: periodic";

}  // namespace

TEST_CASE("the reasons against an equilibrium are those of theory") {
    const std::string post = "{name: post, mass: infinite, radius: 0.1, position: ";
    const std::vector<Case> cases{
        {plane, "{count: 5, speed: 1}"},
        {plane, "{count: 2, speed: 1}"},
        {plane, "{count: 1, speed: 1}"},
        {plane, "{count: 5}"},
        {plane, "{count: 5, speed: 0}"},
        {plane, "{count: 5, temperature: 0}"},
        {plane, "{count: 2, velocity: [[0, 0], [0, 0]]}"},
        {plane, "{count: 2, velocity: [[0, 0], [1, 0]]}"},
        {plane, "{count: 3, mass: infinite}"},
        {plane, "{name: a, count: 5, speed: 1}, " + post + "[5, 5]}"},
        {plane, "{name: a, count: 5, speed: 1}, " + post + "[5, 5], velocity: [1, 0]}"},
        {plane, "{name: a, count: 5, speed: 1}, " + post + "[5, 5], speed: 1}"},
        {plane, "{name: a, count: 5, speed: 1}, " + post + "[5, 5], speed: 0}"},
        {plane, "{name: a, count: 5, speed: 1}, " + post + "[5, 5], temperature: 1}"},
        {plane, "{name: a, count: 1, speed: 1}, " + post + "[5, 5]}"},
        {tube, "{count: 5, speed: 1}"},
        {tube, "{name: a, count: 5, speed: 1}, " + post + "[5, 5]}"},
        {torus, "{count: 5, speed: 1}"},
        {torus, "{count: 2, speed: 1}"},
        {torus, "{count: 3, speed: 1}"},
        {torus, "{count: 5, velocity: [1, 0]}"},
        {torus, "{count: 3, velocity: [[1, 0], [-1, 0], [0, 0]]}"},
        {torus, "{count: 3, mass: [1, 2, 1], velocity: [[1, 0], [-1, 0], [0, 0]]}"},
        {torus, "{count: 3, mass: [1, 2, 1], velocity: [[2, 0], [-1, 0], [0, 0]]}"},
        {torus,
         "{name: a, count: 2, density: 2, velocity: [1, 0]}, {name: b, count: 2, density: "
         "4, velocity: [-0.5, 0]}"},
        {torus, "{name: a, count: 5, velocity: [1, 0]}, " + post + "[5, 5]}"},
        {wire, "{count: 5, speed: 1}"},
        {wire, "{count: 5, radius: 0.5, density: 2, speed: 1}"},
        {wire, "{count: 5, radius: [0.1, 0.2, 0.3, 0.4, 0.5], density: 2, speed: 1}"},
        {wire, "{count: 5, mass: {uniform: [1, 2]}, speed: 1}"},
        {wire, "{name: a, count: 2, speed: 1}, {name: b, count: 1, mass: 2}"},
        {wire, "{name: a, count: 1, speed: 1}, {name: b, count: 1, mass: 2}"},
        {wire, "{name: a, count: 3, speed: 1}, {name: b, count: 3, mass: 1, temperature: 1}"},
        {ring, "{name: a, count: 2, speed: 1}, {name: b, count: 1, mass: 2}"},
        {ring, "{name: a, count: 2, speed: 1}, {name: b, count: 2, mass: 2}"},
        {ring,
         "{name: a, count: 2, mass: 1, velocity: 1}, {name: b, count: 2, mass: 2, velocity: "
         "-0.5}"},
        {ring,
         "{name: a, count: 2, mass: 1, velocity: 1}, {name: b, count: 2, mass: 2, velocity: "
         "-1}"},
        {wire, "{position: [1, 2, 3, 6, 7, 8], mass: [1, 2, 3, 1, 2, 3], speed: 1}"},
        {wire, "{name: a, position: [1, 2, 3, 6, 7, 8], mass: [1, 2, 3, 1, 2, 3], speed: 1}, " +
                   post + "5}"},
        {wire, "{name: a, position: [1, 2, 3, 4], mass: [1, 2, 3, 1], speed: 1}, " + post + "5}"},
        {ring, "{name: a, position: [1, 2, 3, 6, 7, 8], mass: [1, 2, 3, 1, 2, 3], speed: 1}, " +
                   post + "5}"}};
    int without = 0;
    for (const Case& one : cases) {
        CAPTURE(one.box + "; " + one.gas);
        const Scene scene = scene_of(one.box, one.gas);
        const auto reason = why_no_law(scene.gas, scene.run, LawOf::distribution);
        CAPTURE((reason ? to_text(Language::english, *reason, scene.gas.species) : "none"));
        CHECK(has_equilibrium(scene.gas) == !reason.has_value());
        without += reason.has_value();
    }
    CHECK(without > 15);
    CHECK(static_cast<std::size_t>(without) < cases.size() - 12);
}

TEST_CASE("only a curve that is asked for is missed") {
    const auto with = [](const std::string& panel, const Overrides& overrides = {}) {
        return test::scene_from(
            "title: T\nbox: {length: 9}\ngas: [{count: 5, speed: 1}]\nrun: "
            "{until: 1}\nfilm: {seconds: 1, panels: [" +
                panel + "]}\n",
            overrides);
    };
    CHECK_NOTHROW(with("speed-histogram"));
    CHECK_NOTHROW(with("{kind: speed-histogram}"));
    CHECK_NOTHROW(with("{kind: speed-histogram, theory: false}"));
    CHECK_THROWS_AS(with("{kind: speed-histogram, theory: true}"), SceneError);
    CHECK_THROWS_AS(with("{kind: speed-histogram}", {"film.panels.0.theory=true"}), SceneError);
}

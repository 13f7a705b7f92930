// Whose trails a film shows, and how long they are.
#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "panels/chosen.h"
#include "panels/frame.h"
#include "panels/world_lines.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;
using test::Shot;

namespace {

Scene scene_of(const std::string& trails, const std::string& box = "size: [64, 48]") {
    return test::scene_from("title: T\nbox: {" + box +
                            "}\ngas: [{name: a, count: 5, speed: 1}, {name: b, count: 4, "
                            "speed: 1}, {name: c, count: 3, speed: 1, trail: 7}]\nrun: {until: 3}\n"
                            "film: {seconds: 3, fps: 10, size: [640, 360], panels: [], " +
                            trails + "}\n");
}

std::string trails_of(const std::string& trails) {
    const Scene scene = scene_of(trails);
    const Simulation simulation(scene.gas, scene.run);
    const std::optional<EquilibriumGas> none;
    const Cast cast{scene, simulation.particles(), 30, none};
    std::string seconds;
    for (Eigen::Index i = 0; i < 12; ++i) {
        const auto asked = asked_trail(cast, i);
        seconds += asked ? std::to_string(static_cast<int>(*asked)) : "-";
    }
    return seconds;
}

}  // namespace

TEST_CASE("trails are of species and single particles, and a species' own trail wins") {
    CHECK(trails_of("theme: dark") == "---------777");
    CHECK(trails_of("trails: {of: b, seconds: 2}") == "-----2222777");
    CHECK(trails_of("trails: {of: 3}") == "---1-----777");
    CHECK(trails_of("trails: {of: [0, b, 10], seconds: 3}") == "3----3333777");
    CHECK(trails_of("trails: {of: all, seconds: 0}") == "000000000777");
}

TEST_CASE("a trail is drawn behind the particle that has one, and nowhere else") {
    const Shot with(scene_of("trails: {of: 3, seconds: 2}")),
        without(scene_of("trails: {of: 3, seconds: 0}"));
    FramePainter painter(with.scene, *with.observers), plain(without.scene, *without.observers);
    CHECK(test::pixels_of(painter.paint(with.frames.back())) !=
          test::pixels_of(plain.paint(without.frames.back())));
}

TEST_CASE("on a wire a bead with a trail stands out") {
    const Scene scene = scene_of("trails: {of: 3}", "length: 64");
    const Simulation simulation(scene.gas, scene.run);
    const std::optional<EquilibriumGas> none;
    const Cast cast{scene, simulation.particles(), 30, none};
    for (Eigen::Index i = 0; i < 12; ++i) CHECK(stands_out(cast, i) == (i == 3 || i >= 9));
}

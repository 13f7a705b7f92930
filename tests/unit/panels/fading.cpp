#include "panels/gas/marks/fading.h"

#include <doctest/doctest.h>

#include "panels/gas/marks/seed_paths.h"
#include "physics/simulation.h"
#include "scene/scene.h"
#include "support/scene_text.h"

using namespace carom;

TEST_CASE(
    "particles fade after they have entered a part of the box, and come back when they leave") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\ngas: [{count: 3, radius: 0.1, speed: 1}]\nrun: {until: "
        "5}\n"
        "film: {seconds: 5, panels: [], fade_out: {within: [10, 0, 20, 10], seconds: 2}}\n");
    const Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    Fading fading({scene, simulation.particles(), 1, none});
    const auto light_at = [&](double seconds, double first, double second) {
        Eigen::ArrayXXd places = Eigen::ArrayXXd::Constant(3, 2, 5.0);
        places(0, 0) = first;
        places(1, 0) = second;
        std::vector<float> light;
        Tick tick;
        tick.seconds = seconds;
        fading.see(tick, places, light);
        return light;
    };
    const float trace = 0.12F;
    CHECK(light_at(0.0, 5, 12) == std::vector<float>{1, 1, 1});
    CHECK(light_at(1.0, 11, 15)[1] == doctest::Approx(0.5F * (1 + trace)));
    CHECK(light_at(2.0, 11, 15)[0] == doctest::Approx(0.5F * (1 + trace)));
    CHECK(light_at(9.0, 11, 15)[0] == doctest::Approx(trace));
    CHECK(light_at(9.5, 11, 9) == std::vector<float>{light_at(9.5, 11, 9)[0], 1, 1});
    CHECK(light_at(10.0, 11, 12)[1] == 1.0F);
}

TEST_CASE("the paths of other seeds are those of runs with these seeds") {
    const std::string text =
        "title: T\nbox: {size: [20, 10], walls: periodic}\n"
        "gas: [{name: one, count: 1, radius: 0.5, speed: 3}, {name: rest, count: 20, radius: 0.2, "
        "speed: 3}]\nrun: {until: 8}\n"
        "film: {seconds: 5, panels: [], trails: {of: one, seeds: 2}}\n";
    const Scene scene = test::scene_from("seed: 5\n" + text);
    const Simulation simulation(scene.gas, scene.run);
    const BoxedGas none;
    const auto paths = seed_paths({scene, simulation.particles(), 1, none}, {0});
    REQUIRE(paths.size() == 2);
    for (const int k : {0, 1}) {
        const Scene other = test::scene_from("seed: " + std::to_string(6 + k) + "\n" + text);
        Simulation its(other.gas, other.run);
        const SeedPath& path = paths[static_cast<std::size_t>(k)];
        REQUIRE(path.time.back() == 8.0);
        for (const std::size_t i : {std::size_t{0}, path.time.size() / 2, path.time.size() - 1}) {
            its.advance_to(path.time[i]);
            CHECK(path.place[i].x == doctest::Approx(its.sample().position(0, 0)));
            CHECK(path.place[i].y == doctest::Approx(its.sample().position(0, 1)));
        }
        for (std::size_t i = 1; i < path.time.size(); ++i) {
            const bool jumps = std::abs(path.place[i].x - path.place[i - 1].x) > 10.0 ||
                               std::abs(path.place[i].y - path.place[i - 1].y) > 5.0;
            CHECK(jumps == (path.piece[i] != path.piece[i - 1]));
        }
    }
}

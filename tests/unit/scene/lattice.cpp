// What is said of a lattice before anything is placed is what the placement finds.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "support/resources.h"
#include "util/random.h"

using namespace carom;

namespace {

std::string refusal(const std::string& text) {
    try {
        load_scene_text(text, "test", test::resources(), {}, Wanted::physics);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

bool can_begin(const Gas& gas) {
    try {
        Simulation(gas, {.until = 1.0, .events = {}, .time_step = {}});
    } catch (const PlacementError&) {
        return false;
    }
    return true;
}

const char* word_of(Wall wall) { return wall == Wall::solid ? "solid" : "periodic"; }

}  // namespace

TEST_CASE("a lattice that does not fit, or on which rows are full, is refused, and no other") {
    int too_small = 0, full = 0, fine = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        Random random(seed, "lattices");
        // Sides of whole diameters, so that rows are often full.
        Gas gas;
        const auto side = [&] { return 1.0 + 0.25 * static_cast<double>(random.below(30)); };
        const auto wall = [&] { return random.below(2) == 0 ? Wall::solid : Wall::periodic; };
        gas.box = {2, {side(), side()}, {wall(), wall()}};
        const double packing = random.uniform(0.4, 0.95);
        const auto count = std::max<std::int64_t>(
            1, static_cast<std::int64_t>(packing * gas.box.content() / 0.7854));
        gas.species = {{.name = "g",
                        .count = count,
                        .velocity = Temperature{1.0},
                        .position = LatticePlaces{}}};
        const std::string text = fmt::format(
            "title: T\nbox: {{size: [{}, {}], walls: {{left: {}, right: {}, bottom: {}, top: "
            "{}}}}}\ngas: [{{count: {}, temperature: 1, position: lattice}}]\nrun: {{until: 1}}\n",
            gas.box.size[0], gas.box.size[1], word_of(gas.box.walls[0]), word_of(gas.box.walls[0]),
            word_of(gas.box.walls[1]), word_of(gas.box.walls[1]), count);
        CAPTURE(text);
        const std::string why = refusal(text);
        CAPTURE(why);
        CHECK(why.empty() == can_begin(gas));
        ++(why.empty()                                          ? fine
           : why.find("of touching disks") == std::string::npos ? too_small
                                                                : full);
    }
    CHECK(too_small > 20);
    CHECK(full > 5);
    CHECK(fine > 100);
}

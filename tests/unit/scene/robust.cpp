// Broken scenes of every sort: they load or are refused, they never crash or hang.
#include <doctest/doctest.h>

#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scene/load.h"
#include "scene/scene.h"
#include "support/resources.h"
#include "support/share_of_cases.h"
#include "util/random.h"

using namespace carom;

namespace {

const std::string good =
    "title: \"A gas\"\nseed: 7\nbox: {size: [64, 48], walls: solid}\n"
    "gas:\n  - &a {name: a, count: 20, radius: {uniform: [0.5, 0.7]}, speed: 1}\n"
    "  - {name: b, radius: 0.7, position: [[10, 10], [20, 20]], velocity: [1, 0], color: "
    "'#ff0000'}\n"
    "run:\n  until: 60\n  events: [{at: 30, reverse: velocities}]\n"
    "film: {seconds: 30, size: 720p, panels: [speed-histogram, {kind: energy-histogram, bins: "
    "9}]}\n";

const std::string surfaces =
    "title: S\nbox: {size: [64, 48], walls: {left: {temperature: 2}, top: {mass: 20, force: -3}}}\n"
    "gravity: [0, -1]\npartitions:\n  - {name: p, x: 32, gaps: [[1, 2]]}\n  - {x: 40, passes: "
    "[a]}\n"
    "  - {y: 30, passes: {to_top: {faster_than: 1}}}\n  - {name: m, x: 20, mass: 3}\n"
    "obstacles: [{disk: [50, 20], radius: 2}, {polygon: [[1, 1], [2, 2], [1, 3]]}]\n"
    "gas:\n  - {name: a, count: 9, speed: 1, radius: 0.3, position: {side: right, of: p}}\n"
    "run:\n  until: 60\n  events: [{at: 3, open: p}, {at: 4, hold: m}, {at: 5, release: m}, {at: "
    "6, "
    "move: right, velocity: 2}, {at: 7, wall: left, mass: 3}, {at: 8, heat: {of: a, by: 2}}]\n";

const std::string space =
    "title: S\nbox: {size: [30, 22, 20], walls: {left: {temperature: 2}, front: {mass: 20}}}\n"
    "gravity: [0, -1, 0]\npartitions:\n  - {name: p, x: 15, gaps: [[1, 2, 3, 4]]}\n  - {z: 9, "
    "passes: {to_front: {faster_than: 1}}}\n"
    "obstacles: [{sphere: [20, 10, 5], radius: 2}, {cuboid: [1, 1, 1, 2, 2, 3]}]\n"
    "gas:\n  - {name: a, count: 9, speed: 1, radius: 0.3, position: {side: right, of: p}}\n"
    "  - {name: b, radius: 0.2, position: [[5, 5, 5], [9, 9, 12]], velocity: [0, 1, 2]}\n"
    "run:\n  until: 60\n  events: [{at: 3, open: p}, {at: 6, move: back, velocity: 0.1}]\n"
    "film: {panels: [{kind: profile, component: z}]}\n";

// True when it loads; a SceneError is the only other end.
bool loads(const std::string& text) {
    try {
        load_scene_text(text, "test.yaml", test::resources());
        return true;
    } catch (const SceneError& error) {
        CHECK(!error.diagnostics().empty());
        CHECK(error.diagnostics().size() <= 51);
        return false;
    }
}

std::string mutated(const std::string& scene, Random& random) {
    static const std::vector<std::string> pieces{
        "[",    "]",    "{",  "}",    ":",       "-",  ",", "\n",      " ",   "\t",
        "'",    "\"",   "#",  "*a",   "&a ",     "!",  "|", ">",       "? ",  "---\n",
        "...",  "<<",   "~",  ".nan", "1e308",   "-1", "0", "\xFF",    "\\x", "%",
        "null", "true", "[]", "{}",   "2000000", "@",  "`", "\\u0000", "ä",   "1e-308"};
    std::string text = scene;
    const auto edits = 1 + random.below(4);
    for (std::uint64_t i = 0; i < edits; ++i) {
        const auto at = static_cast<std::size_t>(random.below(text.size() + 1));
        const auto length = static_cast<std::size_t>(random.below(6));
        const auto piece = static_cast<std::size_t>(random.below(pieces.size()));
        text.replace(at, random.below(2) == 0 ? length : 0, pieces[piece]);
    }
    return text;
}

}  // namespace

TEST_CASE("a scene cut off anywhere loads or is refused") {
    for (const std::string& scene : {good, surfaces, space}) {
        CHECK(loads(scene));
        for (std::size_t length = 0; length < scene.size(); ++length)
            loads(scene.substr(0, length));
    }
}

TEST_CASE("a scene with random errors loads or is refused") {
    Random random(1, "mutations");
    const int scenes = 1500 / test::every_nth(1, 4);
    for (const std::string& scene : {good, surfaces, space}) {
        int loaded = 0;
        for (int i = 0; i < scenes; ++i) loaded += loads(mutated(scene, random)) ? 1 : 0;
        CHECK(loaded > 0);
        CHECK(loaded < scenes);
    }
}

TEST_CASE("large hostile files are refused within seconds") {
    const std::clock_t start = std::clock();
    std::string listed = "gas: [";
    for (int i = 0; i < 100'000; ++i) listed += "x, ";
    std::string keys;
    for (int i = 0; i < 40'000; ++i) keys += "k" + std::to_string(i) + ": [1, 2\n";
    std::string wrong =
        "title: x\nbox: {size: [64, 48]}\nrun: {until: 1}\ngas: [{count: 2, radius: [";
    for (int i = 0; i < 60'000; ++i) wrong += "-1, ";
    std::string nulls = "title: x\nbox: {size: [64, 48]}\nrun: {until: 1}\ngas: [{position: [";
    std::string same = nulls;
    for (int i = 0; i < 50'000; ++i) nulls += "~, ";
    for (int i = 0; i < 40'000; ++i) same += "[1, 1], ";
    std::string unknown;
    for (int i = 0; i < 40'000; ++i) unknown += "k" + std::to_string(i) + ": 1\n";
    for (const std::string& text :
         {listed + "]", keys, nulls + "~]}]", same + "[1, 1]]}]", unknown, wrong + "1]}]",
          std::string(1 << 20, '-'), std::string(1 << 20, '{'), "a: " + std::string(1 << 20, '&'),
          "a: " + std::string(1 << 20, '"'), std::string(1 << 20, '?') + "\n",
          "\"" + std::string(1 << 20, '\\')})
        CHECK(!loads(text));
    const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    CHECK(taken < 60.0);  // a hang, not a slow machine; nor one that is busy with something else
}

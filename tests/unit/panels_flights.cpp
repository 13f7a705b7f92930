// Paths have their corners where velocities change, not at the frames before and after.
#include <doctest/doctest.h>

#include <string>
#include <variant>
#include <vector>

#include "panels/frame.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

using Pairs = std::vector<std::pair<double, double>>;

// The points of the first panel's path at the end of a film of five frames a second.
Pairs path_of(const std::string& scene, const std::string& panel) {
    const test::Shot film(test::scene_from(
        "title: T\n" + scene + "\nfilm: {seconds: 6, fps: 5, panels: [" + panel + "]}\n"));
    Pairs path;
    const Table table = film.observers->panels().back().panel->table(
        *film.frames.back().states.back(), theme(ThemeKind::light));
    for (const std::vector<Cell>& row : table.rows)
        if (std::get<std::string>(row[0]) == "path")
            path.emplace_back(std::get<double>(row[3]), std::get<double>(row[4]));
    return path;
}

bool has(const Pairs& path, double x, double y) {
    for (const auto& [a, b] : path)
        if (std::abs(a - x) < 1e-9 && std::abs(b - y) < 1e-9) return true;
    return false;
}

// Bead 0 comes to bead 1, which rests at 6, at time 3.3, and takes its place; bead 1 meets the wall
// at time 7.3: both between two frames.
const std::string two_beads =
    "box: {length: 10}\ngas: [{position: [2.7, 6], velocity: [1, 0]}]\nrun: {until: 9}";

}  // namespace

TEST_CASE("positions of two beads turn where they collide, and where one meets a wall") {
    const Pairs path = path_of(two_beads, "{kind: positions, of: [0, 1]}");
    CHECK(has(path, 6.0, 6.0));
    CHECK(has(path, 6.0, 10.0));
    for (const auto& [first, second] : path)  // nothing lies on a short cut
        CHECK((std::abs(second - 6.0) < 1e-9 || std::abs(first - 6.0) < 1e-9));
}

TEST_CASE("a bead's velocity jumps where it collides") {
    const Pairs path = path_of(two_beads, "{kind: phase, of: [0]}");
    CHECK(has(path, 6.0, 1.0));
    CHECK(has(path, 6.0, 0.0));
}

TEST_CASE("around a ring a corner lies where the bead is seen") {
    // They meet at 0.9 after bead 0 has gone around, at time 2.15.
    const Pairs path = path_of(
        "box: {length: 10, walls: periodic}\ngas: [{position: [8.75, 0.9], velocity: [1, 0]}]\n"
        "run: {until: 5}",
        "{kind: positions, of: [0, 1]}");
    CHECK(has(path, 0.9, 0.9));
}

TEST_CASE("at a reversal a velocity jumps to its opposite") {
    const Pairs path = path_of(
        "box: {length: 10}\ngas: [{position: [1, 9], velocity: [1, 0]}]\n"
        "run: {until: 6, events: [{at: 3, reverse: velocities}]}",
        "{kind: phase, of: [0]}");
    CHECK(has(path, 4.0, 1.0));
    CHECK(has(path, 4.0, -1.0));
}

// What ends a run on its way: carom check says it beforehand where it shows early, and every
// command says where in the file and in the box.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;

namespace {

const std::string apart =
    "title: T\nbox: {size: [40, 30]}\n"
    "gas: [{name: a, count: 2, radius: 1, position: [[10, 10], [30, 20]], velocity: [1, 0]}]\n"
    "run: {until: 5}\n";

// A disk in a room of 1/512 between two posts; collisions are 512 in a unit of time.
const std::string trapped =
    "title: T\nbox: {size: [20, 10]}\ngas:\n"
    "  - {name: posts, mass: infinite, radius: 1, position: [[5, 5], [7.501953125, 5]]}\n"
    "  - {name: ball, radius: 0.25, position: [6.25097, 5], velocity: [1, 0]}\n"
    "run: {until: 100, most_collisions: 20000}\nfilm: {seconds: 1, size: [320, 180]}\n"
    "figures: [{name: f, kind: gas, at: 50}]\n";

Outcome checked(const std::string& scene, const std::string& more = "") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    return shell("'" + program + "' check scene.yaml " + more, folder.path());
}

std::string line_of(const std::string& text, std::size_t number) {
    std::size_t begin = 0;
    for (std::size_t k = 1; k < number; ++k) begin = text.find('\n', begin) + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("check refuses panels and figures of a collision that does not happen") {
    for (const std::string kind : {"single-collision", "contact-time", "collision-map"}) {
        CAPTURE(kind);
        const bool on_a_wire = kind == "collision-map";
        const std::string gas =
            on_a_wire ? "title: T\nbox: {length: 40}\ngas: [{name: a, count: 2, radius: 1, "
                        "position: [10, 30], velocity: 1}]\nrun: {until: 5}\n"
                      : apart;
        const Outcome in_film = checked(
            gas + "film:\n  seconds: 1\n  panels:\n    - {kind: " + kind + ", of: [0, 1]}\n");
        CHECK(in_film.exit_code == 2);
        CHECK(has(line_of(in_film.err, 1),
                  "scene.yaml:8:7: error: particles 0 and 1 do not collide from time 0 to 5, the "
                  "end of the run"));
        CHECK(has(in_film.err, "hint: give another pair in `of`"));
        const Outcome as_figure = checked(gas + "figures:\n  - {name: f, kind: " + kind + "}\n");
        CHECK(as_figure.exit_code == 2);
        CHECK(has(line_of(as_figure.err, 1),
                  "scene.yaml:6:5: error: no two particles collide from time 0 to 5"));
        CHECK(has(as_figure.err, "hint: give a longer run, or let particles collide"));
    }
    CHECK(checked(apart + "film: {seconds: 1, panels: [{kind: single-collision}]}\n",
                  "--set run.until=40 --set gas.a.velocity='[[2,1],[-2,-1]]'")
              .exit_code == 0);
}

TEST_CASE("check says all panels and figures of collisions that do not happen at once") {
    const Outcome both = checked(apart +
                                 "film:\n  seconds: 1\n  panels: [{kind: single-collision}]\n"
                                 "figures:\n  - {name: f, kind: contact-time, of: [0, 1]}\n");
    CHECK(both.exit_code == 2);
    CHECK(has(both.err, "scene.yaml:7:12: error: no two particles collide"));
    CHECK(has(both.err, "scene.yaml:9:5: error: particles 0 and 1 do not collide"));
}

TEST_CASE("check refuses beads that an infinite mass presses against the wall, wherever they are") {
    const Outcome outcome = checked(
        "title: T\nbox: {length: 40}\ngas:\n  - {name: few, count: 5, radius: 0.5}\n"
        "  - {name: press, mass: infinite, radius: 0.5, count: 1, velocity: 2}\n"
        "run: {until: 40}\nfilm: {seconds: 1}\n");
    CHECK(outcome.exit_code == 2);
    CHECK(has(line_of(outcome.err, 1), "scene.yaml:5:5: error: "));
    CHECK(has(outcome.err, "particle 5 of infinite mass presses beads against"));
}

TEST_CASE("a trapped disk ends every command at the ceiling, with its place and what to do") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", trapped);
    const std::string expected =
        "scene.yaml:5:5: error: at time 39.0635 the run has had 20000 collisions, the most that it "
        "may have: the next 4096 take 8 units of time, a rate of 512; most are of particle 2, at "
        "(6.25195, 5)";
    for (const std::string command :
         {"check scene.yaml", "run --quiet scene.yaml", "render --quiet scene.yaml -o film.mp4",
          "still --at 1 scene.yaml -o still.png", "plan scene.yaml --chunks 2 -o plan",
          "figures --quiet scene.yaml -o figures"}) {
        CAPTURE(command);
        const Outcome outcome = shell("'" + program + "' " + command, folder.path());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, expected));
        CHECK(has(outcome.err,
                  "hint: give it more room, or let the run end before, or allow more with "
                  "`run.most_collisions`"));
        // The list of figures is kept from the start.
        if (!command.starts_with("figures"))
            CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
    }
    CHECK(shell("'" + program + "' run --quiet scene.yaml --set run.most_collisions=60000",
                folder.path())
              .exit_code == 0);
}

TEST_CASE("a ceiling that no single particle reaches is said at its key") {
    const Outcome outcome = checked(
        "title: T\nbox: {size: [20, 20]}\ngas: [{count: 100, temperature: 1}]\n"
        "run:\n  until: 1000\n  most_collisions: 1000\nfilm: {seconds: 1}\n");
    CHECK(outcome.exit_code == 2);
    CHECK(has(line_of(outcome.err, 1), "scene.yaml:6:20: error: at time "));
    CHECK(has(line_of(outcome.err, 1), "the run has had 1000 collisions"));
}

// Contacts that coincide, by the program itself: what it says of them, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;

namespace {

// A disk that meets two touching ones at time 15 - sqrt(3), and nothing else before 17.
const std::string rack =
    "title: T\nbox: {size: [40, 20]}\n"
    "gas:\n"
    "  - {name: cue, count: 1, radius: 1, position: [5, 10], velocity: [1, 0]}\n"
    "  - {name: rack, count: 2, radius: 1, position: [[20, 11], [20, 9]], velocity: [0, 0]}\n";

json ties_of_run(const std::string& scene) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome outcome = run({program, "run", "scene.yaml", "--json", "-"}, folder.path());
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at("ties");
}

json ties_of_check(const std::string& scene) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome outcome = run({program, "check", "scene.yaml", "--json"}, folder.path());
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at(0).at("ties");
}

}  // namespace

TEST_CASE("the report of a run counts contacts that coincide") {
    CHECK(ties_of_run(rack + "run: {until: 17}\n") == json{{"instants", 1}, {"contacts", 2}});
    CHECK(ties_of_run(rack + "run: {until: 13}\n") == json{{"instants", 0}, {"contacts", 0}});
    // those before the time from which collisions are counted are not among them
    CHECK(ties_of_run(rack + "run: {until: 1, equilibrate: 15}\n").at("instants") == 0);
    const TemporaryFolder folder;
    folder.write("scene.yaml", rack + "run: {until: 17}\n");
    const Outcome outcome = run({program, "run", "scene.yaml"}, folder.path());
    CHECK(has(outcome.out,
              "\n  ties            2 contacts of connected particles at 1 instant, the first at "
              "time 13.2679: carried out together\n"));
}

TEST_CASE("check names contacts that coincide") {
    CHECK(ties_of_check(rack + "run: {until: 17}\n") == json{{"instants", 1}, {"contacts", 2}});
    CHECK(ties_of_check("title: T\nbox: {size: [20, 15]}\n"
                        "gas: [{count: 30, radius: 0.5, speed: 1}]\nrun: {until: 5}\n") ==
          json{{"instants", 0}, {"contacts", 0}});
    const TemporaryFolder folder;
    folder.write("scene.yaml", rack + "run: {until: 17}\n");
    CHECK(has(run({program, "check", "scene.yaml"}, folder.path()).out,
              "\n  ties         2 contacts of connected particles at 1 instant, the first at "
              "time 13.2679: carried out together\n"));
    // more collisions than check tries
    folder.write("scene.yaml", rack + "run: {until: 1e7, most_collisions: 1e9}\n");
    CHECK(has(run({program, "check", "scene.yaml"}, folder.path()).out,
              "time 13.2679, in the beginning of the run: carried out together\n"));
}

TEST_CASE("a reversal after touching disks were pushed apart at once is refused by every command") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 rack + "run: {until: 40, events: [{at: 20, reverse: velocities}]}\n");
    for (const char* command : {"run", "check", "render"}) {
        CAPTURE(command);
        const Outcome outcome = run({program, command, "scene.yaml"}, folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err,
                  "the gas cannot go back from time 20: at time 13.26794919 several contacts"));
        CHECK(has(outcome.err, "scene.yaml:6:"));
    }
    // the same gas without the tie comes back
    const std::string gap = "position: [[20, 11], [20, 8]]";
    std::string apart = rack;
    apart.replace(apart.find("position: [[20, 11], [20, 9]]"), gap.size(), gap);
    folder.write("scene.yaml",
                 apart + "run: {until: 40, events: [{at: 20, reverse: velocities}]}\n");
    CHECK(run({program, "check", "scene.yaml"}, folder.path()).exit_code == 0);
}

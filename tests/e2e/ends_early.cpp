// Runs that the command line ends at another time, by the program itself.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;

namespace {

// The state at the end of a run of a scene of the library.
std::string state_after(const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> command{program, "run", library_scene(name), "--json", "-", "--quiet"};
    command.insert(command.end(), options.begin(), options.end());
    const Outcome outcome = run(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at("state");
}

}  // namespace

TEST_CASE("carom run --to simulates to that time, whatever the film and the figures show") {
    CHECK(state_after("mixed-masses", {"--to", "7"}) ==
          state_after("mixed-masses", {"--set", "run.until=7"}));
    CHECK(state_after("mixed-masses", {"--to", "7"}) != state_after("mixed-masses", {"--to", "8"}));
    const Outcome plain = run({program, "run", library_scene("time-reversal"), "--to", "5"});
    CHECK(plain.exit_code == 0);
    CHECK(plain.err == "");
    CHECK(has(plain.out, "time 0 to 5, "));
    const Outcome late = run({program, "run", library_scene("time-reversal"), "--to", "150"});
    CHECK(late.exit_code == 2);
    CHECK(has(late.err, "the gas returns to its start at 190, but the run ends at 150"));
    const Outcome wrong = run({program, "run", library_scene("mixed-masses"), "--to", "soon"});
    CHECK(wrong.exit_code == 2);
    CHECK(has(wrong.err, "--to soon: error: expected a positive number for `until`"));
}

TEST_CASE("an earlier end leaves out what comes later with one note, or is refused") {
    const std::string note =
        "--set run.until=5: the run ends at 5 now, before 1 event (at 95), 3 captions (at 30, 95 "
        "and 160), 1 monitor (`return-distance`), 1 slow motion (from 186) and 1 figure "
        "(`word-and-back`) of the scene: they are left out\n";
    const std::vector<std::string> call{program, "run", library_scene("time-reversal"), "--set",
                                        "run.until=5"};
    CHECK(run(call).err == "carom: " + note);
    for (const std::string command : {"run", "still", "render", "check", "plan"}) {
        CAPTURE(command);
        const TemporaryFolder folder;
        std::vector<std::string> strict = call;
        strict[1] = command;
        strict.emplace_back("--strict");
        const Outcome refused = run(strict, folder.path());
        CHECK(refused.exit_code == 2);
        CHECK(has(refused.err + refused.out,
                  "run.until=5: error: the run ends at 5 now, before 1 event"));
        CHECK(folder.names().empty());
    }
}

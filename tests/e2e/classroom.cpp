// --limits classroom: every command that takes it refuses what is over its limits, at once, and
// makes the same of what is not.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene =
    "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\nrun: {until: 2}\n"
    "film: {seconds: 1, size: [320, 180]}\n";

Outcome called(const TemporaryFolder& folder, std::vector<std::string> command) {
    command.insert(command.begin(), program);
    return run(command, folder.path());
}

Outcome held(const TemporaryFolder& folder, std::vector<std::string> command) {
    command.insert(command.end(), {"--limits", "classroom"});
    return called(folder, std::move(command));
}

}  // namespace

TEST_CASE("all commands that take --limits classroom refuse a film that is too long") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const std::vector<std::vector<std::string>> commands{
        {"render", "scene.yaml", "-o", "film.mp4"},
        {"still", "scene.yaml", "-o", "still.png"},
        {"figure", "scene.yaml", "--kind", "gas", "-o", "figure", "--formats", "png"},
        {"run", "scene.yaml", "--json", "run.json"},
        {"check", "scene.yaml"}};
    for (std::vector<std::string> command : commands) {
        CAPTURE(command.front());
        command.insert(command.end(), {"--limits", "classroom", "--set", "film.seconds=121"});
        const Outcome refused = called(folder, command);
        CHECK(refused.exit_code == 2);
        CHECK(
            has(refused.err, "hint: the limit is 120 seconds of a film, with --limits classroom"));
        CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
        command.resize(command.size() - 2);
        const Outcome made = called(folder, command);
        CAPTURE(made.err);
        CHECK(made.exit_code == 0);
        for (const std::string& name : folder.names())
            if (name != "scene.yaml") fs::remove_all(folder.path() / name);
    }
    CHECK(called(folder, {"check", "scene.yaml", "--limits", "school"}).exit_code == 2);
}

TEST_CASE("with --limits classroom a film is what it is without") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    called(folder, {"render", "scene.yaml", "-o", "a.mp4"});
    called(folder, {"render", "scene.yaml", "-o", "b.mp4", "--limits", "classroom"});
    CHECK(contents(folder.path() / "a.mp4").size() > 1000);
    CHECK(contents(folder.path() / "a.mp4") == contents(folder.path() / "b.mp4"));
}

TEST_CASE("a film of several scenes is held to the limits as a whole, and runs beside others too") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome joined = called(folder, {"render", "scene.yaml", "scene.yaml", "--join", "-o",
                                           "a.mp4", "--seconds", "61", "--limits", "classroom"});
    CHECK(joined.exit_code == 2);
    CHECK(has(joined.err, "the scenes together are a film of 122 seconds; the limit is 120"));
    folder.write("many.yaml",
                 "title: T\nbox: {size: [40, 30]}\ngas: [{count: 20001, radius: 0.01}]\n"
                 "run: {until: 1}\n");
    std::string text = scene;
    text.replace(text.find("film: {"), std::string::npos,
                 "film: {seconds: 1, panels: [energy-histogram], beside: {label: L, own_label: O, "
                 "scene: many.yaml}}\n");
    folder.write("beside.yaml", text);
    const Outcome beside = held(folder, {"check", "beside.yaml"});
    CHECK(beside.exit_code == 2);
    CHECK(has(beside.err, "20001 particles in all"));
}

TEST_CASE("every command that would draw or plan a film of many large pictures refuses it") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",  // 22 minutes of CPU time, measured
                 "title: T\nbox: {size: [500, 500]}\n"
                 "gas: [{count: 20000, radius: 0.5, temperature: 1}]\nrun: {until: 60}\n"
                 "film: {seconds: 120, fps: 60, size: [3840, 3840]}\n");
    const std::vector<std::vector<std::string>> commands{
        {"render", "scene.yaml", "-o", "film.mp4"},
        {"render", "scene.yaml", "scene.yaml", "--join", "--set", "film.seconds=60", "-o",
         "film.mp4"},
        {"check", "scene.yaml", "--format", "mp4"},
        {"plan", "scene.yaml", "-o", "plan"},
        {"gallery", ".", "-o", "site"}};
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command.front());
        const Outcome refused = held(folder, command);
        CAPTURE(refused.err);
        CHECK(refused.exit_code == 2);
        CHECK(has(refused.err, "frames of 3840 by 3840 as mp4"));
        CHECK(has(refused.err,
                  "the limit is 300 seconds of CPU time, with --limits classroom; "
                  "reduce `film.size`, `film.fps` or `film.seconds`"));
        CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
    }
}

TEST_CASE("the output and the memory of a film have limits too") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const auto refused = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"check", "scene.yaml", "--limits", "classroom"});
        const Outcome outcome = called(folder, options);
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK(has(
        refused({"--format", "png", "--size", "2160p", "--set", "film.seconds=120", "film.fps=60"}),
        "the limit is 1000 MB of output, with --limits classroom; reduce `film.size`, "
        "`film.fps` or `film.seconds`"));
    CHECK(has(refused({"--format", "gif", "--size", "3840x3840"}),
              "the limit is 2000 MB of memory, with --limits classroom; reduce `film.size` or the "
              "particles"));
}

// Each passes where it is small, and is refused before any run is done.
TEST_CASE("many runs are held to the limits together") {
    const TemporaryFolder folder;
    const std::string gas =
        "title: T\nbox: {size: [60, 60]}\nrun: {until: 20, sample_every: 20}\n"
        "gas: [{count: 1000, radius: 0.5, temperature: 1}]\n";
    folder.write("seeds.yaml", gas + "figures: [{name: a, kind: speed-histogram, seeds: 64}]\n");
    folder.write("sweep.yaml", gas +
                                   "figures: [{name: a, kind: sweep, number: virial pressure, "
                                   "vary: \"run.sample_every=20,40\", seeds: 2}]\n");
    folder.write("set.yaml", "title: T\nscenes: [{scene: seeds.yaml}]\n");
    struct Case {
        std::vector<std::string> command;
        std::string much, what;
    };
    const std::vector<Case> cases{
        {{"figures", "seeds.yaml", "-o", "out"}, "run.until=3e4", "in each of 64 runs"},
        {{"figures", "set.yaml", "-o", "out"}, "run.until=3e4", "in each of 64 runs"},
        {{"check", "set.yaml"}, "run.until=3e4", "in each of 64 runs"},
        {{"figure", "seeds.yaml", "--kind", "speed-histogram", "--at", "1", "-o", "out"},
         "run.until=3e6",
         "collisions and crossings of cells"},
        {{"run", "seeds.yaml", "--json", "out"}, "run.until=3e6", "collisions and crossings"},
        {{"figures", "sweep.yaml", "-o", "out"}, "run.until=1e6", "4 runs of a sweep"},
        {{"plan", "seeds.yaml", "--seeds", "1:64", "-o", "out"},
         "run.until=3e4",
         "64 runs of a sweep"}};
    for (const auto& [small, much, what] : cases) {
        CAPTURE(small.front());
        CAPTURE(small[1]);
        std::vector<std::string> large = small;
        large.insert(large.end(), {"--set", much});
        const Outcome refused = held(folder, large);
        CAPTURE(refused.err);
        CHECK(refused.exit_code == 2);
        CHECK(has(refused.err, what));
        CHECK(has(refused.err, "the limit is 300 seconds of CPU time"));
        CHECK(has(refused.err, "reduce "));
        CHECK_FALSE(fs::exists(folder.path() / "out"));
        const Outcome made = held(folder, small);
        CAPTURE(made.err);
        CHECK(made.exit_code == 0);
        fs::remove_all(folder.path() / "out");
    }
}

TEST_CASE("a long point in the middle of a sweep is found") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [60, 60]}\nrun: {until: 5, sample_every: 100}\n"
                 "gas: [{count: 1000, radius: 0.5, temperature: 1}]\n");
    std::string values = "run.until=1";
    for (int k = 2; k < 150; ++k) values += "," + (k == 71 ? "5e6" : std::to_string(k));
    const Outcome refused = held(folder, {"plan", "scene.yaml", "--vary", values, "-o", "out"});
    CAPTURE(refused.err);
    CHECK(refused.exit_code == 2);
    CHECK(has(refused.err, "149 runs of a sweep"));
}

TEST_CASE("chunks of a plan are held to the limits that the whole plan has") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [60, 60]}\nrun: {until: 5}\n"
                 "gas: [{count: 1000, radius: 0.5, temperature: 1}]\n"
                 "film: {seconds: 100, fps: 60, size: [3840, 3840]}\n");
    REQUIRE(called(folder, {"plan", "scene.yaml", "-o", "film"}).exit_code == 0);
    REQUIRE(called(folder, {"plan", "scene.yaml", "--seeds", "1:900", "--set", "run.until=3000",
                            "-o", "sweep"})
                .exit_code == 0);
    const std::vector<std::vector<std::string>> commands{{"render", "film", "--chunk", "1"},
                                                         {"run", "sweep", "--chunk", "1"}};
    for (const std::vector<std::string>& command : commands) {
        CAPTURE(command.front());
        const Outcome refused = held(folder, command);
        CAPTURE(refused.err);
        CHECK(refused.exit_code == 2);
        CHECK(has(refused.err, "the limit is 300 seconds of CPU time"));
    }
}

TEST_CASE("a run ends at the collisions of a classroom, with its limit") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [4, 3]}\ngas: [{count: 6, radius: 0.4, speed: 1}]\n"
                 "run: {until: 1e6, precision: 64, sample_every: 1e5}\n");
    const Outcome ended = held(folder, {"run", "scene.yaml", "--quiet"});
    CHECK(ended.exit_code == 2);
    CHECK(has(ended.err, "the run has had 200000 collisions, the most that it may have"));
    CHECK(has(ended.err,
              "hint: the limit is 200000 collisions of a run of more bits than doubles "
              "have, with --limits classroom"));
}

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
    const Outcome beside = called(folder, {"check", "beside.yaml", "--limits", "classroom"});
    CHECK(beside.exit_code == 2);
    CHECK(has(beside.err, "20001 particles in all"));
}

TEST_CASE("a run ends at the collisions of a classroom, with its limit") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [4, 3]}\ngas: [{count: 6, radius: 0.4, speed: 1}]\n"
                 "run: {until: 1e6, precision: 64, sample_every: 1e5}\n");
    const Outcome ended = called(folder, {"run", "scene.yaml", "--quiet", "--limits", "classroom"});
    CHECK(ended.exit_code == 2);
    CHECK(has(ended.err, "the run has had 200000 collisions, the most that it may have"));
    CHECK(has(ended.err,
              "hint: the limit is 200000 collisions of a run of more bits than doubles "
              "have, with --limits classroom"));
}

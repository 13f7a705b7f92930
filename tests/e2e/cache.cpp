// --cache: axes that are known already, for the same pictures without the whole run.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// carom in a folder, which succeeds.
Outcome made(const std::string& arguments, const fs::path& folder) {
    const Outcome outcome = shell("'" + program + "' " + arguments, folder);
    CAPTURE(arguments);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome;
}

std::vector<fs::path> kept_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder)) files.push_back(file.path());
    return files;
}

bool finds_axes(const Outcome& timed) { return timed.out.find("axes") != std::string::npos; }

}  // namespace

// One that panels see event by event, one whose bits are to be found, and one with a run beside it.
TEST_CASE("films and stills with --cache are those without, from less of the run") {
    const TemporaryFolder folder;
    folder.write("own.yaml",
                 "title: Own\nbox: {size: [40, 30]}\n"
                 "gas: [{count: 40, radius: 0.5, speed: 1}]\nrun: {until: 20}\n"
                 "film: {seconds: 2, beside: {scene: other.yaml, label: Fast, own_label: Slow}, "
                 "panels: [pressure]}\n");
    folder.write("other.yaml",
                 "title: Other\nbox: {size: [40, 30]}\n"
                 "gas: [{count: 40, radius: 0.5, speed: 2}]\nrun: {until: 20}\n");
    for (const std::string& scene : {library_scene("one-hot-particle"),
                                     library_scene("time-reversal"), std::string("own.yaml")}) {
        CAPTURE(scene);
        const std::string options =
            fmt::format(" '{}' --size 480x270 --set film.seconds=2 ", scene);
        fs::remove_all(folder.path() / "kept");
        const auto check_same = [&](const std::string& command, const std::string& file) {
            CAPTURE(command);
            made(command + options + "--quiet -o plain-" + file, folder.path());
            const Outcome with = made(command + options + "--cache kept -o with-" + file +
                                          (command.starts_with("still") ? "" : " --timings"),
                                      folder.path());
            CHECK(contents(folder.path() / ("plain-" + file)) ==
                  contents(folder.path() / ("with-" + file)));
            return with;
        };
        CHECK(finds_axes(check_same("render", "a.mp4")));
        CHECK(kept_in(folder.path() / "kept").size() == 1);
        CHECK_FALSE(finds_axes(check_same("render --from 3 --to 6", "b.mp4")));
        CHECK_FALSE(finds_axes(check_same("render --to 4 --words", "c.webm")));
        CHECK_FALSE(finds_axes(check_same("render", "d.gif")));
        CHECK(contents(folder.path() / "plain-c.vtt") == contents(folder.path() / "with-c.vtt"));
        check_same("still --at 7", "e.png");
        check_same("still --at 0", "f.png");
        CHECK(kept_in(folder.path() / "kept").size() == 1);
    }
}

// The last frame sounds like the collisions before the next one, which the film does not show.
TEST_CASE("a part of a film with --cache has the sound and the captions that it has without") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: Clicks\nbox: {size: [20, 10]}\n"
                 "gas: [{name: a, count: 20, radius: 0.3, speed: 1}]\nrun: {until: 6}\n"
                 "film: {seconds: 10, fps: 10, size: [64, 64], panels: [], sound: {}}\n");
    for (const char* to : {"0.4", "0.5", "6"}) {
        CAPTURE(to);
        const std::string render = fmt::format("render scene.yaml --quiet --words --to {} -o ", to);
        made(render + "plain.mp4", folder.path());
        for (const char* name : {"first", "second"})
            made(fmt::format("{}{}.mp4 --cache kept", render, name), folder.path());
        for (const char* ending : {".mp4", ".captions.vtt"})
            for (const char* name : {"first", "second"}) {
                const std::string file = std::string(name) + ending;
                CAPTURE(file);
                CHECK(contents(folder.path() / file) ==
                      contents(folder.path() / (std::string("plain") + ending)));
            }
    }
}

TEST_CASE("--cache keeps axes of each scene, seed and change apart, and makes damaged ones again") {
    const TemporaryFolder folder;
    const std::string scene = fmt::format("'{}'", library_scene("one-hot-particle"));
    const std::string still = "still --at 5 --quiet --size 480x270 --set film.seconds=1 ";
    made(still + scene + " -o plain.png", folder.path());
    made(still + scene + " --cache kept -o with.png", folder.path());
    REQUIRE(kept_in(folder.path() / "kept").size() == 1);
    const fs::path file = kept_in(folder.path() / "kept").front();
    const std::string kept = contents(file);
    made(still + scene + " --cache kept --quick -o with.png --set film.seconds=2", folder.path());
    CHECK(kept_in(folder.path() / "kept").size() == 1);  // not of so few times
    made(still + scene + " --cache kept -o with.png --set seed=2", folder.path());
    made(still + scene + " --cache kept -o with.png --theme light", folder.path());
    CHECK(kept_in(folder.path() / "kept").size() == 3);
    for (const std::string& damaged :
         {kept.substr(0, kept.size() / 2), std::string("x" + kept.substr(1)),
          kept.substr(0, kept.size() - 1) + "x", std::string()}) {
        folder.write(fs::relative(file, folder.path()).string(), damaged);
        made(still + scene + " --cache kept -o with.png", folder.path());
        CHECK(contents(folder.path() / "plain.png") == contents(folder.path() / "with.png"));
        CHECK(contents(file) == kept);
    }
}

TEST_CASE("a folder for --cache that cannot be made is refused before any work") {
    const TemporaryFolder folder;
    folder.write("file", "mine");
    for (const auto& asked : {std::pair{"render", "a.mp4"}, std::pair{"still", "a.png"}}) {
        const auto& command = asked.first;
        const auto& output = asked.second;
        CAPTURE(std::string(command));
        const Outcome outcome =
            shell(fmt::format("'{}' {} '{}' --quiet --cache file/in -o {}", program, command,
                              library_scene("one-hot-particle"), output),
                  folder.path());
        CHECK(outcome.exit_code == 1);
        CHECK(outcome.err == "carom: --cache file/in: cannot make this folder: Not a directory\n");
        CHECK(folder.names() == std::vector<std::string>{"file"});
    }
}

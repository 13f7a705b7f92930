// What `carom check` accepts, the other commands accept: no scene that it calls valid makes one of
// them end with exit code 2, except commands that it names in `refused`.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"
#include "support/share_of_cases.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string gas = "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\n";
const std::string figure = "figures: [{name: speeds, kind: speed-histogram}]\n";

// Changes after which many scenes of figures are not valid any more, or cannot have a film.
const std::vector<std::string> changes{"film.fps=1",
                                       "film.ground=none",
                                       "film.template=minimal",
                                       "film.panels=[entropy]",
                                       "gas.0.count=1",
                                       "gas.0.count=2",
                                       "gas.0.count=0",
                                       "gas.0.mass=3",
                                       "gas.0.mass=infinite",
                                       "gas.0.radius=0",
                                       "gas.0.speed=0",
                                       "box.walls=periodic",
                                       "gravity=[0, -0.1]",
                                       "run.precision=100",
                                       "run.until=1",
                                       "run.time_step=0.05",
                                       "run.equilibrate=1",
                                       "run.most_collisions=5",
                                       "run.events=[{at: 0.5, reverse: true}]",
                                       "run.events=[{at: 0.1, heat: 2}]",
                                       "figures.0.seeds=2",
                                       "figures.0.test=true",
                                       "figures.0.theory=true",
                                       "figures.0.over=start",
                                       "figures.0.walk=true",
                                       "figures.0.of=[0, 1]",
                                       "figures.0.size=3"};

Outcome called(const TemporaryFolder& folder, std::vector<std::string> command,
               const std::string& change) {
    command.insert(command.begin(), program);
    if (!change.empty()) command.insert(command.end(), {"--set", change});
    return run(command, folder.path());
}

// The commands that `carom check` names as refusing a valid scene; nothing if it is not valid.
std::optional<std::string> refused_of(const TemporaryFolder& folder, const std::string& scene,
                                      const std::string& change) {
    const Outcome checked = called(folder, {"check", scene, "--json"}, change);
    if (checked.exit_code != 0) return std::nullopt;
    std::string commands;
    const nlohmann::json all = nlohmann::json::parse(checked.out);
    for (const auto& one : all.at(0).at("refused"))
        for (const auto& command : one.at("commands")) commands += command.get<std::string>() + ";";
    return commands;
}

// Returns whether the scene is valid; checks that the commands agree.
bool agree(const TemporaryFolder& folder, const std::string& scene, const std::string& change) {
    CAPTURE(scene);
    CAPTURE(change);
    const std::optional<std::string> refused = refused_of(folder, scene, change);
    if (!refused) return false;
    const auto accepts = [&](const std::vector<std::string>& command) {
        const Outcome made = called(folder, command, change);
        CAPTURE(made.err);
        CHECK(made.exit_code == 0);
    };
    if (has(contents(folder.path() / scene), "\nfigures:"))
        accepts({"figures", scene, "-o", scene + ".figures", "--formats", "csv", "--force"});
    if (!has(*refused, "still;"))
        accepts({"still", scene, "--quick", "--size", "320x180", "-o", scene + ".png"});
    accepts({"run", scene, "--json", "run.json"});
    return true;
}

}  // namespace

TEST_CASE("a run of which no film can be made has figures") {
    const TemporaryFolder folder;
    folder.write("long.yaml", gas + "run: {until: 60000}\n" + figure);
    folder.write("captions.yaml",
                 gas +
                     "run: {until: 20, events: [{at: 1, caption: One}, {at: 1.5, caption: "
                     "Two}]}\n" +
                     figure);
    for (const std::string scene : {"long.yaml", "captions.yaml"}) {
        CHECK(agree(folder, scene, ""));
        CHECK(has(refused_of(folder, scene, "").value(), "render;still;plan;gallery;"));
        CHECK(called(folder, {"still", scene, "-o", "still.png"}, "").exit_code == 2);
        // A caption in another language is no wish for a film.
        CHECK(agree(folder, scene, "film.language=de"));
        const Outcome words = called(folder, {"check", scene}, "");
        CHECK(has(words.out, "refused      render, still, plan, gallery and figures --films: "));
    }
    const Outcome streamed = run({"sh", "-c", program + " check - < long.yaml"}, folder.path());
    CHECK(streamed.exit_code == 0);
}

TEST_CASE("check names the formats that a film cannot have") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", gas + "run: {until: 2}\nfilm: {seconds: 1, size: [320, 180]}\n");
    CHECK(refused_of(folder, "scene.yaml", "") == "");
    const std::string refused = refused_of(folder, "scene.yaml", "film.ground=none").value();
    CHECK(refused == "render as mp4;plan as mp4;gallery as mp4;render as gif;plan as gif;");
    for (const std::string format : {"mp4", "webm", "gif", "png"}) {
        CAPTURE(format);
        const bool is_refused = has(refused, "render as " + format);
        CHECK(called(folder, {"render", "scene.yaml", "--format", format}, "film.ground=none")
                  .exit_code == (is_refused ? 2 : 0));
    }
}

TEST_CASE("check refuses tests of histograms that are not possible") {
    const TemporaryFolder folder;
    folder.write("mixed.yaml",
                 "title: T\nbox: {size: [40, 30]}\ngas: [{name: a, count: 29, speed: 1}, {name: "
                 "b, count: 29, mass: 3, speed: 1}]\nrun: {until: 20}\nfigures: [{name: speeds, "
                 "kind: speed-histogram, at: 20, test: true}]\n");
    CHECK_FALSE(agree(folder, "mixed.yaml", ""));
    CHECK(agree(folder, "mixed.yaml", "gas.1.mass=1"));
    CHECK_FALSE(agree(folder, "mixed.yaml", "figures.0.seeds=2"));
}

TEST_CASE("no command refuses a scene that check accepts") {
    const TemporaryFolder folder;
    std::vector<std::string> scenes;
    for (const fs::path& file : yaml_files(root / "docs/panels"))
        if (!has(contents(file), "\nscenes:")) {
            scenes.push_back(file.filename().string());
            folder.write(scenes.back(), contents(file));
        }
    CHECK(scenes.size() > 30);
    const int share = every_nth(25, 64);  // no divisor of the number of changes
    int tried = 0, valid = 0;
    for (const std::string& scene : scenes)
        for (const std::string& change : changes)
            if (tried++ % share == 0 && agree(folder, scene, change)) ++valid;
    CHECK(valid * share > tried / 4);
}

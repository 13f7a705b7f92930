// Runs that the command line ends earlier: what would be shown or happen later is left out, with a
// note, and the scene stays valid.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scene/load.h"
#include "scene/scene.h"
#include "support/files.h"
#include "support/library.h"
#include "support/resources.h"
#include "support/test_root.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

const std::string with_later_things = R"(title: T
box: {size: [40, 30]}
gas: [{name: a, count: 20, radius: 0.5, speed: 1}]
run:
  until: 10
  events:
    - {at: 2, caption: early}
    - {at: 5, caption: at the end}
    - {at: 8, heat: {by: 3}}
film:
  seconds: 20
  panels: [entropy, {kind: speed-histogram, show: {from: 6}}]
  spotlight: [{from: 1, to: 9, of: a}, {from: 6, of: a}]
  callouts: [{at: 1, points_to: 0, text: early}, {at: 7, points_to: 0, text: late}]
  camera: [{at: 1, view: [1, 1, 9, 9]}, {at: 7, view: box}]
  slow: [{from: 2, to: 7, factor: 0.5}]
figures:
  - {name: early, kind: gas, at: 3}
  - {name: late, kind: gas, at: 6}
  - {name: end, kind: gas}
  - {name: span, kind: speed-histogram, over: [4, 7]}
  - {name: strip, kind: gas, strip: [1, 3, 9]}
  - {name: late-strip, kind: gas, strip: [3, 6, 9]}
)";

Scene loaded(const Overrides& overrides) {
    fs::current_path(test::checkout());
    return load_scene_text(with_later_things, "scenes/test.yaml", test::resources(), overrides);
}

}  // namespace

TEST_CASE("an earlier end of the run leaves out what comes later, with a note") {
    const Scene scene = loaded({"run.until=5"});
    REQUIRE(scene.captions.size() == 1);
    CHECK(scene.captions[0].words == "early");
    CHECK(scene.run.events.empty());
    CHECK(scene.film.panels.size() == 1);
    CHECK(scene.film.spotlights.size() == 1);
    CHECK(scene.film.callouts.size() == 1);
    CHECK(scene.film.camera.size() == 1);
    REQUIRE(scene.film.slow.size() == 1);
    CHECK(scene.film.slow[0].to == 5.0);
    std::vector<std::string> figures;
    for (const FigureSpec& figure : scene.figures) figures.push_back(figure.name);
    CHECK(figures == std::vector<std::string>{"early", "end", "strip"});
    CHECK(scene.figures[2].times == std::vector{1.0, 3.0});
    REQUIRE(scene.notes.size() == 1);
    CHECK(scene.notes[0].span.file == "--set run.until=5");
    CHECK(scene.notes[0].message ==
          "the run ends at 5 now, before 2 events, 1 panel, 1 callout, 1 spotlight, 1 camera move "
          "and 3 figures of the scene");
}

TEST_CASE("without an earlier end nothing is left out") {
    CHECK(loaded({}).notes.empty());
    CHECK(loaded({}).figures.size() == 6);
    CHECK(loaded({"run.until=10"}).figures.size() == 6);
    CHECK(loaded({"run.until=20"}).notes.empty());
}

TEST_CASE("a run of another form, or none, is an error like any other") {
    const auto refused = [](const std::string& run, const Overrides& overrides) {
        fs::current_path(test::checkout());
        CHECK_THROWS_AS(
            load_scene_text("title: T\nbox: {size: [40, 30]}\ngas: [{count: 2}]\n" + run,
                            "scenes/test.yaml", {"templates", panel_kinds()}, overrides),
            SceneError);
    };
    refused("run: 5\n", {"run.until=3"});
    refused("", {"run.until=["});
    refused("run: {until: 5}\n", {"run.until=3", "run=4"});
}

TEST_CASE("what the command line itself sets later is an error") {
    CHECK_THROWS_AS(loaded({"run.until=5", "figures.0.at=7"}), SceneError);
}

TEST_CASE("every scene of the library may be ended early, unless a reversal needs its time") {
    fs::current_path(test::checkout());
    for (const fs::path& path : test::library_files())
        for (const char* until : {"1", "7.5"}) {
            CAPTURE(path.string());
            CAPTURE(until);
            std::string errors;
            try {
                load_scene(path, test::resources(), {std::string("run.until=") + until});
            } catch (const SceneError& error) {
                errors = error.what();
            }
            CAPTURE(errors);
            const bool waits = errors.find("the gas returns to its start at") != std::string::npos;
            CHECK((errors.empty() || waits));
        }
}

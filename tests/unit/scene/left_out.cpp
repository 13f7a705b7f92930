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
          "the run ends at 5 now, before 1 event (at 8), 1 caption (at 5), 1 panel "
          "(`speed-histogram`), 1 callout (at 7), 1 spotlight (from 6), 1 camera move (at 7), 3 "
          "figures (`late`, `span` and `late-strip`) and 1 moment in figure `strip` of the scene");
    CHECK(scene.notes[0].hint == "they are left out");
}

TEST_CASE("what is refused with a note is an error for those who ask for it") {
    fs::current_path(test::checkout());
    SceneResources strict = test::resources();
    strict.is_strict = true;
    const auto load = [&](const Overrides& overrides) {
        return load_scene_text(with_later_things, "scenes/test.yaml", strict, overrides);
    };
    CHECK(load({}).figures.size() == 6);
    std::string errors;
    try {
        load({"run.until=5"});
    } catch (const SceneError& error) {
        errors = error.what();
    }
    CAPTURE(errors);
    CHECK(errors.starts_with("--set run.until=5"));
    CHECK(errors.find("before 1 event (at 8), 1 caption (at 5), ") != std::string::npos);
    CHECK(errors.find("hint: without --strict this is a note: they are left out") !=
          std::string::npos);
}

TEST_CASE("of many things that are left out some are named") {
    std::string text = with_later_things;
    for (int at = 11; at < 20; ++at)
        text.insert(text.find("film:"), "    - {at: " + std::to_string(at) + ", mark: later}\n");
    text.replace(text.find("until: 10"), 9, "until: 20");
    fs::current_path(test::checkout());
    const Scene scene =
        load_scene_text(text, "scenes/test.yaml", test::resources(), {"run.until=10.5"});
    REQUIRE(scene.notes.size() == 1);
    CHECK(scene.notes[0].message ==
          "the run ends at 10.5 now, before 9 events (at 11, 12, 13, 14, 15 and 4 more) of the "
          "scene");
}

TEST_CASE("a run that is wanted alone is read without film and figures, to any end") {
    const auto load = [](const std::string& text, const Overrides& overrides) {
        fs::current_path(test::checkout());
        return load_scene_text(text, "scenes/test.yaml", test::resources(), overrides, Wanted::run);
    };
    const Scene early = load(with_later_things, {"run.until=5"});
    CHECK(early.run.until == 5.0);
    CHECK(early.run.events.empty());
    CHECK(early.figures.empty());
    CHECK(early.notes.empty());
    const Scene late = load(with_later_things, {"run.until=50"});
    CHECK(late.run.until == 50.0);
    CHECK(late.run.events.size() == 1);
    std::string mistaken = with_later_things;
    mistaken.replace(mistaken.find("seconds: 20"), 11, "secnods: 20");
    CHECK(load(mistaken, {}).run.until == 10.0);
    mistaken.replace(mistaken.find("heat: {by: 3}"), 13, "heat: {by: x}");
    CHECK_THROWS_AS(load(mistaken, {}), SceneError);
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

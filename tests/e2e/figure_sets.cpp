// Figure sets, by the program itself: figures of several scenes in one folder and on one page, and
// comparisons of their runs.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/figure_folder.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("the sets of the library make their pages, and the same bytes twice") {
    for (const std::string name : {"kinetic-theory", "collisions"}) {
        CAPTURE(name);
        const TemporaryFolder folder;
        const std::string set = (root / "scenes/sets" / (name + ".yaml")).string();
        const Outcome made = figures(folder, {set});
        CAPTURE(made.err);
        REQUIRE(made.exit_code == 0);
        CHECK_FALSE(has(made.err, "carom: "));  // where they take long, how far they are
        const fs::path out = folder.path() / "out" / name;
        const json words = json::parse(contents(out / "captions.json"));
        CHECK(words.at("figures").size() >= 7);
        for (const std::string ending : {".html", ".tex", ".md"})
            for (const json& figure : words.at("figures"))
                CHECK(has(contents(out / (name + ending)), figure.at("name").get<std::string>()));
        CHECK(has(figures(folder, {set}).out, "up to date"));
        CHECK(figures(folder, {set, "-o", "again"}).exit_code == 0);
        CHECK(files_in(out) == files_in(folder.path() / "again"));
        if (is_installed("chromium"))
            CHECK_FALSE(
                has(seen_in_browser(out / (name + ".html"), folder.path() / "profile"), ":false"));
    }
}

TEST_CASE("a comparison of a set is made from all its scenes, and anew when one of them changes") {
    const TemporaryFolder folder;
    folder.write("one.yaml", ten_disks);
    folder.write("two.yaml", ten_disks);
    folder.write("set.yaml",
                 "title: Both\nscenes: [{scene: one.yaml, figures: [start]}]\nformats: [svg, csv]\n"
                 "template: markdown\ncomparisons:\n"
                 "  - name: both\n    kind: speed-histogram\n    at: 5\n    scenes:\n"
                 "      - {scene: one.yaml, label: first}\n"
                 "      - {scene: two.yaml, label: \"second, faster\", set: gas.0.speed=4}\n");
    const Outcome made = figures(folder, {"set.yaml"});
    CAPTURE(made.err);
    REQUIRE(made.exit_code == 0);
    CHECK(made.out == "out/set: 2 figures made\n");
    const fs::path out = folder.path() / "out/set";
    const json words = json::parse(contents(out / "captions.json"));
    const json runs = words.at("figures")[1].at("runs");
    CHECK(runs[0].at("label") == "first");
    CHECK(runs[1].at("scene") == "two");
    CHECK(runs[1].at("overrides") == json{"gas.0.speed=4"});
    CHECK(has(contents(out / "both.csv"), "\n\"second, faster\",bar,all,"));
    const std::string page = contents(out / "set.md");
    CHECK(page.find("## Ten disks") < page.find("## Comparison"));
    CHECK(page.find("## Comparison") < page.find("(both.svg)"));
    CHECK(has(page, "second, faster (“Ten disks”, speed 4; 10 disks, "));
    CHECK(has(figures(folder, {"set.yaml"}).out, "up to date, 2 figures"));
    const std::string before = contents(out / "both.svg");
    std::string slower = ten_disks;
    folder.write("two.yaml", slower.replace(slower.find("radius: 1,"), 10, "radius: 2,"));
    CHECK(figures(folder, {"set.yaml"}).out == "out/set: 1 figure made, 1 up to date\n");
    CHECK(contents(out / "both.svg") != before);
    for (const std::string threads : {"1", "3"})
        CHECK(figures(folder, {"set.yaml", "-o", "t" + threads, "--threads", threads}).exit_code ==
              0);
    CHECK(files_in(folder.path() / "t1") == files_in(folder.path() / "t3"));
    // Films are of scenes, and a comparison has none.
    CHECK(figures(folder, {"set.yaml", "--films", "--quiet", "--set", "film.size=[320, 180]"})
              .exit_code == 0);
    CHECK(fs::exists(out / "one.mp4"));
    CHECK_FALSE(fs::exists(out / "both.mp4"));
    CHECK_FALSE(fs::exists(out / ".film"));
}

TEST_CASE("what a set asks of its scenes must be there, and be told apart") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", ten_disks);
    folder.write("other.yaml", ten_disks);
    folder.write("set.yaml", "title: T\nscenes: [{scene: scene.yaml, figures: [speed]}]\n");
    const Outcome unknown = figures(folder, {"set.yaml"});
    CHECK(unknown.exit_code == 2);
    CHECK(has(unknown.err, "set.yaml:2:40: error: scene.yaml has no figure `speed`"));
    CHECK(has(unknown.err, "did you mean `speeds`?"));
    folder.write("set.yaml", "title: T\nscenes: [scene.yaml, other.yaml]\n");
    const Outcome same = figures(folder, {"set.yaml"});
    CHECK(same.exit_code == 2);
    CHECK(has(same.err, "scene.yaml and other.yaml both have a figure `start`"));
    folder.write("set.yaml", "title: T\nscenes: [nowhere.yaml]\n");
    CHECK(figures(folder, {"set.yaml"}).exit_code == 2);
    folder.write("set.yaml",
                 "title: Both\nformats: [svg]\ntemplate: markdown\nscenes:\n"
                 "  - {scene: other.yaml, figures: [speeds], title: First}\n"
                 "  - {scene: scene.yaml, figures: [start], description: Words.}\n");
    CHECK(figures(folder, {"set.yaml"}).exit_code == 0);
    CHECK(folder.names() ==
          std::vector<std::string>{"other.yaml", "out", "scene.yaml", "set.yaml"});
    const std::string page = contents(folder.path() / "out/set/set.md");
    CHECK(page.starts_with("# Both\n"));
    CHECK(page.find("## First") < page.find("(speeds.svg)"));
    CHECK(page.find("(speeds.svg)") < page.find("## Ten disks"));
    CHECK(page.find("Words.") < page.find("(start.svg)"));
}

TEST_CASE("a set has its figures in the order in which it lists them, of scenes of any folder") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "other");
    folder.write("scene.yaml", ten_disks);
    folder.write("set.yaml",
                 "title: T\nformats: [svg]\nscenes: [{scene: scene.yaml, figures: [speeds, "
                 "start]}]\n");
    CHECK(figures(folder, {"set.yaml"}).exit_code == 0);
    const json words = json::parse(contents(folder.path() / "out/set/captions.json"));
    CHECK(words["figures"][0]["name"] == "speeds");
    CHECK(words["figures"][1]["name"] == "start");
    const std::string page = contents(folder.path() / "out/set/set.html");
    CHECK(page.find("id=\"speeds\"") < page.find("id=\"start\""));
    // Films of two scenes of one name would overwrite each other.
    std::string renamed = ten_disks;
    renamed.replace(renamed.find("name: start"), 11, "name: begin");
    renamed.replace(renamed.find("name: speeds"), 12, "name: fast");
    folder.write("other/scene.yaml", renamed);
    folder.write("set.yaml", "title: T\nscenes: [scene.yaml, other/scene.yaml]\n");
    const Outcome same = figures(folder, {"set.yaml"});
    CHECK(same.exit_code == 2);
    CHECK(has(same.err, "two of its scenes are called scene"));
    // A figure that the set no longer shows is told, and left.
    folder.write("set.yaml",
                 "title: T\nformats: [svg]\nscenes: [{scene: scene.yaml, figures: [start]}]\n");
    CHECK(has(figures(folder, {"set.yaml"}).err, "speeds.svg of figures that no longer exist"));
    CHECK(fs::exists(folder.path() / "out/set/speeds.svg"));
}

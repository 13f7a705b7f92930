// carom check, by the program itself: what it says of scenes, against what they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

json checked(const std::string& scene) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + scene);
    const Outcome outcome = run({program, "check", "--json", "scene.yaml"}, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    return json::parse(outcome.out).at(0);
}

// Collisions between particles in the run itself.
double counted(const std::string& scene) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + scene);
    const Outcome outcome =
        run({program, "run", "--quiet", "--json", "-", "scene.yaml"}, folder.path());
    REQUIRE(outcome.exit_code == 0);
    return json::parse(outcome.out).at("collisions").at("particle");
}

// As far as the name of its figure.
const std::string with_figure =
    "title: T\nbox: {size: [40, 30]}\ngas: [{count: 10, radius: 1, speed: 2}]\n"
    "run: {until: 10}\nfilm: {seconds: 1}\nfigures:\n  - {name: ";

}  // namespace

TEST_CASE("carom check tells what a scene is") {
    const json found = checked(
        "seed: 5\nbox: {size: [40, 30], walls: {left: periodic, right: periodic}}\n"
        "gas: [{name: a, count: 30}, {name: b, radius: 2, position: [[9, 9], [20, 20]]}]\n"
        "run: {until: 12, equilibrate: 3}\nfilm: {seconds: 8, fps: 25, size: [640, 360]}\n");
    CHECK(found.at("scene") == "scene.yaml");
    CHECK(found.at("valid") == true);
    CHECK(found.at("errors") == json::array());
    CHECK(found.at("title") == "T");
    CHECK(found.at("seed") == 5);
    CHECK(found.at("dimension") == 2);
    CHECK(found.at("box") == json{{"size", {40, 30}},
                                  {"walls",
                                   {{"left", "periodic"},
                                    {"right", "periodic"},
                                    {"bottom", "solid"},
                                    {"top", "solid"}}}});
    CHECK(found.at("particles") == 32);
    CHECK(found.at("species") ==
          json{{{"name", "a"}, {"count", 30}}, {{"name", "b"}, {"count", 2}}});
    const double area = std::numbers::pi * (30 * 0.25 + 2 * 4.0);
    CHECK(std::abs(found.at("packing_fraction").get<double>() - area / 1200.0) < 1e-14);
    CHECK(found.at("time") == 12);
    CHECK(found.at("equilibrate") == 3);
    CHECK(found.at("expected_collisions") == 0);
    CHECK(found.at("film").at("frames") == 200);
    CHECK(found.at("film").at("seconds") == 8);
    CHECK(found.at("film").at("size") == json{640, 360});
    CHECK(found.at("film").at("template") == "lecture");
}

TEST_CASE("check warns of a gas that is at rest for ever") {
    const std::string until = "\nrun: {until: 5}\n";
    const std::string box = "box: {size: [20, 15]", still = "}\ngas: [{count: 3, radius: 0.5}]";
    CHECK(checked(box + still + until).at("at_rest") == true);
    CHECK(checked(box + "}\ngas: [{count: 3, radius: 0.5, speed: 1}]" + until).at("at_rest") ==
          false);
    CHECK(checked(box + "}\ngravity: [0, -1]\ngas: [{count: 3, radius: 0.5}]" + until)
              .at("at_rest") == false);
    CHECK(checked(box + ", walls: {left: {temperature: 1}}" + still + until).at("at_rest") ==
          false);
    CHECK(checked(box + ", walls: {left: {velocity: 0.1}}" + still + until).at("at_rest") == false);
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + box + still + until);
    CHECK(has(run({program, "check", "scene.yaml"}, folder.path()).out,
              "\n  warning      all particles are at rest, and nothing moves them: "));
}

TEST_CASE("check lists the panels that have no theory, and why") {
    const json found = checked(
        "box: {size: [20, 15], walls: {left: {temperature: 1}}}\n"
        "gas: [{count: 30, radius: 0.5, speed: 1}]\nrun: {until: 5}\n"
        "figures: [{name: a, kind: speed-histogram}, {name: b, kind: "
        "mean-squared-displacement}]\n");
    CHECK(found.at("no_theory") ==
          json{"speed-histogram: a heat bath exchanges energy with the gas",
               "a: a heat bath exchanges energy with the gas",
               "b: the walls limit how far particles can move"});
}

TEST_CASE("a wire has a line fraction") {
    const json found = checked(
        "box: {length: 20}\ngas: [{count: 8, radius: 0.25, temperature: 1}]\nrun: {until: 5}\n");
    CHECK(found.at("dimension") == 1);
    CHECK(found.at("packing_fraction") == 0.2);
    CHECK(found.at("box") ==
          json{{"length", 20}, {"walls", {{"left", "solid"}, {"right", "solid"}}}});
}

// Of a normal distribution with mean and deviation 1: truncated at 0, mean 1.2876 and deviation
// 0.7935; folded, 1.1666 and 0.7994 (tables of both distributions).
TEST_CASE("carom check says what is cut from normal distributions, if it is more than 1 %") {
    const json found = checked(
        "box: {size: [40, 30]}\ngas:\n"
        "  - {name: a, count: 5, mass: {normal: [1, 1]}, speed: {normal: [1, 1]}}\n"
        "  - {name: b, count: 5, radius: {normal: [0.5, 0.25]}, density: {normal: [1, 0.42]}}\n"
        "run: {until: 12}\n");
    const json& cut = found.at("cut_distributions");
    REQUIRE(cut.size() == 3);
    const auto check_cut = [](const json& one, const char* species, const char* key, double mean,
                              double deviation) {
        CHECK(one.at("species") == species);
        CHECK(one.at("key") == key);
        CHECK(std::abs(one.at("mean").get<double>() - mean) < 1e-4);
        CHECK(std::abs(one.at("deviation").get<double>() - deviation) < 1e-4);
    };
    check_cut(cut[0], "a", "mass", 1.2876, 0.7935);
    check_cut(cut[1], "a", "speed", 1.1666, 0.7994);
    check_cut(cut[2], "b", "radius", 0.5138, 0.2354);
    CHECK(checked("box: {size: [40, 30]}\ngas: [{count: 5, mass: {normal: [1, 0.42]}}]\n"
                  "run: {until: 12}\n")
              .at("cut_distributions")
              .empty());
}

// 20,000 collisions scatter by less than 1 %, theory is off by as much.
TEST_CASE("estimates are plain numbers of two digits") {
    const auto collisions = [](const std::string& until) {
        const Outcome outcome =
            run({program, "check", (root / "scenes/bonkers-mixture.yaml").string(), "--set",
                 "run.until=" + until, "--set", "film.seconds=1", "--set",
                 "run.sample_every=" + until});
        CHECK(outcome.exit_code == 0);
        const std::size_t begin = outcome.out.find("collisions");
        return outcome.out.substr(begin, outcome.out.find('\n', begin) - begin);
    };
    // 1,556 in a time of 300, 2/9 of them for each of nine beads
    CHECK(collisions("300").find("about 1600 between particles, 350 for each") !=
          std::string::npos);
    CHECK(collisions("30000").find(", 35\u2009000 for each") != std::string::npos);
    CHECK(collisions("3").find("about 16 between particles, 3.5 for each") != std::string::npos);
    CHECK(collisions("0.003").find("0.016 between particles, less than 0.01 for each") !=
          std::string::npos);
}

TEST_CASE("a gas in equilibrium collides as often as carom check expects") {
    const std::string scene =
        "box: {size: [60, 45], walls: periodic}\n"
        "gas: [{name: a, count: 300, temperature: 1}, {name: b, count: 100, radius: 1, mass: 4, "
        "temperature: 1}]\nrun: {until: 60, equilibrate: 5}\n";
    const double expected = checked(scene).at("expected_collisions");
    CHECK(std::abs(counted(scene) / expected - 1.0) < 0.03);
}

TEST_CASE("carom check names what has no room, and a field of blank cells") {
    const std::string scene = "subtitle: " + std::string(190, 'w') +
                              "\nbox: {size: [40, 30]}\ngas: [{count: 96, radius: 0.3, speed: 2}]\n"
                              "run: {until: 12}\nfilm:\n  seconds: 8\n"
                              "  panels: [{kind: entropy, title: " +
                              std::string(99, 'w') + "}]\n";
    const json cut = checked(scene).at("cut");
    CHECK(cut == json{"the subtitle “" + std::string(190, 'w') + "”",
                      "the title “" + std::string(99, 'w') + "” of a panel"});
    const TemporaryFolder places;
    places.write("small.yaml",
                 "layout:\n  grid: [60, 33.75]\n  title: [1, 1, 57, 3]\n  gas: [1, 5, 35, 25]\n"
                 "  color_bar: [36, 5, 5, 25]\n"
                 "  panels: [[42, 4, 16, 7], [42, 14, 16, 6.9], [42, 24, 7, 9], [50, 24, 4, 3], "
                 "[50, 28, 8, 3]]\n");
    places.write("scene.yaml",
                 "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 2}]\n"
                 "run: {until: 12}\nfilm: {seconds: 8, template: small, panels: "
                 "[speed-histogram, entropy, {kind: temperature, title: T}, "
                 "{kind: text, words: a}, {kind: monitors, numbers: [time, fast, slow]}]}\n");
    const Outcome small = run({program, "check", "--json", "scene.yaml"}, places.path());
    CHECK(json::parse(small.out).at(0).at("cut") ==
          json{"the panel `entropy` (its place is 16 by 6.9 units, it needs 8 by 7)",
               "the panel `temperature` (its place is 7 by 9 units, it needs 8 by 7)",
               "the monitor `fast`", "the monitor `slow`", "the words “mean” of a plot",
               "the words “mean at start” of a plot", "the words “equilibrium 1.68” of a plot",
               "the words “temperature” of a plot"});
    places.write("words.yaml",
                 "title: T" + std::string(120, 'w') +
                     "\nbox: {size: [10, 10]}\ngas: [{count: 9, radius: 0.3, speed: 2}]\n"
                     "run: {until: 12, events: [{at: 1, mark: " +
                     std::string(40, 'w') +
                     "}]}\nfilm:\n  {seconds: 8, size: [360, 640], template: portrait, title_card: "
                     "true, end_card: e" +
                     std::string(150, 'w') + ", panels: [temperature],\n   beside: {own_label: " +
                     std::string(40, 'w') + ", label: b, set: seed=4}}\n");
    const Outcome words = run({program, "check", "--json", "words.yaml"}, places.path());
    CHECK(json::parse(words.out).at(0).at("cut") ==
          json{"the title or the subtitle", "the mark “" + std::string(40, 'w') + "”",
               "the label “" + std::string(40, 'w') + "”"});
    places.write("three.yaml",
                 "title: T\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 2}]\n"
                 "run: {until: 12}\nfilm: {seconds: 8, panels: [speed-histogram, "
                 "entropy, temperature]}\n");
    const Outcome square = run(
        {program, "check", "--json", "three.yaml", "--set", "film.template=square"}, places.path());
    CHECK(json::parse(square.out).at(0).at("cut") ==
          json{"the panel `temperature` (template square has places for 2)"});
    CHECK(checked("box: {size: [40, 30]}\ngas: [{count: 96, radius: 0.3, speed: 2}]\n"
                  "run: {until: 12}\nfilm: {seconds: 8}\n")
              .at("cut") == json::array());

    const TemporaryFolder folder;
    const auto told = [&](const std::string& cells) {
        folder.write("scene.yaml", "title: T\npartitions: [{name: p, x: 20, gaps: [[14, 16]]}]\n" +
                                       scene + "  field: {of: density, cells: " + cells + "}\n");
        return run({program, "check", "scene.yaml"}, folder.path()).out;
    };
    CHECK(told("8").find("2 particles in a cell on average") != std::string::npos);  // of 48 cells
    CHECK(told("4").find("on average") == std::string::npos);  // of 12: 8 in each
}

TEST_CASE("a length that the command line sets is checked, whichever the file has") {
    const TemporaryFolder folder;
    for (const auto& [written, set] : {std::pair{"pace: 1", "film.seconds=80000"},
                                       {"pace: 1", "film.seconds=0.01"},
                                       {"seconds: 5", "film.pace=1e-5"}}) {
        folder.write("scene.yaml", std::string("title: T\nbox: {size: [40, 30]}\ngas: [{count: 5, "
                                               "speed: 1}]\nrun: {until: 5}\nfilm: {") +
                                       written + "}\n");
        const Outcome outcome = run({program, "check", "scene.yaml", "--set", set}, folder.path());
        CAPTURE(set);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.err.find("at 30 frames a second has") != std::string::npos);
    }
}

TEST_CASE("an MP4 that many players refuse is named") {
    const std::string scene = "'" + library_scene("one-hot-particle") + "' ";
    for (const auto& [options, level, words] :
         {std::tuple{"--size 2160p --fps 60", json("5.2"), ""},
          {"--size 2160p --fps 120", json("6"), "it needs H.264 level 6, "},
          {"--size 8192x4320", json("6"), "it needs H.264 level 6, "},
          {"--size 8192x8192", json(), "it is beyond all levels of H.264, "},
          {"--size 8192x4320 --format webm", json(), ""}}) {
        CAPTURE(options);
        const std::string call = "'" + program + "' check " + scene + options;
        const json film = json::parse(shell(call + " --json", "/").out).at(0).at("film");
        CHECK(film.at("h264_level") == level);
        const Outcome table = shell(call, "/");
        CHECK(table.exit_code == 0);
        CHECK(has(table.out, "players ") == !std::string(words).empty());
        CHECK(has(table.out, words));
    }
}

// As measured: docs/encoding.md has 9.3 and 13.0 ms of one core a frame, and 2.62 and 5.14 MB in
// 300 frames, of 200 and 1,000 disks.
TEST_CASE("the rough cost of a film is that of the films that were measured") {
    const std::string rest = "run: {until: 0.001, sample_every: 0.001}\nfilm: {seconds: 10}\n";
    for (const auto& [disks, milliseconds, megabytes] :
         {std::tuple{200, 9.3, 2.62}, {1000, 13.0, 5.14}}) {
        const json rough =
            checked("box: {size: [64, 48]}\ngas: [{radius: 0.3, count: " + std::to_string(disks) +
                    "}]\n" + rest)
                .at("film")
                .at("rough");
        const double seconds = rough.at("seconds").get<double>() * rough.at("cores").get<double>();
        CHECK(std::abs(seconds / (300 * 1e-3 * milliseconds) - 1) < 0.01);
        CHECK(std::abs(rough.at("bytes").get<double>() / (1e6 * megabytes) - 1) < 0.01);
    }
}

TEST_CASE("the rough size of each kind of film is between half and twice it") {
    const TemporaryFolder folder;
    const std::string options =
        " '" + library_scene("one-hot-particle") + "' --size 640x360 --set film.seconds=6 ";
    const Outcome outcome = shell("'" + program + "' check --json" + options, folder.path());
    const json formats = json::parse(outcome.out).at(0).at("film").at("rough").at("formats");
    CHECK(formats.size() == 4);
    for (const auto& one : formats.items()) {
        const auto& format = one.key();
        const auto& rough = one.value();
        CAPTURE(format);
        REQUIRE(
            shell("'" + program + "' render --quiet --format " + format + options, folder.path())
                .exit_code == 0);
        double bytes = 0.0;
        for (const auto& file : fs::recursive_directory_iterator(folder.path()))
            if (file.is_regular_file()) bytes += double(file.file_size());
        fs::remove_all(folder.path() / "out");
        const double ratio = rough.at("bytes").get<double>() / bytes;
        CHECK(ratio > 0.5);
        CHECK(ratio < 2.0);
        CHECK(rough.at("seconds").get<double>() > 0.0);
    }
    CHECK(formats["png"]["seconds"] > formats["webm"]["seconds"]);
    CHECK(formats["webm"]["seconds"] > formats["mp4"]["seconds"]);
}

TEST_CASE("all scenes are looked at, and one that is not valid gives exit code 2") {
    const std::string good = (root / "tests/e2e/there-and-back.yaml").string();
    const std::vector<std::string> scenes{(root / "tests/scenes_bad/box_both.yaml").string(), good,
                                          (root / "tests/scenes_bad/run_times.yaml").string()};
    const Outcome table = run({program, "check", scenes[0], scenes[1], scenes[2]});
    CHECK(table.exit_code == 2);
    CHECK(has(table.out, scenes[0] + ": not valid, 1 error\n"));
    CHECK(has(table.out, good + ": valid\n  title        Reverse every velocity"));
    CHECK(has(table.out, "\n  species      132 letters\n  packing      0.06 of the area\n"));
    CHECK(has(table.out, "\n  run          time 0 to 24, 1 event\n"));
    CHECK(has(table.out,
              "\n  film         720 frames, 0:24 at 30 a second, 1920 by 1080, template "
              "lecture\n"));
    CHECK(has(table.out,
              "quality standard; several times as much where all moves fast: --measure)\n"));
    CHECK(has(table.out, scenes[2] + ": not valid, 2 errors\n"));
    CHECK(has(table.err, "box_both.yaml:2:21: error: `size` and `length` cannot be combined"));
    CHECK(has(table.err, "run_times.yaml:5:14: error: "));
    const Outcome machine = run({program, "check", scenes[0], scenes[1], scenes[2], "--json"});
    CHECK(machine.exit_code == 2);
    CHECK(machine.err == "carom: 2 of 3 scenes are not valid\n");
    CHECK(run({program, "check", scenes[0], good, "--json"}).err ==
          "carom: 1 of 2 scenes is not valid\n");
    const json list = json::parse(machine.out);
    CHECK(list.size() == 3);
    CHECK(list.at(0).at("valid") == false);
    CHECK(list.at(0).at("errors") == json{{{"file", scenes[0]},
                                           {"line", 2},
                                           {"column", 21},
                                           {"length", 6},
                                           {"message", "`size` and `length` cannot be combined"},
                                           {"hint", "keep one of them"}}});
    CHECK(list.at(1).at("valid") == true);
    CHECK(list.at(2).at("errors").size() == 2);
}

TEST_CASE("what cannot be read, or drawn, is not valid") {
    const Outcome none = run({program, "check", "none.yaml", "--json"});
    CHECK(none.exit_code == 2);
    const json found = json::parse(none.out).at(0);
    CHECK(found.at("valid") == false);
    CHECK(found.at("errors").at(0).at("line") == nullptr);
    CHECK(found.at("errors").at(0).at("message") == "cannot be read: No such file or directory");
}

TEST_CASE("a scene without a film may be too long for one") {
    const std::string physics =
        "box: {length: 10}\ngas: [{count: 2, speed: 1}]\nrun: {until: 1e9}\n";
    CHECK(checked(physics).at("film") == nullptr);
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + physics + "film: {fps: 30}\n");
    CHECK(run({program, "check", "scene.yaml"}, folder.path()).exit_code == 0);
    folder.write("scene.yaml", "title: T\n" + physics + "film: {pace: 1}\n");
    CHECK(run({program, "check", "scene.yaml"}, folder.path()).exit_code == 2);
}

TEST_CASE("values of the command line are checked as in the file") {
    const std::string scene = library_scene("one-hot-particle");
    const Outcome good = run({program, "check", "--json", "--set", "gas.0.count=50", scene});
    CHECK(json::parse(good.out).at(0).at("particles") == 51);
    CHECK(run({program, "check", "--quiet", "--set", "gas.0.count=-5", scene}).exit_code == 2);
    CHECK(run({program, "check"}).exit_code == 2);
}

TEST_CASE("carom check tells what a set would make, and carom figures makes it") {
    const TemporaryFolder folder;
    folder.write("one.yaml", with_figure + "start, kind: gas, at: 0}\n");
    folder.write("two.yaml", with_figure + "speeds, kind: speed-histogram, over: [2, 8]}\n");
    folder.write("set.yaml",
                 "title: Both\nscenes: [one.yaml, {scene: two.yaml, title: Second}]\n"
                 "formats: [csv, svg]\ntemplate: [html, markdown]\ncomparisons:\n"
                 "  - {name: seeds, kind: entropy, at: 4, scenes: [one.yaml, {scene: two.yaml, "
                 "label: other, set: seed=7}]}\n");
    const Outcome outcome =
        run({program, "check", "--json", "set.yaml", "one.yaml"}, folder.path());
    CHECK(outcome.exit_code == 0);
    const json all = json::parse(outcome.out), found = all.at(0);
    CHECK(all.at(1).at("scene") == "one.yaml");
    CHECK(found.at("set") == "set.yaml");
    CHECK(found.at("valid") == true);
    CHECK(found.at("title") == "Both");
    CHECK(found.at("formats") == json{"svg", "csv"});
    CHECK(found.at("pages") == json{"set.html", "set.md"});
    const json sections = found.at("sections");
    REQUIRE(sections.size() == 3);
    CHECK(sections[1].at("scene") == "two");
    CHECK(sections[1].at("title") == "Second");
    CHECK(sections[2].at("scene").is_null());
    CHECK(sections[2].at("figures")[0].at("runs") == json{"T", "other"});
    CHECK(sections[2].at("figures")[0].at("times") == json{4.0});
    const std::string table = run({program, "check", "set.yaml"}, folder.path()).out;
    CHECK(has(table, "set.yaml: valid\n  title        Both\n"));
    CHECK(has(table, "speeds: speed-histogram over time 2 to 8, 8.9 by"));
    CHECK(has(table, "seeds: entropy of 2 runs at time 4"));
    CHECK(has(table, "figures      3, each as svg and csv\n"));
    REQUIRE(run({program, "figures", "set.yaml"}, folder.path()).exit_code == 0);
    for (const json& section : sections)
        for (const json& figure : section.at("figures"))
            for (const std::string format : found.at("formats"))
                CHECK(fs::exists(folder.path() / "out/set" /
                                 (figure.at("name").get<std::string>() + "." + format)));
    for (const std::string page : found.at("pages"))
        CHECK(fs::exists(folder.path() / "out/set" / page));
}

TEST_CASE("carom check tells the mistakes of a set, of its scenes and of its pages") {
    const TemporaryFolder folder;
    folder.write("one.yaml", with_figure + "a, kind: gas, at: 0}\n");
    folder.write("two.yaml", with_figure + "a, kind: gas, at: 12}\n");
    folder.write("same.yaml", with_figure + "a, kind: gas, at: 1}\n");
    folder.write("page.html", "<p>{{titel}}</p>\n");
    const auto message = [&](const std::string& set) {
        folder.write("set.yaml", "title: T\n" + set);
        const Outcome outcome = run({program, "check", "set.yaml"}, folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.out, "set.yaml: not valid, 1 error\n"));
        return outcome.err;
    };
    CHECK(has(message("scenes: [one.yaml, two.yaml]\n"),
              "two.yaml:7:30: error: expected a time from 0 to 10"));
    CHECK(has(message("scenes: [one.yaml, same.yaml]\n"), "both have a figure `a`"));
    CHECK(has(message("scenes: [one.yaml]\ntemplate: page.html\n"),
              "`titel` is no placeholder of a page"));
    CHECK(
        has(message("scenes: [one.yaml]\ncomparisons: [{name: c, kind: temperature, of: b, scenes: "
                    "[one.yaml, {scene: one.yaml, label: x}]}]\n"),
            "there is no species `b`"));
    CHECK(has(message("scenes: [one.yaml]\ncomparisons: [{name: c, kind: entropy, scenes: "
                      "[one.yaml, same.yaml]}]\n"),
              "set.yaml:3:59: error: another run has the label `T`"));
    CHECK(has(message("scenes: [one.yaml]\ncomparisons: [{name: c, kind: entropy, scenes: "
                      "[one.yaml, {scene: one.yaml, label: x, set: 'box.size=[20, 20, 20]'}]}]\n"),
              "set.yaml:3:59: error: this run has another number of dimensions than the first"));
    folder.write("set.yaml", "title: T\nscenes: [nowhere.yaml]\n");
    const Outcome outcome = run({program, "check", "--json", "set.yaml"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(json::parse(outcome.out).at(0).at("errors").size() == 1);
    CHECK(has(outcome.err, "1 of 1 file is not valid"));
}

TEST_CASE("check lists the numbers for which words may ask, if it is asked to") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", with_figure + "v, kind: velocity-histogram}\n");
    const auto listed = [&](const std::vector<std::string>& options) {
        std::vector<std::string> command{program, "check", "scene.yaml", "--json"};
        command.insert(command.end(), options.begin(), options.end());
        const Outcome outcome = run(command, folder.path());
        REQUIRE(outcome.exit_code == 0);
        std::vector<std::string> names;
        for (const json& one : json::parse(outcome.out).at(0).value("numbers", json::array()))
            names.push_back(one.at("name"));
        return names;
    };
    const auto is_listed = [&](const std::string& name) {
        const std::vector<std::string> all = listed({"--numbers"});
        return std::ranges::find(all, name) != all.end();
    };
    CHECK(listed({}).empty());
    for (const char* name : {"temperature", "pressure.left", "fit.deviation"})
        CHECK(is_listed(name));
    CHECK(!is_listed("position"));
}

// --depfile: make and ninja read the rule, whatever the files are called.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "e2e/still_life.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// The scene in that folder, with a template beside it.
void write_scene(const TemporaryFolder& folder, const std::string& scene) {
    std::string text = still_life;
    text.replace(text.find("template: lecture"), 17, "template: own");
    folder.write(scene, text);
    folder.write((fs::path(scene).parent_path() / "own.yaml").string(),
                 contents(root / "templates/films/lecture.yaml"));
}

}  // namespace

TEST_CASE("a rule names the scene, its template, and the scene beside it") {
    const TemporaryFolder folder;
    write_scene(folder, "scene.yaml");
    REQUIRE(run({program, "still", "scene.yaml", "-o", "a.png", "--quiet", "--depfile", "a.d"},
                folder.path())
                .exit_code == 0);
    CHECK(contents(folder.path() / "a.d") == "a.png: \\\n  scene.yaml \\\n  own.yaml\n");
    REQUIRE(run({program, "run", "scene.yaml", "--quiet", "--csv", "a.csv", "--xyz", "a.xyz",
                 "--depfile", "b.d"},
                folder.path())
                .exit_code == 0);
    CHECK(contents(folder.path() / "b.d") == "a.csv a.xyz: \\\n  scene.yaml \\\n  own.yaml\n");
    REQUIRE(run({program, "render", "scene.yaml", "-o", "a.pdf", "--seconds", "0.2", "--quiet",
                 "--depfile", "c.d"},
                folder.path())
                .exit_code == 0);
    CHECK(contents(folder.path() / "c.d") == "a.pdf: \\\n  scene.yaml \\\n  own.yaml\n");
}

TEST_CASE("make and ninja make again what a changed file with any name was used for") {
    for (const std::string name :
         {"plain", "two words", "cash$money", "no#comment", "back\\slash", "a\\ b", "per:cent"}) {
        CAPTURE(name);
        const TemporaryFolder folder;
        write_scene(folder, name + "/scene.yaml");
        const std::string scene = name + "/scene.yaml";
        const auto still = [&] {
            return run({program, "still", scene, "-o", "a.png", "--quiet", "--depfile", "a.d"},
                       folder.path());
        };
        REQUIRE(still().exit_code == 0);
        folder.write("Makefile", "a.png:\n\ttouch made\n\ttouch a.png\n-include a.d\n");
        folder.write(
            "build.ninja",
            "rule still\n  depfile = a.d\n  command = touch made a.png\nbuild a.png: still\n");
        const auto makes = [&](const std::string& tool) {
            fs::remove(folder.path() / "made");
            const Outcome outcome = run({tool}, folder.path());
            CAPTURE(outcome.out + outcome.err);
            CHECK(outcome.exit_code == 0);
            return fs::exists(folder.path() / "made");
        };
        const auto touch = [&](const std::string& file) {
            REQUIRE(run({"touch", "-d", "next year", file}, folder.path()).exit_code == 0);
        };
        touch("a.png");
        CHECK_FALSE(makes("make"));
        makes("ninja");  // which keeps a log of its own, and has never made it before
        REQUIRE(still().exit_code == 0);
        touch("a.png");
        for (const std::string& file : {scene, name + "/own.yaml"}) {
            CAPTURE(file);
            REQUIRE(run({"touch", "-d", "2 years", file}, folder.path()).exit_code == 0);
            CHECK(makes("make"));
            CHECK(makes("ninja"));
            REQUIRE(run({"touch", "-d", "yesterday", file}, folder.path()).exit_code == 0);
        }
    }
}

TEST_CASE(
    "rules of folders name all that figures and sites are made from, and hold after a deletion") {
    const TemporaryFolder folder;
    const std::string gas =
        "box: {size: [20, 15]}\ngas: [{count: 9, speed: 2}]\nrun: {until: 3}\n"
        "film: {seconds: 0.4, fps: 5, size: [320, 180], panels: []}\n";
    folder.write("scenes/one.yaml", "title: One\n" + gas + "figures: [{name: one, kind: gas}]\n");
    folder.write("scenes/more/two.yaml", "title: Two\n" + gas);
    folder.write("set.yaml",
                 "title: Both\nscenes: [{scene: scenes/one.yaml}]\ncomparisons:\n"
                 "  - name: both\n    kind: temperature\n    caption: Two.\n    scenes:\n"
                 "      - {scene: scenes/one.yaml, label: a}\n"
                 "      - {scene: scenes/more/two.yaml, label: b}\n");
    folder.write("own.md", "{{title}}\n");
    folder.write("Makefile",
                 "site/index.html:\n\t" + program +
                     " gallery scenes -o site --depfile site.d\n"
                     "set/captions.json:\n\t" +
                     program +
                     " figures set.yaml -o set --formats svg --page own.md --depfile set.d\n"
                     "-include site.d set.d\n");
    const auto makes = [&](const std::string& target) {
        const Outcome outcome = run({"make", target}, folder.path());
        CAPTURE(outcome.out + outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return !has(outcome.out, "is up to date");
    };
    const std::string site = "site/index.html", set = "set/captions.json";
    for (const std::string& target : {site, set}) CHECK(makes(target));
    const std::string rules = contents(folder.path() / "set.d");
    CHECK(rules.starts_with("set/captions.json: \\\n  set.yaml \\\n  scenes/one.yaml"));
    for (const std::string file : {" own.md", " scenes/more/two.yaml", "/lecture.yaml"})
        CHECK(has(rules, file));
    for (const std::string& target : {site, set}) CHECK_FALSE(makes(target));
    // A file that is newer, though nothing in it has changed, is made from once.
    const auto touch = [&](const std::string& file) {
        fs::last_write_time(folder.path() / file, fs::file_time_type::clock::now());
    };
    for (const std::string& target : {site, set}) {
        touch("scenes/more/two.yaml");
        CHECK(makes(target));
        CHECK_FALSE(makes(target));
    }
    // A scene that is new, and one that is gone.
    folder.write("scenes/more/three.yaml", "title: Three\n" + gas);
    CHECK(makes(site));
    CHECK(fs::exists(folder.path() / "site/films/more/three.html"));
    fs::remove(folder.path() / "scenes/more/three.yaml");
    CHECK(makes(site));
    CHECK_FALSE(fs::exists(folder.path() / "site/films/more/three.html"));
    CHECK_FALSE(makes(site));
}

TEST_CASE("a rule about nothing, and names that no rule can hold, are refused before the work") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", still_life);
    folder.write("a\nb.yaml", still_life);
    const auto said = [&](const std::vector<std::string>& arguments) {
        std::vector<std::string> command{program};
        command.insert(command.end(), arguments.begin(), arguments.end());
        const Outcome outcome = run(command, folder.path());
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK(said({"run", "scene.yaml", "--depfile", "a.d"}) ==
          "carom: --depfile: this run writes no other file, and the rule would be about none; add "
          "--csv FILE or another output\n");
    CHECK(has(said({"render", "scene.yaml", "-o", "-", "--depfile", "a.d"}), "name one with -o"));
    CHECK(has(said({"still", "a\nb.yaml", "-o", "a.png", "--depfile", "new/a.d"}),
              "has a line break"));
    CHECK(folder.names() == std::vector<std::string>{"a\nb.yaml", "scene.yaml"});
}

TEST_CASE("no output takes the place of a file that the work is read from, or of another output") {
    const TemporaryFolder folder;
    write_scene(folder, "scene.yaml");
    fs::create_symlink("new.json", folder.path() / "link");
    const std::string scene = contents(folder.path() / "scene.yaml");
    const std::string read = "a file that the work is read from", twice = "two outputs";
    for (const auto& [arguments, reason] :
         {std::pair{std::string("still scene.yaml -o a.png --depfile scene.yaml"), read},
          {"still scene.yaml -o a.png --depfile own.yaml", read},
          {"render scene.yaml -o a.mp4 --depfile scene.yaml", read},
          {"figure scene.yaml --kind gas -o figures --depfile scene.yaml", read},
          {"still scene.yaml -o a.png --depfile a.png", twice},
          {"render scene.yaml -o a.mp4 --words --depfile a.transcript.txt", twice},
          {"figure scene.yaml --kind gas -o figures --depfile figures/gas.svg", twice},
          {"run scene.yaml --json new.json --csv link", twice}}) {
        CAPTURE(arguments);
        const Outcome outcome = shell("'" + program + "' " + arguments, folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, reason));
        CHECK(contents(folder.path() / "scene.yaml") == scene);
    }
    CHECK_FALSE(fs::exists(folder.path() / "a.mp4"));
    CHECK_FALSE(fs::exists(folder.path() / "new.json"));
}

TEST_CASE("a depfile in place of anything that the command makes is refused before the work") {
    const TemporaryFolder folder;
    const std::string scene =
        "title: T\nbox: {size: [20, 15]}\ngas: [{count: 4, speed: 1}]\nrun: {until: 1}\n"
        "film: {seconds: 0.4, fps: 5, size: [64, 64], panels: []}\n"
        "figures: [{name: one, kind: gas}]\n";
    for (const char* name : {"scenes/s.yaml", "s.yaml", "t.yaml"}) folder.write(name, scene);
    const std::vector<std::string> before = folder.names();
    for (const auto& [command, depfile] :
         {std::pair{"figures s.yaml t.yaml --films -o out", "out/t/t.mp4"},
          {"figures s.yaml --films -o out", "out/s.transcript.txt"},
          {"figures s.yaml -o out", "out/captions.json"},
          {"figures s.yaml -o out", "out/figures.json"},
          {"figures s.yaml -o out --page html", "out/s.html"},
          {"figures s.yaml -o out", "out/one.csv"},
          {"gallery scenes -o out", "out/films/s.mp4"},
          {"gallery scenes -o out", "out/films/s.card.png"},
          {"gallery scenes -o out", "out/index.html"},
          {"gallery scenes -o out", "out/gallery.json"},
          {"render s.yaml t.yaml -o out", "out/t.mp4"},
          {"render s.yaml t.yaml -o out/ --words", "out/t.chapters.vtt"},
          {"render s.yaml -o out/a.html --page html", "out/a.html"},
          {"render s.yaml t.yaml --join -o out/a.mp4", "out/a.mp4"}}) {
        CAPTURE(std::string(command));
        CAPTURE(std::string(depfile));
        fs::create_directories(folder.path() / "out");
        const Outcome outcome = shell(
            fmt::format("'{}' {} --quiet --depfile {}", program, command, depfile), folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK(has(outcome.err, fmt::format("{}: two outputs would be written", depfile)));
        for (const auto& file : fs::recursive_directory_iterator(folder.path() / "out"))
            CHECK(file.is_directory());
        fs::remove_all(folder.path() / "out");
        CHECK(folder.names() == before);
    }
}

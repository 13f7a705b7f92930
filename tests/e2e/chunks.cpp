// A film that several processes make.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene = library_scene("one-hot-particle");
const std::string small = " --size 320x180 --seconds 8 --quality draft";

Outcome call(const std::string& arguments, const fs::path& folder) {
    return shell("'" + program + "' " + arguments, folder);
}

void plan(const fs::path& folder, const std::string& options = " --chunks 3 -o plan") {
    const Outcome outcome = call("plan '" + scene + "'" + small + options, folder);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
}

// The film of one process.
std::string direct_film(const fs::path& folder) {
    REQUIRE(call("render '" + scene + "'" + small + " -o direct.mp4 --quiet", folder).exit_code ==
            0);
    return contents(folder / "direct.mp4");
}

void check_joined(const fs::path& folder, const std::string& expected) {
    const Outcome joined = call("join plan -o joined.mp4", folder);
    CAPTURE(joined.err);
    CHECK(joined.exit_code == 0);
    CHECK((contents(folder / "joined.mp4") == expected));
}

// What is neither an output nor a manifest.
std::vector<std::string> others_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".chunk" && extension != ".json")
            names.push_back(entry.path().filename().string());
    }
    return names;
}

}  // namespace

TEST_CASE("chunks that several processes make in any order join to the film of one process") {
    const TemporaryFolder folder;
    plan(folder.path());
    CHECK(call("plan plan --list", folder.path()).out == "1\n2\n3\n");
    CHECK(call("render plan --chunk 2 --threads 1", folder.path()).exit_code == 0);
    CHECK(call("plan plan --missing", folder.path()).out == "1\n3\n");
    const Outcome missing = call("join plan -o joined.mp4", folder.path());
    CHECK(missing.exit_code == 2);
    CHECK(missing.err ==
          "carom: plan: 2 of 3 chunks are missing (1, 3); make them with carom render plan --chunk "
          "K\n");
    CHECK(call("render plan", folder.path()).exit_code == 0);
    CHECK(call("plan plan --missing", folder.path()).out.empty());
    const std::string expected = direct_film(folder.path());
    check_joined(folder.path(), expected);
    CHECK(call("join plan -o words.mp4 --words --poster", folder.path()).exit_code == 0);
    CHECK(contents(folder.path() / "words.poster.png").starts_with("\x89PNG"));
    CHECK(has(contents(folder.path() / "words.transcript.txt"), "A silent film of 0:08"));
    // A machine that has another folder.
    fs::create_directory(folder.path() / "elsewhere");
    fs::rename(folder.path() / "plan", folder.path() / "elsewhere/plan");
    CHECK(call("render plan --chunk 1 --force", folder.path() / "elsewhere").exit_code == 0);
    check_joined(folder.path() / "elsewhere", expected);
}

TEST_CASE("two processes that make one chunk write the same bytes") {
    const TemporaryFolder folder;
    plan(folder.path());
    const std::string one = "'" + program + "' render plan --quiet & ";
    CHECK(shell(one + one + "wait", folder.path()).exit_code == 0);
    check_joined(folder.path(), direct_film(folder.path()));
}

TEST_CASE("a process that is killed loses its chunk, and nothing else") {
    const TemporaryFolder folder;
    plan(folder.path());
    REQUIRE(call("render plan --chunk 1", folder.path()).exit_code == 0);
    const std::string done = contents(folder.path() / "plan/chunks/0001.chunk");
    shell("'" + program + "' render plan --quiet --threads 1 & sleep 0.15; kill -9 $!; wait $!",
          folder.path());
    CHECK((contents(folder.path() / "plan/chunks/0001.chunk") == done));
    CHECK(call("render plan", folder.path()).exit_code == 0);
    check_joined(folder.path(), direct_film(folder.path()));
}

TEST_CASE("a full disk in the middle of a chunk is worth another try") {
    if (geteuid() != 0) return;
    const TemporaryFolder folder;
    plan(folder.path());
    const fs::path chunks = folder.path() / "plan/chunks";
    fs::create_directory(chunks);
    if (run({"mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", chunks.string()}).exit_code != 0) {
        MESSAGE("no tmpfs may be mounted here: a full disk is not tested");
        return;
    }
    const Outcome full = call("render plan --chunk 3", folder.path());
    const std::vector<std::string> left = others_in(chunks);
    const bool is_there = fs::exists(chunks / "0003.chunk");
    run({"umount", chunks.string()});
    CAPTURE(full.err);
    CHECK(full.exit_code == 75);
    CHECK(has(full.err, "No space left on device"));
    CHECK(left.empty());
    CHECK_FALSE(is_there);
    CHECK(call("render plan", folder.path()).exit_code == 0);
    check_joined(folder.path(), direct_film(folder.path()));
}

TEST_CASE("a plan is made once, of several scenes each in its folder, and tells what is wrong") {
    const TemporaryFolder folder;
    const std::string scenes = "plan '" + scene + "' '" + library_scene("two-to-one") + "'" + small;
    CHECK(call(scenes + " --chunk-seconds 1000 -o plans", folder.path()).exit_code == 0);
    for (const std::string name : {"one-hot-particle", "two-to-one"})
        CHECK(call("plan plans/" + name + " --list", folder.path()).out == "1\n");
    const Outcome again = call(scenes + " --chunk-seconds 1000 -o plans", folder.path());
    CHECK(again.exit_code == 0);
    CHECK(has(again.out, "planned before"));

    const auto refusal = [&](const std::string& arguments) {
        const Outcome outcome = call(arguments, folder.path());
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    const std::string a = "plans/one-hot-particle";
    CHECK(has(refusal("render " + a + " --chunk 2"),
              "--chunk 2: the chunks of plans/one-hot-particle have the numbers 1 to 1"));
    for (const char* option :
         {"-o film.mp4", "--quality draft", "--quality standard", "--from 1", "--no-sound"})
        CHECK(
            has(refusal("render " + a + " " + option), "give what changes the film to carom plan"));
    CHECK(has(refusal("render '" + scene + "' --chunk 2"), "apply to the folder of a plan"));
    CHECK(
        has(refusal("run " + a), "is the plan of a film, and carom run works on that of a sweep"));
    CHECK(has(refusal("join missing"), "missing holds no plan (plan.json)"));
    CHECK(has(refusal("join " + a + " --csv runs.csv"), "--csv applies to the plan of a sweep"));
    CHECK(has(refusal("plan '" + scene + "' --chunks 2 --chunk-seconds 2 -o x"),
              "cannot be combined"));
    CHECK(has(refusal("plan '" + scene + "' --from 9 --to 3 -o x"), "expected an end after"));
    folder.write("mine/notes.txt", "mine");
    CHECK(has(refusal("plan '" + scene + "'" + small + " -o mine"), "is not a file of a plan"));
    CHECK_FALSE(fs::exists(folder.path() / "x"));
    REQUIRE(call("render " + a, folder.path()).exit_code == 0);
    CHECK(has(refusal("join " + a + " -o film.webm"),
              "-o film.webm: " + a + " was planned with --format mp4"));
}

TEST_CASE("a plan holds the template and the scene beside that its scene names") {
    const TemporaryFolder folder;
    const auto gas = [](const std::string& name, int count) {
        return "title: " + name +
               "\nbox: {size: [20, 15]}\ngas: [{count: " + std::to_string(count) +
               ", radius: 0.4, speed: 1}]\nrun: {until: 4}\n";
    };
    folder.write("home/mine.yaml", contents(root / "templates/films/side-by-side.yaml"));
    folder.write("home/other.yaml", gas("Other", 30));
    folder.write("home/scene.yaml",
                 gas("Scene", 20) +
                     "film: {seconds: 4, size: [320, 180], template: mine, panels: [temperature], "
                     "beside: {scene: other.yaml, label: more, own_label: fewer}}\n");
    const fs::path home = folder.path() / "home", away = folder.path() / "away";
    REQUIRE(call("render scene.yaml -o direct.mp4 --quiet", home).exit_code == 0);
    const Outcome planned = call("plan scene.yaml --chunks 2 -o ../away/plan", home);
    CAPTURE(planned.err);
    REQUIRE(planned.exit_code == 0);
    REQUIRE(call("plan scene.yaml --seeds 2 -o ../away/sweep", home).exit_code == 0);
    fs::rename(home / "direct.mp4", away / "direct.mp4");
    fs::remove_all(home);
    const Outcome rendered = call("render plan", away);
    CAPTURE(rendered.err);
    CHECK(rendered.exit_code == 0);
    check_joined(away, contents(away / "direct.mp4"));
    CHECK(call("run sweep", away).exit_code == 0);
    CHECK(call("join sweep -o summary.json", away).exit_code == 0);
}

TEST_CASE("a plan of a scene whose name is not UTF-8 is kept, and its film has that name") {
    const TemporaryFolder folder;
    const std::string small_scene =
        "title: T\nbox: {size: [20, 15]}\ngas: [{count: 4, radius: 0.4, speed: 1}]\n"
        "run: {until: 1}\nfilm: {seconds: 0.4, fps: 5, size: [64, 64], panels: []}\n";
    const std::string name = "caf\xE9";
    folder.write(name + ".yaml", small_scene);
    folder.write("caf\xE8.yaml", small_scene);
    const std::string command = "plan " + name + ".yaml -o plan";
    REQUIRE(call(command, folder.path()).exit_code == 0);
    REQUIRE(call("render plan --quiet", folder.path()).exit_code == 0);
    CHECK(has(call(command, folder.path()).out, "planned before"));
    CHECK(call("plan plan --missing", folder.path()).out.empty());
    CHECK(call("join plan --quiet", folder.path()).exit_code == 0);
    CHECK(fs::exists(folder.path() / "out" / (name + ".mp4")));
    CHECK(has(call("plan caf\xE8.yaml -o plan", folder.path()).out, "planned in"));
    const std::string sweep = "plan " + name + ".yaml --seeds 2 -o sweep";
    REQUIRE(call(sweep, folder.path()).exit_code == 0);
    CHECK(call("run sweep --quiet", folder.path()).exit_code == 0);
    CHECK(has(call(sweep, folder.path()).out, "planned before"));
    CHECK(call("join sweep --quiet", folder.path()).exit_code == 0);
}

TEST_CASE("the film of a plan from standard input is called stdin, as that of render") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: T\nbox: {size: [20, 15]}\ngas: [{count: 4, radius: 0.4, speed: 1}]\n"
                 "run: {until: 1}\nfilm: {seconds: 0.4, fps: 5, size: [64, 64], panels: []}\n");
    REQUIRE(call("plan - -o plan --quiet < scene.yaml", folder.path()).exit_code == 0);
    REQUIRE(call("render plan --quiet", folder.path()).exit_code == 0);
    REQUIRE(call("join plan --quiet", folder.path()).exit_code == 0);
    CHECK(fs::exists(folder.path() / "out/stdin.mp4"));
}

TEST_CASE("plan.json is as its JSON Schema says") {
    const TemporaryFolder folder;
    plan(folder.path());
    REQUIRE(call("plan '" + scene + "' --seeds 1:3 -o sweep", folder.path()).exit_code == 0);
    for (const std::string name : {"plan", "sweep"}) {
        const Outcome outcome = shell(
            "python3 -c 'import json, jsonschema, sys; "
            "jsonschema.validate(json.load(open(sys.argv[1])), json.load(open(sys.argv[2])))' "
            "'" +
            (folder.path() / name / "plan.json").string() + "' '" +
            (root / "cluster/plan.schema.json").string() + "'");
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 0);
    }
}

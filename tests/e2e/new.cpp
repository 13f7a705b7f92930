// carom new, by the program itself: what it writes is valid, renders, and replaces nothing.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string mark = "# yaml-language-server: $schema=";

std::string first_line(const fs::path& file) {
    const std::string text = contents(file);
    return text.substr(0, text.find('\n'));
}

}  // namespace

TEST_CASE("carom new writes a scene that is valid and renders") {
    const TemporaryFolder folder;
    const Outcome made = run({program, "new", "mine"}, folder.path());
    CHECK(made.exit_code == 0);
    CHECK(made.out == "mine.yaml: a scene; `carom render mine.yaml` makes its film\n");
    CHECK(folder.names() == std::vector<std::string>{"mine.yaml", "scene.schema.json"});
    const std::string line = first_line(folder.path() / "mine.yaml");
    REQUIRE(line.starts_with(mark));
    CHECK(line.substr(mark.size()) == "scene.schema.json");
    CHECK(contents(folder.path() / "scene.schema.json") ==
          contents(root / "scenes/scene.schema.json"));
    folder.write("scene.schema.json", "mine");
    CHECK(run({program, "new", "second", "--quiet"}, folder.path()).exit_code == 0);
    CHECK(contents(folder.path() / "scene.schema.json") == "mine");
    fs::remove(folder.path() / "second.yaml");
    CHECK(run({program, "check", "mine.yaml"}, folder.path()).exit_code == 0);
    const Outcome film = run({program, "render", "mine.yaml", "--quality", "draft", "--size",
                              "320x180", "--set", "film.seconds=0.2", "--quiet"},
                             folder.path());
    CAPTURE(film.err);
    CHECK(film.exit_code == 0);
    CHECK(fs::file_size(folder.path() / "out/mine.mp4") > 1000);
}

TEST_CASE("an independent validator takes the new scene by the schema it names") {
    const TemporaryFolder folder;
    REQUIRE(run({program, "new", "mine.yml", "--quiet"}, folder.path()).exit_code == 0);
    const std::string schema = first_line(folder.path() / "mine.yml").substr(mark.size());
    const Outcome found =
        run({"/usr/bin/python3", (root / "tests/support/validate.py").string(), schema, "mine.yml"},
            folder.path());
    CAPTURE(found.err);
    CHECK(found.out == "{\"mine.yml\": null}\n");
}

TEST_CASE("carom new makes the folder of its file") {
    const TemporaryFolder folder;
    const Outcome made = run({program, "new", "course/week-1/gas"}, folder.path());
    CHECK(made.exit_code == 0);
    CHECK(run({program, "check", "--quiet", "course/week-1/gas.yaml"}, folder.path()).exit_code ==
          0);
}

TEST_CASE("carom new replaces nothing") {
    const TemporaryFolder folder;
    folder.write("mine.yaml", "kept");
    fs::create_symlink("nowhere", folder.path() / "link.yaml");
    for (const std::string& name : std::vector<std::string>{"mine", "link.yaml"}) {
        const Outcome again = run({program, "new", name}, folder.path());
        CHECK(again.exit_code == 2);
        CHECK(again.err.find("exists already and was left unchanged; give another name\n") !=
              std::string::npos);
    }
    CHECK(contents(folder.path() / "mine.yaml") == "kept");
    CHECK(run({program, "new", "mine.yaml/other"}, folder.path()).exit_code == 1);
    CHECK(run({program, "new", "folder/"}, folder.path()).exit_code == 2);
    CHECK(run({program, "new"}, folder.path()).exit_code == 2);
    CHECK(folder.names().size() == 2);
}

TEST_CASE("a new scene may begin with another one, by its path or its name in the library") {
    const TemporaryFolder folder;
    for (const std::string& from : std::vector<std::string>{"time-reversal", "single-collision",
                                                            library_scene("time-reversal")}) {
        const std::string name = fs::path(from).stem().string();
        const std::string original = contents(library_scene(name));
        fs::remove(folder.path() / "mine.yaml");
        CHECK(run({program, "new", "mine", "--from", from}, folder.path()).exit_code == 0);
        const std::string text = contents(folder.path() / "mine.yaml");
        CHECK(text.starts_with(mark));
        CHECK(original.ends_with(text.substr(text.find('\n') + 1)));
        CHECK(run({program, "check", "mine.yaml"}, folder.path()).exit_code == 0);
    }
    const Outcome bad =
        run({program, "new", "other", "--from", (root / "tests/scenes_bad/box_both.yaml").string()},
            folder.path());
    CHECK(bad.exit_code == 2);
    CHECK(bad.err.find("box_both.yaml:2:21: error: ") != std::string::npos);
    const Outcome misspelt =
        run({program, "new", "other", "--from", "time-revesal"}, folder.path());
    CHECK(misspelt.exit_code == 2);
    CHECK(misspelt.err.find("did you mean `time-reversal`?") != std::string::npos);
    CHECK(folder.names() == std::vector<std::string>{"mine.yaml", "scene.schema.json"});
}

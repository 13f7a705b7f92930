// Surroundings in which a command cannot do its work as usual: killed, without /proc, with hardly
// any descriptors or stack.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "e2e/two_disks.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

TEST_CASE("a killed command leaves no film behind, neither in $TMPDIR nor in a site") {
    const TemporaryFolder folder;
    folder.write("films/scene.yaml", two_disks);
    fs::create_directory(folder.path() / "tmp");
    const std::string large = " --size 1280x720 --seconds 20 --fps 60 --quiet";
    for (const std::string& command :
         {"render films/scene.yaml --page html -o page.html" + large,
          "gallery films -o site" + large, "render films/scene.yaml -o -" + large + " > piped"}) {
        CAPTURE(command);
        const Outcome outcome = shell(
            fmt::format("TMPDIR=tmp timeout -s KILL 0.5 '{}' {}", program, command), folder.path());
        CHECK(outcome.exit_code == 137);
        CHECK(fs::is_empty(folder.path() / "tmp"));
        for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
            CHECK_FALSE(has(entry.path().string(), ".carom-"));
    }
}

TEST_CASE("a name that is too long for one of the files is refused before any is written") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    const std::string name(251, 'a');  // with .mp4 as long as names may be
    const Outcome outcome = run({program, "render", "scene.yaml", "--words", "--size", "128x96",
                                 "--quiet", "-o", name + ".mp4"},
                                folder.path());
    CHECK(outcome.exit_code == 1);
    CHECK(has(outcome.err, "carom: cannot write " + name));
    CHECK(has(outcome.err, "File name too long"));
    const Outcome planned = run({program, "plan", "scene.yaml", "-o", name + name}, folder.path());
    CHECK(planned.exit_code == 1);
    CHECK(has(planned.err, "carom: cannot create the folder " + name));
    CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
}

TEST_CASE("too small a stack is an error in plain words") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    // With 16 kB the system's loader fails now and then, before the program begins.
    for (const int size : {24, 64, 255}) {
        CAPTURE(size);
        const Outcome outcome =
            shell(fmt::format("ulimit -s {}; '{}' check scene.yaml", size, program), folder.path());
        CHECK(outcome.exit_code == 1);
        CHECK(has(outcome.err, "ulimit -s 8192"));
    }
    CHECK(shell(fmt::format("ulimit -s 256; '{}' check scene.yaml", program), folder.path())
              .exit_code == 0);
}

TEST_CASE("a system without /proc makes the same pictures and films") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    const std::string small = " --size 128x96 --quiet && ";
    const std::string work = fmt::format(
        "'{0}' still scene.yaml -o a.png{1}'{0}' render scene.yaml "
        "--words -o a.mp4{1}'{0}' new mine --quiet",
        program, small);
    REQUIRE(shell(work, folder.path()).exit_code == 0);
    const std::string picture = contents(folder.path() / "a.png");
    const std::string film = contents(folder.path() / "a.mp4");
    fs::remove(folder.path() / "mine.yaml");
    const std::string hide = "unshare -rm sh -c \"mount -t tmpfs none /proc && ";
    if (shell(hide + "true\"", folder.path()).exit_code != 0) {
        MESSAGE("left out: /proc cannot be hidden here");
        return;
    }
    const Outcome outcome = shell(hide + work + "\"", folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(contents(folder.path() / "a.png") == picture);
    CHECK(contents(folder.path() / "a.mp4") == film);
    CHECK(fs::exists(folder.path() / "mine.yaml"));
}

TEST_CASE("an empty scene is reported at its first line") {
    const TemporaryFolder folder;
    folder.write("empty.yaml", "");
    CHECK(has(run({program, "check", "empty.yaml"}, folder.path()).err,
              "empty.yaml:1:1: error: the scene is empty"));
    CHECK(has(run({program, "check", "empty.yaml", "--json"}, folder.path()).out, "\"line\": 1,"));
}

TEST_CASE("with hardly any files that may be open a command succeeds, or is worth another try") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", two_disks);
    // What a program that runs the tests leaves open would take the only number that is free.
    const std::string close_inherited = "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-;";
    for (const int files : {4, 5, 6, 7})
        for (const std::string command :
             {"render scene.yaml -o film.mp4 --words --quiet", "run scene.yaml --csv a --json b",
              "render scene.yaml --page html -o page.html --quiet", "new mine",
              "still scene.yaml -o still.png", "plan scene.yaml -o plan --quiet --force"}) {
            CAPTURE(files);
            CAPTURE(command);
            const Outcome outcome = shell(
                fmt::format("{} ulimit -n {}; '{}' {}", close_inherited, files, program, command),
                folder.path());
            CAPTURE(outcome.err);
            CHECK((outcome.exit_code == 0 || outcome.exit_code == 75));
            for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
                CHECK_FALSE(has(entry.path().string(), ".carom-"));
            fs::remove(folder.path() / "mine.yaml");
        }
}

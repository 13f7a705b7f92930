// Standard input as a scene, standard output as a picture or a film, and formats by name.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene = library_scene("two-to-one");
const std::string other = library_scene("cradle");
const std::string small = " --size 320x180 --quiet ";
const std::string short_film = small + "--quality draft --seconds 1 ";

Outcome call(const std::string& arguments, const fs::path& folder) {
    return shell("'" + program + "' " + arguments, folder);
}

}  // namespace

TEST_CASE("`-` is a scene from standard input, for every command that takes one") {
    const TemporaryFolder folder;
    const std::string in = "<'" + scene + "'";
    REQUIRE(call("still - --at 6" + small + in, folder.path()).exit_code == 0);
    REQUIRE(call("still '" + scene + "' --at 6" + small, folder.path()).exit_code == 0);
    const fs::path out = folder.path() / "out";
    CHECK(contents(out / "stdin.png") == contents(out / "two-to-one.png"));
    CHECK(call("render -" + short_film + in, folder.path()).exit_code == 0);
    CHECK(fs::exists(out / "stdin.mp4"));
    CHECK(call("run - " + in, folder.path()).out.find("<stdin>: 2 particles") != std::string::npos);
    CHECK(call("check - " + in, folder.path()).out.starts_with("<stdin>: valid"));
    REQUIRE(call("new mine --quiet --from - " + in, folder.path()).exit_code == 0);
    CHECK(call("check mine.yaml", folder.path()).exit_code == 0);
}

TEST_CASE("mistakes in a scene from standard input have their place in it") {
    const TemporaryFolder folder;
    const Outcome outcome = shell("echo 'titel: T' | '" + program + "' check -", folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "<stdin>: not valid, 4 errors\n");
    CHECK(outcome.err.find("<stdin>:1:1: error: `titel` is not a key") != std::string::npos);
    const Outcome twice = call("check - - </dev/null", folder.path());
    CHECK(twice.exit_code == 2);
    CHECK(twice.err == "carom: only one scene can be - (standard input)\n");
}

TEST_CASE("a template beside the working folder's scene is found for standard input") {
    const TemporaryFolder folder;
    fs::copy(root / "templates/films/minimal.yaml", folder.path() / "mine.yaml");
    const Outcome outcome =
        call("check - --set film.template=mine <'" + scene + "'", folder.path());
    CHECK(outcome.out.find("template mine") != std::string::npos);
}

TEST_CASE("`still -o -` writes the very file to standard output, and nothing else") {
    const TemporaryFolder folder;
    for (const std::string format : {"png", "svg", "pdf"}) {
        const std::string still = "still '" + scene + "' --at 6 --size 320x180 ";
        REQUIRE(call(still + "-o file." + format, folder.path()).exit_code == 0);
        const Outcome streamed =
            call(still + "-o - " + (format == "png" ? "" : "--format " + format), folder.path());
        CHECK(streamed.err.empty());
        CHECK((streamed.out == contents(folder.path() / ("file." + format))));
    }
    CHECK(call("still '" + scene + "' -o - >/dev/full", folder.path()).exit_code == 75);
}

TEST_CASE("`render -o -` writes the very film to standard output, its report elsewhere") {
    const TemporaryFolder folder;
    for (const std::string format : {"mp4", "webm", "gif"}) {
        CAPTURE(format);
        const std::string film = "render '" + scene + "' --size 320x180 --seconds 1 ";
        REQUIRE(call(film + "-o film." + format, folder.path()).exit_code == 0);
        const Outcome streamed = call("render '" + scene + "' --size 320x180 --seconds 1 -o - " +
                                          (format == "mp4" ? "" : "--format " + format),
                                      folder.path());
        CHECK((streamed.out == contents(folder.path() / ("film." + format))));
        CHECK(streamed.err.find("standard output: 30 frames") != std::string::npos);
    }
    // No part of it stays anywhere.
    const Outcome full = shell("mkdir tmp; TMPDIR=tmp '" + program + "' render '" + scene + "'" +
                                   short_film + "-o - >/dev/full; echo $?; ls -A tmp",
                               folder.path());
    CHECK(full.out == "75\n");
    CHECK(full.err == "carom: cannot write standard output: No space left on device\n");
    CHECK(call("render '" + scene + "' -o - --format png", folder.path()).exit_code == 2);
    CHECK(call("render '" + scene + "' '" + other + "' -o -", folder.path()).exit_code == 2);
}

TEST_CASE("`still` and `render` write into a pipe that is named, which stays one") {
    const TemporaryFolder folder;
    const fs::path out = folder.path() / "out";
    REQUIRE(shell("mkfifo still.svg render.mp4 unnamed && ln -s unnamed linked", folder.path())
                .exit_code == 0);
    const auto through = [&](const std::string& pipe, const std::string& arguments) {
        const Outcome outcome = shell("timeout 60 cat " + pipe + " >read & '" + program + "' " +
                                          arguments + " -o " + pipe + "; code=$?; wait; exit $code",
                                      folder.path());
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 0);
        CHECK(fs::is_fifo(folder.path() / pipe));
        return contents(folder.path() / "read");
    };
    const std::string still = "still '" + scene + "' --at 6" + small;
    const std::string render = "render '" + scene + "'" + short_film;
    REQUIRE(call(still + "--format svg", folder.path()).exit_code == 0);
    CHECK(through("still.svg", still) == contents(out / "two-to-one.svg"));
    REQUIRE(call(still, folder.path()).exit_code == 0);
    CHECK(through("linked", still) == contents(out / "two-to-one.png"));
    REQUIRE(call(render, folder.path()).exit_code == 0);
    const std::string film = contents(out / "two-to-one.mp4");
    CHECK(through("render.mp4", render) == film);
    CHECK(through("unnamed", render) == film);
    const Outcome frames = call(render + "--format png -o unnamed", folder.path());
    CHECK(frames.exit_code == 2);
    CHECK(frames.err.find("cannot go to a device or a pipe") != std::string::npos);
}

TEST_CASE("a standard stream that is closed cannot be written, nor read, which is told at once") {
    const TemporaryFolder folder;
    const std::string closed = "carom: cannot write standard output: Bad file descriptor\n";
    for (const std::string& command :
         {"render '" + scene + "' --size 320x180 --seconds 3600 -o -",
          "still '" + scene + "'" + small + "-o -", "run '" + scene + "' --json -",
          "run '" + scene + "' --csv -", "run '" + scene + "'", "check '" + scene + "'",
          std::string("schema")}) {
        CAPTURE(command);
        const Outcome outcome = call(command + " >&-", folder.path());
        CHECK(outcome.exit_code == 1);
        CHECK(outcome.err == closed);
    }
    const Outcome none = call("run - <&-", folder.path());
    CHECK(none.exit_code == 2);
    CHECK(none.err == "<stdin>: error: cannot be read: Bad file descriptor\n");
    // Its file is no standard stream.
    CHECK(
        call("render '" + scene + "'" + short_film + "-o a.mp4 >&- <&-", folder.path()).exit_code ==
        0);
    CHECK(call("render '" + scene + "'" + short_film + "-o b.mp4", folder.path()).exit_code == 0);
    CHECK(contents(folder.path() / "a.mp4") == contents(folder.path() / "b.mp4"));
}

TEST_CASE("a reader that ends early ends the command, without a word and without its other files") {
    const TemporaryFolder folder;
    const Outcome outcome = run({"bash", "-c",
                                 "'" + program + "' run '" + library_scene("mixed-masses") +
                                     "' --csv - --json run.json | head -1; echo ${PIPESTATUS[0]}"},
                                folder.path());
    CHECK(outcome.out == "time,particle,species,mass,radius,x,y,vx,vy\n141\n");
    CHECK(outcome.err.empty());
    CHECK(folder.names().empty());
}

TEST_CASE("an empty TMPDIR is none") {
    const TemporaryFolder folder;
    const Outcome made =
        shell("TMPDIR= '" + program + "' render '" + scene + "'" + short_film + "-o film.mp4",
              folder.path());
    CAPTURE(made.err);
    CHECK(made.exit_code == 0);
    CHECK(fs::exists(folder.path() / "film.mp4"));
    const Outcome streamed =
        shell("TMPDIR= '" + program + "' render '" + scene + "'" + short_film + "-o - > film2.mp4",
              folder.path());
    CHECK(streamed.exit_code == 0);
    CHECK(fs::file_size(folder.path() / "film2.mp4") > 1000);
}

TEST_CASE("a film for standard output needs a folder for temporary files, which is named") {
    const TemporaryFolder folder;
    const Outcome outcome =
        shell("TMPDIR=nowhere '" + program + "' render '" + scene + "'" + short_film + "-o -",
              folder.path());
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err,
              "carom: cannot write to the folder for temporary files (TMPDIR is nowhere): "));
}

TEST_CASE("--format chooses the kind of all films, and the ending where none is given") {
    const TemporaryFolder folder;
    const std::string both = "render '" + scene + "' '" + other + "'" + short_film;
    for (const std::string format : {"mp4", "webm", "gif"}) {
        REQUIRE(call(both + "-o films --format " + format, folder.path()).exit_code == 0);
        CHECK(fs::exists(folder.path() / "films" / ("two-to-one." + format)));
        CHECK(fs::exists(folder.path() / "films" / ("cradle." + format)));
    }
    REQUIRE(call(both + "-o films --format png", folder.path()).exit_code == 0);
    CHECK(fs::exists(folder.path() / "films/two-to-one/frame-00030.png"));
    CHECK(fs::exists(folder.path() / "films/cradle/frame-00030.png"));
    REQUIRE(call(both, folder.path()).exit_code == 0);
    CHECK(fs::exists(folder.path() / "out/cradle.mp4"));

    const std::string one = "render '" + scene + "'" + short_film;
    for (const auto& asked : {std::pair{"--format gif", "out/two-to-one.gif"},
                              {"--format png", "out/two-to-one/frame-00001.png"},
                              {"--format webm -o films/", "films/two-to-one.webm"},
                              {"--format png -o a/", "a/frame-00001.png"},
                              {"--format png -o b", "b/frame-00001.png"}}) {
        const auto& arguments = asked.first;
        const auto& path = asked.second;
        CAPTURE(std::string(arguments));
        REQUIRE(call(one + arguments, folder.path()).exit_code == 0);
        CHECK(fs::exists(folder.path() / path));
    }
    REQUIRE(call("still '" + scene + "' --format svg" + small, folder.path()).exit_code == 0);
    CHECK(fs::exists(folder.path() / "out/two-to-one.svg"));
}

TEST_CASE("a format and an ending that contradict one another are refused") {
    const TemporaryFolder folder;
    const Outcome film = call("render '" + scene + "' --format gif -o film.webm", folder.path());
    CHECK(film.exit_code == 2);
    CHECK(film.err == "carom: -o film.webm: the name ends in .webm, but --format is gif\n");
    const Outcome frames = call("render '" + scene + "' --format png -o film.mp4", folder.path());
    CHECK(frames.exit_code == 2);
    const Outcome still = call("still '" + scene + "' --format svg -o a.png", folder.path());
    CHECK(still.exit_code == 2);
    CHECK(still.err == "carom: -o a.png: the name ends in .png, but --format is svg\n");
    CHECK(call("render '" + scene + "' --format avi", folder.path()).exit_code == 2);
    CHECK(folder.names().empty());
}

TEST_CASE("Ctrl-C ends the wait for a scene that does not come, or for a reader of a named pipe") {
    const TemporaryFolder folder;
    REQUIRE(shell("mkfifo pipe", folder.path()).exit_code == 0);
    for (const std::string& waiting : std::vector<std::string>{
             "check - <>pipe", "render - -o a.mp4 <>pipe", "run '" + scene + "' --csv pipe",
             "run '" + scene + "' --json pipe"}) {
        CAPTURE(waiting);
        // From when it handles the signal until it is gone: the first may come before it waits.
        const Outcome stopped = call(waiting +
                                         " & p=$!; until grep -q '^SigCgt:.*[2367abef]$' "
                                         "/proc/$p/status || ! kill -0 $p; do sleep 0.01; done "
                                         "2>gone; for i in $(seq 600); do kill -INT $p || "
                                         "break; sleep 0.1; done 2>gone; wait $p",
                                     folder.path());
        CHECK(stopped.exit_code == 130);
        CHECK(has(stopped.err, "carom: interrupted; nothing "));  // more, while it reads a scene
    }
}

TEST_CASE("an option whose value is empty is refused: a variable of a shell that is not set") {
    const TemporaryFolder folder;
    for (const std::string& option : std::vector<std::string>{
             "still --at", "still --output", "run --csv", "run --json", "render --to",
             "figures --only", "check --set", "still --template"}) {
        CAPTURE(option);
        const Outcome refused = call(option + " '' '" + scene + "'", folder.path());
        CHECK(refused.exit_code == 2);
        CHECK(has(refused.err, option.substr(option.find("--")) + ": the value is empty; carom "));
    }
    CHECK(folder.names().empty());
}

// Bad input and bad days: one clear message, the right exit code, no half-written film, no earlier
// film lost.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "e2e/interrupted.h"
#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene = library_scene("one-hot-particle");

std::string render_small(const std::string& output, const std::string& more = "") {
    return "'" + program + "' render '" + scene + "' -o " + output +
           " --size 320x180 --seconds 8 --quality draft " + more;
}

}  // namespace

TEST_CASE("a wrong scene is refused with exit code 2 and nothing is written") {
    const TemporaryFolder folder;
    folder.write(
        "bad.yaml",
        "title: T\nbox: {size: [10, 10]}\ngas: [{count: 3, raduis: 1}]\nrun: {until: 1}\n");
    const Outcome outcome = run({program, "render", "bad.yaml"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("bad.yaml:3:18: error:") == 0);
    CHECK(outcome.err.find("radius") != std::string::npos);
    CHECK(folder.names() == std::vector<std::string>{"bad.yaml"});
}

TEST_CASE("a gas that finds no room is refused at its place in the file") {
    const TemporaryFolder folder;
    folder.write("full.yaml",
                 "title: T\nbox: {size: [20, 20]}\ngas:\n  - {name: small, count: 420, radius: "
                 "0.45}\nrun: {until: 1}\nfilm: {seconds: 1}\n");
    const Outcome outcome = run({program, "render", "full.yaml"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("full.yaml:4:") == 0);
    CHECK(outcome.err.find("of 420") != std::string::npos);
    CHECK(folder.names() == std::vector<std::string>{"full.yaml"});
}

TEST_CASE("missing scenes, wrong options and wrong endings are told with exit code 2") {
    const TemporaryFolder folder;
    for (const std::string& arguments :
         {std::string("render missing.yaml"), std::string("render"), std::string("paint x"),
          std::string("render . "), "render '" + scene + "' -o film.avi",
          "render '" + scene + "' --fps fast", "render '" + scene + "' --quality best",
          "render '" + scene + "' --set gas", "render '" + scene + "' '" + scene + "'",
          "render '" + scene + "' '" + library_scene("mixed-masses") + "' -o both.mp4",
          "render '" + scene + "' --size 1x1", "render '" + scene + "' --seconds -1",
          "render '" + scene + "' --template none", "still '" + scene + "' --at 37",
          "still '" + scene + "' --at nan", "still '" + scene + "' -o film.mp4"}) {
        CAPTURE(arguments);
        const Outcome outcome = shell("'" + program + "' " + arguments, folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(outcome.err.empty());
        CHECK(outcome.out.empty());
        CHECK(folder.names().empty());
    }
}

TEST_CASE("the scene itself is never the output") {
    const TemporaryFolder folder;
    fs::copy(scene, folder.path() / "scene.mp4");
    const Outcome outcome = run({program, "render", "scene.mp4", "-o", "scene.mp4"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(contents(folder.path() / "scene.mp4") == contents(scene));
}

TEST_CASE("an unknown command is told with the nearest one") {
    const Outcome outcome = run({program, "rendr", scene});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err == "carom: there is no command `rendr`; did you mean `render`?\n");
}

TEST_CASE("of several scenes none is rendered when one is wrong, and all their errors are told") {
    const TemporaryFolder folder;
    folder.write("bad.yaml", "title: T\nbox: {size: [10, 10]}\ngas: []\n");
    folder.write("worse.yaml", "title: T\n");
    const Outcome outcome =
        run({program, "render", scene, "bad.yaml", "worse.yaml", "-o", "films"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("bad.yaml:") != std::string::npos);
    CHECK(outcome.err.find("worse.yaml") != std::string::npos);
    CHECK(folder.names() == std::vector<std::string>{"bad.yaml", "worse.yaml"});
}

TEST_CASE("a folder that cannot be written is exit code 1 with its name") {
    const TemporaryFolder folder;
    folder.write("file", "x");
    const Outcome outcome = shell(render_small("file/film.mp4"), folder.path());
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.find("file") != std::string::npos);
    CHECK(contents(folder.path() / "file") == "x");
}

TEST_CASE("a full disk is exit code 75; the earlier film stays and no part is left") {
    const TemporaryFolder folder;
    folder.write("film.mp4", "earlier");
    // A limit on file sizes fails as a full disk does, one buffer late, and needs no rights.
    const Outcome limited = shell("ulimit -f 40; " + render_small("film.mp4"), folder.path());
    CAPTURE(limited.err);
    CHECK(limited.exit_code == 1);
    CHECK(limited.err.find("film.mp4") != std::string::npos);
    CHECK(contents(folder.path() / "film.mp4") == "earlier");
    CHECK(folder.names() == std::vector<std::string>{"film.mp4"});

    if (geteuid() != 0) return;
    const fs::path disk = folder.path() / "disk";
    fs::create_directory(disk);
    if (run({"mount", "-t", "tmpfs", "-o", "size=96k", "tmpfs", disk.string()}).exit_code != 0) {
        MESSAGE("no tmpfs may be mounted here: a full disk is tested by a limit only");
        return;
    }
    std::ofstream(disk / "film.mp4") << "earlier";
    const Outcome full = shell(render_small("disk/film.mp4"), folder.path());
    const std::string kept = contents(disk / "film.mp4");
    const auto entries = std::distance(fs::directory_iterator(disk), {});
    run({"umount", disk.string()});
    CHECK(full.exit_code == 75);
    CHECK(full.err.find("No space left on device") != std::string::npos);
    CHECK(kept == "earlier");
    CHECK(entries == 1);
}

TEST_CASE("Ctrl-C ends at once with exit code 130; the earlier film stays and no part is left") {
    const TemporaryFolder folder;
    folder.write("film.mp4", "earlier");
    const Interruption outcome =
        interrupted("render '" + scene + "' -o film.mp4 --quality final", folder.path());
    CHECK(outcome.exit_code == 130);
    CHECK(outcome.err.find("interrupted") != std::string::npos);
    CHECK(outcome.seconds < 10.0);  // no measurement: the film takes some 45 s
    CHECK(contents(folder.path() / "film.mp4") == "earlier");
    CHECK(folder.names() == std::vector<std::string>{"film.mp4"});
}

TEST_CASE("a terminal that closes leaves no part of a film, and nohup outlives it") {
    const TemporaryFolder folder;
    const std::string render = "render '" + scene + "' -o film.mp4 --size 320x180 --seconds ";
    const Outcome closed = interrupted(render + "2000", folder.path(), "HUP");
    CHECK(closed.exit_code == 130);
    CHECK(closed.err.find("interrupted; nothing was written") != std::string::npos);
    CHECK(folder.names().empty());
    const Outcome kept =
        interrupted(render + "60", folder.path(), "HUP", "left\r", "env --ignore-signal=HUP");
    CHECK(kept.exit_code == 0);
    CHECK(folder.names() == std::vector<std::string>{"film.mp4"});
}

TEST_CASE("an interruption between films tells how many there are") {
    const TemporaryFolder folder;
    fs::copy(scene, folder.path() / "a.yaml");
    folder.write("b.yaml", contents(scene));
    fs::create_directory(folder.path() / "films");
    // The first is there when the second begins.
    const Outcome outcome =
        shell("'" + program +
                  "' render a.yaml b.yaml -o films --size 320x180 --seconds 120 & "
                  "for i in $(seq 9000); do [ -e films/a.mp4 ] && break; sleep 0.05; done; kill "
                  "-INT $!; wait $!",
              folder.path());
    CHECK(outcome.exit_code == 130);
    CHECK(outcome.err.find("carom: interrupted; 1 of 2 films is written\n") != std::string::npos);
    CHECK(std::distance(fs::directory_iterator(folder.path() / "films"), {}) == 1);
}

TEST_CASE("a size is written with any cross, and a wrong one is told the form") {
    const TemporaryFolder folder;
    for (const std::string size : {"320x180", "320X180", "320×180"}) {
        CAPTURE(size);
        const Outcome outcome =
            run({program, "check", "--quiet", scene, "--size", size}, folder.path());
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.err.empty());
    }
    const Outcome wrong = run({program, "check", "--quiet", scene, "--size", "320,180"});
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.err.find("expected WIDTHxHEIGHT, for instance 320x180,") != std::string::npos);
}

TEST_CASE("a flag that the command does not have is told with the nearest one") {
    const Outcome outcome = run({program, "render", scene, "--qualty=draft"});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err ==
          "carom: carom render has no option --qualty; did you mean --quality?; carom render "
          "--help lists the options\n");
    const Outcome other = run({program, "render", scene, "--xyzzy"});
    CHECK(other.exit_code == 2);
    CHECK(other.err.find("mean") == std::string::npos);
}

TEST_CASE("an empty name of a scene can be seen") {
    const Outcome outcome = run({program, "render", ""});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err ==
          "\"\": error: cannot be read: No such file or directory\n  hint: give the name of a "
          "file\n");
}

TEST_CASE("help that cannot be written on a full device is exit code 75") {
    CHECK(shell("'" + program + "' --help > /dev/full").exit_code == 75);
    CHECK(shell("'" + program + "' render --help > /dev/full").exit_code == 75);
    CHECK(shell("'" + program + "' render --help > /dev/null").exit_code == 0);
}

TEST_CASE("what a command has made stays where its report cannot be written, and the code is 75") {
    const TemporaryFolder folder;
    const Outcome film = shell(render_small("film.mp4", ">/dev/full"), folder.path());
    CHECK(film.exit_code == 75);
    CHECK(film.err.find("cannot write standard output: No space left") != std::string::npos);
    CHECK(shell(render_small("heard.mp4"), folder.path()).exit_code == 0);
    CHECK(contents(folder.path() / "film.mp4") == contents(folder.path() / "heard.mp4"));
    CHECK(shell("'" + program + "' new a.yaml >/dev/full", folder.path()).exit_code == 75);
    CHECK(fs::exists(folder.path() / "a.yaml"));
}

TEST_CASE("a standard error that cannot be written costs neither the film nor the exit code") {
    const TemporaryFolder folder;
    CHECK(shell("'" + program + "' render missing.yaml 2>&-", folder.path()).exit_code == 2);
    CHECK(shell("'" + program + "' render missing.yaml 2>/dev/full", folder.path()).exit_code == 2);
    CHECK(shell(render_small("closed.mp4", "2>&-"), folder.path()).exit_code == 0);
    CHECK(shell(render_small("open.mp4"), folder.path()).exit_code == 0);
    CHECK(contents(folder.path() / "closed.mp4") == contents(folder.path() / "open.mp4"));
}

TEST_CASE(
    "with --quiet nothing is said, without it progress goes to standard error and results to "
    "standard output") {
    const TemporaryFolder folder;
    const Outcome quiet = shell(render_small("a.mp4", "--quiet"), folder.path());
    CHECK(quiet.exit_code == 0);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
    const Outcome timed = shell(render_small("b.mp4", "--timings"), folder.path());
    CHECK(timed.out.find("b.mp4: 240 frames, 0:08") == 0);
    CHECK(timed.out.find("events/s") != std::string::npos);
}

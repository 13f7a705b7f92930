// carom run, by the program itself: where its outputs go, and what happens when they cannot, or
// when it is interrupted.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/interrupted.h"
#include "e2e/run_scene.h"
#include "support/share_of_cases.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("without files the report is a table for people; --timings adds to it, --quiet says no") {
    const std::string scene = (root / "tests/e2e/there-and-back.yaml").string();
    const Outcome table = run({program, "run", scene});
    CHECK(table.exit_code == 0);
    CHECK((table.err.empty() || has_sanitizers));  // which take so long that progress is told
    for (const char* words : {"Reverse every velocity", "132 particles in two dimensions",
                              "for each), ", "relative error ", "reversed at 12", "out, ",
                              "letters", "mean speed", " by the virial", "█"})
        CHECK(table.out.find(words) != std::string::npos);
    CHECK(table.out.find("events/s") == std::string::npos);
    CHECK(run({program, "run", scene, "--timings"}).out.find("events/s") != std::string::npos);
    const Outcome quiet = run({program, "run", scene, "--quiet"});
    CHECK(quiet.exit_code == 0);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
}

TEST_CASE("standard output holds what is asked for and nothing else") {
    const TemporaryFolder folder;
    const std::string scene = (root / "tests/e2e/there-and-back.yaml").string();
    const Outcome both =
        run({program, "run", scene, "--json", "-", "--csv", "a.csv", "--timings"}, folder.path());
    CHECK(both.exit_code == 0);
    CHECK(json::parse(both.out)["particles"] == 132);
    CHECK(both.err.find("events/s") != std::string::npos);
    const Outcome csv =
        run({program, "run", scene, "--csv", "-", "--json", "a.json"}, folder.path());
    CHECK(csv.out == contents(folder.path() / "a.csv"));
    CHECK((csv.err.empty() || has_sanitizers));
    CHECK(json::parse(contents(folder.path() / "a.json"))["seed"] == 4);
    const Outcome named =
        run({program, "run", scene, "--csv", "b.csv", "--json", "b.json"}, folder.path());
    CHECK(named.out == "b.json\nb.csv\n");
    CHECK(contents(folder.path() / "b.csv") == csv.out);
}

TEST_CASE("outputs that would lie on each other or on the scene are refused") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + one_disk);
    const std::string before = contents(folder.path() / "scene.yaml");
    for (const char* arguments :
         {"--json - --csv -", "--json a --csv a", "--json a --csv ./b/../a", "--json scene.yaml",
          "--csv ./scene.yaml", "other.yaml", "--json", "--at 3"}) {
        CAPTURE(arguments);
        const Outcome outcome =
            shell("'" + program + "' run scene.yaml " + arguments, folder.path());
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.out.empty());
        CHECK_FALSE(outcome.err.empty());
        CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
    }
    CHECK(contents(folder.path() / "scene.yaml") == before);
}

TEST_CASE("a scene that does not say how long is told to; the command line can say it") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\nbox: {size: [12, 10]}\ngas: [{count: 1, speed: 1}]\n");
    const Outcome outcome = run({program, "run", "scene.yaml"}, folder.path());
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("`run`") != std::string::npos);
    const Outcome given =
        run({program, "run", "scene.yaml", "--json", "-", "--set", "run.until=1e5"}, folder.path());
    CAPTURE(given.err);
    CHECK(given.exit_code == 0);
    CHECK(json::parse(given.out)["time"] == 1e5);
}

TEST_CASE(
    "what cannot be written is exit code 1, a full device 75; earlier files stay and no part is "
    "left") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + small_gas);
    folder.write("a.csv", "earlier");
    const auto attempt = [&](const std::string& arguments, const std::string& before = "") {
        return shell(before + "'" + program + "' run scene.yaml --quiet " + arguments,
                     folder.path());
    };
    const Outcome no_folder = attempt("--json a.csv/a.json --csv b.csv");
    CHECK(no_folder.exit_code == 1);
    CHECK(no_folder.err.find("a.csv") != std::string::npos);
    // A limit on file sizes fails as a full disk does, while samples are written.
    const Outcome limited =
        attempt("--csv a.csv --json a.json --set run.sample_every=0.01", "ulimit -f 40; ");
    CHECK(limited.exit_code == 1);
    CHECK(limited.err.find("a.csv") != std::string::npos);
    CHECK(contents(folder.path() / "a.csv") == "earlier");
    CHECK(folder.names() == std::vector<std::string>{"a.csv", "scene.yaml"});

    for (const char* arguments : {"--json - >/dev/full", "--csv - >/dev/full"}) {
        CAPTURE(arguments);
        const Outcome full = attempt(arguments);
        CHECK(full.exit_code == 75);
        CHECK(full.err.find("No space left on device") != std::string::npos);
    }
    const Outcome table = shell("'" + program + "' run scene.yaml >/dev/full", folder.path());
    CHECK(table.exit_code == 75);
}

TEST_CASE("a file that is open already is written as it stands") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + one_disk);
    const std::string command = "'" + program + "' run scene.yaml --quiet ";
    const Outcome third = shell(command + "--csv /dev/fd/3 3> a.csv", folder.path());
    CAPTURE(third.err);
    CHECK(third.exit_code == 0);
    CHECK(rows_of(contents(folder.path() / "a.csv")).size() == 8);
    // A name that no one may replace, whatever it leads to.
    for (const char* same :
         {"--csv /dev/fd/1 --json - | cat", "--csv - --json /proc/self/fd/1 | cat",
          "--csv - --json /dev/fd/1 > both", "--csv both --json - > both",
          "--csv /dev/fd/3 --json - 3>&1 | cat"}) {
        CAPTURE(std::string(same));
        const Outcome mixed = shell(command + same, folder.path());
        CHECK(has(mixed.err, " would both be written to "));
        CHECK(mixed.out.empty());
    }
    CHECK(shell(command + "--csv /dev/null --json - > /dev/null", folder.path()).exit_code == 0);
    const Outcome both = shell(command + "--csv - --json /dev/stdout", folder.path());
    CHECK(both.exit_code == 2);
    CHECK(both.err == "carom: --json and --csv would both be written to standard output\n");
}

TEST_CASE("a file whose name ends in a slash is refused before the work, of any option") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + one_disk);
    fs::create_directory(folder.path() / "there");
    const std::vector<std::string> before = folder.names();
    for (const std::string arguments :
         {"run scene.yaml --csv a.csv --json ", "run scene.yaml --json a.json --xyz ",
          "still scene.yaml -o a.png --depfile ", "figure scene.yaml --kind gas --depfile "})
        for (const std::string name : {"new/", "there/"}) {
            CAPTURE(arguments);
            const Outcome outcome = shell("'" + program + "' " + arguments + name, folder.path());
            CHECK(outcome.exit_code == 2);
            CHECK(has(outcome.err, "carom: " + name + ": one file is written there"));
            CHECK(folder.names() == before);
        }
}

TEST_CASE("a pipe is written as it stands") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + one_disk);
    const Outcome outcome =
        shell("mkfifo pipe; cat pipe & '" + program + "' run scene.yaml --quiet --csv pipe; wait",
              folder.path());
    CHECK(outcome.exit_code == 0);
    CHECK(rows_of(outcome.out).size() == 8);
    CHECK(fs::is_fifo(folder.path() / "pipe"));
}

TEST_CASE("Ctrl-C ends a run with exit code 130; earlier files stay and no part is left") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + small_gas);
    folder.write("a.csv", "earlier");
    // Few events and a million samples, a sample and many events, and some of both
    for (const char* more :
         {"--set run.sample_every=100 --set gas.0.speed=1e-9 --set gas.1.speed=0",
          "--set run.sample_every=1e9 --csv a.csv", "--set run.sample_every=1000 --csv a.csv"}) {
        CAPTURE(more);
        const Interruption outcome = interrupted(
            std::string("run scene.yaml --json a.json ") + more + " --set run.until=1e9",
            folder.path());
        CHECK(outcome.exit_code == 130);
        CHECK(outcome.err.find("interrupted") != std::string::npos);
        CHECK(outcome.seconds <
              5.0);  // no measurement: the runs take from half a minute to an hour
        CHECK(contents(folder.path() / "a.csv") == "earlier");
        CHECK(folder.names() == std::vector<std::string>{"a.csv", "scene.yaml"});
    }
}

TEST_CASE("an interrupted table on a stream is said to be a part") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", "title: T\n" + small_gas);
    const auto stopped = [&](const std::string& options) {
        return interrupted(
            "run scene.yaml --set run.until=1e9 --set run.sample_every=1000 " + options,
            folder.path());
    };
    const Outcome table = stopped("--csv -");
    CHECK(table.exit_code == 130);
    CHECK(table.out.starts_with("time,particle,"));
    CHECK(table.err.ends_with("carom: interrupted; standard output is incomplete\n"));
    const Outcome device = stopped("--csv /dev/null");
    CHECK(device.exit_code == 130);
    CHECK(device.err.ends_with("carom: interrupted; /dev/null is incomplete\n"));
    for (const std::string& options : std::vector<std::string>{"--json -", "--csv a.csv", ""}) {
        CAPTURE(options);
        const Outcome nothing = stopped(options);
        CHECK(nothing.out.empty());
        CHECK(nothing.err.ends_with("carom: interrupted; nothing was written\n"));
    }
}

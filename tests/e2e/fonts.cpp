#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"
#include "support/share_of_cases.h"

using namespace carom::test;

namespace {

namespace fs = std::filesystem;

std::string small_still(const std::string& output) {
    return "'" + program + "' still '" + library_scene("two-to-one") +
           "' --set 'subtitle=⠿ two to one' --size 320x180 -o " + output;
}

// Where the opening number `number` of a font fails.
Outcome with_failing_open(int number, const std::string& of, const TemporaryFolder& folder) {
    return shell(fmt::format("ASAN_OPTIONS=verify_asan_link_order=0 FAULT_CALL=open FAULT_OF={} "
                             "FAULT_NUMBER={} FAULT_ERROR={} LD_PRELOAD='{}' {}",
                             of, number, EMFILE, CAROM_FAILING_CALLS, small_still("failed.png")),
                 folder.path());
}

}  // namespace

TEST_CASE("where a font cannot be opened, a picture has the same letters, or there is none") {
    const TemporaryFolder folder;
    REQUIRE(shell(small_still("whole.png"), folder.path()).exit_code == 0);
    const std::string whole = contents(folder.path() / "whole.png");
    int refused = 0;
    for (int number = 1; number <= 60; ++number) {
        CAPTURE(number);
        const Outcome outcome = with_failing_open(number, "/fonts/", folder);
        CAPTURE(outcome.err);
        if (outcome.exit_code == 0) {
            CHECK(contents(folder.path() / "failed.png") == whole);
            fs::remove(folder.path() / "failed.png");
            continue;
        }
        ++refused;
        CHECK(outcome.exit_code == 75);
        CHECK(outcome.err.starts_with("carom: cannot read the font /"));
        CHECK(folder.names() == std::vector<std::string>{"whole.png"});
    }
    CHECK(refused >= 3);  // regular, semi-bold, and that of the other letters
}

// How many files the shell has open differs from system to system. The sanitizer of undefined
// behaviour opens files itself, and takes types for wrong where it cannot.
TEST_CASE("a film whose encoder is too many open files is refused, with the file") {
    if (has_sanitizers) return;
    bool encoder = false;
    for (int most = 8; most >= 3; --most) {
        const TemporaryFolder folder;
        const Outcome outcome =
            shell("ulimit -n " + std::to_string(most) + "; exec '" + program + "' render '" +
                      library_scene("two-to-one") + "' --size 320x180 --seconds 1 -o film.mp4",
                  folder.path());
        if (outcome.exit_code == 0) continue;
        CAPTURE(most);
        CAPTURE(outcome.err);
        if (outcome.err.find("loading shared libraries") != std::string::npos)
            break;  // carom's own
        CHECK(outcome.exit_code == 75);
        CHECK(outcome.err.ends_with("Too many open files\n"));
        encoder |= outcome.err.starts_with("carom: cannot encode films: ");
        CHECK(folder.names().empty());
    }
    CHECK(encoder);
}

TEST_CASE("without memory or threads for text, carom says so before it begins an output") {
    const TemporaryFolder folder;
    const std::string of_scene = "'" + library_scene("two-to-one") + "'";
    const std::vector<std::string> commands{
        "render " + of_scene + " --size 320x180 --seconds 1 -o film.mp4",
        "still " + of_scene + " --size 320x180 -o still.png",
        "figure " + of_scene + " --kind speed-histogram -o figure"};
    const auto check = [&](const std::string& limit, const std::string& command) {
        CAPTURE(limit);
        CAPTURE(command);
        const Outcome outcome =
            shell("ulimit -c 0; " + limit + "'" + program + "' " + command, folder.path());
        CAPTURE(outcome.err);
        if (outcome.exit_code == 0) {
            for (const std::string& name : folder.names()) fs::remove_all(folder.path() / name);
            return true;
        }
        CHECK(outcome.exit_code == 1);
        CHECK(has(outcome.err, "carom: "));
        CHECK(folder.names().empty());
        return false;
    };
    const auto starts = [&](int kilobytes) {  // not where a sanitizer maps all there is
        return shell(fmt::format("ulimit -v {}; '{}' --version", kilobytes, program)).exit_code ==
               0;
    };
    for (const std::string& command : commands) {
        int granted = 0;
        for (int kilobytes = 255'000; kilobytes < 900'000; kilobytes += 60'000)
            if (starts(kilobytes))
                granted += check(fmt::format("ulimit -v {}; ", kilobytes), command) ? 1 : 0;
        if (starts(900'000)) CHECK(granted > 0);
    }
    std::string few_threads = "exec prlimit --nproc=2 ";
    if (geteuid() == 0) {  // whose threads have no limit
        few_threads += "setpriv --reuid nobody --clear-groups ";
        fs::permissions(folder.path(), fs::perms::all);
    }
    if (shell(few_threads + "'" + program + "' --version").exit_code != 0) {
        MESSAGE("no program can be run here with few threads");
        return;
    }
    for (const std::string& command : commands) CHECK_FALSE(check(few_threads, command));
}

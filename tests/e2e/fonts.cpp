#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;

namespace {

namespace fs = std::filesystem;

std::string small_still(const std::string& output) {
    return "'" + program + "' still '" + library_scene("two-to-one") +
           "' --set 'subtitle=⠿ two to one' --size 320x180 -o " + output;
}

// Where the opening number `number` of a font fails.
Outcome with_failing_open(int number, const std::string& of, const TemporaryFolder& folder) {
    return shell(fmt::format("ASAN_OPTIONS=verify_asan_link_order=0 FAIL_OPEN_OF={} "
                             "FAIL_OPEN_NUMBER={} LD_PRELOAD='{}' {}",
                             of, number, CAROM_FAILING_OPEN, small_still("failed.png")),
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
        CHECK(outcome.exit_code == 1);
        CHECK(outcome.err.starts_with("carom: cannot read the font /"));
        CHECK(folder.names() == std::vector<std::string>{"whole.png"});
    }
    CHECK(refused > 5);
}

TEST_CASE("a film whose fonts are too many open files is refused, with the file") {
    const TemporaryFolder folder;
    const Outcome outcome =
        shell("ulimit -n 5; '" + program + "' render '" + library_scene("two-to-one") +
                  "' --size 320x180 --seconds 1 -o film.mp4",
              folder.path());
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.starts_with("carom: cannot read the font /"));
    CHECK(folder.names().empty());
}

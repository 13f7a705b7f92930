// The outputs of one command appear together or not at all, and a killed one leaves nothing.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "e2e/run_scene.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string small = " --size 320x180 --seconds 1 --quality draft -o film.mp4 --words --quiet";

}  // namespace

TEST_CASE("where the words of a film cannot be written, the earlier film stays") {
    const TemporaryFolder folder;
    folder.write("film.mp4", "earlier");
    fs::create_directory(folder.path() / "film.transcript.txt");
    const Outcome outcome =
        shell("'" + program + "' render '" + library_scene("one-hot-particle") + "'" + small,
              folder.path());
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.find("film.transcript.txt") != std::string::npos);
    CHECK(contents(folder.path() / "film.mp4") == "earlier");
    CHECK(folder.names() == std::vector<std::string>{"film.mp4", "film.transcript.txt"});
}

TEST_CASE("a film and its words replace earlier ones") {
    const TemporaryFolder folder;
    folder.write("film.mp4", "earlier");
    folder.write("film.transcript.txt", "earlier");
    const Outcome outcome =
        shell("'" + program + "' render '" + library_scene("one-hot-particle") + "'" + small,
              folder.path());
    CHECK(outcome.exit_code == 0);
    CHECK(contents(folder.path() / "film.mp4").find("ftyp") == 4);
    CHECK(contents(folder.path() / "film.transcript.txt") != "earlier");
    for (const std::string& name : folder.names()) CHECK(name.starts_with("film."));
}

TEST_CASE("a film that is killed leaves no file") {
    const TemporaryFolder folder;
    const Outcome outcome = shell("timeout --foreground -s KILL 1 '" + program + "' render '" +
                                      library_scene("mixed-masses") + "' -o film.mp4 --quiet",
                                  folder.path());
    CHECK(outcome.exit_code != 0);
    CHECK(folder.names().empty());
}

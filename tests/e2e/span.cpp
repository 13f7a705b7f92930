// A part of a film: its frames are those of the whole film.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// Reversed at 12 of 24, with pauses at both ends and there; trails, histograms and means since the
// start, all of which must know what came before the part.
const std::string scene = (root / "tests/e2e/there-and-back.yaml").string();

// Without captions: one that fades in is whole in a still.
const std::string events = "run.events=[{at: 12, reverse: velocities}]";

// In a film numbers in words are held for a fifth of a second, in a still they are of its own time:
// a layout without a clock and numbers.
const std::string without_panels = "film.panels=[]";
std::string without_numbers(const fs::path& folder) {
    const fs::path file = folder / "plain.yaml";
    std::ofstream(file) << "layout: {grid: [64, 36], title: [2, 1, 60, 2], gas: [2, 4, 56, 30], "
                           "color_bar: [59, 4, 4, 30]}\n";
    return "film.template=" + file.string();
}

std::vector<std::string> frames_of(const fs::path& folder, const std::string& span) {
    const Outcome outcome = shell(
        "'" + program + "' render '" + scene + "' --size 320x180 --seconds 8 --quiet --set '" +
            events + "' --set '" + without_numbers(folder) + "' --set '" + without_panels +
            "' -o '" + (folder / "frames").string() + "/' " + span,
        folder);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    std::vector<std::string> names, frames;
    for (const auto& entry : fs::directory_iterator(folder / "frames"))
        names.push_back(entry.path().string());
    std::ranges::sort(names);
    for (const std::string& name : names) frames.push_back(contents(name));
    fs::remove_all(folder / "frames");
    return frames;
}

}  // namespace

TEST_CASE("--from and --to give the frames of the whole film between two times") {
    const TemporaryFolder folder;
    const std::vector<std::string> whole = frames_of(folder.path(), "");
    REQUIRE(whole.size() == 240);
    const auto still = [&](const std::string& at) {
        REQUIRE(run({program, "still", scene, "--at", at, "-o", "still.png", "--size", "320x180",
                     "--set", "film.seconds=8", "--set", events, "--set",
                     without_numbers(folder.path()), "--set", without_panels},
                    folder.path())
                    .exit_code == 0);
        return contents(folder.path() / "still.png");
    };
    for (const auto& span : {std::pair{"2", "5.5"}, {"10", "14"}, {"12", "24"}, {"0", "12"}}) {
        const auto& from = span.first;
        const auto& to = span.second;
        CAPTURE(std::string(from));
        const std::vector<std::string> part =
            frames_of(folder.path(), std::string("--from ") + from + " --to " + to);
        REQUIRE(part.size() > 20);
        REQUIRE(part.size() < 200);
        // In one piece, and beginning with the frame that `still` draws for that time.
        const auto found = std::search(whole.begin(), whole.end(), part.begin(), part.end());
        REQUIRE(found != whole.end());
        CHECK((part.front() == still(from)));
        // It ends with the last frame of that time: the next one shows another.
        const std::string last = still(to);
        CHECK(std::ranges::find(part, last) != part.end());
    }
    const std::vector<std::string> rest = frames_of(folder.path(), "--from 20");
    CHECK(std::equal(rest.rbegin(), rest.rend(), whole.rbegin()));
    const std::vector<std::string> start = frames_of(folder.path(), "--to 3");
    CHECK(std::equal(start.begin(), start.end(), whole.begin()));
    // The pauses at both of its ends belong to a part: 0 and 12 come in several frames.
    CHECK(frames_of(folder.path(), "--to 12").size() +
              frames_of(folder.path(), "--from 12").size() >
          241 + 10);
}

TEST_CASE("a part without length, or outside of the run, is refused") {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& span) {
        const Outcome outcome =
            shell("'" + program + "' render '" + scene + "' " + span, folder.path());
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    CHECK(refusal("--from 5 --to 5") ==
          "carom: --from 5 --to 5: expected an end after the start\n");
    CHECK(refusal("--from 6 --to 5") ==
          "carom: --from 6 --to 5: expected an end after the start; write --from 5 --to 6\n");
    CHECK(refusal("--from 24") == "carom: --from 24 --to 24: expected an end after the start\n");
    CHECK(refusal("--from 25") == "carom: --from 25: the scene runs from 0 to 24\n");
    CHECK(refusal("--to 24.5") == "carom: --to 24.5: the scene runs from 0 to 24\n");
    CHECK(refusal("--from -1") == "carom: --from -1: the scene runs from 0 to 24\n");
    CHECK(refusal("--from nan") == "carom: --from nan: the scene runs from 0 to 24\n");
    CHECK(folder.names().empty());
}

TEST_CASE("a part of a film tells what it is a part of") {
    const TemporaryFolder folder;
    REQUIRE(run({program, "render", scene, "--size", "320x180", "--seconds", "8", "--from", "2",
                 "--to", "5.5", "-o", "part.webm", "--quiet"},
                folder.path())
                .exit_code == 0);
    const Outcome words =
        run({"ffprobe", "-v", "error", "-show_entries", "format_tags=comment", "part.webm"},
            folder.path());
    CHECK(words.out.find("--from 2\n--to 5.5\n") != std::string::npos);
}

TEST_CASE("a part may be one frame, which is told as one") {
    const TemporaryFolder folder;
    const Outcome outcome = run({program, "render", scene, "--size", "320x180", "--from", "2",
                                 "--to", "2.0001", "-o", "part.mp4"},
                                folder.path());
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.starts_with("part.mp4: 1 frame, 0:00, "));
}

// How far long work has come, told by the program itself to someone at a terminal.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "e2e/interrupted.h"
#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;

namespace {

// More than anyone waits for: what is awaited, not the clock, ends these runs.
const std::string scene =
    "title: T\nbox: {size: [30, 30]}\ngas: [{count: 50, radius: 0.5, speed: 1}]\n"
    "run: {until: 1e9, sample_every: 1e9}\nfilm: {seconds: 60, template: wide-gas}\n"
    "figures: [{name: a, kind: gas}]\n";

bool has_terminal() {
    if (is_installed("script")) return true;
    MESSAGE("no `script` here to play the terminal: the bar is not tested");
    return false;
}

// What carom shows on a terminal until these words are there and it is interrupted; or for `most`
// seconds, of which there are plenty.
std::string shown_until(const std::string& words, const std::string& arguments, int most = 60) {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    return interrupted(arguments, folder.path(), "INT", words, "", most).err;
}

}  // namespace

TEST_CASE("on a terminal a bar tells how far a long run has come") {
    if (!has_terminal()) return;
    const std::string shown = shown_until("left\r", "run scene.yaml");
    CAPTURE(shown);
    CHECK(has(shown, "░ scene: simulating "));
    CHECK(has(shown, "/1e+09 time units, "));
    CHECK(has(shown, " left\x1b[K"));
    CHECK(shown.ends_with("carom: interrupted; nothing was written\n"));
}

TEST_CASE("on a terminal a bar tells how far figures and stills have come, not with --quiet") {
    if (!has_terminal()) return;
    for (const auto& [command, amount] : {std::pair{"figures scene.yaml", "/2e+06 time units, "},
                                          {"still scene.yaml", "/1800 frames, "}}) {
        const std::string all = std::string(command) + " --set run.until=1e6";
        CAPTURE(all);
        const std::string shown = shown_until("left\r", all);
        CHECK(has(shown, "░ scene: simulating "));
        CHECK(has(shown, amount));
        CHECK(has(shown, " left\x1b[K"));
        CHECK_FALSE(has(shown_until("left\r", all + " --quiet", 1), "left"));
    }
}

TEST_CASE("on a terminal a bar tells how far a gas has equilibrated") {
    if (!has_terminal()) return;
    for (const std::string& command :
         std::vector<std::string>{"run scene.yaml", "render scene.yaml -o film.mp4",
                                  "still scene.yaml", "run scene.yaml --set run.precision=64"}) {
        const std::string all = command + " --set run.equilibrate=1e9";
        CAPTURE(all);
        const std::string shown = shown_until("left\r", all);
        CHECK(has(shown, "░ scene: equilibrating "));
        CHECK(has(shown, "/1e+09 time units, "));
    }
    const std::string shown =
        shown_until("left\r", "figures scene.yaml --set run.equilibrate=1e9 --set run.until=1e6");
    CHECK(has(shown, "░ scene: simulating "));
    CHECK(has(shown, "/1.002e+09 time units, "));
}

TEST_CASE("on a terminal a bar tells of the colours of a film as GIF after it has equilibrated") {
    if (!has_terminal()) return;
    CHECK(has(shown_until("choosing colours",
                          "render scene.yaml -o film.gif --set run.until=1e4 "
                          "--set run.equilibrate=1"),
              "░ scene: choosing colours "));
}

// The words beside a film, read back by a program that shares nothing with their writer.
#include <doctest/doctest.h>

#include <string>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene =
    "title: Two beads\nbox: {length: 10}\n"
    "gas: [{radius: 0, position: [2, 8], velocity: [1, -1]}]\n"
    "run: {until: 6, events: [{at: 0, caption: \"<b>They</b> meet & part --> look\"}]}\n"
    "film: {seconds: 6, fps: 5, size: [320, 180]}\n";

// A file of WebVTT as ffmpeg understands it.
std::string as_srt(const fs::path& file) {
    const Outcome outcome = run({"ffmpeg", "-v", "error", "-i", file.string(), "-f", "srt", "-"});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    return outcome.out;
}

}  // namespace

TEST_CASE("a film's words stand beside it, as players read them") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    const Outcome outcome = run(
        {program, "render", "scene.yaml", "--words", "-o", "film.mp4", "--quiet"}, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::string captions = as_srt(folder.path() / "film.captions.vtt");
    CHECK(captions.find("00:00:00,000 --> 00:00:06,000\n") != std::string::npos);
    CHECK(captions.find("They</b> meet & part --> look") != std::string::npos);
    CHECK(as_srt(folder.path() / "film.chapters.vtt").find("--> 00:00:06,000") !=
          std::string::npos);
    CHECK(as_srt(folder.path() / "film.descriptions.vtt").find("1 collision between particles") !=
          std::string::npos);
    CHECK(contents(folder.path() / "film.transcript.txt").starts_with("Two beads\n"));
}

TEST_CASE("a film without captions has no file of captions, and does not keep an earlier one") {
    const TemporaryFolder folder;
    std::string silent = scene;
    const std::size_t caption = silent.find("caption:");
    REQUIRE(caption != std::string::npos);
    silent.replace(silent.rfind('{', caption),
                   silent.find('}', caption) + 1 - silent.rfind('{', caption),
                   "{at: 1, mark: here}");
    folder.write("scene.yaml", silent);
    const auto render = [&] {
        const Outcome outcome =
            run({program, "render", "scene.yaml", "--words", "-o", "film.mp4", "--quiet"},
                folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    };
    render();
    CHECK_FALSE(fs::exists(folder.path() / "film.captions.vtt"));
    CHECK(fs::exists(folder.path() / "film.descriptions.vtt"));
    folder.write("film.captions.vtt", "WEBVTT\n\n00:00.000 --> 00:01.000\nold\n");
    render();
    CHECK(contents(folder.path() / "film.captions.vtt") == "WEBVTT\n");
}

TEST_CASE("words go beside a folder of frames, and nowhere without being asked") {
    const TemporaryFolder folder;
    folder.write("scene.yaml", scene);
    REQUIRE(
        run({program, "render", "scene.yaml", "--words", "-o", "frames/", "--quiet"}, folder.path())
            .exit_code == 0);
    CHECK(fs::exists(folder.path() / "frames.transcript.txt"));
    REQUIRE(run({program, "render", "scene.yaml", "-o", "film.mp4", "--quiet"}, folder.path())
                .exit_code == 0);
    CHECK_FALSE(fs::exists(folder.path() / "film.transcript.txt"));
    const Outcome streamed =
        run({program, "render", "scene.yaml", "--words", "-o", "-"}, folder.path());
    CHECK(streamed.exit_code == 2);
    CHECK(streamed.err.find("--words") != std::string::npos);
    CHECK(streamed.out.empty());
}

TEST_CASE("numbers in captions are those of the run, and one that the run lacks is an error") {
    const TemporaryFolder folder;
    // The beads, of mass 1, meet once, at time 3.
    const auto film = [&](const std::string& asked) {
        std::string text = scene;
        const std::string words = "<b>They</b> meet & part --> look";
        text.replace(text.find(words), words.size(), asked);
        folder.write("scene.yaml", text);
        return run({program, "render", "scene.yaml", "--words", "-o", "film.mp4", "--quiet"},
                   folder.path());
    };
    REQUIRE(film("{collisions}, {collisions at 4}: {mean_energy:.4f}").exit_code == 0);
    CHECK(as_srt(folder.path() / "film.captions.vtt").find("0, 1: 0.5000") != std::string::npos);
    const std::string before = contents(folder.path() / "film.mp4");
    const Outcome none = film("{mean_free_path}");
    CHECK(none.exit_code == 2);
    CHECK(none.err.find("scene.yaml:4:") != std::string::npos);
    CHECK(none.err.find("`{mean_free_path}` has no value at time 0") != std::string::npos);
    CHECK(contents(folder.path() / "film.mp4") == before);
}

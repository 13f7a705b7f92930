// A film from a scene file, by the program itself, read by independent programs: ffprobe and
// ffmpeg.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "e2e/program.h"
#include "e2e/still_life.h"
#include "support/film_tags.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

Outcome run_carom(std::vector<std::string> arguments, const fs::path& folder = ".") {
    arguments.insert(arguments.begin(), program);
    return run(arguments, folder);
}

struct Rgb {
    int red, green, blue;
};

// One frame of a film as RGB, decoded by ffmpeg.
class Decoded {
  public:
    Decoded(const fs::path& film, int frame, int width, int height) : width_(width) {
        const Outcome outcome =
            run({"ffmpeg", "-v", "error", "-i", film.string(), "-vf",
                 "select=eq(n\\," + std::to_string(frame) +
                     "),scale=out_color_matrix=bt709:flags=accurate_rnd+full_chroma_int",
                 "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"});
        REQUIRE(outcome.exit_code == 0);
        bytes_ = outcome.out;
        REQUIRE(bytes_.size() == static_cast<std::size_t>(3 * width * height));
    }
    Rgb at(int x, int y) const {
        const auto i = static_cast<std::size_t>(3 * (y * width_ + x));
        const auto byte = [&](std::size_t k) {
            return int(static_cast<std::uint8_t>(bytes_[i + k]));
        };
        return {byte(0), byte(1), byte(2)};
    }

  private:
    int width_;
    std::string bytes_;
};

// 8-bit YCbCr of limited range rounds each channel by up to 2; the encoder's quantiser adds as much
// on flat ground.
void check_color(Rgb found, Rgb expected) {
    constexpr int tolerance = 4;
    CAPTURE(found.red);
    CAPTURE(found.green);
    CAPTURE(found.blue);
    CHECK(std::abs(found.red - expected.red) <= tolerance);
    CHECK(std::abs(found.green - expected.green) <= tolerance);
    CHECK(std::abs(found.blue - expected.blue) <= tolerance);
}

nlohmann::json probe(const fs::path& film) {
    const Outcome outcome = run({"ffprobe", "-v", "error", "-count_frames", "-show_streams",
                                 "-show_format", "-of", "json", film.string()});
    REQUIRE(outcome.exit_code == 0);
    return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a scene becomes a film of the promised format, length and words") {
    const TemporaryFolder folder;
    const fs::path scene = folder.write("scene.yaml", still_life);
    const Outcome outcome = run_carom({"render", scene.string()}, folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const fs::path film = folder.path() / "out" / "scene.mp4";
    REQUIRE(fs::exists(film));

    const nlohmann::json found = probe(film);
    const nlohmann::json& stream = found["streams"][0];
    check_film_tags(found, 25);
    CHECK(stream["codec_name"] == "h264");
    CHECK(stream["profile"] == "High");
    CHECK(stream["width"] == 640);
    CHECK(stream["height"] == 360);
    CHECK(stream["nb_read_frames"] == "50");
    CHECK(std::stod(found["format"]["duration"].get<std::string>()) ==
          doctest::Approx(2.0).epsilon(1e-6));
    const nlohmann::json& tags = found["format"]["tags"];
    CHECK(tags["title"] == "One disk at rest");
    CHECK(tags["comment"].get<std::string>().find("seed: 1") != std::string::npos);
    CHECK(tags["comment"].get<std::string>().find(still_life) != std::string::npos);
    CHECK_FALSE(tags["description"].get<std::string>().empty());

    const std::string bytes = contents(film);
    CHECK(bytes.find("moov") < bytes.find("mdat"));
}

TEST_CASE(
    "a picture of odd size is padded to an even one, and what the command line changed is noted") {
    const TemporaryFolder folder;
    const fs::path scene = folder.write("scene.yaml", still_life);
    const Outcome outcome =
        run_carom({"render", scene.string(), "-o", "odd.mp4", "--size", "321x181", "--seed", "7"},
                  folder.path());
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const nlohmann::json found = probe(folder.path() / "odd.mp4");
    CHECK(found["streams"][0]["width"] == 322);
    CHECK(found["streams"][0]["height"] == 182);
    const std::string comment = found["format"]["tags"]["comment"];
    CHECK(comment.starts_with(
        "seed: 7\n--set seed=7\n--set film.size=[321, 181]\n\ntitle: One disk"));
}

TEST_CASE("a film may keep its scene to itself, and so may its page") {
    const TemporaryFolder folder;
    const std::string note = "# the answer is 42\n";
    const fs::path scene = folder.write("scene.yaml", std::string(still_life) + note);
    const auto made = [&](const std::string& name, const std::vector<std::string>& options) {
        std::vector<std::string> call{"render", scene.string(), "--size", "320x180"};
        call.insert(call.end(), options.begin(), options.end());
        if (name.ends_with(".html"))
            call.insert(call.end(), {"--page", "html", "-o", name});
        else
            call.insert(call.end(), {"-o", name});
        const Outcome outcome = run_carom(call, folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return contents(folder.path() / name);
    };
    for (const std::string name : {"film.mp4", "film.webm", "film.gif"}) {
        CAPTURE(name);
        CHECK(made(name, {}).find("the answer is 42") != std::string::npos);
        const std::string kept = made(name, {"--no-recipe"});
        CHECK(kept.find("the answer is 42") == std::string::npos);
        CHECK(kept.find("film.recipe") == std::string::npos);
        CHECK(kept.find("One disk at rest") != std::string::npos);
    }
    const nlohmann::json tags = probe(folder.path() / "film.mp4")["format"]["tags"];
    CHECK_FALSE(tags.contains("comment"));
    CHECK(tags["title"] == "One disk at rest");
    CHECK(made("film.html", {}).find("data:text/yaml") != std::string::npos);
    const std::string page = made("film.html", {"--set", "film.recipe=false"});
    CHECK(page.find("text/yaml") == std::string::npos);
    CHECK(page.find("--set") == std::string::npos);
    CHECK(page.find("id=\"save\"") != std::string::npos);
}

TEST_CASE("the decoded colours are those that were drawn") {
    const TemporaryFolder folder;
    const fs::path scene = folder.write("scene.yaml", still_life);
    REQUIRE(run_carom({"render", scene.string(), "-o", "film.mp4"}, folder.path()).exit_code == 0);
    const Decoded frame(folder.path() / "film.mp4", 30, 640, 360);
    check_color(frame.at(4, 4), {0xFF, 0xFF, 0xFF});  // page
    // lecture's gas slot begins at (1.8, 6.4) units of 8 pixels and is 42.6 by 32: the box is 40 :
    // 30, 341 by 256 pixels.
    const double scale = std::min(42.6 * 8 / 40, 32.0 * 8 / 30);
    const double left = 1.8 * 8, top = 6.4 * 8 + (32.0 * 8 - 30 * scale) / 2;
    const auto pixel = [&](double x, double y) {
        return frame.at(static_cast<int>(left + x * scale),
                        static_cast<int>(top + (30 - y) * scale));
    };
    check_color(pixel(10, 20), {0x56, 0xB4, 0xE9});  // centre of the disk
    check_color(pixel(14.5, 20),
                {0x56, 0xB4, 0xE9});                // inside, a quarter of the radius from its rim
    check_color(pixel(30, 8), {0xFF, 0xFF, 0xFF});  // ground
    check_color(pixel(10, 28.5), {0xFF, 0xFF, 0xFF});  // ground, above the disk
}

TEST_CASE(
    "the film is the same, byte for byte, on any number of threads, and another with another "
    "seed") {
    const TemporaryFolder folder;
    const std::string scene = library_scene("one-hot-particle");
    const auto render = [&](const std::string& name, const std::string& threads,
                            const std::string& seed) {
        const Outcome outcome =
            run_carom({"render", scene, "-o", name, "--size", "320x180", "--seconds", "9",
                       "--threads", threads, "--seed", seed, "--quality", "draft"},
                      folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return contents(folder.path() / name);
    };
    const std::string one = render("one.mp4", "1", "1");
    CHECK(one.size() > 10'000);
    CHECK(render("two.mp4", "2", "1") == one);
    CHECK(render("five.mp4", "5", "1") == one);
    CHECK(render("other.mp4", "2", "2") != one);
}

TEST_CASE("so is that of a gas of disks too small and too many to be told apart") {
    const TemporaryFolder folder;
    folder.write("crowd.yaml",
                 "title: A crowd\nbox: {size: [80, 60]}\n"
                 "gas: [{count: 6000, radius: 0.25, temperature: 1}]\n"
                 "run: {until: 1}\nfilm: {seconds: 3}\n");
    const auto render = [&](const std::string& threads) {
        const std::string name = "film-" + threads + ".mp4";
        const Outcome outcome = run_carom(
            {"render", "crowd.yaml", "-o", name, "--size", "320x180", "--threads", threads},
            folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return contents(folder.path() / name);
    };
    const std::string one = render("1");
    CHECK(one.size() > 10'000);
    CHECK(render("2") == one);
    CHECK(render("8") == one);
}

TEST_CASE("the last picture of a reversed film is its first") {
    const TemporaryFolder folder;
    const std::string scene = (root / "tests/e2e/there-and-back.yaml").string();
    const std::vector<std::string> common{"still",          scene,     "--size",
                                          "640x360",        "--quiet", "--set",
                                          "film.panels=[]", "--set",   "run.precision=auto"};
    const auto still = [&](const std::string& at) {
        std::vector<std::string> arguments = common;
        arguments.insert(arguments.end(), {"--at", at, "-o", at + ".png"});
        const Outcome outcome = run_carom(arguments, folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        // The gas alone: captions change, and the monitors count collisions on.
        return run({"ffmpeg", "-v", "error", "-i", at + ".png", "-vf", "crop=340:230:15:52", "-f",
                    "rawvideo", "-pix_fmt", "rgb24", "-"},
                   folder.path())
            .out;
    };
    const std::string first = still("0");
    const std::string last = still("24");
    const std::string middle = still("12");
    REQUIRE(first.size() == 340 * 230 * 3);
    REQUIRE(last.size() == first.size());
    CHECK(last == first);
    CHECK(middle != first);
}

TEST_CASE("render names callouts that no frame shows") {
    const TemporaryFolder folder;
    const fs::path scene = folder.write(
        "scene.yaml",
        "title: T\nbox: {size: [10, 10]}\ngas: [{count: 20, radius: 0.3, speed: 1}]\n"
        "run: {until: 4}\nfilm: {size: [320, 180], fps: 10, seconds: 4, panels: [speed-histogram], "
        "callouts: [{at: 1, points_to: {panel: speed-histogram, x: 1}, text: seen}, {at: 1, "
        "points_to: {panel: "
        "speed-histogram, x: 50}, text: too fast}]}\n");
    const Outcome outcome = run_carom({"render", scene.string()}, folder.path());
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.find("no frame shows the callout “too fast”; `x` is beyond the axis") !=
          std::string::npos);
}

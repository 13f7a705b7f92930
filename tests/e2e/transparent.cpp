// A film for slides: nothing lies behind the box, the panels and the words.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

constexpr int width = 640, height = 360;
const TemporaryFolder of_scene;
const std::string scene = without_card(of_scene, "one-hot-particle");
const std::string common = " '" + scene + "' --size 640x360 --quiet --theme dark ";
constexpr int page[] = {0x10, 0x14, 0x18}, ink[] = {0xE9, 0xED, 0xF1};

using Pixels = std::vector<int>;  // red, green, blue, alpha; row by row

Pixels pixels_of(const fs::path& picture, const std::string& decoder = "", int frame = 0) {
    const Outcome outcome =
        shell("ffmpeg -v error " + decoder + " -i '" + picture.string() + "' -vf 'select=eq(n\\," +
              std::to_string(frame) + ")' -frames:v 1 -f rawvideo -pix_fmt rgba -");
    CAPTURE(outcome.err);
    REQUIRE(outcome.out.size() == std::size_t{4} * width * height);
    Pixels pixels;
    for (const char byte : outcome.out) pixels.push_back(static_cast<std::uint8_t>(byte));
    return pixels;
}

void still(const fs::path& folder, const std::string& ground, const std::string& name) {
    const Outcome outcome = shell(
        "'" + program + "' still" + common + "--at 3 --ground " + ground + " -o " + name, folder);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
}

// The largest difference of a channel between a picture laid over the page, and one with a page.
int largest_over_page(const Pixels& transparent, const Pixels& opaque) {
    int largest = 0;
    for (std::size_t i = 0; i < transparent.size(); i += 4) {
        const int alpha = transparent[i + 3];
        for (std::size_t k = 0; k < 3; ++k) {
            const int over = (transparent[i + k] * alpha + page[k] * (255 - alpha) + 127) / 255;
            largest = std::max(largest, std::abs(over - opaque[i + k]));
        }
    }
    return largest;
}

int alpha_at(const Pixels& pixels, int x, int y) {
    return pixels[std::size_t(4 * (y * width + x) + 3)];
}

}  // namespace

TEST_CASE("without a ground nothing is there but what was drawn, and it lies well on any slide") {
    const TemporaryFolder folder;
    still(folder.path(), "none", "none.png");
    still(folder.path(), "theme", "page.png");
    const Pixels none = pixels_of(folder.path() / "none.png");
    const Pixels with_page = pixels_of(folder.path() / "page.png");
    CHECK(alpha_at(none, 2, 2) == 0);
    CHECK(alpha_at(none, width - 3, height - 3) == 0);
    CHECK(alpha_at(none, 150, 200) == 255);  // in the box
    CHECK(alpha_at(with_page, 2, 2) == 255);
    // Over the page it is the very picture: half-covered pixels were not mixed with anything. Two
    // roundings to 8 bits, and one more for each layer of ink upon another.
    CHECK(largest_over_page(none, with_page) <= 4);

    // The letters of the title: their edges are of the ink's own colour, more or less covered. Of
    // faint ones, multiplied by an alpha of a few steps of 255, less of the colour is left.
    int edges = 0;
    for (int y = 8; y < 30; ++y)
        for (int x = 10; x < 300; ++x) {
            const std::size_t i = std::size_t(4 * (y * width + x));
            if (none[i + 3] < 32 || none[i + 3] == 255) continue;
            ++edges;
            for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(none[i + k] - ink[k]) <= 8);
        }
    CHECK(edges > 200);
}

TEST_CASE("cards of a film without a ground lie well on any slide, too") {
    const TemporaryFolder folder;
    const auto render = [&](const std::string& ground) {
        const Outcome outcome =
            shell("'" + program + "' render '" + (root / "scenes/one-hot-particle.yaml").string() +
                      "' --size 640x360 --quiet --theme dark --seconds 8 --fps 4 --set "
                      "'film.end_card=All as fast' --set film.title_card=2 --ground " +
                      ground + " -o " + ground + "/",
                  folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    };
    render("none");
    render("theme");
    int compared = 0, clear = 0;
    for (int frame = 1; frame <= 32; ++frame) {
        const std::string name = "frame-" + std::to_string(100'000 + frame).substr(1) + ".png";
        CAPTURE(name);
        const Pixels none = pixels_of(folder.path() / "none" / name);
        // One more rounding for each of two covers, and of words that move.
        CHECK(largest_over_page(none, pixels_of(folder.path() / "theme" / name)) <= 6);
        clear += alpha_at(none, 2, 2) == 0;
        ++compared;
    }
    CHECK(compared == 32);
    CHECK(clear == compared);
}

TEST_CASE("an SVG and a PDF without a ground have none") {
    const TemporaryFolder folder;
    still(folder.path(), "none", "none.svg");
    still(folder.path(), "none", "none.pdf");
    REQUIRE(run({"rsvg-convert", "none.svg", "-o", "svg.png"}, folder.path()).exit_code == 0);
    const Pixels svg = pixels_of(folder.path() / "svg.png");
    CHECK(alpha_at(svg, 2, 2) == 0);
    CHECK(alpha_at(svg, 150, 200) == 255);
    // Paper is white where nothing lies on it.
    REQUIRE(run({"pdftoppm", "-png", "-singlefile", "-r", "96", "none.pdf", "pdf"}, folder.path())
                .exit_code == 0);
    CHECK(pixels_of(folder.path() / "pdf.png")[std::size_t(4 * (2 * width + 2))] == 255);
}

TEST_CASE("a WebM without a ground has a plane of alpha, that of the frames") {
    const TemporaryFolder folder;
    const auto render = [&](const std::string& more) {
        const Outcome outcome =
            shell("'" + program + "' render" + common + "--ground none --seconds 2 " + more,
                  folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
    };
    render("-o film.webm --threads 1");
    render("-o more.webm --threads 3");
    CHECK((contents(folder.path() / "film.webm") == contents(folder.path() / "more.webm")));
    render("-o frames/");
    const Outcome probed =
        run({"ffprobe", "-v", "error", "-show_streams", "film.webm"}, folder.path());
    CHECK(probed.out.find("TAG:ALPHA_MODE=1") != std::string::npos);

    for (const int frame : {0, 29, 30, 59}) {  // two segments
        CAPTURE(frame);
        const std::string number = std::to_string(100'001 + frame).substr(1);
        const Pixels drawn = pixels_of(folder.path() / ("frames/frame-" + number + ".png"));
        const Pixels shown = pixels_of(folder.path() / "film.webm", "-c:v libvpx-vp9", frame);
        double squares = 0.0;
        int there = 0;
        for (std::size_t i = 3; i < drawn.size(); i += 4) {
            squares += std::pow(drawn[i] - shown[i], 2);
            there += drawn[i] > 0;
        }
        CHECK(alpha_at(shown, 2, 2) == 0);
        CHECK(alpha_at(shown, 150, 200) == 255);
        CHECK(there > width * height / 4);
        CHECK(there < width * height * 3 / 4);
        // As like as the colours of a film at quality standard: 36 dB and more.
        CHECK(std::sqrt(squares / (width * height)) < 4.0);
    }
    // A player that knows no transparency shows the page.
    const Pixels plain = pixels_of(folder.path() / "film.webm");
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(plain[8 * width + 8 + k] - page[k]) <= 4);
}

TEST_CASE("films that cannot be transparent are refused") {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& more) {
        const Outcome outcome =
            shell("'" + program + "' render" + common + "--ground none " + more, folder.path());
        CHECK(outcome.exit_code == 2);
        return outcome.err;
    };
    const std::string mp4 =
        "carom: the ground is none, but MP4 cannot be transparent; write a .webm or a "
        "folder of frames (--format webm or png)\n";
    CHECK(refusal("-o film.mp4") == mp4);
    CHECK(refusal("") == mp4);
    CHECK(refusal("-o film.gif").find("ragged letters; write a .webm") != std::string::npos);
    CHECK(folder.names().empty());
}

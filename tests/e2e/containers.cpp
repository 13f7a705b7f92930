// What a film can be besides an MP4: VP9 in WebM, and a folder of numbered frames.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "e2e/interrupted.h"
#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const TemporaryFolder of_scene;
const std::string scene = without_card(of_scene, "one-hot-particle");

// 180 frames in four segments, or fewer frames.
Outcome render_small(const fs::path& folder, const std::string& output,
                     std::vector<std::string> more = {}) {
    if (std::ranges::find(more, "--quality") == more.end())
        more.insert(more.end(), {"--quality", "draft"});
    std::vector<std::string> command{program, "render", scene,     "-o",
                                     output,  "--size", "320x180", "--quiet"};
    if (std::ranges::find(more, "--seconds") == more.end())
        more.insert(more.end(), {"--seconds", "6"});
    command.insert(command.end(), more.begin(), more.end());
    return run(command, folder);
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::string all_of(const fs::path& folder) {
    std::string bytes;
    for (const std::string& name : names_in(folder)) bytes += name + contents(folder / name);
    return bytes;
}

// All frames of 320 by 180 as 4:2:0, decoded (and of pictures converted) by ffmpeg.
std::string decoded(const fs::path& film) {
    const Outcome outcome =
        run({"ffmpeg", "-v", "error", "-i", film.string(), "-fps_mode", "passthrough", "-vf",
             "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int", "-f",
             "rawvideo", "-pix_fmt", "yuv420p", "-"});
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
}

constexpr std::size_t frame_bytes = 320 * 180 * 3 / 2;

// Peak signal-to-noise ratio of one frame in dB, over all three planes.
double psnr(const std::string& a, std::size_t frame_of_a, const std::string& b,
            std::size_t frame_of_b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < frame_bytes; ++i) {
        const int difference = int(static_cast<std::uint8_t>(a[frame_of_a * frame_bytes + i])) -
                               int(static_cast<std::uint8_t>(b[frame_of_b * frame_bytes + i]));
        sum += difference * difference;
    }
    return 10.0 * std::log10(255.0 * 255.0 * double(frame_bytes) / sum);
}

}  // namespace

TEST_CASE("a name with a slash is a folder of all frames, each as `still` draws it") {
    const TemporaryFolder folder;
    const Outcome outcome = render_small(folder.path(), "new/frames/");
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(folder.names() == std::vector<std::string>{"new"});
    CHECK(names_in(folder.path() / "new") == std::vector<std::string>{"frames"});

    const fs::path frames = folder.path() / "new/frames";
    const std::vector<std::string> names = names_in(frames);
    REQUIRE(names.size() == 180);
    CHECK(names.front() == "frame-00001.png");
    CHECK(names[99] == "frame-00100.png");
    CHECK(names.back() == "frame-00180.png");
    const fs::perms usual = fs::status(folder.write("file", "")).permissions();
    CHECK(fs::status(frames / names.front()).permissions() == usual);

    // The scene runs from 0 to 36.
    for (const auto& [at, name] : {std::pair{"0", names.front()}, std::pair{"36", names.back()}}) {
        REQUIRE(run({program, "still", scene, "--at", at, "-o", "still.png", "--size", "320x180",
                     "--set", "film.seconds=6"},
                    folder.path())
                    .exit_code == 0);
        CHECK(contents(folder.path() / "still.png") == contents(frames / name));
    }

    // An independent reader sees a numbered row of pictures.
    const Outcome probed = run({"ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of",
                                "json", (frames / "frame-%05d.png").string()});
    REQUIRE(probed.exit_code == 0);
    const nlohmann::json stream = nlohmann::json::parse(probed.out)["streams"][0];
    CHECK(stream["codec_name"] == "png");
    CHECK(stream["nb_read_frames"] == "180");
    CHECK(stream["width"] == 320);
    CHECK(stream["height"] == 180);
}

TEST_CASE("frames are the same on any number of threads") {
    const TemporaryFolder folder;
    const auto render = [&](const char* output, const char* threads) {  // in four segments
        return render_small(folder.path(), output, {"--seconds", "4", "--threads", threads});
    };
    REQUIRE(render("one/", "1").exit_code == 0);
    REQUIRE(render("three/", "3").exit_code == 0);
    CHECK(all_of(folder.path() / "one").size() > 120 * 1000);
    CHECK(all_of(folder.path() / "one") == all_of(folder.path() / "three"));
}

TEST_CASE("a folder that holds anything is refused before any work, and stays as it is") {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "mine");
    std::ofstream(folder.path() / "mine/frame-00001.png") << "mine";
    const Outcome outcome = render_small(folder.path(), "mine/");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err ==
          "carom: -o mine/: frames need a new or empty folder, and this one holds files; for a "
          "film in it write -o mine/one-hot-particle.mp4\n");
    CHECK(names_in(folder.path() / "mine") == std::vector<std::string>{"frame-00001.png"});
    CHECK(contents(folder.path() / "mine/frame-00001.png") == "mine");

    fs::create_directory(folder.path() / "here");
    CHECK(render_small(folder.path() / "here", "./").exit_code == 2);
    folder.write("file", "mine");
    CHECK(render_small(folder.path(), "file/").exit_code == 1);
    CHECK(contents(folder.path() / "file") == "mine");
    CHECK(folder.names() == std::vector<std::string>{"file", "here", "mine"});
}

TEST_CASE("an empty folder, or a link to one, is filled; without a slash a folder gets a film") {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "empty");
    fs::create_directory_symlink("empty", folder.path() / "link");
    REQUIRE(render_small(folder.path(), "link/", {"--seconds", "1"}).exit_code == 0);
    CHECK(fs::is_symlink(folder.path() / "link"));
    CHECK(names_in(folder.path() / "empty").size() == 30);
    CHECK(folder.names() == std::vector<std::string>{"empty", "link"});

    fs::create_directory(folder.path() / "films");
    REQUIRE(render_small(folder.path(), "films", {"--seconds", "1"}).exit_code == 0);
    CHECK(names_in(folder.path() / "films") == std::vector<std::string>{"one-hot-particle.mp4"});
}

TEST_CASE("frames that cannot all be written, or are interrupted, leave nothing") {
    const TemporaryFolder folder;
    // Larger than any file may be: fails as a full disk does.
    const std::string command = "'" + program + "' render '" + scene + "' -o frames/ --quiet ";
    const Outcome limited = shell("ulimit -f 4; " + command + "--seconds 1", folder.path());
    CHECK(limited.exit_code == 1);
    CHECK(limited.err == "carom: cannot write frames/frame-00001.png: File too large\n");
    CHECK(folder.names().empty());

    const Outcome stopped = interrupted("render '" + scene + "' -o frames/", folder.path());
    CHECK(stopped.exit_code == 130);
    CHECK(folder.names().empty());
}

TEST_CASE("an ending that is none of a film is refused with those that are") {
    const TemporaryFolder folder;
    const Outcome outcome = render_small(folder.path(), "film.avi");
    CHECK(outcome.exit_code == 2);
    CHECK(
        outcome.err ==
        "carom: -o film.avi: a film ends in .mp4, .webm, .gif or .pdf; a folder of PNG frames ends "
        "in a slash\n");
    CHECK(folder.names().empty());
}

TEST_CASE("a WebM is VP9 of the promised length and words, and its frames are those drawn") {
    const TemporaryFolder folder;
    REQUIRE(render_small(folder.path(), "frames/", {"--to", "12"}).exit_code == 0);
    const std::string drawn = decoded(folder.path() / "frames/frame-%05d.png");
    const std::size_t count = names_in(folder.path() / "frames").size();
    REQUIRE(count >= 60);  // two segments
    REQUIRE(count < 120);
    REQUIRE(drawn.size() == count * frame_bytes);
    // Gases move so little from frame to frame that a film which is one frame late has some 35 dB:
    // a film that is right has more in every frame. 41 dB are 2.3 of 255 in the mean square.
    constexpr double late_by_one = 36.0;
    for (const auto& asked :
         {std::pair{"draft", late_by_one}, std::pair{"standard", 39.0}, std::pair{"final", 41.0}}) {
        const auto& quality = asked.first;
        const auto& bound = asked.second;
        CAPTURE(std::string(quality));
        const Outcome outcome =
            run({program, "render", scene, "-o", "film.webm", "--size", "320x180", "--seconds", "6",
                 "--to", "12", "--quality", quality},
                folder.path());
        CAPTURE(outcome.err);
        REQUIRE(outcome.exit_code == 0);
        CHECK(outcome.out.starts_with("film.webm: " + std::to_string(count) + " frames, 0:03"));
        const fs::path film = folder.path() / "film.webm";
        const Outcome probed = run({"ffprobe", "-v", "error", "-count_frames", "-show_streams",
                                    "-show_format", "-of", "json", film.string()});
        REQUIRE(probed.exit_code == 0);
        const nlohmann::json found = nlohmann::json::parse(probed.out);
        const nlohmann::json& stream = found["streams"][0];
        CHECK(found["streams"].size() == 1);
        CHECK(stream["codec_name"] == "vp9");
        CHECK(stream["width"] == 320);
        CHECK(stream["height"] == 180);
        CHECK(stream["nb_read_frames"] == std::to_string(count));
        CHECK(std::stod(found["format"]["duration"].get<std::string>()) ==
              doctest::Approx(double(count) / 30.0).epsilon(1e-3));
        const nlohmann::json& tags = found["format"]["tags"];
        CHECK(tags["title"] == "One fast particle among slow ones");
        CHECK(tags["COMMENT"].get<std::string>().find("count: 200") != std::string::npos);

        const std::string shown = decoded(film);
        REQUIRE(shown.size() == drawn.size());
        double least = 1000.0, of_neighbours = 0.0;
        for (std::size_t i = 1; i < count; ++i) {
            least = std::min(least, psnr(shown, i, drawn, i));
            of_neighbours += psnr(shown, i, drawn, i - 1) / double(count - 1);
        }
        CHECK(least > bound);
        CHECK(of_neighbours < late_by_one);
    }
}

TEST_CASE("a WebM is the same, byte for byte, on any number of threads") {
    const TemporaryFolder folder;
    for (const char* quality : {"standard", "final"}) {
        for (const auto& [output, threads] : {std::pair{"one.webm", "1"}, {"three.webm", "3"}})
            REQUIRE(render_small(folder.path(), output,
                                 {"--seconds", "4", "--threads", threads, "--quality", quality})
                        .exit_code == 0);
        CHECK(contents(folder.path() / "one.webm").size() > 10'000);
        CHECK(contents(folder.path() / "one.webm") == contents(folder.path() / "three.webm"));
    }
}

TEST_CASE("a WebM or GIF that cannot be written, or is interrupted, leaves the earlier one") {
    for (const auto& asked : {std::pair<std::string, std::string>{"film.webm", "--quality final"},
                              {"film.gif", "--size 2160p"}}) {
        const auto& film = asked.first;
        const auto& slowly = asked.second;
        CAPTURE(film);
        const TemporaryFolder folder;
        folder.write(film, "earlier");
        const std::string command =
            "'" + program + "' render '" + scene + "' -o " + film + " --quiet ";
        const Outcome limited = shell("ulimit -f 40; " + command + "--seconds 1", folder.path());
        CHECK(limited.exit_code == 1);
        CHECK(limited.err == "carom: cannot write " + film + ": File too large\n");
        const Outcome stopped =
            interrupted("render '" + scene + "' -o " + film + " " + slowly, folder.path());
        CHECK(stopped.exit_code == 130);
        CHECK(contents(folder.path() / film) == "earlier");
        CHECK(folder.names() == std::vector<std::string>{film});
    }
}

TEST_CASE(
    "a picture of odd sizes is itself as PNG, SVG and GIF, and gains a row and a column in films") {
    const TemporaryFolder folder;
    const auto size_of = [&](const std::string& file) {
        const Outcome probed = run({"ffprobe", "-v", "error", "-show_entries",
                                    "stream=width,height", "-of", "csv=p=0", file},
                                   folder.path());
        return probed.out;
    };
    const std::string odd = " --size 641x481 --quiet --seconds 1 ";
    const std::string command = "'" + program + "' render '" + scene + "'" + odd + "-o ";
    for (const std::string output : {"film.mp4", "film.webm", "film.gif", "frames/"})
        REQUIRE(shell(command + output, folder.path()).exit_code == 0);
    CHECK(size_of("film.mp4") == "642,482\n");
    CHECK(size_of("film.webm") == "642,482\n");
    CHECK(size_of("film.gif") == "641,481\n");
    CHECK(size_of("frames/frame-00001.png") == "641,481\n");

    // Nothing is stretched: the film without its last row and column is what was drawn, and those
    // are the ground. The quantiser costs up to 4 of 255 on flat ground, a shift by half a pixel
    // would cost 20 in the mean square over a film with so many edges.
    const auto greys = [&](const std::string& file, const std::string& crop) {
        return run({"ffmpeg", "-v", "error", "-i", file, "-frames:v", "1", "-vf",
                    crop + "format=gray", "-f", "rawvideo", "-"},
                   folder.path())
            .out;
    };
    const std::string drawn = greys("frames/frame-00001.png", "");
    REQUIRE(drawn.size() == 641 * 481);
    for (const std::string film : {"film.mp4", "film.webm"}) {
        const std::string shown = greys(film, "crop=641:481:0:0:exact=1,");
        REQUIRE(shown.size() == drawn.size());
        double squares = 0.0;
        for (std::size_t i = 0; i < drawn.size(); ++i)
            squares += std::pow(int(std::uint8_t(shown[i])) - int(std::uint8_t(drawn[i])), 2);
        CHECK(std::sqrt(squares / double(drawn.size())) < 4.0);
        const std::string corner = greys(film, "crop=1:1:641:481:exact=1,");
        REQUIRE(corner.size() == 1);
        CHECK(std::abs(int(std::uint8_t(corner[0])) - int(std::uint8_t(drawn[0]))) <= 4);
    }
}

// A film as a GIF: read back by ffprobe and ffmpeg, and compared with the frames that were drawn.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const std::string scene = library_scene("one-hot-particle");
constexpr std::size_t frame_bytes = 480 * 270 * 3;

Outcome render(const fs::path& folder, const std::string& output,
               const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{program,  "render",  scene,       "-o", output,
                                     "--size", "480x270", "--seconds", "5"};
    command.insert(command.end(), more.begin(), more.end());
    return run(command, folder);
}

std::string decoded(const fs::path& film) {
    const Outcome outcome = run({"ffmpeg", "-v", "error", "-i", film.string(), "-fps_mode",
                                 "passthrough", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"});
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
}

int apart(const std::string& a, const std::string& b, std::size_t at) {
    return std::abs(int(static_cast<std::uint8_t>(a[at])) - int(static_cast<std::uint8_t>(b[at])));
}

}  // namespace

TEST_CASE("a GIF has the film's frames, length and colours") {
    const TemporaryFolder folder;
    const Outcome outcome = render(folder.path(), "film.gif");
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.out.starts_with("film.gif: 150 frames, 0:05"));
    const Outcome probed = run({"ffprobe", "-v", "error", "-count_frames", "-show_streams",
                                "-show_format", "-of", "json", "film.gif"},
                               folder.path());
    const nlohmann::json found = nlohmann::json::parse(probed.out);
    CHECK(found["streams"][0]["codec_name"] == "gif");
    CHECK(found["streams"][0]["nb_read_frames"] == "150");
    CHECK(found["streams"][0]["width"] == 480);
    CHECK(found["streams"][0]["height"] == 270);
    CHECK(found["format"]["duration"] == "5.000000");

    // 255 colours for the thousands of shades on the edges of letters and disks, and for a scale
    // of 256: most pixels are flat ground and as drawn. The largest errors are those of shades of a
    // rare colour on some edge, a few pixels of a film; another colour would be off by more than a
    // hundred.
    REQUIRE(render(folder.path(), "frames/").exit_code == 0);
    const std::string drawn = decoded(folder.path() / "frames/frame-%05d.png");
    const std::string shown = decoded(folder.path() / "film.gif");
    REQUIRE(drawn.size() == 150 * frame_bytes);
    REQUIRE(shown.size() == drawn.size());
    double off = 0.0, far = 0.0, squares = 0.0;
    int largest = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const int error = apart(drawn, shown, i);
        off += error > 2;
        far += error > 64;
        squares += error * error;
        largest = std::max(largest, error);
    }
    CAPTURE(largest);
    CHECK(largest <= 100);
    CHECK(far / double(drawn.size()) < 1e-6);
    CHECK(off / double(drawn.size()) < 0.05);
    CHECK(std::sqrt(squares / double(drawn.size())) < 1.5);

    // No noise that moves: what is the same in two frames as drawn is the same as shown.
    for (std::size_t i = frame_bytes; i < drawn.size(); i += 3) {
        const bool still = std::equal(&drawn[i], &drawn[i] + 3, &drawn[i - frame_bytes]);
        if (still) REQUIRE(std::equal(&shown[i], &shown[i] + 3, &shown[i - frame_bytes]));
    }
}

TEST_CASE("a GIF is the same, byte for byte, on any number of threads") {
    const TemporaryFolder folder;
    REQUIRE(render(folder.path(), "one.gif", {"--threads", "1"}).exit_code == 0);
    REQUIRE(render(folder.path(), "three.gif", {"--threads", "3"}).exit_code == 0);
    CHECK(contents(folder.path() / "one.gif").size() > 100'000);
    CHECK(contents(folder.path() / "one.gif") == contents(folder.path() / "three.gif"));
}

TEST_CASE("a GIF of more frames a second than it can hold is refused, a large one is told") {
    const TemporaryFolder folder;
    const Outcome fast = render(folder.path(), "film.gif", {"--fps", "60"});
    CHECK(fast.exit_code == 2);
    CHECK(fast.err ==
          "carom: a GIF cannot show 60 frames a second, 50 are the most; give --fps 50 or fewer, "
          "or write a .webm or .mp4\n");
    CHECK(folder.names().empty());
    const Outcome large = run(
        {program, "render", library_scene("maxwell-boltzmann"), "--seconds", "6", "-o", "film.gif"},
        folder.path());
    REQUIRE(large.exit_code == 0);
    CHECK(large.err.find("MB is large for a GIF; a smaller --size or --fps makes it smaller") !=
          std::string::npos);
    CHECK(render(folder.path(), "small.gif").err.find("large") == std::string::npos);
}

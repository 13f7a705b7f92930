// The levels of H.264: by the standard, and as the encoder finds them.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "media/codecs.h"
#include "support/numbered_film.h"

using namespace carom;
using namespace carom::test;

namespace {

std::string name(int width, int height, int fps) {
    const std::optional<H264Level> level = h264_level(width, height, fps);
    return level ? level->name : "none";
}

// What ffprobe reads from a film of one frame: 52 is level 5.2.
int encoded_level(int width, int height, int fps, Quality quality) {
    const FilmFolder folder;
    VideoSettings settings = small_film(quality);
    settings.width = width;
    settings.height = height;
    settings.fps = fps;
    const std::unique_ptr<FilmWriter> writer = film_writer(folder.film(), settings, 1);
    encode(*writer, settings, 0, 1)->join();
    writer->commit();
    return probe(folder.film())["streams"][0]["level"];
}

}  // namespace

// Table A-6 of the standard lists the most frames in a second for some sizes.
TEST_CASE("a film has the lowest level that allows its frames") {
    CHECK(name(128, 96, 30) == "1");
    CHECK(name(1280, 720, 30) == "3.1");
    CHECK(name(1280, 720, 60) == "3.2");
    CHECK(name(1280, 720, 68) == "4");
    CHECK(name(1920, 1080, 30) == "4");
    CHECK(name(1920, 1080, 60) == "4.2");
    CHECK(name(1920, 1080, 120) == "5.1");
    CHECK(name(2560, 1440, 40) == "5");
    CHECK(name(3840, 2160, 30) == "5.1");
    CHECK(name(3840, 2160, 60) == "5.2");
    CHECK(name(3840, 2160, 64) == "5.2");
    CHECK(name(3840, 2160, 65) == "6");
    CHECK(name(3840, 2160, 120) == "6");
    CHECK(name(4096, 2304, 56) == "5.2");
    CHECK(name(4096, 2304, 57) == "6");
    CHECK(name(4096, 2305, 1) == "6");  // one more row of blocks
    CHECK(name(8192, 4320, 30) == "6");
    CHECK(name(8192, 4320, 60) == "6.1");
    CHECK(name(8192, 4320, 120) == "6.2");
    CHECK(name(8192, 8192, 1) == "none");
    CHECK(name(8192, 64, 1) == "5.1");  // 512 blocks in a row: at most the root of 8 * 36864
    CHECK(h264_level(3840, 2160, 60)->is_common);
    CHECK_FALSE(h264_level(3840, 2160, 120)->is_common);
}

TEST_CASE("the encoder finds the same level") {
    for (const auto& [width, height, fps] :
         {std::array{1280, 720, 30}, {1920, 1080, 60}, {3840, 2160, 60}, {3840, 2160, 65}}) {
        CAPTURE(width);
        CAPTURE(fps);
        const double found = std::stod(name(width, height, fps));
        CHECK(encoded_level(width, height, fps, Quality::draft) == std::lround(10.0 * found));
    }
    CHECK(encoded_level(4096, 2304, 26, Quality::final_) == 51);  // with all its reference frames
}

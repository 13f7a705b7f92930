#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "media/formats.h"
#include "media/gif_film.h"
#include "media/gif_palette.h"
#include "support/numbered_film.h"

using namespace carom;
using namespace carom::test;

namespace {

VideoSettings small_gif() {
    VideoSettings settings = small_film();
    settings.metadata = {{"title", "One hot particle — 293 K"}, {"comment", std::string(700, 'x')}};
    return settings;
}

void write_gif(const std::filesystem::path& path, const VideoSettings& settings, bool in_threads) {
    PaletteMaker maker(settings.width, settings.height);
    for (const int frame : {0, total - 1})
        maker.add(numbered_frame(settings, frame).canvas().pixels());
    const GifPalette palette = maker.finish();
    write_film(path, settings, in_threads, {palette.begin(), palette.end()});
}

std::string failure_of_gif(const std::filesystem::path& path) {
    try {
        write_gif(path, small_gif(), false);
    } catch (const SystemError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the delays of a GIF are those of its rate, and add up to its length") {
    for (int fps = 1; fps <= most_gif_frames_per_second; ++fps) {
        CAPTURE(fps);
        int sum = 0;
        for (int frame = 0; frame < 10 * fps; ++frame) {
            const int delay = gif_delay(frame, fps);
            CHECK(std::abs(delay - 100.0 / fps) < 1.0);
            CHECK(delay >= 2);
            sum += delay;
        }
        CHECK(sum == 1000);
    }
    CHECK(std::vector{gif_delay(0, 30), gif_delay(1, 30), gif_delay(2, 30)} ==
          std::vector{3, 4, 3});
}

TEST_CASE("each colour is given the nearest of the palette") {
    Random random(1, "colours");
    const auto color = [&] { return 0xff000000u | std::uint32_t(random.below(1 << 24)); };
    GifPalette palette{};
    for (int i = 0; i < gif_colors; ++i) palette[std::size_t(i)] = color();
    const auto distance = [](std::uint32_t a, std::uint32_t b) {
        double sum = 0;
        for (const int shift : {0, 8, 16})
            sum += std::pow(int((a >> shift) & 255) - int((b >> shift) & 255), 2);
        return sum;
    };
    ColorFinder finder(palette);
    std::vector<std::uint32_t> pixels(40'000);  // more than are remembered
    for (std::uint32_t& pixel : pixels) pixel = color();
    pixels[0] = 0xff000000u;
    std::copy_n(palette.begin(), gif_colors, pixels.begin() + 1);
    std::vector<std::uint8_t> indices(pixels.size());
    finder.find(pixels.data(), indices.data(), int(pixels.size()));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        double least = 1e9;
        for (int k = 0; k < gif_colors; ++k)
            least = std::min(least, distance(pixels[i], palette[std::size_t(k)]));
        REQUIRE(indices[i] < gif_colors);  // never the transparent one
        REQUIRE(distance(pixels[i], palette[indices[i]]) == least);
    }
}

TEST_CASE("a film of few colours is in its GIF as it was drawn, pixel by pixel") {
    const FilmFolder folder;
    const std::filesystem::path path = folder.path() / "film.gif";
    const VideoSettings settings = small_gif();
    write_gif(path, settings, false);
    const std::string shown = output_of("ffmpeg -v error -i " + path.string() +
                                        " -fps_mode passthrough -f rawvideo -pix_fmt bgra -");
    const std::size_t frame_bytes = std::size_t(settings.width * settings.height) * 4;
    REQUIRE(shown.size() == total * frame_bytes);
    for (int i = 0; i < total; ++i) {
        const Frame drawn = numbered_frame(settings, i);
        const std::string expected(reinterpret_cast<const char*>(drawn.pixels.data()), frame_bytes);
        CAPTURE(i);
        CHECK((shown.substr(std::size_t(i) * frame_bytes, frame_bytes) == expected));
    }

    const nlohmann::json all = probe(path);
    CHECK(all["streams"][0]["codec_name"] == "gif");
    int until = 0;
    for (const nlohmann::json& item : all["packets_and_frames"]) {
        if (item["type"] != "packet") continue;
        CHECK(item["pts"].get<int>() == until);
        until += item["duration"].get<int>();
    }
    CHECK(until == std::lround(100.0 * total / settings.fps));
}

TEST_CASE("a GIF loops forever, and holds the words of its film in blocks that readers skip") {
    const FilmFolder folder;
    const std::filesystem::path path = folder.path() / "film.gif";
    write_gif(path, small_gif(), false);
    const std::string bytes = contents(path);
    const std::size_t colors_end = 13 + 3 * 256;
    CHECK(bytes.substr(colors_end, 19) == std::string("\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19));
    CHECK(bytes.substr(colors_end + 19, 2) == "\x21\xfe");
    CHECK(bytes.find("title: One hot particle — 293 K") < 1000);
    CHECK(bytes.back() == ';');
}

TEST_CASE("a GIF is the same bytes whatever threads encoded its segments") {
    const FilmFolder folder;
    write_gif(folder.path() / "one.gif", small_gif(), false);
    write_gif(folder.path() / "many.gif", small_gif(), true);
    CHECK(contents(folder.path() / "one.gif") == contents(folder.path() / "many.gif"));
}

TEST_CASE("a GIF whose write fails, early or late, is one clear error and harms nothing") {
    const FilmFolder folder;
    const std::filesystem::path path = folder.path() / "film.gif";
    REQUIRE(failure_of_gif(path) == "");
    const auto size = static_cast<rlim_t>(std::filesystem::file_size(path));
    std::ofstream(path) << "earlier";
    for (const rlim_t limit : {rlim_t{1}, rlim_t{900}, size / 2, size - 1}) {
        CAPTURE(limit);
        std::string message;
        {
            const FileSizeLimit limited(limit);
            message = failure_of_gif(path);
        }
        CHECK(message == "cannot write " + path.string() + ": File too large");
        CHECK(contents(path) == "earlier");
    }
    CHECK(folder.names().size() == 1);
}

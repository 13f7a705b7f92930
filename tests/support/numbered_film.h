// Films whose frames show their own number, written through FilmWriter, and an independent reader
// of such films.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "media/formats.h"
#include "support/file_size_limit.h"
#include "support/files.h"
#include "util/diagnostics.h"
#include "util/random.h"

namespace carom::test {

struct FilmFolder : TemporaryFolder {
    std::filesystem::path film() const { return path() / "film.mp4"; }
    std::filesystem::path webm() const { return path() / "film.webm"; }
};

inline std::string output_of(const std::string& command) {
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 65536> buffer;
    for (std::size_t count; (count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        text.append(buffer.data(), count);
    REQUIRE_MESSAGE(pclose(pipe) == 0, command);
    return text;
}

inline nlohmann::json probe(const std::filesystem::path& film) {
    return nlohmann::json::parse(
        output_of("ffprobe -v error -of json -show_format -show_streams -show_packets "
                  "-show_entries frame=pict_type,key_frame " +
                  film.string()));
}

inline constexpr int patch = 32, bits = 8;
inline constexpr std::array<std::uint32_t, 8> colors = {0xffff0000u, 0xff00ff00u, 0xff0000ffu,
                                                        0xffffffffu, 0xff000000u, 0xff808080u,
                                                        0xffe69f00u, 0xff0072b2u};

struct Frame {
    int width, height;
    std::vector<std::uint32_t> pixels;
    Canvas canvas() const {
        Canvas drawn({width, height});
        const PixelView view = drawn.pixels();
        for (int y = 0; y < height; ++y)
            std::copy_n(pixels.begin() + y * width, width,
                        view.data + std::ptrdiff_t{y} * view.stride);
        drawn.pixels_changed();
        return drawn;
    }
    void square(int left, int top, int size, std::uint32_t color) {
        for (int y = top; y < top + size; ++y)
            std::fill_n(pixels.begin() + y * width + left, size, color);
    }
};

// A frame with flat patches of known colours, the frame number in binary as black and white squares
// below them, and a moving square.
inline Frame numbered_frame(const VideoSettings& settings, int number) {
    Frame frame{settings.width, settings.height, {}};
    frame.pixels.assign(std::size_t(settings.width * settings.height), 0xff181818u);
    for (int k = 0; k < int(colors.size()); ++k)
        frame.square(k * patch, 0, patch, colors[std::size_t(k)]);
    for (int k = 0; k < bits; ++k)
        frame.square(k * patch, patch, patch, (number >> k) & 1 ? 0xffffffffu : 0xff000000u);
    frame.square((5 * number) % (settings.width - patch), 2 * patch + number % 20, patch / 2,
                 0xffffd166u);
    return frame;
}

inline VideoSettings small_film(Quality quality = Quality::standard) {
    VideoSettings settings;
    settings.width = 320;
    settings.height = 180;
    settings.quality = quality;
    return settings;
}

inline std::unique_ptr<FilmSegment> encode(FilmWriter& writer, const VideoSettings& settings,
                                           int first, int count) {
    std::unique_ptr<FilmSegment> segment = writer.segment(first);
    for (int i = first; i < first + count; ++i) segment->add(numbered_frame(settings, i).canvas());
    segment->finish();
    return segment;
}

inline const std::vector<int> lengths = {7, 20, 13, 1, 2};
inline constexpr int total = 43;

// Writes a film, whose format follows from the extension of `path`. Its segments are encoded one
// after the other or, with `in_threads`, each on its own thread, all at once and the last segment
// started first.
inline void write_film(const std::filesystem::path& path, const VideoSettings& settings,
                       bool in_threads = false, const std::vector<std::uint32_t>& palette = {}) {
    const std::unique_ptr<FilmWriter> writer = film_writer(path, settings, total);
    if (!palette.empty()) writer->use_colors(palette);
    std::vector<std::unique_ptr<FilmSegment>> segments(lengths.size());
    std::vector<std::thread> threads;
    for (std::size_t k = lengths.size(); k-- > 0;) {
        const int first = std::accumulate(lengths.begin(), lengths.begin() + long(k), 0);
        threads.emplace_back([&writer, &segments, &settings, first, k] {
            segments[k] = encode(*writer, settings, first, lengths[k]);
        });
        if (!in_threads) threads.back().join();
    }
    if (in_threads)
        for (std::thread& thread : threads) thread.join();
    for (const auto& segment : segments) segment->join();
    writer->commit();
    if (!std::filesystem::is_directory(path))
        CHECK(writer->bytes() == std::int64_t(std::filesystem::file_size(path)));
}

// Writes frames of noise, which do not compress: the file outgrows every buffer long before its
// end.
inline void write_noise(const std::filesystem::path& path, const VideoSettings& settings,
                        int count) {
    const std::unique_ptr<FilmWriter> writer = film_writer(path, settings, count);
    const std::unique_ptr<FilmSegment> segment = writer->segment(0);
    Random random(1, "noise");
    for (int i = 0; i < count; ++i) {
        Frame frame = numbered_frame(settings, i);
        for (std::uint32_t& pixel : frame.pixels)
            pixel = 0xff000000u | static_cast<std::uint32_t>(random.below(1 << 24));
        segment->add(frame.canvas());
    }
    segment->finish();
    segment->join();
    writer->commit();
}

inline std::string failure_of(const std::filesystem::path& path, const VideoSettings& settings,
                              int frames) {
    try {
        write_noise(path, settings, frames);
    } catch (const SystemError& error) {
        return error.what();
    }
    return "";
}

// `least`: a lower bound on the size of the film in bytes, several times the size of the buffers.
inline void check_failing_writes(const std::filesystem::path& path, const VideoSettings& settings,
                                 rlim_t least) {
    REQUIRE(failure_of(path, settings, 40) == "");
    const auto size = static_cast<rlim_t>(std::filesystem::file_size(path));
    REQUIRE(size > least);
    std::ofstream(path) << "earlier";
    for (const rlim_t limit : {rlim_t{1}, size / 2, size - 2000, size - 1}) {
        CAPTURE(limit);
        std::string message;
        {
            const FileSizeLimit limited(limit);
            message = failure_of(path, settings, 40);
        }
        CHECK(message == "cannot write " + path.string() + ": File too large");
        CHECK(contents(path) == "earlier");
    }
}

}  // namespace carom::test

// Sound in films: how it is written, whatever the pieces in which it comes.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "sound/rate.h"
#include "support/numbered_film.h"

using namespace carom;
using namespace carom::test;

namespace {

VideoSettings with_sound() {
    VideoSettings settings = small_film(Quality::draft);
    settings.has_sound = true;
    return settings;
}

// A tone of 1 kHz.
std::vector<std::int16_t> tone(std::size_t count) {
    std::vector<std::int16_t> samples(count);
    for (std::size_t n = 0; n < count; ++n)
        samples[n] = static_cast<std::int16_t>(
            std::lround(8000.0 * std::sin(2.0 * std::numbers::pi * double(n) / 48.0)));
    return samples;
}

// In pieces of so many samples; what is before each segment comes before it is joined.
void write_with_sound(const std::filesystem::path& path, std::size_t piece, std::size_t count) {
    const VideoSettings settings = with_sound();
    const std::unique_ptr<FilmWriter> writer = film_writer(path, settings, total);
    const std::vector<std::int16_t> samples = tone(count);
    for (std::size_t n = 0; n < count; n += piece)
        writer->add_sound(std::int64_t(n),
                          std::span(samples).subspan(n, std::min(piece, count - n)));
    int first = 0;
    for (const int length : lengths) {
        encode(*writer, settings, first, length)->join();
        first += length;
    }
    writer->commit();
    CHECK(writer->bytes() == std::int64_t(std::filesystem::file_size(path)));
}

}  // namespace

TEST_CASE("the sound of a film does not depend on the pieces in which it comes") {
    const FilmFolder folder;
    const auto all = static_cast<std::size_t>(samples_before(total, 30));
    for (const std::filesystem::path& path : {folder.film(), folder.webm()}) {
        CAPTURE(path.string());
        write_with_sound(path, all, all);
        const std::string whole = contents(path);
        for (const std::size_t piece : {std::size_t{7}, std::size_t{1024}, std::size_t{5000}}) {
            write_with_sound(path, piece, all);
            CHECK((contents(path) == whole));
        }
        // What is missing at the end is silence.
        write_with_sound(path, all, all / 2);
        const nlohmann::json streams = probe(path)["streams"];
        REQUIRE(streams.size() == 2);
        CHECK(streams[1]["codec_type"] == "audio");
        CHECK(streams[1]["sample_rate"] == "48000");
        CHECK(streams[1]["channels"] == 1);
        // Opus has 6.5 ms before its first sample, which a decoder drops. FFprobe counts them in
        // the start; from version 9 on it does not.
        CHECK(std::stod(streams[0]["start_time"].get<std::string>()) == 0.0);
        const double start = std::stod(streams[1]["start_time"].get<std::string>());
        CHECK((path == folder.film() ? start == 0.0 : start >= -0.007 && start <= 0.0));
    }
}

TEST_CASE("packets of sound lie among those of the pictures that they belong to") {
    const FilmFolder folder;
    const auto all = static_cast<std::size_t>(samples_before(total, 30));
    for (const std::filesystem::path& path : {folder.film(), folder.webm()}) {
        CAPTURE(path.string());
        write_with_sound(path, all, all);
        const nlohmann::json packets = nlohmann::json::parse(
            output_of("ffprobe -v error -of json -show_entries packet=stream_index,dts_time,pos " +
                      path.string()))["packets"];
        std::vector<std::pair<long, double>> places[2];
        for (const nlohmann::json& one : packets)
            places[one["stream_index"].get<int>()].emplace_back(
                std::stol(one["pos"].get<std::string>()),
                std::stod(one["dts_time"].get<std::string>()));
        CHECK(places[0].size() == total);
        CHECK(places[1].size() >= 60);
        for (const auto& [place, time] : places[0])
            for (const auto& [other, its_time] : places[1])
                if (its_time < time - 0.05) CHECK(other < place);
    }
}

TEST_CASE("a format without sound refuses it") {
    const FilmFolder folder;
    for (const std::string name : {"film.gif", "frames/", "film.pdf"})
        CHECK_THROWS_AS(film_writer(folder.path() / name, small_film(), 10)->add_sound(0, {}),
                        std::logic_error);
    CHECK_THROWS_AS(film_writer(folder.film(), small_film(), 10)->add_sound(0, {}),
                    std::logic_error);
}

// Checks the metadata that every film of carom has according to ffprobe, independent of its codec.
#pragma once

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace carom::test {

/// Checks the only stream of a film: television colours and a constant frame rate.
inline void check_film_tags(const nlohmann::json& found, int frames_per_second) {
    REQUIRE(found["streams"].size() == 1);
    const nlohmann::json& stream = found["streams"][0];
    CHECK(stream["pix_fmt"] == "yuv420p");
    CHECK(stream["color_range"] == "tv");
    CHECK(stream["color_space"] == "bt709");
    CHECK(stream["color_transfer"] == "bt709");
    CHECK(stream["color_primaries"] == "bt709");
    CHECK(stream["chroma_location"] == "left");
    const std::string rate = std::to_string(frames_per_second) + "/1";
    CHECK(stream["r_frame_rate"] == rate);
    CHECK(stream["avg_frame_rate"] == rate);
}

}  // namespace carom::test

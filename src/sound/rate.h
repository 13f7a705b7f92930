// How sound is sampled.
#pragma once

#include <cstdint>

namespace carom {

inline constexpr int sound_rate = 48'000;  ///< samples in a second, of one channel

/// How many samples lie before a frame of a film, counted from its first one.
constexpr std::int64_t samples_before(std::int64_t frame, int frames_per_second) {
    return frame * sound_rate / frames_per_second;
}

}  // namespace carom

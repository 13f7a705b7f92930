// The sampling rate of sound.
#pragma once

#include <cstdint>

namespace carom {

inline constexpr int sound_rate = 48'000;  ///< samples per second, one channel

/// The number of samples before a frame of a film, counted from its first frame.
constexpr std::int64_t samples_before(std::int64_t frame, int frames_per_second) {
    return frame * sound_rate / frames_per_second;
}

}  // namespace carom

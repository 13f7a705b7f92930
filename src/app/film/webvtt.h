// Timed words as WebVTT (W3C, https://www.w3.org/TR/webvtt1/).
#pragma once

#include <string>
#include <vector>

namespace carom {

/// Words from `start` to `end`, seconds; lines are kept.
struct Cue {
    double start = 0.0, end = 0.0;
    std::string words;
};

/// A whole file. Cues without words or without length are left out.
std::string webvtt(const std::vector<Cue>& cues);

}  // namespace carom

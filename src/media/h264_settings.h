// What each quality means to x264. Chosen by measurement: see docs/encoding.md.
#pragma once

#include "media/video_writer.h"

namespace carom {

/// Settings in x264's own words.
struct H264Settings {
    const char* preset;
    const char* parameters;  ///< in place of the preset's: `key=value:key=value`
};

/// The settings of a quality, without those that every film shares (threads, colour tags, groups).
H264Settings h264_settings(Quality quality);

/// What every film shares, beside the length of its groups of pictures: nothing that depends on the
/// number of cores or on the instruction set may change a byte.
inline constexpr const char* shared_h264_parameters =
    "threads=1:lookahead-threads=1:cpu-independent=1:open-gop=0:scenecut=0";

}  // namespace carom

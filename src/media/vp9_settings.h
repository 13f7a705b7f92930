// What each quality means to libvpx. Chosen by measurement: see docs/encoding.md.
#pragma once

#include "media/video_writer.h"

namespace carom {

/// Settings in libvpx's own words.
struct Vp9Settings {
    const char* deadline;
    const char* cpu_used;
    const char* crf;
};

Vp9Settings vp9_settings(Quality quality);

}  // namespace carom

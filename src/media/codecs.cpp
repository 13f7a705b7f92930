#include "media/codecs.h"

#include <fmt/format.h>

#include <cassert>

namespace carom {
namespace {

// A segment is one group of pictures, however long.
CodecOptions h264_options(Quality quality) {
    const H264Settings chosen = h264_settings(quality);
    return {{"preset", chosen.preset},
            {"profile", "high"},
            {"x264-params",
             fmt::format("{}:keyint=infinite:{}", chosen.parameters, shared_h264_parameters)}};
}

// A constant quality, for the reasons that H.264 has a constant quantiser, and about the same
// likeness. The realtime modes cost two to three times what x264 does; the other is only for the
// final film. Without look-ahead and hidden reference frames every packet is a frame that is shown.
CodecOptions vp9_options(Quality quality) {
    const bool is_final = quality == Quality::final_, is_draft = quality == Quality::draft;
    return {{"deadline", is_final ? "good" : "realtime"},
            {"cpu-used", is_final   ? "3"
                         : is_draft ? "8"
                                    : "5"},
            {"crf", is_final   ? "20"
                    : is_draft ? "32"
                               : "24"},
            {"lag-in-frames", "0"},
            {"auto-alt-ref", "0"},
            {"row-mt", "0"},
            {"aq-mode", "0"}};
}

}  // namespace

const Codec h264{"libx264", "mp4", {"movflags", "faststart"}, false, h264_options};
const Codec vp9{"libvpx-vp9", "webm", {"cues_to_front", "1"}, true, vp9_options};

H264Settings h264_settings(Quality quality) {
    // A constant quantiser: a gas film is alike from end to end, so that rate control would only
    // measure every frame once more, and give crowded films less quality than empty ones. Plain P
    // frames without look-ahead cost a third less time than B frames, and a third of the memory.
    switch (quality) {
        case Quality::draft:
            return {"ultrafast", "qp=25:8x8dct=1"};  // a film is High, which means 8x8 blocks
        case Quality::standard:
            return {"veryfast", "qp=24:bframes=0:weightp=0:rc-lookahead=0"};
        case Quality::final_:
            return {"medium",
                    "qp=20:bframes=2:b-pyramid=none:weightp=0:rc-lookahead=3:ref=2:subme=7:"
                    "psy-rd=0.4,0:deblock=1,1"};
    }
    assert(false);
    return {};
}

}  // namespace carom

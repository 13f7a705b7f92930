#include "media/codecs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace carom {
namespace {

const char* of(Quality quality, const char* draft, const char* standard, const char* final_) {
    if (quality == Quality::draft) return draft;
    return quality == Quality::final_ ? final_ : standard;
}

// The motion search. The diamond pattern finds motions of a few pixels, the uneven hexagon those of
// many. Blocks of 8 x 8 in B frames help with many edges side by side, a second reference frame
// with what another disk had covered.
const char* standard_search(Motion motion) {
    if (motion == Motion::fast) return ":ref=2:me=umh:analyse=i8x8,i4x4,p8x8";
    return motion == Motion::sparse ? ":ref=1:me=dia:analyse=i8x8,i4x4,p8x8" : ":ref=2:me=dia";
}

// A constant quantiser: a gas film is alike from end to end, so that rate control would only
// measure every frame once more, and give crowded films less quality than empty ones. What stands
// still is copied from the key frame, so that a fine key frame (ipratio) pays for the whole
// segment; what moves is shown in a B frame only for a moment, and a coarse one (pbratio) is not
// noticed. Every fourth frame is a P frame, without look-ahead (b-adapt). A segment is one group of
// pictures, however long.
CodecOptions h264_options(Quality quality, Motion motion) {
    const char* const parameters =
        of(quality, "qp=25:8x8dct=1",  // a film is High, which means 8x8 blocks
           "qp=23:ipratio=2.5:pbratio=2:bframes=3:b-adapt=0:b-pyramid=strict:weightp=0:"
           "rc-lookahead=0:subme=1:direct=temporal:chroma-qp-offset=1:deblock=3,3",
           "qp=19:ipratio=2.5:pbratio=1.8:bframes=3:b-adapt=0:b-pyramid=strict:weightp=0:"
           "rc-lookahead=0:ref=3:subme=6:me=umh:direct=temporal:psy=0:deblock=1,1");
    const char* const search = quality == Quality::standard ? standard_search(motion) : "";
    return {{"preset", of(quality, "ultrafast", "veryfast", "medium")},
            {"profile", "high"},
            {"x264-params",
             fmt::format("{}{}:keyint=infinite:{}", parameters, search, shared_h264_parameters)}};
}

// A constant quality, for the same reasons as the constant quantiser of H.264, and with about the
// same fidelity. The realtime modes cost two to three times as much as x264; the "good" mode is
// only for the final film. Without look-ahead and hidden reference frames every packet is a frame
// that is shown.
CodecOptions vp9_options(Quality quality, Motion /*motion*/) {
    return {{"deadline", of(quality, "realtime", "realtime", "good")},
            {"cpu-used", of(quality, "8", "5", "3")},
            {"crf", of(quality, "32", "24", "20")},
            {"lag-in-frames", "0"},
            {"auto-alt-ref", "0"},
            {"row-mt", "0"},
            {"aq-mode", "0"}};
}

// MaxFS and MaxMBPS of table A-1. Levels 1b, 2 and 4.1 have those of the level before them. Levels
// from 6 on came in 2016, and decoders in hardware end at 5.2, as do those of operating systems.
constexpr std::array<H264Level, 17> levels{{{"1", 99, 1'485, true},
                                            {"1.1", 396, 3'000, true},
                                            {"1.2", 396, 6'000, true},
                                            {"1.3", 396, 11'880, true},
                                            {"2.1", 792, 19'800, true},
                                            {"2.2", 1'620, 20'250, true},
                                            {"3", 1'620, 40'500, true},
                                            {"3.1", 3'600, 108'000, true},
                                            {"3.2", 5'120, 216'000, true},
                                            {"4", 8'192, 245'760, true},
                                            {"4.2", 8'704, 522'240, true},
                                            {"5", 22'080, 589'824, true},
                                            {"5.1", 36'864, 983'040, true},
                                            {"5.2", 36'864, 2'073'600, true},
                                            {"6", 139'264, 4'177'920, false},
                                            {"6.1", 139'264, 8'355'840, false},
                                            {"6.2", 139'264, 16'711'680, false}}};

std::int64_t blocks_along(int pixels) { return (pixels + 15) / 16; }

}  // namespace

const Codec h264{"libx264", "mp4", {"movflags", "faststart"}, false, h264_options, {"aac", 96'000}};
const Codec vp9{"libvpx-vp9", "webm",      {"cues_to_front", "1"},
                true,         vp9_options, {"libopus", 64'000}};

std::optional<H264Level> h264_level(int width, int height, int fps) {
    const std::int64_t across = blocks_along(width), down = blocks_along(height);
    const std::int64_t longer = std::max(across, down), blocks = across * down;
    const auto allows = [&](const H264Level& level) {
        return blocks <= level.most_blocks && longer * longer <= 8 * level.most_blocks &&
               blocks * fps <= level.most_blocks_in_a_second;
    };
    const auto found = std::ranges::find_if(levels, allows);
    if (found == levels.end()) return std::nullopt;
    return *found;
}

}  // namespace carom

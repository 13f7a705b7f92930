// The codecs of video films, and the encoder settings for each quality. Chosen by measurement: see
// docs/encoding.md.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "media/film_writer.h"

namespace carom {

/// Encoder options (name, value), with libav's names.
using CodecOptions = std::vector<std::pair<const char*, std::string>>;

/// How the sound of a film is encoded.
struct SoundCodec {
    const char* encoder;  ///< libav's name of it
    int bits_per_second;
};

struct Codec {
    const char* encoder;                              ///< libav's name of it
    const char* container;                            ///< libav's name of the file format
    std::pair<const char*, const char*> index_first;  ///< its option (name, value) for this
    bool keeps_all_metadata;                          ///< whether metadata of any name are stored
    CodecOptions (*encoder_options)(Quality, Motion);
    SoundCodec sound;
};

extern const Codec h264;  ///< and AAC, in MP4
extern const Codec vp9;   ///< and Opus, in WebM

/// Settings shared by all films, except the length of their groups of pictures: the number of cores
/// and the instruction set must not change a single byte of the result.
inline constexpr const char* shared_h264_parameters =
    "threads=1:lookahead-threads=1:cpu-independent=1:open-gop=0:scenecut=0";

/// The level of an H.264 film, which says how large and how fast its frames are, and from which
/// players decide whether they can decode it.
struct H264Level {
    const char* name;             ///< "4.2"
    int most_blocks;              ///< of 16 by 16 pixels, in a frame
    int most_blocks_in_a_second;  ///< of all frames
    bool is_common;               ///< whether most players have it
};

/// The lowest level (ITU-T H.264, table A-1) that allows films of this size and frame rate; none:
/// no level does. The other limits of a level, of bits in a second and of reference frames, do not
/// count: carom's films stay below them.
std::optional<H264Level> h264_level(int width, int height, int fps);

}  // namespace carom

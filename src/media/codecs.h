// The codecs of films that are video, and what each quality means to their encoders. Chosen by
// measurement: see docs/encoding.md.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "media/film_writer.h"

namespace carom {

/// Options by libav's names.
using CodecOptions = std::vector<std::pair<const char*, std::string>>;

/// How the sound of a film is encoded.
struct SoundCodec {
    const char* encoder;  ///< libav's name of it
    int bits_per_second;
};

struct Codec {
    const char* encoder;                              ///< libav's name of it
    const char* container;                            ///< libav's name of the file format
    std::pair<const char*, const char*> index_first;  ///< its option for that
    bool keeps_all_metadata;                          ///< texts by any name
    CodecOptions (*encoder_options)(Quality, Motion);
    SoundCodec sound;
};

extern const Codec h264;  ///< and AAC, in MP4
extern const Codec vp9;   ///< and Opus, in WebM

/// What every film shares, beside the length of its groups of pictures: nothing that depends on the
/// number of cores or on the instruction set may change a byte.
inline constexpr const char* shared_h264_parameters =
    "threads=1:lookahead-threads=1:cpu-independent=1:open-gop=0:scenecut=0";

}  // namespace carom

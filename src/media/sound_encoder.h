// Encodes sound as packets of AAC or Opus while its samples arrive. One channel, sound_rate samples
// per second (sound/rate.h). The packets depend on the samples alone, not on how they are divided
// among calls.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "media/codecs.h"
#include "media/libav.h"

namespace carom {

class SoundEncoder {
  public:
    /// All functions throw SystemError if the encoder fails; the constructor also if there is no
    /// such encoder.
    explicit SoundEncoder(const SoundCodec& codec);

    void add(std::span<const std::int16_t> samples);
    void fill(std::int64_t end);  ///< with silence, up to sample number `end`
    void finish();                ///< after the last sample

    /// The next packet, if it begins at or before sample number `end`; null if there is none yet.
    /// Its time stamps count samples.
    libav::Owned<AVPacket> next(std::int64_t end);

    const AVCodecParameters& parameters() const { return *parameters_; }

  private:
    void encode(const AVFrame* frame);
    void encode_waiting();

    const char* name_;
    libav::Owned<AVCodecContext> context_;
    libav::Owned<AVCodecParameters> parameters_;
    std::vector<std::int16_t> waiting_;  ///< samples that do not yet fill a frame of the encoder
    std::int64_t encoded_ = 0;           ///< number of encoded samples
    std::deque<libav::Owned<AVPacket>> packets_;
};

}  // namespace carom

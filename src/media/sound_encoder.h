// Sound as packets of AAC or Opus, encoded as its samples come. One channel, sound_rate samples a
// second (sound/rate.h). The packets depend on the samples alone, not on how they are divided.
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
    /// All throw SystemError where the encoder fails, or there is none.
    explicit SoundEncoder(const SoundCodec& codec);

    void add(std::span<const std::int16_t> samples);
    void fill(std::int64_t end);  ///< with silence, up to sample number `end`
    void finish();                ///< after the last sample

    /// The next packet, if it begins at sample number `end` or before; null if there is none yet.
    /// Its times count samples.
    libav::Owned<AVPacket> next(std::int64_t end);

    const AVCodecParameters& parameters() const { return *parameters_; }

  private:
    void encode(const AVFrame* frame);
    void encode_waiting();

    const char* name_;
    libav::Owned<AVCodecContext> context_;
    libav::Owned<AVCodecParameters> parameters_;
    std::vector<std::int16_t> waiting_;  ///< less than a frame of the encoder
    std::int64_t encoded_ = 0;           ///< samples
    std::deque<libav::Owned<AVPacket>> packets_;
};

}  // namespace carom

#include "media/sound_encoder.h"

#include <algorithm>
#include <utility>

#include "sound/rate.h"

namespace carom {

using libav::Owned, libav::owned, libav::api;

SoundEncoder::SoundEncoder(const SoundCodec& codec)
    : name_(codec.encoder), context_(libav::encoder(codec.encoder)) {
    AVCodecContext& context = *context_;
    // With one channel, planar and interleaved samples are the same.
    context.sample_fmt =
        context.codec_id == AV_CODEC_ID_AAC ? AV_SAMPLE_FMT_FLTP : AV_SAMPLE_FMT_FLT;
    context.sample_rate = sound_rate;
    context.time_base = {1, sound_rate};
    context.ch_layout = AV_CHANNEL_LAYOUT_MONO;
    context.bit_rate = codec.bits_per_second;
    context.thread_count = 1;
    context.flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
    // The encoder chooses its functions when it is opened: without CPU flags it takes the plain
    // ones, which round alike on every machine.
    constexpr int plain = 0, all_there_are = -1;
    api().av_force_cpu_flags(plain);
    const int result = api().avcodec_open2(&context, nullptr, nullptr);
    api().av_force_cpu_flags(all_there_are);
    libav::check_encoder(name_, result);
    parameters_ = owned(api().avcodec_parameters_alloc());
    libav::check_encoder(name_, api().avcodec_parameters_from_context(parameters_.get(), &context));
}

void SoundEncoder::add(std::span<const std::int16_t> samples) {
    const auto size = static_cast<std::size_t>(context_->frame_size);
    while (!samples.empty()) {
        const std::size_t count = std::min(size - waiting_.size(), samples.size());
        waiting_.insert(waiting_.end(), samples.begin(),
                        samples.begin() + static_cast<std::ptrdiff_t>(count));
        samples = samples.subspan(count);
        if (waiting_.size() == size) encode_waiting();
    }
}

void SoundEncoder::fill(std::int64_t end) {
    const std::vector<std::int16_t> silence(static_cast<std::size_t>(context_->frame_size));
    while (true) {
        const std::int64_t missing = end - encoded_ - static_cast<std::int64_t>(waiting_.size());
        if (missing <= 0) return;
        add(std::span(silence).first(std::min(silence.size(), static_cast<std::size_t>(missing))));
    }
}

void SoundEncoder::finish() {
    if (!waiting_.empty()) encode_waiting();
    encode(nullptr);
}

Owned<AVPacket> SoundEncoder::next(std::int64_t end) {
    if (packets_.empty() || packets_.front()->pts > end) return nullptr;
    Owned<AVPacket> packet = std::move(packets_.front());
    packets_.pop_front();
    return packet;
}

void SoundEncoder::encode_waiting() {
    Owned<AVFrame> frame = owned(api().av_frame_alloc());
    frame->format = context_->sample_fmt;
    frame->sample_rate = sound_rate;
    frame->ch_layout = AV_CHANNEL_LAYOUT_MONO;
    frame->nb_samples = static_cast<int>(waiting_.size());
    frame->pts = encoded_;
    libav::check_encoder(name_, api().av_frame_get_buffer(frame.get(), 0));
    auto* const values = reinterpret_cast<float*>(frame->data[0]);
    constexpr float full_scale = 32768.0F;
    std::ranges::transform(waiting_, values, [](std::int16_t one) { return one / full_scale; });
    encode(frame.get());
    encoded_ += frame->nb_samples;
    waiting_.clear();
}

// Null flushes the frames that the encoder still holds.
void SoundEncoder::encode(const AVFrame* frame) {
    libav::check_encoder(name_, api().avcodec_send_frame(context_.get(), frame));
    while (true) {
        Owned<AVPacket> packet = owned(api().av_packet_alloc());
        const int result = api().avcodec_receive_packet(context_.get(), packet.get());
        if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
        libav::check_encoder(name_, result);
        packets_.push_back(std::move(packet));
    }
}

}  // namespace carom

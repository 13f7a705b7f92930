#include "media/gif_encoder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <span>

#include "media/libav.h"
#include "util/diagnostics.h"

namespace carom {

using libav::Owned, libav::owned;

namespace {

constexpr const char* encoder_name = "gif";

void check(int result) { libav::check_encoder(encoder_name, result); }

// The encoder begins its first packet with the header of a file and the colours, which the film's
// file has already.
std::size_t header_bytes(std::span<const std::uint8_t> packet) {
    constexpr std::size_t screen = 13, flags_at = 10;
    if (packet.size() < screen || packet[0] != 'G') return 0;
    const std::uint8_t flags = packet[flags_at];
    return screen + ((flags & 0x80) != 0 ? 3u * (2u << (flags & 7)) : 0u);
}

GifImage image_of(std::span<const std::uint8_t> packet) {
    const std::span<const std::uint8_t> image = packet.subspan(header_bytes(packet));
    constexpr std::array<std::uint8_t, 3> control = {0x21, 0xf9, 0x04};
    if (image.size() < 8 || !std::equal(control.begin(), control.end(), image.begin()))
        throw SystemError("cannot encode with gif: this libavcodec writes another kind of packet");
    return {image.begin(), image.end()};
}

}  // namespace

struct GifEncoder::Implementation {
    Implementation(const GifPalette& colors) : palette(colors), finder(colors) {}

    GifPalette palette;
    ColorFinder finder;
    Owned<AVCodecContext> context;
    Owned<AVFrame> frame;
    Owned<AVPacket> packet = owned(av_packet_alloc());
};

GifEncoder::GifEncoder(int width, int height, const GifPalette& palette)
    : implementation_(std::make_unique<Implementation>(palette)) {
    libav::listen();
    Implementation& own = *implementation_;
    own.context = libav::encoder(encoder_name);
    own.context->width = width;
    own.context->height = height;
    own.context->pix_fmt = AV_PIX_FMT_PAL8;
    own.context->time_base = {1, 100};
    own.context->thread_count = 1;
    check(avcodec_open2(own.context.get(), nullptr, nullptr));
    own.frame = owned(av_frame_alloc());
    own.frame->format = AV_PIX_FMT_PAL8;
    own.frame->width = width;
    own.frame->height = height;
    own.frame->pts = 0;
    check(av_frame_get_buffer(own.frame.get(), 0));
}

GifEncoder::~GifEncoder() = default;

GifImage GifEncoder::add(const PixelView& frame) {
    Implementation& own = *implementation_;
    AVFrame& indices = *own.frame;
    assert(frame.width == indices.width && frame.height == indices.height);
    check(av_frame_make_writable(&indices));  // the encoder keeps the one before
    for (int y = 0; y < frame.height; ++y)
        own.finder.find(frame.data + std::ptrdiff_t{y} * frame.stride,
                        indices.data[0] + std::ptrdiff_t{y} * indices.linesize[0], frame.width);
    std::memcpy(indices.data[1], own.palette.data(), sizeof own.palette);
    check(avcodec_send_frame(own.context.get(), &indices));
    ++indices.pts;
    check(avcodec_receive_packet(own.context.get(), own.packet.get()));
    GifImage image = image_of({own.packet->data, static_cast<std::size_t>(own.packet->size)});
    av_packet_unref(own.packet.get());
    return image;
}

}  // namespace carom

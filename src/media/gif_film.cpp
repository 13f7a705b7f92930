#include "media/gif_film.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "media/film_file.h"
#include "media/gif_palette.h"
#include "media/libav.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/files/spool.h"

namespace carom {

using libav::Owned, libav::owned, libav::api;

namespace {

constexpr const char* encoder_name = "gif";

// Offset of the delay in an image: little-endian, in hundredths of a second.
constexpr std::size_t delay_at = 4;

using Bytes = std::vector<std::uint8_t>;

void put_number(Bytes& bytes, int number) {
    bytes.push_back(static_cast<std::uint8_t>(number & 255));
    bytes.push_back(static_cast<std::uint8_t>(number >> 8));
}

void put_text(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

// Appends text in blocks of at most 255 bytes, each preceded by its length, ended by a block of
// length 0.
void put_blocks(Bytes& bytes, std::string_view text) {
    constexpr std::size_t longest = 255;
    for (; !text.empty(); text.remove_prefix(std::min(longest, text.size()))) {
        const std::string_view block = text.substr(0, longest);
        bytes.push_back(static_cast<std::uint8_t>(block.size()));
        put_text(bytes, block);
    }
    bytes.push_back(0);
}

void put_screen(Bytes& bytes, int width, int height) {
    constexpr std::uint8_t table_of_256 = 0x80 | 0x70 | 0x07;
    put_text(bytes, "GIF89a");
    put_number(bytes, width);
    put_number(bytes, height);
    bytes.insert(bytes.end(), {table_of_256, gif_colors, 0});
}

void put_palette(Bytes& bytes, const GifPalette& palette) {
    for (const std::uint32_t color : palette)
        for (const int shift : {16, 8, 0})
            bytes.push_back(static_cast<std::uint8_t>(color >> shift));
}

void put_endless_loop(Bytes& bytes) {
    bytes.insert(bytes.end(), {0x21, 0xff, 11});
    put_text(bytes, "NETSCAPE2.0");
    put_blocks(bytes, std::string_view("\x01\0\0", 3));
}

void put_comment(Bytes& bytes, const VideoSettings& settings) {
    std::string text;
    for (const auto& [key, value] : settings.metadata) {
        if (value.empty()) continue;
        text += (text.empty() ? "" : "\n\n") + key + ": " + value;
    }
    if (text.empty()) return;
    bytes.insert(bytes.end(), {0x21, 0xfe});
    put_blocks(bytes, text);
}

// The number of bytes at the start of the encoder's first packet that hold a file header and the
// colours, which the file of the film has already.
std::size_t header_bytes(std::span<const std::uint8_t> packet) {
    constexpr std::size_t screen = 13, flags_at = 10;
    if (packet.size() < screen || packet[0] != 'G') return 0;
    const std::uint8_t flags = packet[flags_at];
    return screen + ((flags & 0x80) != 0 ? 3u * (2u << (flags & 7)) : 0u);
}

// A graphic control extension and an image of GIF89a, without a colour table of its own.
std::string image_of(std::span<const std::uint8_t> packet) {
    const std::span<const std::uint8_t> image = packet.subspan(header_bytes(packet));
    constexpr std::array<std::uint8_t, 3> control = {0x21, 0xf9, 0x04};
    if (image.size() < 8 || !std::equal(control.begin(), control.end(), image.begin()))
        throw SystemError("cannot encode with gif: this libavcodec writes another kind of packet");
    return {image.begin(), image.end()};
}

Owned<AVCodecContext> open_encoder(const VideoSettings& settings) {
    Owned<AVCodecContext> context = libav::encoder(encoder_name);
    context->width = settings.width;
    context->height = settings.height;
    context->pix_fmt = AV_PIX_FMT_PAL8;
    context->time_base = {1, 100};
    context->thread_count = 1;
    libav::check_encoder(encoder_name, api().avcodec_open2(context.get(), nullptr, nullptr));
    return context;
}

class GifFilm : public FilmInFile {
  public:
    GifFilm(const std::filesystem::path& path, VideoSettings settings)
        : FilmInFile(path, std::move(settings)) {
        assert(settings_.fps <= most_gif_frames_per_second);
    }

    void use_colors(const std::vector<std::uint32_t>& colors) override {
        std::ranges::copy(colors, palette_.begin());
        Bytes start;
        put_screen(start, settings_.width, settings_.height);
        put_palette(start, palette_);
        put_endless_loop(start);
        put_comment(start, settings_);
        file_.write(start);
    }

    // After use_colors(): segments share the palette.
    std::unique_ptr<FilmSegment> segment(int) override { return std::make_unique<Segment>(*this); }

  private:
    void write_end() override {
        constexpr std::string_view end = ";";
        file_.write(end);
    }

    // Each frame is stored as the part that differs from the previous frame; the first one is
    // stored whole.
    class Segment : public FilmSegment {
      public:
        explicit Segment(GifFilm& film) : film_(film), finder_(film.palette_) { libav::listen(); }
        void add(const Canvas& canvas) override {
            if (!context_) open();
            convert(canvas.pixels());
            libav::check_encoder(encoder_name,
                                 api().avcodec_send_frame(context_.get(), indices_.get()));
            ++indices_->pts;
            const Owned<AVPacket> packet = owned(api().av_packet_alloc());
            libav::check_encoder(encoder_name,
                                 api().avcodec_receive_packet(context_.get(), packet.get()));
            images_.add(image_of({packet->data, static_cast<std::size_t>(packet->size)}));
        }
        void archive(Archive& archive) override { archive(images_); }
        void join() override {
            for (std::size_t k = 0; k < images_.size(); ++k) film_.write(images_.piece(k));
        }

      private:
        void open() {
            context_ = open_encoder(film_.settings_);
            indices_ = libav::frame(AV_PIX_FMT_PAL8, context_->width, context_->height);
            indices_->pts = 0;
        }
        void convert(const PixelView& frame) {
            assert(frame.width == indices_->width && frame.height == indices_->height);
            // The encoder holds a reference to the previous frame.
            libav::check_encoder(encoder_name, api().av_frame_make_writable(indices_.get()));
            for (int y = 0; y < frame.height; ++y)
                finder_.find(frame.data + std::ptrdiff_t{y} * frame.stride,
                             indices_->data[0] + std::ptrdiff_t{y} * indices_->linesize[0],
                             frame.width);
            std::memcpy(indices_->data[1], film_.palette_.data(), sizeof film_.palette_);
        }

        GifFilm& film_;
        ColorFinder finder_;
        Owned<AVCodecContext> context_;
        Owned<AVFrame> indices_;
        Spool images_{most_encoded_bytes};
    };

    void write(std::string image) {
        const int delay = gif_delay(frames_++, settings_.fps);
        image[delay_at] = static_cast<char>(delay & 255);
        image[delay_at + 1] = static_cast<char>(delay >> 8);
        file_.write(image);
    }

    GifPalette palette_{};
    int frames_ = 0;
};

}  // namespace

int gif_delay(int frame, int fps) {
    const auto shown_until = [fps](std::int64_t frames) {
        return static_cast<int>((200 * frames + fps) / (2 * fps));  // to the nearest
    };
    return shown_until(frame + 1) - shown_until(frame);
}

std::unique_ptr<FilmWriter> gif_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int) {
    return std::make_unique<GifFilm>(path, settings);
}

}  // namespace carom

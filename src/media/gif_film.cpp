#include "media/gif_film.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "media/gif_encoder.h"
#include "media/gif_palette.h"
#include "util/atomic_file.h"

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;

void put_number(Bytes& bytes, int number) {
    bytes.push_back(static_cast<std::uint8_t>(number & 255));
    bytes.push_back(static_cast<std::uint8_t>(number >> 8));
}

void put_text(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

// In blocks of at most 255 bytes, each after its length, ended by one of length 0.
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

class GifFilm : public FilmWriter {
  public:
    GifFilm(const std::filesystem::path& path, VideoSettings settings)
        : settings_(std::move(settings)), file_(path) {
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

    void commit() override {
        constexpr std::string_view end = ";";
        file_.write(end);
        bytes_ = file_.size();
        file_.commit();
    }

    std::int64_t bytes() const override { return bytes_; }

  private:
    class Segment : public FilmSegment {
      public:
        explicit Segment(GifFilm& film)
            : film_(film), encoder_(film.settings_.width, film.settings_.height, film.palette_) {}
        void add(const Canvas& frame) override { images_.push_back(encoder_.add(frame.pixels())); }
        void finish() override {}
        void join() override {
            for (GifImage& image : images_) film_.write(image);
        }

      private:
        GifFilm& film_;
        GifEncoder encoder_;
        std::vector<GifImage> images_;
    };

    void write(GifImage& image) {
        const int delay = gif_delay(frames_++, settings_.fps);
        image[gif_delay_at] = static_cast<std::uint8_t>(delay & 255);
        image[gif_delay_at + 1] = static_cast<std::uint8_t>(delay >> 8);
        file_.write(image);
    }

    VideoSettings settings_;
    AtomicFile file_;
    GifPalette palette_{};
    int frames_ = 0;
    std::int64_t bytes_ = 0;
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

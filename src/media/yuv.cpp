#include "media/yuv.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "util/processors.h"

#define CAROM_SIMD CAROM_FOR_PROCESSORS("arch=x86-64-v4", "arch=x86-64-v3")

namespace carom {
namespace {

constexpr double red_weight = 0.2126, green_weight = 0.7152, blue_weight = 0.0722;

// 23 bits keep the error of a rounded weight below 5e-5 of a luma step, and the sum below 2^31.
constexpr int luma_bits = 23;
// Chroma is a sum of eight pixels: three bits less, and the sum below 2^31 all the same.
constexpr int chroma_bits = 23 - 3;
constexpr int chroma_shift = chroma_bits + 3;

constexpr std::int32_t fixed(double weight, int bits) {
    const double scaled = weight * (1 << bits);
    return static_cast<std::int32_t>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
}

constexpr double luma_range = 219.0 / 255.0, chroma_range = 224.0 / 255.0;
constexpr double cb_scale = chroma_range / (2 * (1 - blue_weight));
constexpr double cr_scale = chroma_range / (2 * (1 - red_weight));

constexpr std::int32_t y_red = fixed(luma_range * red_weight, luma_bits);
constexpr std::int32_t y_green = fixed(luma_range * green_weight, luma_bits);
constexpr std::int32_t y_blue = fixed(luma_range * blue_weight, luma_bits);
// The weights of a chroma row sum to exactly zero, so that greys have none.
constexpr std::int32_t cb_red = fixed(-cb_scale * red_weight, chroma_bits);
constexpr std::int32_t cb_blue = fixed(cb_scale * (1 - blue_weight), chroma_bits);
constexpr std::int32_t cb_green = -cb_red - cb_blue;
constexpr std::int32_t cr_red = fixed(cr_scale * (1 - red_weight), chroma_bits);
constexpr std::int32_t cr_blue = fixed(-cr_scale * blue_weight, chroma_bits);
constexpr std::int32_t cr_green = -cr_red - cr_blue;

constexpr std::int32_t y_offset = (16 << luma_bits) + (1 << (luma_bits - 1));
constexpr std::int32_t chroma_offset = (128 << chroma_shift) + (1 << (chroma_shift - 1));

CAROM_SIMD void luma_row(const std::uint32_t* __restrict pixels, std::uint8_t* __restrict y,
                         int width) {
    for (int i = 0; i < width; ++i) {
        const auto pixel = static_cast<std::int32_t>(pixels[i]);
        const std::int32_t red = (pixel >> 16) & 255, green = (pixel >> 8) & 255,
                           blue = pixel & 255;
        y[i] = static_cast<std::uint8_t>(
            (y_red * red + y_green * green + y_blue * blue + y_offset) >> luma_bits);
    }
}

// Red and blue share a word, 16 bits each: sums of eight bytes fit.
CAROM_SIMD void sum_rows(const std::uint32_t* __restrict above,
                         const std::uint32_t* __restrict below, std::uint32_t* __restrict red_blue,
                         std::uint32_t* __restrict green, int width) {
    for (int i = 0; i < width; ++i) {
        red_blue[i] = (above[i] & 0xff00ffu) + (below[i] & 0xff00ffu);
        green[i] = ((above[i] >> 8) & 255u) + ((below[i] >> 8) & 255u);
    }
}

// `red_blue` and `green` have one more element before them, a copy of the first.
CAROM_SIMD void chroma_row(const std::uint32_t* __restrict red_blue,
                           const std::uint32_t* __restrict green, std::uint8_t* __restrict cb,
                           std::uint8_t* __restrict cr, int chroma_width) {
    for (int i = 0; i < chroma_width; ++i) {
        const std::uint32_t both = red_blue[2 * i - 1] + 2 * red_blue[2 * i] + red_blue[2 * i + 1];
        const auto red = static_cast<std::int32_t>(both >> 16);
        const auto blue = static_cast<std::int32_t>(both & 0xffffu);
        const auto mid =
            static_cast<std::int32_t>(green[2 * i - 1] + 2 * green[2 * i] + green[2 * i + 1]);
        cb[i] = static_cast<std::uint8_t>(
            (cb_red * red + cb_green * mid + cb_blue * blue + chroma_offset) >> chroma_shift);
        cr[i] = static_cast<std::uint8_t>(
            (cr_red * red + cr_green * mid + cr_blue * blue + chroma_offset) >> chroma_shift);
    }
}

std::uint32_t without_alpha(std::uint32_t pixel, std::uint32_t behind) {
    const std::uint32_t alpha = pixel >> 24;
    if (alpha == 255) return pixel;
    if (alpha == 0) return behind;
    std::uint32_t color = 0xff;
    for (const int shift : {16, 8, 0}) {
        const std::uint32_t channel = (pixel >> shift) & 255;
        color = color << 8 | std::min(255u, (channel * 255 + alpha / 2) / alpha);
    }
    return color;
}

// Pairs of rows of a frame, each with its row of chroma.
class RowPairs {
  public:
    RowPairs(const PixelView& frame, const YuvPlanes& planes)
        : frame_(frame),
          planes_(planes),
          // One element to the left for the filter, and one to the right for an odd width.
          padded_(static_cast<std::size_t>(frame.width) + 2),
          sums_(2 * padded_) {}

    int count() const { return even_size(frame_.height) / 2; }

    // Converts the columns [begin, end), both even, of one pair; the filter of chroma sees one more
    // to the left.
    void columns(int pair, int begin, int end) {
        const int row = 2 * pair, last = std::min(end, frame_.width);
        const std::uint32_t* rows[2];
        for (int k = 0; k < 2; ++k) {
            rows[k] =
                frame_.data + std::ptrdiff_t{std::min(row + k, frame_.height - 1)} * frame_.stride;
            std::uint8_t* const y = planes_.y + std::ptrdiff_t{row + k} * planes_.y_stride;
            luma_row(rows[k] + begin, y + begin, last - begin);
            if (last < end) y[last] = y[last - 1];
        }
        std::uint32_t* const red_blue = sums_.data() + 1;
        std::uint32_t* const green = red_blue + padded_;
        const int first = std::max(begin - 1, 0);
        sum_rows(rows[0] + first, rows[1] + first, red_blue + first - begin, green + first - begin,
                 last - first);
        for (std::uint32_t* sum : {red_blue, green}) {
            if (first == begin) sum[-1] = sum[0];
            if (last < end) sum[last - begin] = sum[last - begin - 1];
        }
        const std::ptrdiff_t chroma = std::ptrdiff_t{pair} * planes_.chroma_stride + begin / 2;
        chroma_row(red_blue, green, planes_.cb + chroma, planes_.cr + chroma, (end - begin) / 2);
    }

  private:
    const PixelView& frame_;
    const YuvPlanes& planes_;
    std::size_t padded_;
    std::vector<std::uint32_t> sums_;  ///< of the two rows: red and blue, then green
};

// Which parts of the rows must be converted, in blocks of so many columns.
class ChangedBlocks {
  public:
    ChangedBlocks(const PixelView& frame, std::span<const PixelBounds> changed)
        : in_a_row_((frame.width - 1) / columns + 1),
          is_changed_(static_cast<std::size_t>(in_a_row_) *
                      static_cast<std::size_t>(even_size(frame.height) / 2)) {
        for (const PixelBounds& box : changed) {
            assert(box.left < box.right && box.top < box.bottom);
            // A pixel in an odd column is seen by the chroma of the next one, too.
            const int first = box.left / columns;
            const int end = std::min(box.right / columns + 1, in_a_row_);
            for (int pair = box.top / 2; pair <= (box.bottom - 1) / 2; ++pair)
                std::fill(blocks_of(pair) + first, blocks_of(pair) + end, 1);
        }
    }

    // Calls visit(first column, end) for each run of changed blocks; the last may end beyond the
    // frame.
    template <typename Visit>
    void for_runs_of(int pair, const Visit& visit) {
        const auto begin = blocks_of(pair);
        const auto end = begin + in_a_row_;
        for (auto run = std::find(begin, end, 1); run != end;) {
            const auto behind = std::find(run, end, 0);
            visit(static_cast<int>(run - begin) * columns,
                  static_cast<int>(behind - begin) * columns);
            run = std::find(behind, end, 1);
        }
    }

  private:
    static constexpr int columns = 32;

    std::vector<std::uint8_t>::iterator blocks_of(int pair) {
        return is_changed_.begin() + std::ptrdiff_t{pair} * in_a_row_;
    }

    int in_a_row_;
    std::vector<std::uint8_t> is_changed_;  ///< row after row
};

}  // namespace

void to_yuv420(const PixelView& frame, const YuvPlanes& planes) {
    assert(frame.width > 0 && frame.height > 0);
    RowPairs convert(frame, planes);
    for (int pair = 0; pair < convert.count(); ++pair)
        convert.columns(pair, 0, even_size(frame.width));
}

void to_yuv420(const PixelView& frame, std::span<const PixelBounds> changed,
               const YuvPlanes& planes) {
    RowPairs convert(frame, planes);
    ChangedBlocks blocks(frame, changed);
    for (int pair = 0; pair < convert.count(); ++pair)
        blocks.for_runs_of(pair, [&](int begin, int end) {
            convert.columns(pair, begin, std::min(end, even_size(frame.width)));
        });
}

void to_yuva420(const PixelView& frame, std::uint32_t behind, const YuvPlanes& planes) {
    assert(planes.alpha != nullptr);
    std::vector<std::uint32_t> colors;
    colors.reserve(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
    for (int row = 0; row < even_size(frame.height); ++row) {
        const std::uint32_t* const pixels =
            frame.data + std::ptrdiff_t{std::min(row, frame.height - 1)} * frame.stride;
        std::uint8_t* const alpha = planes.alpha + std::ptrdiff_t{row} * planes.alpha_stride;
        for (int x = 0; x < frame.width; ++x) {
            if (row < frame.height) colors.push_back(without_alpha(pixels[x], behind));
            alpha[x] = static_cast<std::uint8_t>(pixels[x] >> 24);
        }
        if (frame.width % 2 != 0) alpha[frame.width] = alpha[frame.width - 1];
    }
    to_yuv420({colors.data(), frame.width, frame.height, frame.width}, planes);
}

}  // namespace carom

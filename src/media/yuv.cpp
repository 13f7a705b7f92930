#include "media/yuv.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <vector>

#include "util/threads/processors.h"

#define CAROM_SIMD CAROM_FOR_PROCESSORS("arch=x86-64-v4", "arch=x86-64-v3")
#define CAROM_INLINE [[gnu::always_inline]] inline

#pragma GCC diagnostic ignored "-Wpsabi"  // of vectors, which only inlined functions take

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
// The weights of a chroma component sum to exactly zero, so that greys have no chroma.
constexpr std::int32_t cb_red = fixed(-cb_scale * red_weight, chroma_bits);
constexpr std::int32_t cb_blue = fixed(cb_scale * (1 - blue_weight), chroma_bits);
constexpr std::int32_t cb_green = -cb_red - cb_blue;
constexpr std::int32_t cr_red = fixed(cr_scale * (1 - red_weight), chroma_bits);
constexpr std::int32_t cr_blue = fixed(-cr_scale * blue_weight, chroma_bits);
constexpr std::int32_t cr_green = -cr_red - cr_blue;

constexpr std::int32_t y_offset = (16 << luma_bits) + (1 << (luma_bits - 1));
constexpr std::int32_t chroma_offset = (128 << chroma_shift) + (1 << (chroma_shift - 1));

// Eight pixels, or a channel of eight: the compiler has one instruction for all, or several.
using EightWords [[gnu::vector_size(32)]] = std::uint32_t;
using EightNumbers [[gnu::vector_size(32)]] = std::int32_t;
using EightShorts [[gnu::vector_size(16)]] = std::uint16_t;
using SixteenBytes [[gnu::vector_size(16)]] = std::uint8_t;
constexpr int lanes = 8;

// The unit of conversion, in columns.
constexpr int block = 4 * lanes;

constexpr int blocks_in(int columns) { return (columns - 1) / block + 1; }

CAROM_INLINE EightWords load_eight(const std::uint32_t* from) {
    EightWords words;
    std::memcpy(&words, from, sizeof words);
    return words;
}

// Numbers from 0 to 255, as bytes.
CAROM_INLINE void store_sixteen(std::uint8_t* to, const EightNumbers& first,
                                const EightNumbers& second) {
    const auto shorts = __builtin_shufflevector(__builtin_convertvector(first, EightShorts),
                                                __builtin_convertvector(second, EightShorts), 0, 1,
                                                2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const SixteenBytes bytes = __builtin_convertvector(shorts, SixteenBytes);
    std::memcpy(to, &bytes, sizeof bytes);
}

CAROM_INLINE EightNumbers luma(const std::uint32_t* pixels) {
    const auto pixel = reinterpret_cast<EightNumbers>(load_eight(pixels));
    const EightNumbers red = (pixel >> 16) & 255, green = (pixel >> 8) & 255, blue = pixel & 255;
    return (y_red * red + y_green * green + y_blue * blue + y_offset) >> luma_bits;
}

CAROM_INLINE void luma_block(const std::uint32_t* pixels, std::uint8_t* y) {
    for (int i = 0; i < block; i += 2 * lanes)
        store_sixteen(y + i, luma(pixels + i), luma(pixels + i + lanes));
}

// The sums of two rows. Red and blue share a word, 16 bits each: sums of eight bytes fit.
CAROM_INLINE EightWords red_and_blue(const EightWords& above, const EightWords& below) {
    return (above & 0xff00ffu) + (below & 0xff00ffu);
}
CAROM_INLINE EightWords greens(const EightWords& above, const EightWords& below) {
    return ((above >> 8) & 255u) + ((below >> 8) & 255u);
}

// Sums over two rows of pixels: of the odd columns before the even ones, of the even columns, and
// of the odd columns. No constructor, as Clang 19 does not emit it for multi-versioned functions.
struct Columns {
    EightWords before, even, odd;
};

CAROM_INLINE Columns columns_of(const EightWords& first, const EightWords& second,
                                const EightWords& odd_before) {
    const EightWords odd = __builtin_shufflevector(first, second, 1, 3, 5, 7, 9, 11, 13, 15);
    return {__builtin_shufflevector(odd_before, odd, 7, 8, 9, 10, 11, 12, 13, 14),
            __builtin_shufflevector(first, second, 0, 2, 4, 6, 8, 10, 12, 14), odd};
}

CAROM_INLINE EightWords filtered(const Columns& at) { return at.before + 2 * at.even + at.odd; }

CAROM_INLINE void chroma_block(const std::uint32_t* above, const std::uint32_t* below,
                               std::uint8_t* cb, std::uint8_t* cr) {
    const EightWords left_above = EightWords{} + above[-1], left_below = EightWords{} + below[-1];
    EightWords red_blue_before = red_and_blue(left_above, left_below);
    EightWords green_before = greens(left_above, left_below);
    EightNumbers blues[2], reds[2];
    constexpr std::ptrdiff_t step = 2 * lanes;
    for (int k = 0; k < 2; ++k) {
        const std::uint32_t *const a = above + step * k, *const b = below + step * k;
        const EightWords a0 = load_eight(a), a1 = load_eight(a + lanes), b0 = load_eight(b),
                         b1 = load_eight(b + lanes);
        const Columns red_blue =
            columns_of(red_and_blue(a0, b0), red_and_blue(a1, b1), red_blue_before);
        const Columns green = columns_of(greens(a0, b0), greens(a1, b1), green_before);
        red_blue_before = red_blue.odd;
        green_before = green.odd;
        const EightWords both = filtered(red_blue);
        const auto red = reinterpret_cast<EightNumbers>(both >> 16);
        const auto blue = reinterpret_cast<EightNumbers>(both & 0xffffu);
        const auto mid = reinterpret_cast<EightNumbers>(filtered(green));
        blues[k] = (cb_red * red + cb_green * mid + cb_blue * blue + chroma_offset) >> chroma_shift;
        reds[k] = (cr_red * red + cr_green * mid + cr_blue * blue + chroma_offset) >> chroma_shift;
    }
    store_sixteen(cb, blues[0], blues[1]);
    store_sixteen(cr, reds[0], reds[1]);
}

// Two rows of pixels, each with one extra pixel before its first, and their results: two rows of
// luma and one of each chroma component.
struct RowPair {
    std::array<const std::uint32_t*, 2> pixels;
    std::array<std::uint8_t*, 2> y;
    std::uint8_t *cb, *cr;

    CAROM_INLINE RowPair from(int column) const {
        return {{pixels[0] + column, pixels[1] + column},
                {y[0] + column, y[1] + column},
                cb + column / 2,
                cr + column / 2};
    }
};

CAROM_SIMD void convert_blocks(const RowPair& rows, int blocks) {
    for (int k = 0; k < blocks; ++k) {
        const RowPair part = rows.from(k * block);
        for (std::size_t row = 0; row < 2; ++row) luma_block(part.pixels[row], part.y[row]);
        chroma_block(part.pixels[0], part.pixels[1], part.cb, part.cr);
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

// The pairs of rows of a frame, each with its row of chroma.
class RowPairs {
  public:
    RowPairs(const PixelView& frame, const YuvPlanes& planes) : frame_(frame), planes_(planes) {}

    int count() const { return even_size(frame_.height) / 2; }

    // Converts the blocks [first, end) of one pair; the last may end beyond the frame.
    void blocks(int pair, int first, int end) const {
        const RowPair rows = row_pair(pair);
        const int whole = frame_.width / block;
        if (first == 0) convert_edge(rows, 0);
        const int begin = std::max(first, 1), inner_end = std::min(end, whole);
        if (begin < inner_end) convert_blocks(rows.from(begin * block), inner_end - begin);
        if (end > std::max(whole, 1)) convert_edge(rows, end - 1);
    }

  private:
    RowPair row_pair(int pair) const {
        const int row = 2 * pair, below = std::min(row + 1, frame_.height - 1);
        const std::ptrdiff_t chroma = std::ptrdiff_t{pair} * planes_.chroma_stride;
        std::uint8_t* const y = planes_.y + std::ptrdiff_t{row} * planes_.y_stride;
        return {{frame_.data + std::ptrdiff_t{row} * frame_.stride,
                 frame_.data + std::ptrdiff_t{below} * frame_.stride},
                {y, y + planes_.y_stride},
                planes_.cb + chroma,
                planes_.cr + chroma};
    }

    // Converts a block at the left or right edge of the frame: the pixels at the edge are repeated
    // beyond it.
    void convert_edge(const RowPair& rows, int at) const {
        std::array<std::array<std::uint32_t, 1 + block>, 2> pixels;
        std::array<std::array<std::uint8_t, block>, 2> y;
        std::array<std::uint8_t, block / 2> cb, cr;
        const int begin = at * block;
        for (int i = 0; i <= block; ++i) {
            const int column = std::clamp(begin + i - 1, 0, frame_.width - 1);
            for (std::size_t k = 0; k < 2; ++k)
                pixels[k][static_cast<std::size_t>(i)] = rows.pixels[k][column];
        }
        convert_blocks(
            {{&pixels[0][1], &pixels[1][1]}, {y[0].data(), y[1].data()}, cb.data(), cr.data()}, 1);
        const RowPair to = rows.from(begin);
        const int columns = std::min(block, even_size(frame_.width) - begin);
        for (std::size_t k = 0; k < 2; ++k) std::copy_n(y[k].data(), columns, to.y[k]);
        std::copy_n(cb.data(), columns / 2, to.cb);
        std::copy_n(cr.data(), columns / 2, to.cr);
    }

    const PixelView& frame_;
    const YuvPlanes& planes_;
};

// Finds the blocks that must be converted.
class ChangedBlocks {
  public:
    ChangedBlocks(const PixelView& frame, std::span<const PixelBounds> changed)
        : in_a_row_(blocks_in(frame.width)),
          is_changed_(static_cast<std::size_t>(in_a_row_) *
                      static_cast<std::size_t>(even_size(frame.height) / 2)) {
        for (const PixelBounds& box : changed) {
            assert(box.left < box.right && box.top < box.bottom);
            // A pixel in an odd column also contributes to the chroma of the next column.
            const int first = box.left / block;
            const int end = std::min(box.right / block + 1, in_a_row_);
            for (int pair = box.top / 2; pair <= (box.bottom - 1) / 2; ++pair)
                std::fill(blocks_of(pair) + first, blocks_of(pair) + end, 1);
        }
    }

    // Calls visit(first, end) for each run of changed blocks.
    template <typename Visit>
    void for_runs_of(int pair, const Visit& visit) {
        const auto begin = blocks_of(pair);
        const auto end = begin + in_a_row_;
        for (auto run = std::find(begin, end, 1); run != end;) {
            const auto behind = std::find(run, end, 0);
            visit(static_cast<int>(run - begin), static_cast<int>(behind - begin));
            run = std::find(behind, end, 1);
        }
    }

  private:
    std::vector<std::uint8_t>::iterator blocks_of(int pair) {
        return is_changed_.begin() + std::ptrdiff_t{pair} * in_a_row_;
    }

    int in_a_row_;
    std::vector<std::uint8_t> is_changed_;  ///< row after row
};

}  // namespace

void to_yuv420(const PixelView& frame, const YuvPlanes& planes) {
    assert(frame.width > 0 && frame.height > 0);
    const RowPairs convert(frame, planes);
    for (int pair = 0; pair < convert.count(); ++pair)
        convert.blocks(pair, 0, blocks_in(frame.width));
}

void to_yuv420(const PixelView& frame, std::span<const PixelBounds> changed,
               const YuvPlanes& planes) {
    const RowPairs convert(frame, planes);
    ChangedBlocks blocks(frame, changed);
    for (int pair = 0; pair < convert.count(); ++pair)
        blocks.for_runs_of(pair, [&](int first, int end) { convert.blocks(pair, first, end); });
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

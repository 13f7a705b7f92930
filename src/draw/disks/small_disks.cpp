#include "draw/disks/small_disks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

namespace carom {
namespace {

using Pixel = std::uint8_t __attribute__((vector_size(4)));

// The length of the part of [from, to] inside [at, at + 1].
float overlap(float from, float to, float at) {
    return std::max(0.0F, std::min(to, at + 1.0F) - std::max(from, at));
}

}  // namespace

void SmallDisks::begin(PixelSize size, const Rect& clip) {
    bounds_ = bounds_of(size, clip);
    clip_ = clip;
    stride_ = std::max(0, bounds_.right - bounds_.left) + 2 * margin;
    const int rows = std::max(0, bounds_.bottom - bounds_.top) + 2 * margin;
    sums_.assign(static_cast<std::size_t>(stride_) * (band_rows + 2 * margin), Ink{});
    left_ = static_cast<float>(bounds_.left - reach);
    top_ = static_cast<float>(bounds_.top - reach);
    right_ = static_cast<float>(bounds_.right + reach);
    bottom_ = static_cast<float>(bounds_.bottom + reach);
    bands_.resize(static_cast<std::size_t>(rows / band_rows + 1));
}

const SmallDisks::Shape& SmallDisks::shape_of(float radius) {
    const int steps = std::max(1, static_cast<int>(radius * radius_steps + 0.5F));
    Shape& shape = shapes_[static_cast<std::size_t>(steps)];
    if (shape.width == 0) shape = make_shape(steps);
    return shape;
}

// Integrates along scan lines that have the same distances from the centre for all phases.
SmallDisks::Shape SmallDisks::make_shape(int radius) {
    constexpr auto step = 1.0F / phases;
    const float whole = static_cast<float>(radius) / radius_steps;
    Shape shape;
    shape.width = static_cast<int>(std::ceil(2.0F * whole)) + 1;
    for (int k = 0; k < phases; ++k)
        shape.first.at(static_cast<std::size_t>(k)) =
            static_cast<int>(std::floor(static_cast<float>(k) * step - whole));
    std::vector<float> half;  // half the chord of each line, from one pole to the other
    float area = 0.0F;
    for (int line = -radius; line < radius; ++line) {
        const float height = (static_cast<float>(line) + 0.5F) * step;
        half.push_back(std::sqrt((whole - height) * (whole + height)));
        area += 2.0F * half.back();
    }
    const auto width = static_cast<std::size_t>(shape.width);
    shape.shares.resize(phases * phases * width * width);
    // Of the chords of one phase's row of pixels, in a column of pixels.
    std::vector<float>::iterator share = shape.shares.begin();
    for (int down = 0; down < phases; ++down)
        for (int across = 0; across < phases; ++across) {
            const float middle = static_cast<float>(across) * step;
            const int top = shape.first.at(static_cast<std::size_t>(down)) * phases - down;
            for (int row = 0; row < shape.width; ++row)
                for (int column = 0; column < shape.width; ++column, ++share) {
                    const auto at = static_cast<float>(
                        shape.first.at(static_cast<std::size_t>(across)) + column);
                    const int begin = std::max(-radius, top + row * phases);
                    const int end = std::min(radius, top + (row + 1) * phases);
                    float sum = 0.0F;
                    for (int line = begin; line < end; ++line) {
                        const float chord = half[static_cast<std::size_t>(line + radius)];
                        sum += overlap(middle - chord, middle + chord, at);
                    }
                    *share = sum / area;
                }
        }
    return shape;
}

// Counted from the first pixel of the sums, in row `first_row`, all positions are positive, so that
// a cast rounds down.
void SmallDisks::add_up(const std::vector<Disk>& disks, int first_row) {
    constexpr int first = (margin - reach) * phases;
    const Shape* shape = nullptr;
    float radius = 0.0F, area = 0.0F;
    for (const Disk& disk : disks) {
        if (disk.radius != radius) {
            radius = disk.radius;
            shape = &shape_of(radius);
            area = std::numbers::pi_v<float> * radius * radius;
        }
        const auto x =
            static_cast<unsigned>(static_cast<int>((disk.x - left_) * phases + 0.5F) + first);
        const auto y = static_cast<unsigned>(static_cast<int>((disk.y - top_) * phases + 0.5F) +
                                             first - first_row * phases);
        const std::size_t phase_x = x % phases, phase_y = y % phases;
        const int column = static_cast<int>(x / phases) + shape->first[phase_x];
        const int line = static_cast<int>(y / phases) + shape->first[phase_y];
        const Pixel color = {static_cast<std::uint8_t>(disk.color & 0xFF),
                             static_cast<std::uint8_t>(disk.color >> 8 & 0xFF),
                             static_cast<std::uint8_t>(disk.color >> 16 & 0xFF), 255};
        const Ink ink = __builtin_convertvector(color, Ink) * area;
        const int width = shape->width;
        Ink* row = sums_.data() + static_cast<std::ptrdiff_t>(line) * stride_ + column;
        const float* share = shape->shares.data() +
                             (phase_y * phases + phase_x) * static_cast<std::size_t>(width * width);
        if (width == 2) {  // the usual case
            row[0] += ink * share[0];
            row[1] += ink * share[1];
            row[stride_] += ink * share[2];
            row[stride_ + 1] += ink * share[3];
            continue;
        }
        for (int i = 0; i < width; ++i, row += stride_)
            for (int k = 0; k < width; ++k) row[k] += ink * *share++;
    }
}

// Mixes the rows to which no later band contributes.
void SmallDisks::mix(const PixelView& pixels, int first_row) const {
    const int top = bounds_.top - margin + first_row;
    for (int y = std::max(top, bounds_.top); y < std::min(top + band_rows, bounds_.bottom); ++y) {
        const Ink* sum = sums_.data() + static_cast<std::ptrdiff_t>(y - top) * stride_ + margin;
        std::uint32_t* row = pixels.data + static_cast<std::ptrdiff_t>(y) * pixels.stride;
        for (int x = bounds_.left; x < bounds_.right; ++x, ++sum) {
            const float alpha = (*sum)[3];
            if (alpha == 0.0F) continue;
            Pixel pixel;
            std::memcpy(&pixel, row + x, sizeof pixel);
            const Ink below = __builtin_convertvector(pixel, Ink);
            const Ink above = alpha > 255.0F ? *sum * (255.0F / alpha) : *sum;
            const Ink mixed = below * (1.0F - above[3] / 255.0F) + above + 0.5F;
            pixel = __builtin_convertvector(mixed, Pixel);
            std::memcpy(row + x, &pixel, sizeof pixel);
        }
    }
}

// Moves the last rows to the front: they are the first rows of the next band.
void SmallDisks::go_on() {
    const auto done = sums_.begin() + static_cast<std::ptrdiff_t>(band_rows) * stride_;
    const auto rest = std::copy(done, sums_.end(), sums_.begin());
    std::fill(rest, sums_.end(), Ink{});
}

void SmallDisks::draw(Canvas& canvas) {
    const PixelView pixels = canvas.pixels();
    int first_row = 0;
    for (std::vector<Disk>& band : bands_) {
        add_up(band, first_row);
        mix(pixels, first_row);
        go_on();
        band.clear();
        first_row += band_rows;
    }
    canvas.pixels_changed();
    canvas.touch(clip_);
}

}  // namespace carom

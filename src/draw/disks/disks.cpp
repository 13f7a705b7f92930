#include "draw/disks/disks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <vector>

#include "draw/disks/disk_mask.h"
#include "draw/disks/small_disks.h"
#include "draw/raster/pixel_bounds.h"

namespace carom {
namespace {

using Bytes = std::uint8_t __attribute__((vector_size(16)));
using Quads = std::uint32_t __attribute__((vector_size(16)));
using Words = std::uint16_t __attribute__((vector_size(16)));

template <typename T>
T load(const void* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

// The two halves of a vector, each byte widened to a word.
Words low_words(Bytes bytes) {
    return reinterpret_cast<Words>(__builtin_shufflevector(bytes, Bytes{}, 0, 16, 1, 17, 2, 18, 3,
                                                           19, 4, 20, 5, 21, 6, 22, 7, 23));
}
Words high_words(Bytes bytes) {
    return reinterpret_cast<Words>(__builtin_shufflevector(bytes, Bytes{}, 8, 24, 9, 25, 10, 26, 11,
                                                           27, 12, 28, 13, 29, 14, 30, 15, 31));
}

Bytes twice_each(Bytes bytes) {
    return __builtin_shufflevector(bytes, bytes, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7,
                                   23);
}

// A coverage of 255 has the weight 256, so that a fully covered pixel has exactly the colour of the
// disk.
Words blend(Words below, Words above, Words coverage) {
    const Words weight = coverage + (coverage >> 7);
    return (below * (256 - weight) + above * weight + 128) >> 8;
}

void blend_group(std::uint32_t* pixels, const std::uint8_t* coverages, Bytes color) {
    static_assert(group_size * sizeof *pixels == sizeof(Bytes));
    const Quads four = {load<std::uint32_t>(coverages)};
    const Bytes coverage = twice_each(twice_each(reinterpret_cast<Bytes>(four)));
    const Bytes below = load<Bytes>(pixels);
    const Words low = blend(low_words(below), low_words(color), low_words(coverage));
    const Words high = blend(high_words(below), high_words(color), high_words(coverage));
    const Bytes mixed =
        __builtin_shufflevector(reinterpret_cast<Bytes>(low), reinterpret_cast<Bytes>(high), 0, 2,
                                4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    std::memcpy(pixels, &mixed, sizeof mixed);
}

// The highlight of a lit sphere is at the upper left of its middle, at this share of its radius
// along each axis; its lower right rim is farthest from there.
constexpr float light_aside = 0.3F;
constexpr float light_reach = 1.0F + light_aside * 1.4142135F;

// The colours of a lit sphere at shares of the largest distance from its highlight.
std::array<Canvas::Stop, 4> stops_of(Color color) {
    const Color white = rgb(0xFFFFFF), black = rgb(0x000000);
    return {{{0.0, mix(color, white, 0.45)},
             {0.3, mix(color, white, 0.08)},
             {0.62, mix(color, black, 0.06)},
             {1.0, mix(color, black, 0.5)}}};
}

// They at equal steps of the square of that share.
constexpr int ramp_size = 256;
using Ramp = std::array<std::uint32_t, ramp_size>;

Ramp ramp_of(std::uint32_t color) {
    const auto stops = stops_of(rgb(color));
    Ramp ramp{};
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        const double share = std::sqrt((static_cast<double>(i) + 0.5) / ramp_size);
        std::size_t next = 1;
        while (next + 1 < stops.size() && stops.at(next).share < share) ++next;
        const Canvas::Stop &low = stops.at(next - 1), &high = stops.at(next);
        ramp.at(i) =
            to_pixel(mix(low.color, high.color, (share - low.share) / (high.share - low.share)));
    }
    return ramp;
}

// Draws masks of one colour.
class Stamp {
  public:
    Stamp(const PixelView& pixels, const PixelBounds& bounds, std::uint32_t color)
        : pixels_(pixels), bounds_(bounds), color_(color | 0xFF000000U) {
        const std::uint32_t four[] = {color_, color_, color_, color_};
        color_bytes_ = load<Bytes>(four);
    }

    void draw(const MaskStore& store, const DiskMask& mask, int x, int y) const {
        const bool is_inside =
            x + mask.left >= bounds_.left && x + mask.left + mask.width <= bounds_.right &&
            y + mask.top >= bounds_.top && y + mask.top + mask.height <= bounds_.bottom;
        const MaskRow* row = store.rows(mask);
        const std::uint8_t* coverage = store.coverages(mask);
        for (int line = y + mask.top; line < y + mask.top + mask.height; ++line, ++row) {
            if (is_inside)
                draw_row(*row, coverage, x, line);
            else if (line >= bounds_.top && line < bounds_.bottom)
                draw_cut_row(*row, coverage, x, line);
            coverage += group_size * (row->left_groups + row->right_groups);
        }
    }

  private:
    std::uint32_t* start_of(int line) const {
        return pixels_.data + static_cast<std::ptrdiff_t>(line) * pixels_.stride;
    }

    void draw_row(const MaskRow& row, const std::uint8_t* coverage, int x, int line) const {
        std::uint32_t* pixel = start_of(line) + x + row.left;
        for (int i = 0; i < row.left_groups; ++i, pixel += group_size, coverage += group_size)
            blend_group(pixel, coverage, color_bytes_);
        pixel = std::fill_n(pixel, row.full, color_);
        for (int i = 0; i < row.right_groups; ++i, pixel += group_size, coverage += group_size)
            blend_group(pixel, coverage, color_bytes_);
    }

    // Draws a row of which a part may lie outside the bounds.
    void draw_cut_row(const MaskRow& row, const std::uint8_t* coverage, int x, int line) const {
        const int left = x + row.left;
        const int inside = left + row.left_groups * group_size;
        const int outside = inside + row.full;
        draw_cut(line, left, inside, coverage);
        const int from = std::max(inside, bounds_.left), to = std::min(outside, bounds_.right);
        if (from < to) std::fill(start_of(line) + from, start_of(line) + to, color_);
        draw_cut(line, outside, outside + row.right_groups * group_size,
                 coverage + (inside - left));
    }

    void draw_cut(int line, int from, int to, const std::uint8_t* coverage) const {
        for (int i = std::max(from, bounds_.left); i < std::min(to, bounds_.right); ++i) {
            const std::uint8_t alone[group_size] = {coverage[i - from]};
            std::uint32_t group[group_size] = {start_of(line)[i]};
            blend_group(group, alone, color_bytes_);
            start_of(line)[i] = group[0];
        }
    }

    PixelView pixels_;
    PixelBounds bounds_;
    std::uint32_t color_;
    Bytes color_bytes_;
};

// Draws masks of lit spheres. The colour of a pixel depends on its distance from the highlight: the
// share of the square of the largest distance in the sphere is its place in the ramp.
class LitStamp {
  public:
    LitStamp(const PixelView& pixels, const PixelBounds& bounds, const Ramp& ramp,
             const Disk& shape)
        : pixels_(pixels), bounds_(bounds), ramp_(ramp) {
        const float aside = light_aside * shape.radius, reach = light_reach * shape.radius;
        x_ = shape.x - aside - 0.5F;
        y_ = shape.y - aside - 0.5F;
        steps_ = static_cast<float>(ramp_size) / (reach * reach);
    }

    void draw(const MaskStore& store, const DiskMask& mask, int x, int y) const {
        const MaskRow* row = store.rows(mask);
        const std::uint8_t* coverage = store.coverages(mask);
        for (int line = y + mask.top; line < y + mask.top + mask.height; ++line, ++row) {
            if (line >= bounds_.top && line < bounds_.bottom) draw_row(*row, coverage, x, line);
            coverage += group_size * (row->left_groups + row->right_groups);
        }
    }

  private:
    void draw_row(const MaskRow& row, const std::uint8_t* coverage, int x, int line) const {
        std::uint32_t* const pixels =
            pixels_.data + static_cast<std::ptrdiff_t>(line) * pixels_.stride;
        const float down = static_cast<float>(line) - y_;
        const float of_line = steps_ * down * down;
        const int left = x + row.left;
        const int inside = left + row.left_groups * group_size, outside = inside + row.full;
        draw_rim(pixels, of_line, left, inside, coverage);
        const int from = std::max(inside, bounds_.left), to = std::min(outside, bounds_.right);
        for (int i = from; i < to; ++i) pixels[i] = color_at(i, of_line);
        draw_rim(pixels, of_line, outside, outside + row.right_groups * group_size,
                 coverage + (inside - left));
    }

    void draw_rim(std::uint32_t* pixels, float of_line, int from, int to,
                  const std::uint8_t* coverage) const {
        for (int x = from; x < to; x += group_size, coverage += group_size) {
            std::uint32_t colors[group_size];
            for (int i = 0; i < group_size; ++i) colors[i] = color_at(x + i, of_line);
            if (x >= bounds_.left && x + group_size <= bounds_.right) {
                blend_group(pixels + x, coverage, load<Bytes>(colors));
                continue;
            }
            for (int i = 0; i < group_size; ++i) {
                if (x + i < bounds_.left || x + i >= bounds_.right) continue;
                const std::uint8_t alone[group_size] = {coverage[i]};
                std::uint32_t group[group_size] = {pixels[x + i]};
                const std::uint32_t color[group_size] = {colors[i]};
                blend_group(group, alone, load<Bytes>(color));
                pixels[x + i] = group[0];
            }
        }
    }

    std::uint32_t color_at(int x, float of_line) const {
        const float across = static_cast<float>(x) - x_;
        const int step = static_cast<int>(of_line + steps_ * across * across);
        return ramp_[static_cast<std::size_t>(std::min(step, ramp_size - 1))];
    }

    PixelView pixels_;
    PixelBounds bounds_;
    const Ramp& ramp_;
    float x_, y_, steps_;
};

// A disk on the grid of phases: the pixel that contains its centre, and its shape relative to that
// pixel.
struct PlacedDisk {
    int x = 0, y = 0;
    DiskShape shape;
};

constexpr float largest_radius = 16000;  // rows are counted in 16 bits

bool is_visible(const Disk& disk, const PixelBounds& bounds) {
    // Written so that only finite numbers pass.
    return disk.radius > 0 && disk.radius <= largest_radius &&
           disk.x + disk.radius + 1 > static_cast<float>(bounds.left) &&
           disk.x - disk.radius - 1 < static_cast<float>(bounds.right) &&
           disk.y + disk.radius + 1 > static_cast<float>(bounds.top) &&
           disk.y - disk.radius - 1 < static_cast<float>(bounds.bottom);
}

PlacedDisk place(const Disk& disk) {
    constexpr int phases = DiskShape::phases;
    // Shifted to be positive, so that a cast rounds down.
    constexpr int shift = 1 << 15;
    const auto to_steps = [](float position) {
        return static_cast<int>((static_cast<double>(position) + shift) * phases + 0.5);
    };
    const int x = to_steps(disk.x), y = to_steps(disk.y);
    const int radius = static_cast<int>(disk.radius * DiskShape::radius_steps + 0.5F);
    return {x / phases - shift, y / phases - shift, {x % phases, y % phases, std::max(1, radius)}};
}

void draw_circles(Canvas& canvas, std::span<const Disk> disks, Rect clip) {
    const PixelBounds bounds = bounds_of(canvas.size(), clip);
    std::vector<Circle> circles;
    for (const Disk& disk : disks)
        if (is_visible(disk, bounds))
            circles.push_back({{static_cast<double>(disk.x), static_cast<double>(disk.y)},
                               static_cast<double>(disk.radius),
                               rgb(disk.color)});
    canvas.fill_circles(circles, clip);
}

void draw_lit_circles(Canvas& canvas, std::span<const Disk> disks, Rect clip) {
    const PixelBounds bounds = bounds_of(canvas.size(), clip);
    canvas.clip_to(clip);
    for (const Disk& disk : disks) {
        if (!is_visible(disk, bounds)) continue;
        const Point center{static_cast<double>(disk.x), static_cast<double>(disk.y)};
        const double radius = static_cast<double>(disk.radius);
        const double aside = static_cast<double>(light_aside) * radius;
        canvas.fill_circle(center, radius, {center.x - aside, center.y - aside},
                           static_cast<double>(light_reach) * radius, stops_of(rgb(disk.color)));
    }
    canvas.release_clip();
}

// A sphere on a coarser grid.
Disk with_few_masks(const Disk& disk) {
    const auto rounded = [](float value, float steps) {
        return std::floor(value * steps + 0.5F) / steps;
    };
    float steps = 16.0F;  // of the radius, in a pixel
    while (disk.radius * steps > 512.0F && steps > 1.0F) steps *= 0.5F;
    return {rounded(disk.x, 8.0F), rounded(disk.y, 8.0F),
            std::max(rounded(disk.radius, steps), 1.0F / steps), disk.color};
}

// Prefetches the pixels of a disk that will be drawn soon. Disks are in no spatial order: without
// prefetching, waiting for memory takes half of the time.
void fetch_ahead(const PixelView& pixels, const PixelBounds& bounds, const Disk& disk) {
    constexpr int step = 64 / sizeof *pixels.data;  // a line of the processor's cache
    if (!is_visible(disk, bounds)) return;
    const int top = std::max(bounds.top, static_cast<int>(disk.y - disk.radius));
    const int bottom = std::min(bounds.bottom - 1, static_cast<int>(disk.y + disk.radius));
    const int left = std::max(bounds.left, static_cast<int>(disk.x - disk.radius));
    const int right = std::min(bounds.right - 1, static_cast<int>(disk.x + disk.radius));
    for (int line = top; line <= bottom; ++line) {
        const std::uint32_t* row = pixels.data + static_cast<std::ptrdiff_t>(line) * pixels.stride;
        for (int x = left; x < right + step; x += step)
            __builtin_prefetch(row + std::min(x, right), 1);
    }
}

Rect box_around(const Disk& disk) {
    const double reach = static_cast<double>(disk.radius) + 2.0;
    return {static_cast<double>(disk.x) - reach, static_cast<double>(disk.y) - reach, 2.0 * reach,
            2.0 * reach};
}

}  // namespace

// Masks are cached while there is room for them: for each radius, at the phases met so far. The
// cache saves time and never affects the picture.
struct DiskPainter::Implementation {
    static constexpr std::size_t most_bytes = 16 << 20;
    static constexpr int largest_kept = 64 * DiskShape::radius_steps;
    using Phases = std::array<int, DiskShape::phases * DiskShape::phases>;  ///< index, or -1

    std::size_t bytes() const {
        return store.bytes() + masks.size() * sizeof(DiskMask) + by_radius.size() * sizeof(Phases);
    }

    void forget_if_full() {
        if (!is_full) return;
        store = MaskStore();
        masks.clear();
        by_radius.clear();
        last_radius = -1;
        is_full = false;
    }

    /// The phases of a radius, or null if there is no room for it.
    Phases* phases_of(int radius) {
        if (radius == last_radius) return last_phases;
        const auto known = by_radius.find(radius);
        Phases* phases = known != by_radius.end() ? &known->second : nullptr;
        if (phases == nullptr && radius <= largest_kept) {
            is_full |= bytes() > most_bytes;
            if (!is_full) {
                phases = &by_radius[radius];
                phases->fill(-1);
            }
        }
        last_radius = radius;
        last_phases = phases;
        return phases;
    }

    /// The colours of a lit sphere, which are valid until the next call.
    const Ramp& ramp_for(std::uint32_t color) {
        constexpr std::size_t most_ramps = 8192;
        if (ramps.size() >= most_ramps) ramps.clear();
        const auto [at, is_new] = ramps.try_emplace(color);
        if (is_new) at->second = ramp_of(color);
        return at->second;
    }

    template <class Its>
    void draw_one(const Its& stamp, const PlacedDisk& disk) {
        Phases* phases = phases_of(disk.shape.radius);
        const int phase = disk.shape.phase_y * DiskShape::phases + disk.shape.phase_x;
        int* index = phases != nullptr ? &(*phases)[static_cast<std::size_t>(phase)] : nullptr;
        if (index != nullptr && *index >= 0) {
            stamp.draw(store, masks[static_cast<std::size_t>(*index)], disk.x, disk.y);
            return;
        }
        const DiskMask mask = store.add(disk.shape);
        stamp.draw(store, mask, disk.x, disk.y);
        is_full |= bytes() > most_bytes;
        if (index == nullptr || is_full) {
            store.truncate_to(mask);
        } else {
            *index = static_cast<int>(masks.size());
            masks.push_back(mask);
        }
    }

    MaskStore store;
    std::vector<DiskMask> masks;
    std::unordered_map<int, Phases> by_radius;      ///< looked up only
    std::unordered_map<std::uint32_t, Ramp> ramps;  ///< looked up only
    int last_radius = -1;
    Phases* last_phases = nullptr;
    bool is_full = false;
    std::unique_ptr<SmallDisks> small;  ///< created on first use, as it takes memory
};

DiskPainter::DiskPainter() : implementation_(std::make_unique<Implementation>()) {}
DiskPainter::~DiskPainter() = default;
DiskPainter::DiskPainter(DiskPainter&&) noexcept = default;
DiskPainter& DiskPainter::operator=(DiskPainter&&) noexcept = default;

SmallDisks& DiskPainter::small_disks() {
    std::unique_ptr<SmallDisks>& small = implementation_->small;
    if (!small) small = std::make_unique<SmallDisks>();
    return *small;
}

// Calls `draw` with each disk that is visible, the pixels and their bounds.
template <class Draw>
void DiskPainter::draw_each(Canvas& canvas, std::span<const Disk> disks, Rect clip,
                            const Draw& draw) {
    implementation_->forget_if_full();
    const PixelView pixels = canvas.pixels();
    const PixelBounds bounds = bounds_of(canvas.size(), clip);
    constexpr std::size_t ahead = 4;
    DrawnBoxes boxes(clip);
    for (std::size_t i = 0; i < disks.size(); ++i) {
        const Disk& disk = disks[i];
        if (i + ahead < disks.size()) fetch_ahead(pixels, bounds, disks[i + ahead]);
        if (!is_visible(disk, bounds)) continue;
        boxes.add(box_around(disk));
        draw(disk, pixels, bounds);
    }
    canvas.pixels_changed();
    boxes.touch(canvas);
}

void DiskPainter::draw(Canvas& canvas, std::span<const Disk> disks, Rect clip) {
    if (!canvas.is_raster()) return draw_circles(canvas, disks, clip);
    draw_each(canvas, disks, clip,
              [&](const Disk& disk, const PixelView& pixels, const PixelBounds& bounds) {
                  const Stamp stamp(pixels, bounds, disk.color);
                  implementation_->draw_one(stamp, place(disk));
              });
}

void DiskPainter::draw_lit(Canvas& canvas, std::span<const Disk> disks, Rect clip) {
    if (!canvas.is_raster()) return draw_lit_circles(canvas, disks, clip);
    draw_each(canvas, disks, clip,
              [&](const Disk& disk, const PixelView& pixels, const PixelBounds& bounds) {
                  const Disk shape = with_few_masks(disk);
                  const LitStamp stamp(pixels, bounds, implementation_->ramp_for(disk.color),
                                       shape);
                  implementation_->draw_one(stamp, place(shape));
              });
}

}  // namespace carom

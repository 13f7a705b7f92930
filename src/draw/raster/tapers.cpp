#include "draw/raster/tapers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "draw/raster/pixel_bounds.h"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace carom {
namespace {

// Four pixels of a row.
constexpr int lanes = 4;
using Floats = float __attribute__((vector_size(lanes * sizeof(float))));
using Ints = std::int32_t __attribute__((vector_size(lanes * sizeof(std::int32_t))));

[[gnu::always_inline]] inline Floats all(float a) { return Floats{a, a, a, a}; }
[[gnu::always_inline]] inline Floats least(Floats a, Floats b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Floats most(Floats a, Floats b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Floats share(Floats a) { return least(most(a, all(0)), all(1)); }
[[gnu::always_inline]] inline Floats root(Floats a) {
    Floats to;
    for (int k = 0; k < lanes; ++k) to[k] = std::sqrt(a[k]);
    return to;
}

constexpr std::size_t most_joined = 8;  // lines before that a line may overlap
constexpr float edge = 0.5F;  // pixels over which the coverage falls, on either side of an edge

// A taper prepared for the computation of pixels: positions are relative to its start.
struct Shape {
    double x, y, along_x, along_y;
    float dx, dy, by_length_squared;
    float half_width, growth;  // change of half_width along the line
    double reach;              // distance from the line up to which pixels are partly covered
    std::array<float, 4> channel, change;
    float opacity, opacity_change;

    explicit Shape(const Taper& taper)
        : x(taper.from.x),
          y(taper.from.y),
          along_x(taper.to.x - taper.from.x),
          along_y(taper.to.y - taper.from.y),
          dx(static_cast<float>(along_x)),
          dy(static_cast<float>(along_y)),
          half_width(static_cast<float>(0.5 * taper.width_at_start)),
          growth(static_cast<float>(0.5 * (taper.width_at_end - taper.width_at_start))),
          reach(0.5 * std::max(taper.width_at_start, taper.width_at_end) + edge),
          opacity(static_cast<float>(taper.opacity_at_start)),
          opacity_change(static_cast<float>(taper.opacity_at_end - taper.opacity_at_start)) {
        const float length_squared = dx * dx + dy * dy;
        by_length_squared = length_squared > 0.0F ? 1.0F / length_squared : 0.0F;
        const Color &a = taper.color_at_start, &b = taper.color_at_end;
        const std::array<double, 4> start{a.blue, a.green, a.red, 1.0},
            end{b.blue, b.green, b.red, 1.0};
        for (std::size_t k = 0; k < 4; ++k) {
            channel[k] = static_cast<float>(255.0 * start[k]);
            change[k] = static_cast<float>(255.0 * (end[k] - start[k]));
        }
    }

    // Only tapers that are finite and have a width are drawn.
    bool is_drawn() const {
        return std::isfinite(x + y + along_x + along_y) && reach > static_cast<double>(edge);
    }

    Rect box() const {
        return {std::min(x, x + along_x) - reach, std::min(y, y + along_y) - reach,
                std::abs(along_x) + 2.0 * reach, std::abs(along_y) + 2.0 * reach};
    }
};

[[gnu::always_inline]] inline Floats coverage(const Shape& shape, Floats x, Floats y, Floats at) {
    const Floats off_x = x - at * shape.dx, off_y = y - at * shape.dy;
    const Floats distance = root(off_x * off_x + off_y * off_y);
    const Floats half = shape.half_width + at * shape.growth;
    // The second term matters where the line is thinner than a pixel.
    return share(half - distance + edge) - share(edge - half - distance);
}

[[gnu::always_inline]] inline Ints mixed(Ints below, const Shape& shape, Floats at, Floats weight) {
    Ints pixel{};
    for (int k = 0; k < 4; ++k) {
        const auto channel = static_cast<std::size_t>(k);
        const Floats old = __builtin_convertvector((below >> (8 * k)) & 0xFF, Floats);
        const Floats own = shape.channel[channel] + at * shape.change[channel];
        const Floats now = old + weight * (own - old) + 0.5F;
        pixel |= __builtin_convertvector(now, Ints) << (8 * k);
    }
    return pixel;
}

// The columns [first, last] that the line may cover in the row through `y`.
struct Span {
    double first, last;
};

Span span_at(const Shape& shape, const Rect& box, double y) {
    Span span{box.x, box.right()};
    if (std::abs(shape.along_y) < 1e-3) return span;
    const double middle = shape.x + (y - shape.y) * shape.along_x / shape.along_y;
    const double around =
        shape.reach * std::hypot(shape.along_x, shape.along_y) / std::abs(shape.along_y);
    return {std::max(span.first, middle - around), std::min(span.last, middle + around)};
}

// The share along the line of the nearest point, for pixels relative to its start.
[[gnu::always_inline]] inline Floats share_along(const Shape& shape, Floats columns, Floats rows) {
    return share((columns * shape.dx + rows * shape.dy) * shape.by_length_squared);
}

[[gnu::always_inline]] inline Floats weight_at(const Shape& shape, Floats columns, Floats rows,
                                               Floats at) {
    return coverage(shape, columns, rows, at) * (shape.opacity + at * shape.opacity_change);
}

// What is left to draw of a weight where joined lines before have been drawn with theirs, so that
// the largest of all weights results.
Floats weight_beyond(std::span<const Shape> before, const Shape& shape, Floats columns, Floats rows,
                     Floats weight) {
    Floats drawn = all(0);
    for (const Shape& one : before) {
        const Floats x = columns + static_cast<float>(shape.x - one.x);
        const Floats y = rows + static_cast<float>(shape.y - one.y);
        drawn = most(drawn, weight_at(one, x, y, share_along(one, x, y)));
    }
    constexpr float least = 1.0F / 1024.0F;
    return share((weight - drawn) / most(all(1) - drawn, all(least)));
}

// A line, and the lines before that it is joined to.
struct Joined {
    const Shape& shape;
    std::span<const Shape> before;
};

// Draws `count` pixels of a group, with their columns and rows relative to the start of the line.
template <int count>
[[gnu::always_inline]] inline void draw_group(const Joined& line, std::uint32_t* pixels,
                                              Floats columns, Floats rows) {
    const Shape& shape = line.shape;
    const Floats at = share_along(shape, columns, rows);
    Floats weight = weight_at(shape, columns, rows, at);
    if (!line.before.empty()) weight = weight_beyond(line.before, shape, columns, rows, weight);
    const Ints covered = weight > 0.0F;
    if ((covered[0] | covered[1] | covered[2] | covered[3]) == 0) return;
    Ints group{};
    std::memcpy(&group, pixels, count * sizeof *pixels);
    group = mixed(group, shape, at, weight);
    std::memcpy(pixels, &group, count * sizeof *pixels);
}

void draw_row(const Joined& line, std::uint32_t* row, int first, int end, float y) {
    const Floats rows = all(y);
    const Floats columns =
        Floats{0.5F, 1.5F, 2.5F, 3.5F} - static_cast<float>(line.shape.x - first);
    int x = first;
    for (; x + lanes <= end; x += lanes)
        draw_group<lanes>(line, row + x, columns + static_cast<float>(x - first), rows);
    for (; x < end; ++x)
        draw_group<1>(line, row + x, columns + static_cast<float>(x - first), rows);
}

void draw_one(const PixelView& pixels, const PixelBounds& bounds, const Joined& line,
              const Rect& box) {
    const Shape& shape = line.shape;
    const auto within = [](double place, int least, int most) {
        return static_cast<int>(std::max<double>(least, std::min<double>(place, most)));
    };
    const int top = within(std::floor(box.y), bounds.top, bounds.bottom);
    const int bottom = within(std::ceil(box.bottom()), bounds.top, bounds.bottom);
    for (int y = top; y < bottom; ++y) {
        const double middle = y + 0.5;
        const Span span = span_at(shape, box, middle);
        const int first = within(std::floor(span.first - 0.5), bounds.left, bounds.right);
        const int end = within(std::ceil(span.last + 0.5), bounds.left, bounds.right);
        if (first < end)
            draw_row(line, pixels.data + static_cast<std::ptrdiff_t>(y) * pixels.stride, first, end,
                     static_cast<float>(middle - shape.y));
    }
}

// Draws a taper in a vector document, in steps that can hardly be told apart.
void stroke(Canvas& canvas, const Taper& taper) {
    constexpr double step = 3.0 / 255.0;
    const Color &a = taper.color_at_start, &b = taper.color_at_end;
    const double change =
        std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
    const int steps = std::max(1, static_cast<int>(std::ceil(change / step)));
    const auto between = [](double from, double to, double at) { return from + (to - from) * at; };
    const auto place = [&](double at) {
        return Point{between(taper.from.x, taper.to.x, at), between(taper.from.y, taper.to.y, at)};
    };
    for (int i = 0; i < steps; ++i) {
        const double middle = (i + 0.5) / steps;
        const std::array<Point, 2> ends{place(1.0 * i / steps), place((i + 1.0) / steps)};
        canvas.stroke_path(ends, between(taper.width_at_start, taper.width_at_end, middle),
                           mix(a, b, middle));
    }
}

}  // namespace

void draw_tapers(Canvas& canvas, std::span<const Taper> tapers, Rect clip) {
    if (tapers.empty()) return;
    if (!canvas.is_raster()) {
        canvas.clip_to(clip);
        for (const Taper& taper : tapers) stroke(canvas, taper);
        return canvas.release_clip();
    }
    const PixelView pixels = canvas.pixels();
    const PixelBounds bounds = bounds_of(canvas.size(), clip);
    DrawnBoxes boxes(clip);
    std::vector<Shape> before;  // joined to the next one
    for (const Taper& taper : tapers) {
        if (!taper.is_joined) before.clear();
        const Shape shape(taper);
        if (!shape.is_drawn()) continue;
        const Rect box = shape.box();
        const std::size_t near = std::min(before.size(), most_joined);
        draw_one(pixels, bounds, {shape, std::span(before).last(near)}, box);
        boxes.add(box);
        before.push_back(shape);
    }
    canvas.pixels_changed();
    boxes.touch(canvas);
}

}  // namespace carom

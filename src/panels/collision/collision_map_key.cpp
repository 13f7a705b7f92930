#include "panels/collision/collision_map_key.h"

#include <algorithm>

#include "panels/collision/velocity_plane.h"

namespace carom {
namespace {

constexpr double above = 2.8, below = 1.6;                         // units: title and axis
constexpr double row = 1.5, sample = 2.0, gap = 0.5, apart = 1.4;  // units
constexpr double thinnest = 0.8, widest = 1.6;  // of the plane beside its key, width over height

MapPlaces places_beside(const DrawContext& dc, const Rect& whole, const std::vector<double>& words,
                        const std::vector<double>& samples, const Eigen::Array2d& reach) {
    const double u = dc.unit;
    const double column = *std::ranges::max_element(words) + (samples.front() + apart) * u;
    const double ratio = std::clamp(reach[0] / reach[1], thinnest, widest);
    MapPlaces found{whole, {}, samples};
    found.plane.width = std::clamp(whole.width - column, 0.1 * u, ratio * whole.height);
    Point at{found.plane.right() + apart * u, whole.y + u};
    for (std::size_t i = 0; i < words.size(); ++i, at.y += row * u) {
        if (at.y > whole.bottom()) at = {at.x + column, whole.y + u};
        if (at.x + samples[i] * u + words[i] > dc.area.right() + 1e-6) break;
        found.key.push_back(at);
    }
    return found;
}

// In rows, as many as leave half of the height.
MapPlaces places_over(const DrawContext& dc, const Rect& whole, const std::vector<double>& words,
                      const std::vector<double>& samples) {
    const double u = dc.unit;
    MapPlaces found{whole, {}, samples};
    Point at{dc.area.x, whole.y - 0.05 * u};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const double width = samples[i] * u + words[i];
        if (at.x > dc.area.x && at.x + width > dc.area.right()) at = {dc.area.x, at.y + row * u};
        if (at.y > whole.y + 0.45 * whole.height || at.x + width > dc.area.right()) break;
        found.key.push_back(at);
        at.x += width + apart * u;
    }
    if (found.key.empty()) return found;
    const double taken = found.key.back().y + 1.85 * u - whole.y;
    found.plane.y += taken;
    found.plane.height = std::max(u, whole.height - taken);
    return found;
}

}  // namespace

MapPlaces map_places(const DrawContext& dc, double left, const std::vector<MapKeyEntry>& entries,
                     const Eigen::Array2d& reach) {
    const double u = dc.unit;
    std::vector<double> words, level, short_ones;  // in a column the words begin at one place
    for (const MapKeyEntry& entry : entries) {
        words.push_back(gap * u + measure_text(entry.words, label_style(dc)).width);
        level.push_back(sample);
        short_ones.push_back(is_point(entry.mark) ? 2.5 * map_point_radius : sample);
    }
    const Rect whole{dc.area.x + left, dc.area.y + above * u, std::max(u, dc.area.width - left),
                     std::max(u, dc.area.height - (above + below) * u)};
    const MapPlaces beside = places_beside(dc, whole, words, level, reach);
    const MapPlaces over = places_over(dc, whole, words, short_ones);
    const double gain = scale_in(beside.plane, reach) - scale_in(over.plane, reach);
    return gain > 0.0 ? beside : over;
}

void draw_map_key(Canvas& canvas, const DrawContext& dc, const std::vector<MapKeyEntry>& entries,
                  const MapPlaces& places) {
    for (std::size_t i = 0; i < places.key.size(); ++i) {
        const Point at = places.key[i];
        draw_map_sample(canvas, dc, entries[i].mark, at, places.sample[i]);
        draw_text(canvas, {at.x + (places.sample[i] + gap) * dc.unit, at.y}, entries[i].words,
                  label_style(dc));
    }
}

}  // namespace carom

// The streaks of disks: the paths of their last moment, as wide as the disks and fading backwards.
#include <algorithm>
#include <cmath>

#include "panels/gas/gas_drawing.h"

namespace carom {
namespace {

constexpr double head_opacity = 0.6;
constexpr double tail_width = 0.5;  // of the disk's
constexpr double least_seen = 0.5;  // pixels: shorter streaks lie under their disks

}  // namespace

// Calls `draw` with the place on the canvas of a disk and of each periodic image whose streak may
// be visible, also where the disk itself is beyond a side.
template <class Draw>
void GasPanel::Drawing::for_each_streak(Eigen::Index i, const Draw& draw) const {
    const Vec at_end = place_of(gas.place, i);
    const Point place{at_end[0], at_end[1]};
    Vec low{place.x, place.y}, high = low;
    for (const StreakState::Corner& corner : gas.streaks->of(static_cast<std::size_t>(i))) {
        const Vec at{place.x + static_cast<double>(corner.x),
                     place.y + static_cast<double>(corner.y)};
        low = lower(low, at), high = upper(high, at);
    }
    if (longest(high - low, 2) * scale < least_seen) return;
    Vec from, to = box.size;
    if (gas.view) from = map.low, to = map.low + Vec{frame.width, frame.height} / scale;
    const double around = shown_radius(i) / scale;
    Eigen::Array2i first{0, 0}, last{0, 0};
    constexpr double most_turns = 4.0;
    for (int axis = 0; axis < 2; ++axis) {
        if (!box.is_periodic(axis)) continue;
        const double turn = box.size[axis];
        const auto bounded = [&](double turns) {
            return static_cast<int>(std::clamp(turns, -most_turns, most_turns));
        };
        first[axis] = bounded(std::ceil((from[axis] - around - high[axis]) / turn));
        last[axis] = bounded(std::floor((to[axis] + around - low[axis]) / turn));
    }
    for (int across = first[0]; across <= last[0]; ++across)
        for (int up = first[1]; up <= last[1]; ++up)
            draw(Point{place.x + across * box.size[0], place.y + up * box.size[1]});
}

// A document of lines has no opacities that change along them: there, colours fade to the ground.
void GasPanel::Drawing::draw_streaks() const {
    if (!gas.streaks) return;
    const bool is_raster = canvas.is_raster();
    std::vector<Taper> tapers;
    for (Eigen::Index i = 0; i < radius.size(); ++i) {
        const auto corners = gas.streaks->of(static_cast<std::size_t>(i));
        if (corners.empty() || is_in_crowd(i) || !gas.is_shown(i)) continue;
        const double wide = 2.0 * shown_radius(i);
        const Color own = colors[shade(i)];
        const Color ink =
            gas.seen(panel.is_disk(i, gas) ? own : edge_of(own, dc.theme), i, dc.theme.ground);
        for_each_streak(i, [&](Point place) {
            Taper taper{.from = {},
                        .to = pixel(Vec{place.x, place.y}),
                        .color_at_start = ink,
                        .color_at_end = ink};
            taper.width_at_end = wide;
            taper.opacity_at_end = head_opacity;
            for (const StreakState::Corner& corner : corners) {
                taper.is_joined = &corner != corners.data();
                taper.from = taper.to;
                taper.width_at_start = taper.width_at_end;
                taper.opacity_at_start = taper.opacity_at_end;
                const auto light = static_cast<double>(corner.light);
                taper.to = pixel({place.x + static_cast<double>(corner.x),
                                  place.y + static_cast<double>(corner.y)});
                taper.width_at_end = wide * (tail_width + (1.0 - tail_width) * light);
                taper.opacity_at_end = head_opacity * light;
                tapers.push_back(taper);
                if (is_raster) continue;
                tapers.back().color_at_start = mix(dc.theme.ground, ink, taper.opacity_at_start);
                tapers.back().color_at_end = mix(dc.theme.ground, ink, taper.opacity_at_end);
            }
        });
    }
    draw_tapers(canvas, tapers, frame);
}

}  // namespace carom

// What of the surfaces of a box in space stands behind one another in its picture, which is seen
// from the front: partitions across z and back and front walls that act, as frames, and obstacles.
#include <algorithm>
#include <vector>

#include "panels/surfaces/surface_brush.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_words.h"
#include "util/overloaded.h"

namespace carom {
namespace {

constexpr double deepest = 1.8;     // units, of the frame at the back inside the box
constexpr double most_deep = 0.25;  // of the shorter side of its picture
constexpr double bath_depth = 0.7;  // units: of the band of a heat bath
constexpr double left_open = 1.2;   // units: of each line of what is left of an open partition

// Spheres beside a block have depths between its ends and are not behind it.
double depth_of(const Obstacle& obstacle) {
    return std::visit(
        Overloaded{[](const Obstacle::Ball& ball) { return ball.center[2]; },
                   [](const Obstacle::Lines& lines) { return lines.corners.front()[2]; },
                   [](const Obstacle::Cuboid& block) { return block.high[2]; }},
        obstacle.shape);
}

}  // namespace

bool SurfaceView::is_deep() const { return gas_.box.dimension == 3; }

std::vector<SurfaceView::InDepth> SurfaceView::in_depth(
    const std::vector<SurfaceState>& states) const {
    std::vector<InDepth> all;
    if (!is_deep() || plain_) return all;
    const Surfaces& surfaces = gas_.box.surfaces;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const bool is_drawn =
            !surfaces.is_side(k) || !only_reflects(states[k].behaviour) || states[k].motion;
        if (surfaces.axis_of(k) == 2 && is_drawn)
            all.push_back({place_of_surface(gas_.box, states, k), k});
    }
    auto number = static_cast<std::size_t>(surfaces.first_obstacle());
    for (const Obstacle& obstacle : surfaces.obstacles)
        all.push_back({depth_of(obstacle), number++});
    std::ranges::stable_sort(all, {}, &InDepth::depth);
    return all;
}

void SurfaceView::draw_in_depth(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                                const std::vector<SurfaceState>& states,
                                std::size_t surface) const {
    const Brush brush{*this, canvas, dc, map, states};
    canvas.clip_to(brush.room);
    brush.draw_in_depth(surface);
    canvas.release_clip();
}

void SurfaceView::Brush::draw_in_depth(std::size_t k) const {
    const auto first = static_cast<std::size_t>(box.surfaces.first_obstacle());
    if (k < first)
        draw_frame(k);
    else
        draw_images(box.surfaces.obstacles[k - first]);
}

// The frame of what is at a place along z, whose size tells the depth.
Rect SurfaceView::Brush::frame_at(double depth) const {
    const double most = std::min(deepest * u, most_deep * std::min(room.width, room.height));
    const double inset = most * std::clamp(1.0 - depth / box.size[2], 0.0, 1.0);
    return {room.x + inset, room.y + inset, room.width - 2.0 * inset, room.height - 2.0 * inset};
}

// What is left of an open partition.
void SurfaceView::Brush::draw_corners(const Rect& frame) const {
    for (const double x : {frame.x, frame.right()})
        for (const double y : {frame.y, frame.bottom()}) {
            const double across = (x == frame.x ? left_open : -left_open) * u;
            const double down = (y == frame.y ? left_open : -left_open) * u;
            canvas.stroke_path(std::vector<Point>{{x + across, y}, {x, y}, {x, y + down}},
                               SurfaceSize::line * u, theme.wall);
        }
}

void SurfaceView::Brush::draw_frame(std::size_t k) const {
    Rect frame = frame_at(place_of_surface(box, states, k));
    if (states[k].is_open) return draw_corners(frame);
    if (const auto* bath = bath_of(behaviour(k))) {
        const double deep = bath_depth * u;
        const Color color = bath_color(*bath);
        for (const double x : {frame.x, frame.right() - deep})
            draw_bath(canvas, dc, {x, frame.y, deep, frame.height}, true, color);
        for (const double y : {frame.y, frame.bottom() - deep})
            draw_bath(canvas, dc, {frame.x + deep, y, frame.width - 2.0 * deep, deep}, false,
                      color);
    } else {
        const double half = 0.5 * SurfaceSize::thick * u;
        frame = {frame.x + half, frame.y + half, frame.width - 2.0 * half,
                 frame.height - 2.0 * half};
        const Point low{frame.x, frame.bottom()}, high{frame.right(), frame.y};
        draw_line({low.x, low.y}, {high.x, low.y}, k);
        draw_line({high.x, low.y}, {high.x, high.y}, k);
        draw_line({high.x, high.y}, {low.x, high.y}, k);
        draw_line({low.x, high.y}, {low.x, low.y}, k);
    }
    const Partition* partition = box.surfaces.partition(k);
    if (partition == nullptr) return;
    for (const Gap& gap : partition->gaps)
        canvas.stroke_rect(map.rect({{gap.low[0], gap.low[1]}, {gap.high[0], gap.high[1]}}),
                           0.14 * u, theme.wall);
}

// From one end of a partition to the other, without what is open from the back to the front. In the
// plane a gap is open.
std::vector<SurfaceView::Brush::Stretch> SurfaceView::Brush::stretches(const Partition& partition,
                                                                       double begin,
                                                                       double end) const {
    // Of a partition across x a gap lies along y and z, of one across y along x and z.
    const double deep = box.size[2];
    const auto is_open = [&](const Gap& gap) {
        return box.dimension < 3 || (gap.low[1] <= 0.0 && gap.high[1] >= deep);
    };
    std::vector<double> ends{begin};
    for (const Gap& gap : partition.gaps) {
        ends.push_back(std::clamp(gap.from(), begin, std::max(begin, end)));
        ends.push_back(std::clamp(gap.to(), begin, std::max(begin, end)));
    }
    ends.push_back(end);
    std::ranges::sort(ends);
    std::vector<Stretch> all;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const double from = ends[k], to = ends[k + 1];
        if (!(to > from)) continue;
        bool has_gap = false, is_free = false;
        for (const Gap& gap : partition.gaps) {
            if (gap.from() > from || gap.to() < to) continue;
            has_gap = true;
            is_free = is_free || is_open(gap);
        }
        if (is_free) continue;
        if (!all.empty() && all.back().to == from && all.back().is_whole == !has_gap)
            all.back().to = to;
        else
            all.push_back({from, to, !has_gap});
    }
    return all;
}

}  // namespace carom

// The drawing of surfaces.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "panels/surfaces/surface_brush.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_words.h"
#include "util/overloaded.h"

namespace carom {
void SurfaceView::draw_room(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                            const std::vector<SurfaceState>& states) const {
    const Brush brush{*this, canvas, dc, map, states};
    canvas.fill(brush.room, dc.theme.ground);
    brush.draw_obstacles();
    brush.draw_outline();
    brush.draw_gravity();
}

void SurfaceView::draw_obstacles(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                                 const std::vector<SurfaceState>& states) const {
    if (!plain_) Brush{*this, canvas, dc, map, states}.draw_obstacles();
}

void SurfaceView::draw_partitions(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                                  const std::vector<SurfaceState>& states) const {
    const Brush brush{*this, canvas, dc, map, states};
    for (std::size_t k = gas_.box.surfaces.numbered_sides().size(); k < states.size(); ++k)
        brush.draw_partition(k);
}

void SurfaceView::draw_around(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                              const std::vector<SurfaceState>& states) const {
    const Brush brush{*this, canvas, dc, map, states};
    if (is_deep()) {
        for (std::size_t k = 0; k < states.size(); ++k) brush.draw_arrow_in_space(k);
        brush.draw_names_of_axes();
        brush.draw_gravity();
    }
    for (std::size_t k = 0; k < states.size() && !is_deep(); ++k)
        gas_.box.surfaces.is_side(k) ? brush.draw_side(k) : brush.draw_ends(k);
    if (!states.empty()) brush.draw_labels();
}

Rect SurfaceView::Brush::outside(std::size_t side, double offset, double depth) const {
    if (side == 0) return {room.x - offset - depth, room.y, depth, room.height};
    if (side == 1) return {room.right() + offset, room.y, depth, room.height};
    if (side == bottom_side) return {room.x, room.bottom() + offset, room.width, depth};
    return {room.x, room.y - offset - depth, room.width, depth};
}

// Walls along which other walls move are drawn over the full range of that motion.
void SurfaceView::Brush::draw_outline() const {
    const double wide = SurfaceSize::line * u, half = wide / 2;
    draw_box_outline(canvas, dc, room, {box.is_periodic(0), box.is_periodic(1)});
    const Rect& all = map.frame;
    const bool across = view.may_move(0) || view.may_move(1);
    const bool up = view.may_move(bottom_side) || view.may_move(top_side);
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
        if (const double x = side == 0 ? room.x - half : room.right() + half;
            up && !view.may_move(side))
            canvas.stroke_line({x, all.y - half}, {x, all.bottom() + half}, wide, theme.wall);
    for (const std::size_t side : {bottom_side, top_side})
        if (const double y = side == top_side ? room.y - half : room.bottom() + half;
            across && !view.may_move(side))
            canvas.stroke_line({all.x - half, y}, {all.right() + half, y}, wide, theme.wall);
}

// --------------------------------------------------------------------------------------- obstacles

void SurfaceView::Brush::draw_obstacle(const Obstacle& obstacle, Point shift) const {
    const double wide = 0.14 * u;
    std::vector<Point> corners;
    const auto add = [&](double x, double y) {
        corners.push_back(map.pixel({x + shift.x, y + shift.y}));
    };
    const auto draw_lines = [&](bool is_closed) {
        if (is_closed) {
            canvas.fill_polygon(corners, fill_of_obstacle());
            hatch_polygon(canvas, corners, hatch_apart * u, 0.09 * u, theme.wall);
            corners.push_back(corners.front());
        }
        canvas.stroke_path(corners, is_closed ? wide : SurfaceSize::thick * u, theme.wall);
    };
    std::visit(
        Overloaded{[&](const Obstacle::Ball& ball) {
                       constexpr int count = 72;
                       const double radius = std::max(ball.radius, 0.1 * u / map.scale);
                       for (int k = 0; k < count; ++k) {
                           const double angle = 2.0 * std::numbers::pi * k / count;
                           const double inside = radius - 0.5 * wide / map.scale;
                           add(ball.center[0] + inside * std::cos(angle),
                               ball.center[1] + inside * std::sin(angle));
                       }
                       const Point center =
                           map.pixel({ball.center[0] + shift.x, ball.center[1] + shift.y});
                       canvas.fill_circle(center, radius * map.scale, fill_of_obstacle());
                       if (radius * map.scale > hatch_apart * u)
                           hatch_polygon(canvas, corners, hatch_apart * u, 0.09 * u, theme.wall);
                       canvas.stroke_circle(center, std::max(0.0, radius * map.scale - wide / 2),
                                            wide, theme.wall);
                   },
                   [&](const Obstacle::Lines& lines) {
                       for (const Vec& corner : lines.corners) add(corner[0], corner[1]);
                       draw_lines(lines.is_closed);
                   },
                   [](const Obstacle::Cuboid&) {}},
        obstacle.shape);
}

// With its periodic images.
void SurfaceView::Brush::draw_images(const Obstacle& obstacle) const {
    for (const double across : {-1.0, 0.0, 1.0})
        for (const double up : {-1.0, 0.0, 1.0}) {
            if ((across != 0.0 && !box.is_periodic(0)) || (up != 0.0 && !box.is_periodic(1)))
                continue;
            draw_obstacle(obstacle, {across * box.size[0], up * box.size[1]});
        }
}

void SurfaceView::Brush::draw_obstacles() const {
    canvas.clip_to(room);
    for (const Obstacle& obstacle : box.surfaces.obstacles) draw_images(obstacle);
    canvas.release_clip();
}

// ------------------------------------------------------------------------------------------- sides

void SurfaceView::Brush::draw_side(std::size_t side) const {
    std::visit(Overloaded{[](const Reflecting&) {},
                          [&](const Bath& bath) {
                              draw_bath(canvas, dc, outside(side, 0.0, SurfaceSize::bath * u),
                                        is_upright(side), bath_color(bath));
                          },
                          [&](const Driven&) { draw_bar(side); },
                          [&](const Piston&) { draw_bar(side); }, [](const Membrane&) {},
                          [&](const Diffuse&) {
                              draw_teeth(canvas, dc, outside(side, 0.0, SurfaceSize::teeth * u),
                                         side);
                          }},
               behaviour(side));
    draw_side_label(side);
}

// Of a side that moves, or is held.
void SurfaceView::Brush::draw_bar(std::size_t side) const {
    canvas.fill(outside(side, 0.0, SurfaceSize::bar * u), theme.muted);
    if (is_imposed(side))
        draw_ticks(canvas, dc, outside(side, SurfaceSize::bar * u, 0.8 * SurfaceSize::hatch * u),
                   side);
    draw_side_arrow(side);
}

// The arrow of the force on a piston, or of an imposed motion.
void SurfaceView::Brush::draw_side_arrow(std::size_t side) const {
    const auto* piston = piston_of(behaviour(side));
    const auto& motion = states[side].motion;
    const double along = piston != nullptr ? piston->force : (motion ? motion->velocity : 0.0);
    if (along == 0.0) return;
    const double sign = along > 0.0 ? 1.0 : -1.0;
    const Point up = upwards(static_cast<int>(side / 2));
    const Rect band =
        outside(side, (SurfaceSize::bar + (is_imposed(side) ? SurfaceSize::hatch : 0.1)) * u,
                SurfaceSize::arrow * u);
    const Point middle{band.x + band.width / 2 - label_beside(side).shift,
                       band.y + band.height / 2};
    const double half = 0.45 * SurfaceSize::arrow * u * sign;
    draw_surface_arrow(canvas, dc, {middle.x - half * up.x, middle.y - half * up.y},
                       {2.0 * half * up.x, 2.0 * half * up.y});
}

// -------------------------------------------------------------------------------------- partitions

void SurfaceView::Brush::draw_line(Point from, Point to, std::size_t k) const {
    const auto draw_thick = [&](Color color) {
        canvas.stroke_line(from, to, SurfaceSize::thick * u, color);
    };
    std::visit(Overloaded{[&](const Reflecting&) { draw_thick(theme.wall); },
                          [&](const Bath& bath) { draw_thick(bath_color(bath)); },
                          [&](const Driven&) { draw_thick(theme.muted); },
                          [&](const Piston&) { draw_thick(theme.muted); },
                          [&](const Membrane& its) {
                              its.is_demon()
                                  ? draw_dotted_line(canvas, dc, from, to)
                                  : canvas.stroke_line(from, to, 0.22 * u, theme.ink, 0.8 * u);
                          },
                          [&](const Diffuse&) { draw_rough_line(canvas, dc, from, to); }},
               behaviour(k));
}

// An open partition is drawn by its ends at the walls only.
void SurfaceView::Brush::draw_partition(std::size_t k) const {
    const Partition& partition = *box.surfaces.partition(k);
    const double at = place_of_surface(box, states, k);
    const Region inside = view.room(states);
    const Eigen::Index along = 1 - partition.axis;
    const auto pixel = [&](double where) {
        return partition.axis == 0 ? map.pixel({at, where}) : map.pixel({where, at});
    };
    const double begin = inside.low[along], end = inside.high[along];
    if (states[k].is_open) {
        const double end_length = 1.2 * u / map.scale;
        canvas.stroke_line(pixel(begin), pixel(begin + end_length), SurfaceSize::line * u,
                           theme.wall);
        canvas.stroke_line(pixel(end - end_length), pixel(end), SurfaceSize::line * u, theme.wall);
        return;
    }
    double from = begin;
    const auto draw_to = [&](double to) {
        if (to > from) draw_line(pixel(from), pixel(to), k);
    };
    for (const Gap& gap : partition.gaps) {
        draw_to(std::clamp(gap.from(), begin, std::max(begin, end)));
        from = std::clamp(gap.to(), begin, std::max(begin, end));
    }
    draw_to(end);
}

void SurfaceView::Brush::draw_block(const Rect& block, std::size_t k) const {
    std::visit(
        Overloaded{[](const Reflecting&) {},
                   [&](const Bath& bath) { canvas.fill(block, bath_color(bath)); },
                   [&](const Driven&) { draw_holder(canvas, dc, block, is_imposed(k)); },
                   [&](const Piston&) { draw_holder(canvas, dc, block, is_imposed(k)); },
                   [&](const Membrane&) { draw_eye(canvas, dc, block); }, [](const Diffuse&) {}},
        behaviour(k));
}

bool SurfaceView::Brush::has_block(std::size_t k) const {
    return std::visit(
        Overloaded{[](const Reflecting&) { return false; }, [](const Bath&) { return true; },
                   [](const Driven&) { return true; }, [](const Piston&) { return true; },
                   [](const Membrane& its) { return its.is_demon(); },
                   [](const Diffuse&) { return false; }},
        behaviour(k));
}

// The holders of a partition that does more than reflect: outside of the walls at both ends, moving
// with it.
void SurfaceView::Brush::draw_ends(std::size_t k) const {
    const Partition& partition = *box.surfaces.partition(k);
    if (states[k].is_open || !has_block(k)) return;
    const double at = place_of_surface(box, states, k);
    const Point foot = map.pixel({at, at});
    const double deep = 0.6 * u, wide = 0.9 * u;
    const bool upright = partition.axis == 0;
    const double near = thickness(upright ? bottom_side : 0) * u;
    const double far = thickness(upright ? top_side : 1) * u;
    const Rect first = upright ? Rect{foot.x - wide / 2, room.y - far - deep, wide, deep}
                               : Rect{room.right() + far, foot.y - wide / 2, deep, wide};
    const Rect second = upright ? Rect{first.x, room.bottom() + near, wide, deep}
                                : Rect{room.x - near - deep, first.y, deep, wide};
    draw_block(first, k);
    if (!membrane_of(behaviour(k))) draw_block(second, k);
    const auto* piston = piston_of(behaviour(k));
    const auto& motion = states[k].motion;
    const double along = piston != nullptr
                             ? piston->force
                             : (driven_of(behaviour(k)) && motion ? motion->velocity : 0.0);
    if (along == 0.0) return;
    const Point up = upwards(partition.axis);
    const double sign = along > 0.0 ? 1.0 : -1.0, off = wide / 2 + 0.15 * u;
    const double away = 0.25 * u;  // from the wall
    const Point middle{first.x + first.width / 2 + (upright ? 0.0 : away),
                       first.y + first.height / 2 - (upright ? away : 0.0)};
    draw_surface_arrow(
        canvas, dc, {middle.x + sign * off * up.x, middle.y + sign * off * up.y},
        {0.8 * SurfaceSize::arrow * sign * u * up.x, 0.8 * SurfaceSize::arrow * sign * u * up.y});
}

void SurfaceView::Brush::draw_gravity() const {
    const Vec& g = box.surfaces.gravity;
    const double size = length(g);
    if (!(size > 0.0)) return;
    const double reach = 2.0 * u;
    const Point middle{view.whole(map, u).x + 1.1 * u, map.frame.y + 2.0 * u};
    const Point seen = map.space
                           ? map.space->velocity(0.5 * (view.extent_.low + view.extent_.high), g)
                           : Point{g[0], -g[1]};
    const Point step{reach * seen.x / size, reach * seen.y / size};
    if (std::hypot(step.x, step.y) > 0.5 * reach)
        draw_surface_arrow(canvas, dc, {middle.x - step.x / 2, middle.y - step.y / 2}, step);
    else
        draw_arrow_end_on(canvas, dc, middle, dot(map.space->eye() - 0.5 * box.size, g) > 0.0);
    TextStyle style = label_style(dc);
    style.color = theme.ink;
    style.align = Align::center;
    draw_text(canvas, {middle.x, middle.y + 2.2 * u}, "<i>g</i>", style);
}

}  // namespace carom

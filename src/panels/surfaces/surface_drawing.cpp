// The drawing of surfaces.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "panels/surfaces/surface_sizes.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_view.h"
#include "panels/surfaces/surface_words.h"
#include "physics/gas.h"
#include "physics/surfaces/behaviours.h"
#include "util/overloaded.h"

namespace carom {
namespace {

constexpr double hatch_apart = 0.55;  // units

}  // namespace

// A frame being drawn.
struct SurfaceView::Brush {
    const SurfaceView& view;
    Canvas& canvas;
    const DrawContext& dc;
    const BoxMap& map;
    const std::vector<SurfaceState>& states;
    const Box& box = view.gas_.box;
    const Theme& theme = dc.theme;
    double u = dc.unit;
    Rect room = map.rect(view.room(states));

    struct SurfaceLabel {
        double middle;
        std::string words;
        bool is_of_side = false;
        Color color = {};
    };

    struct SideLabel {
        std::string words;
        bool has_arrow = false;
        double shift = 0.0;  // of the arrow from the middle to the left, and of the words with it
    };

    const Behaviour& behaviour(std::size_t k) const { return states[k].behaviour; }
    bool is_imposed(std::size_t k) const { return driven_of(behaviour(k)) || states[k].is_held; }

    // Of a side, outside of the room, in units.
    double thickness(std::size_t side) const { return thickness_of_side(behaviour(side)); }

    Color bath_color(const Bath& bath) const { return view.bath_color(bath.temperature, theme); }

    // In the direction in which it grows along an axis, on the picture.
    Point upwards(int axis) const { return axis == 0 ? Point{1.0, 0.0} : Point{0.0, -1.0}; }

    Rect outside(std::size_t side, double offset, double depth) const;
    void draw_outline() const;
    void draw_obstacle(const Obstacle& obstacle, Point shift) const;
    void draw_obstacles() const;
    void draw_side(std::size_t side) const;
    void draw_bar(std::size_t side) const;
    void draw_side_arrow(std::size_t side) const;
    SideLabel label_beside(std::size_t side) const;
    void draw_side_label(std::size_t side) const;
    void draw_line(Point from, Point to, std::size_t k) const;
    void draw_partition(std::size_t k) const;
    void draw_ends(std::size_t k) const;
    bool has_block(std::size_t k) const;
    void draw_block(const Rect& block, std::size_t k) const;
    double row_over_side(double from, double to) const;
    Color label_color(std::size_t k) const;
    void draw_labels() const;
    void draw_gravity() const;
};

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
    for (std::size_t k = 0; k < states.size(); ++k)
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
    const Color fill = mix(theme.ground, theme.wall, 0.3);
    const double wide = 0.14 * u;
    std::vector<Point> corners;
    const auto add = [&](double x, double y) {
        corners.push_back(map.pixel({x + shift.x, y + shift.y}));
    };
    if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape)) {
        constexpr int count = 72;
        const double radius = std::max(disk->radius, 0.1 * u / map.scale);
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / count;
            const double inside = radius - 0.5 * wide / map.scale;
            add(disk->center[0] + inside * std::cos(angle),
                disk->center[1] + inside * std::sin(angle));
        }
        const Point center = map.pixel({disk->center[0] + shift.x, disk->center[1] + shift.y});
        canvas.fill_circle(center, radius * map.scale, fill);
        if (radius * map.scale > hatch_apart * u)
            hatch_polygon(canvas, corners, hatch_apart * u, 0.09 * u, theme.wall);
        canvas.stroke_circle(center, std::max(0.0, radius * map.scale - wide / 2), wide,
                             theme.wall);
        return;
    }
    const auto& lines = std::get<Obstacle::Lines>(obstacle.shape);
    for (const Vec& corner : lines.corners) add(corner[0], corner[1]);
    if (lines.is_closed) {
        canvas.fill_polygon(corners, fill);
        hatch_polygon(canvas, corners, hatch_apart * u, 0.09 * u, theme.wall);
        corners.push_back(corners.front());
    }
    canvas.stroke_path(corners, lines.is_closed ? wide : SurfaceSize::thick * u, theme.wall);
}

void SurfaceView::Brush::draw_obstacles() const {
    canvas.clip_to(room);
    for (const Obstacle& obstacle : box.surfaces.obstacles)
        for (const double across : {-1.0, 0.0, 1.0})
            for (const double up : {-1.0, 0.0, 1.0}) {
                if ((across != 0.0 && !box.is_periodic(0)) || (up != 0.0 && !box.is_periodic(1)))
                    continue;
                draw_obstacle(obstacle, {across * box.size[0], up * box.size[1]});
            }
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

// The part of the label of the lower or the upper side that fits beside its arrow, or beyond the
// side: all of it, or only its last part. The arrow is shifted if necessary.
SurfaceView::Brush::SideLabel SurfaceView::Brush::label_beside(std::size_t side) const {
    if (is_upright(side)) return {};
    const std::string all = label_of_surface(view.language_, view.gas_, behaviour(side), 1);
    const auto* piston = piston_of(behaviour(side));
    const bool has_arrow = piston != nullptr && piston->force != 0.0;
    const double taken = has_arrow ? 1.8 * u : 0.0;
    const std::size_t comma = all.rfind(", ");
    const std::string last = comma == std::string::npos ? all : all.substr(comma + 2);
    for (const std::string& words : {all, last}) {
        const double width = measure_text(escape_markup(words), label_style(dc)).width;
        if (width + taken > room.width) continue;
        const double excess = has_arrow ? 0.5 * taken + width - room.width / 2 : 0.0;
        return {words, has_arrow, std::max(0.0, excess)};
    }
    return {"", has_arrow, 0.0};
}

void SurfaceView::Brush::draw_side_label(std::size_t side) const {
    const auto [words, has_arrow, shift] = label_beside(side);
    if (words.empty()) return;
    TextStyle style = label_style(dc);
    style.color = label_color(side);
    style.align = has_arrow ? Align::left : Align::center;
    const double from = bath_of(behaviour(side)) ? SurfaceSize::bath : SurfaceSize::bar;
    const Rect band =
        outside(side, from * u, (has_arrow ? SurfaceSize::arrow : SurfaceSize::label) * u);
    draw_text(canvas,
              {band.x + band.width / 2 + (has_arrow ? 0.9 * u - shift : 0.0),
               band.y + band.height / 2 + 0.36 * u},
              escape_markup(words), style);
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
    for (const Gap& gap : partition.gaps) {
        if (gap.from() > from) draw_line(pixel(from), pixel(gap.from()), k);
        from = gap.to();
    }
    if (end > from) draw_line(pixel(from), pixel(end), k);
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

// The baseline of words from one place to another that stand on the end of a side at the left or
// the right: over the upper side or, where the words of that are, over these.
double SurfaceView::Brush::row_over_side(double from, double to) const {
    const double row = view.whole(map, u).y + 1.05 * u;
    if (moves(behaviour(top_side))) return row;  // the sides reach to where it moves
    const auto [words, has_arrow, shift] = label_beside(top_side);
    if (!words.empty() || has_arrow) {
        const double width = measure_text(escape_markup(words), label_style(dc)).width;
        const double middle = room.x + room.width / 2, half = 0.5 * SurfaceSize::arrow * u;
        const double left = has_arrow ? middle - shift - half : middle - width / 2;
        const double right = has_arrow ? middle - shift + half + width : middle + width / 2;
        if (from < right + 0.5 * u && to > left - 0.5 * u) return row;
    }
    const double hatch = is_imposed(top_side) ? SurfaceSize::hatch : 0.0;
    return std::max(row, room.y - (thickness(top_side) + hatch + 0.45) * u);
}

// A heat bath's words have its colour, in print that of all words.
Color SurfaceView::Brush::label_color(std::size_t k) const {
    const auto* bath = bath_of(behaviour(k));
    if (theme.kind == ThemeKind::print) return theme.ink;
    return bath != nullptr ? legible(bath_color(*bath), theme) : theme.ink;
}

// Labels of vertical partitions are in a row above the box, clear of each other, and those of sides
// on their ends; labels of horizontal partitions are on them.
void SurfaceView::Brush::draw_labels() const {
    TextStyle style = label_style(dc);
    style.color = theme.ink;
    std::vector<SurfaceLabel> labels;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const int axis = box.surfaces.axis_of(k);
        const std::string words = label_of_surface(view.language_, view.gas_, behaviour(k), axis);
        if (words.empty() || states[k].is_open || (axis == 1 && box.surfaces.is_side(k))) continue;
        const double at = place_of_surface(box, states, k);
        const Point foot = map.pixel({at, at});
        if (axis == 0) {
            labels.push_back(
                {foot.x, escape_markup(words), box.surfaces.is_side(k), label_color(k)});
            continue;
        }
        TextStyle within = style;
        within.halo = 0.16 * u;
        within.behind = theme.ground;
        draw_text(canvas, {room.x + 0.5 * u, foot.y - 0.45 * u}, escape_markup(words), within);
    }
    std::ranges::stable_sort(labels, {}, &SurfaceLabel::middle);
    const Rect all = view.whole(map, u);
    const double gap = 1.2 * u;
    const auto width_of = [&](const SurfaceLabel& label) {
        return measure_text(label.words, style).width + gap;
    };
    const auto all_widths = [&] {
        double sum = -gap;
        for (const SurfaceLabel& label : labels) sum += width_of(label);
        return sum;
    };
    while (!labels.empty() && all_widths() > all.width)  // the longest says the most, but not there
        labels.erase(std::ranges::max_element(labels, {}, width_of));
    std::vector<double> lefts;
    double least = all.x;
    for (const SurfaceLabel& label : labels) {
        const double width = measure_text(label.words, style).width;
        lefts.push_back(std::max(least, label.middle - width / 2));
        least = lefts.back() + width + gap;
    }
    double most = all.right();
    for (std::size_t k = labels.size(); k-- > 0;) {
        lefts[k] = std::min(lefts[k], most - measure_text(labels[k].words, style).width);
        const double right = lefts[k] + width_of(labels[k]) - gap;
        most = lefts[k] - gap;
        style.color = labels[k].color;
        const double row = labels[k].is_of_side ? row_over_side(lefts[k], right) : all.y + 1.05 * u;
        draw_text(canvas, {lefts[k], row}, labels[k].words, style);
    }
}

void SurfaceView::Brush::draw_gravity() const {
    const Vec& g = box.surfaces.gravity;
    const double size = std::hypot(g[0], g[1]);
    if (!(size > 0.0)) return;
    const double length = 2.0 * u;
    const Point middle{view.whole(map, u).x + 1.1 * u, map.frame.y + 2.0 * u};
    const Point step{length * g[0] / size, -length * g[1] / size};
    draw_surface_arrow(canvas, dc, {middle.x - step.x / 2, middle.y - step.y / 2}, step);
    TextStyle style = label_style(dc);
    style.color = theme.ink;
    style.align = Align::center;
    draw_text(canvas, {middle.x, middle.y + 2.2 * u}, "<i>g</i>", style);
}

}  // namespace carom

// The surfaces of a box in space, in perspective: its edges, walls that act and partitions as
// translucent sheets, obstacles.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "panels/surfaces/surface_brush.h"
#include "panels/surfaces/surface_strokes.h"
#include "panels/surfaces/surface_words.h"
#include "util/overloaded.h"

namespace carom {
namespace {

constexpr double of_walls = 0.14, of_partitions = 0.2;  // opacities
constexpr double dim = 0.4;        // share of the colour of edges that is left behind the gas
constexpr double left_open = 1.2;  // units: of each line of what is left of an open partition
constexpr double room_of_arrow = 1.3, room_of_name = 1.1;  // units

bool is_drawn(const Surfaces& surfaces, const std::vector<SurfaceState>& states, std::size_t k) {
    return !surfaces.is_side(k) || !only_reflects(states[k].behaviour) || states[k].motion;
}

// The force on a piston, or an imposed velocity; 0 for others.
double push_on(const SurfaceState& state) {
    if (const auto* piston = piston_of(state.behaviour)) return piston->force;
    return driven_of(state.behaviour) && state.motion ? state.motion->velocity : 0.0;
}

Vec unit_along(std::size_t axis) {
    Vec unit;
    unit[axis] = 1.0;
    return unit;
}

std::vector<Point> images(const Perspective& seen, const std::vector<Vec>& places) {
    std::vector<Point> points;
    points.reserve(places.size());
    for (const Vec& place : places) points.push_back(seen.at(place));
    return points;
}

// A rectangle across an axis.
struct Rectangle {
    std::size_t axis;
    double at;
    std::array<double, 2> low, high;  // along the two other axes

    Vec corner(double first, double second) const {
        const auto others = other_axes(axis);
        Vec place;
        place[axis] = at;
        place[others[0]] = first;
        place[others[1]] = second;
        return place;
    }
    std::vector<Vec> corners() const {
        return {corner(low[0], low[1]), corner(high[0], low[1]), corner(high[0], high[1]),
                corner(low[0], high[1])};
    }
    bool is_empty() const { return !(low[0] < high[0] && low[1] < high[1]); }
};

Rectangle rectangle_of(std::size_t axis, double at, const Region& part) {
    const auto [first, second] = other_axes(axis);
    return {axis, at, {part.low[first], part.low[second]}, {part.high[first], part.high[second]}};
}

// What of a gap lies in a rectangle.
Rectangle hole_in(const Rectangle& sheet, const Gap& gap) {
    Rectangle hole = sheet;
    for (const std::size_t i : {0, 1}) {
        hole.low.at(i) = std::max(sheet.low.at(i), gap.low.at(i));
        hole.high.at(i) = std::min(sheet.high.at(i), gap.high.at(i));
    }
    return hole;
}

}  // namespace

bool SurfaceView::is_deep() const { return gas_.box.dimension == 3; }

SurfaceView::Margins SurfaceView::margins_in_space() const {
    bool has_labels = false, has_arrows = false;
    for (std::size_t k = 0; k < behaviours_.size(); ++k)
        for (const Behaviour& behaviour : behaviours_[k]) {
            has_labels |= !only_reflects(behaviour);
            const auto* piston = piston_of(behaviour);
            has_arrows |= driven_of(behaviour) || (piston != nullptr && piston->force != 0.0);
        }
    const double around = has_arrows ? room_of_arrow : 0.0;
    const double names = around + (names_axes_ ? room_of_name : 0.0);
    return {names + (gas_.box.surfaces.has_gravity() ? SurfaceSize::gravity : 0.0), around, names,
            around + (has_labels ? SurfaceSize::label : 0.0)};
}

void SurfaceView::draw_behind(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                              const std::vector<SurfaceState>& states) const {
    const Brush brush{*this, canvas, dc, map, states};
    brush.draw_walls(false);
    brush.draw_edges(false);
}

void SurfaceView::draw_in_front(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                                const std::vector<SurfaceState>& states) const {
    const Brush brush{*this, canvas, dc, map, states};
    brush.draw_walls(true);
    brush.draw_edges(true);
}

std::vector<SurfaceView::Sheet> SurfaceView::sheets(const std::vector<SurfaceState>& states) const {
    const Surfaces& surfaces = gas_.box.surfaces;
    std::vector<Sheet> all;
    for (std::size_t k = 0; k < states.size(); ++k)
        if (!surfaces.is_side(k))
            all.push_back({k, static_cast<std::size_t>(surfaces.axis_of(k)),
                           place_of_surface(gas_.box, states, k)});
    return all;
}

std::vector<SurfaceView::Body> SurfaceView::bodies() const {
    auto number = static_cast<std::size_t>(gas_.box.surfaces.first_obstacle());
    std::vector<Body> all;
    for (const Obstacle& obstacle : gas_.box.surfaces.obstacles)
        all.push_back({number++, &obstacle});
    return all;
}

void SurfaceView::draw_sheet(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                             const std::vector<SurfaceState>& states, const Sheet& sheet,
                             const Region& part) const {
    Brush{*this, canvas, dc, map, states}.draw_sheet(sheet.surface, sheet.axis, sheet.at, part,
                                                     of_partitions);
}

void SurfaceView::draw_body(Canvas& canvas, const DrawContext& dc, const BoxMap& map,
                            const Body& body) const {
    const std::vector<SurfaceState> none;
    const Brush brush{*this, canvas, dc, map, none};
    std::visit(Overloaded{[&](const Obstacle::Ball& ball) { brush.draw_ball_in_space(ball); },
                          [](const Obstacle::Lines&) {},
                          [&](const Obstacle::Cuboid& block) { brush.draw_block_in_space(block); }},
               body.obstacle->shape);
}

// An edge that two walls share which face the eye lies before the gas, one between a wall that does
// and one that does not on the outline of the picture. Those of periodic sides are dashed. The part
// of the box that a wall has left is dim.
void SurfaceView::Brush::draw_edges(bool in_front) const {
    const Perspective& seen = *map.space;
    const Region inside = view.room(states);
    const double wide = SurfaceSize::line * u;
    const Color color = in_front ? theme.wall : mix(theme.page, theme.wall, dim);
    const auto faces_eye = [&](std::size_t axis, bool is_high) {
        return is_high ? seen.is_beyond(axis, inside.high[axis])
                       : !seen.is_beyond(axis, inside.low[axis]);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [first, second] = other_axes(axis);
        for (const bool high_first : {false, true})
            for (const bool high_second : {false, true}) {
                Vec from = inside.low;
                from[first] = (high_first ? inside.high : inside.low)[first];
                from[second] = (high_second ? inside.high : inside.low)[second];
                Vec to = from;
                to[axis] = inside.high[axis];
                const bool is_in_front =
                    faces_eye(first, high_first) || faces_eye(second, high_second);
                if (!in_front)
                    for (const bool is_high : {false, true}) {
                        const Vec& end = is_high ? to : from;
                        Vec far = end;
                        far[axis] = (is_high ? view.extent_.high : view.extent_.low)[axis];
                        if (far[axis] != end[axis])
                            canvas.stroke_line(seen.at(end), seen.at(far), wide, color);
                    }
                if (is_in_front != in_front) continue;
                const bool is_joined = box.is_periodic(first) || box.is_periodic(second);
                canvas.stroke_path(
                    std::vector{seen.at(from), seen.at(to)}, wide, color,
                    is_joined ? std::vector{0.8 * u, 0.5 * u} : std::vector<double>{});
            }
    }
}

void SurfaceView::Brush::draw_walls(bool in_front) const {
    const Region inside = view.room(states);
    for (std::size_t k = 0; k < states.size() && box.surfaces.is_side(k); ++k) {
        if (!is_drawn(box.surfaces, states, k)) continue;
        const auto axis = static_cast<std::size_t>(box.surfaces.axis_of(k));
        const bool is_high = box.surfaces.is_far_side(k);
        const double at = (is_high ? inside.high : inside.low)[axis];
        if ((map.space->is_beyond(axis, at) == is_high) != in_front) continue;
        draw_sheet(k, axis, at, inside, of_walls);
    }
}

Color SurfaceView::Brush::fill_of_sheet(std::size_t k, double opacity) const {
    const auto color =
        std::visit(Overloaded{[&](const Reflecting&) { return theme.wall; },
                              [&](const Bath& bath) { return bath_color(bath); },
                              [&](const Driven&) { return theme.muted; },
                              [&](const Piston&) { return theme.muted; },
                              [&](const Membrane&) { return mix(theme.page, theme.wall, 0.5); },
                              [&](const Diffuse&) { return theme.wall; }},
                   behaviour(k));
    return with_alpha(color, opacity);
}

// Without its gaps: the outline of the area goes to each of them, around it and back.
void SurfaceView::Brush::draw_sheet(std::size_t k, std::size_t axis, double at, const Region& part,
                                    double opacity) const {
    const Perspective& seen = *map.space;
    const Rectangle sheet = rectangle_of(axis, at, part);
    if (sheet.is_empty()) return;
    const std::vector<Vec> corners = sheet.corners();
    const double length = length_of_unit();
    const auto side = [&](std::size_t i) { return corners[(i + 1) % 4] - corners[i]; };
    const auto inward = [&](std::size_t i) {
        const Vec in = corners[(i + 3) % 4] - corners[i];
        return in / carom::length(in);
    };
    if (states[k].is_open) {
        for (std::size_t i = 0; i < 4; ++i) {
            const double all = carom::length(side(i));
            const Vec end = std::min(left_open * length, 0.5 * all) / all * side(i);
            const Vec next = corners[(i + 1) % 4];
            for (const auto& [from, to] :
                 {std::pair{corners[i], corners[i] + end}, std::pair{next, next - end}})
                canvas.stroke_line(seen.at(from), seen.at(to), SurfaceSize::line * u, theme.wall);
        }
        return;
    }
    std::vector<Rectangle> holes;
    if (const Partition* partition = box.surfaces.partition(k))
        for (const Gap& gap : partition->gaps)
            if (const Rectangle hole = hole_in(sheet, gap); !hole.is_empty()) holes.push_back(hole);
    std::vector<Vec> around = corners;
    around.push_back(corners.front());
    for (const Rectangle& hole : holes) {
        const std::vector<Vec> its = hole.corners();
        for (const std::size_t i : {0, 3, 2, 1, 0}) around.push_back(its.at(i));
        around.push_back(corners.front());
    }
    canvas.fill_polygon(images(seen, around), fill_of_sheet(k, opacity));
    for (std::size_t i = 0; i < 4; ++i) draw_border(k, corners[i], side(i), inward(i));
    for (const Rectangle& hole : holes) {
        std::vector<Vec> its = hole.corners();
        its.push_back(its.front());
        canvas.stroke_path(images(seen, its), 0.14 * u, theme.wall);
    }
}

// One side of a sheet: `along` it from a corner, with `inward` as the direction to its middle. As
// the border of the same surface in the plane, but that of a heat bath and the ticks of an imposed
// motion lie in the sheet.
void SurfaceView::Brush::draw_border(std::size_t k, const Vec& corner, const Vec& along,
                                     const Vec& inward) const {
    const Perspective& seen = *map.space;
    draw_line(seen.at(corner), seen.at(corner + along), k);
    const double all = carom::length(along), unit = length_of_unit();
    const auto at = [&](double way, double deep) {
        return corner + way / all * along + deep * inward;
    };
    if (const auto* bath = bath_of(behaviour(k))) {
        const double middle = 0.8 * unit, period = 1.2 * unit, inset = 1.3 * unit;
        std::vector<Vec> wave;
        for (double way = inset; way <= all - inset; way += period / 12.0)
            wave.push_back(
                at(way, middle + 0.28 * unit * std::sin(2.0 * std::numbers::pi * way / period)));
        if (wave.size() > 1) canvas.stroke_path(images(seen, wave), 0.13 * u, bath_color(*bath));
    }
    if (is_imposed(k))
        for (double way = 0.2 * unit; way + 0.5 * unit < all; way += 0.75 * unit)
            canvas.stroke_line(seen.at(at(way, 0.0)), seen.at(at(way + 0.5 * unit, 0.5 * unit)),
                               0.12 * u, theme.muted);
}

// Outside of a wall, in the middle of it; over a partition, or beside one across y.
void SurfaceView::Brush::draw_arrow_in_space(std::size_t k) const {
    const double push = push_on(states[k]);
    if (push == 0.0 || states[k].is_open) return;
    const auto axis = static_cast<std::size_t>(box.surfaces.axis_of(k));
    const Region inside = view.room(states);
    const double unit = length_of_unit(), half = 0.45 * SurfaceSize::arrow * unit;
    Vec middle = 0.5 * (inside.low + inside.high);
    middle[axis] = place_of_surface(box, states, k);
    if (box.surfaces.is_side(k)) {
        const double outward = box.surfaces.is_far_side(k) ? 1.0 : -1.0;
        middle[axis] += outward * (half + 0.3 * unit);
    } else {
        const std::size_t beyond = axis == 1 ? 0 : 1;
        middle[beyond] = inside.high[beyond] + unit;
    }
    const Vec step = (push > 0.0 ? half : -half) * unit_along(axis);
    const Point from = map.space->at(middle - step), to = map.space->at(middle + step);
    if (std::hypot(to.x - from.x, to.y - from.y) > 0.6 * u)
        draw_surface_arrow(canvas, dc, from, {to.x - from.x, to.y - from.y});
    else
        draw_arrow_end_on(canvas, dc, {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)},
                          dot(map.space->eye() - middle, step) > 0.0);
}

// Hatched as in the plane; the hatching is that of the picture.
void SurfaceView::Brush::draw_ball_in_space(const Obstacle::Ball& ball) const {
    const Perspective::Image image = map.space->image(ball.center);
    const double wide = 0.14 * u, radius = std::max(ball.radius * image.scale, 0.1 * u);
    canvas.fill_circle(image.at, radius, mix(theme.page, theme.wall, 0.3));
    constexpr int count = 72;
    std::vector<Point> around;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / count;
        around.push_back({image.at.x + (radius - 0.5 * wide) * std::cos(angle),
                          image.at.y + (radius - 0.5 * wide) * std::sin(angle)});
    }
    if (radius > hatch_apart * u)
        hatch_polygon(canvas, around, hatch_apart * u, 0.09 * u, theme.wall);
    canvas.stroke_circle(image.at, std::max(0.0, radius - wide / 2), wide, theme.wall);
}

// The faces that are seen, the upper and lower ones lightest.
void SurfaceView::Brush::draw_block_in_space(const Obstacle::Cuboid& block) const {
    const Perspective& seen = *map.space;
    constexpr std::array shares{0.22, 0.42, 0.3};  // of the wall's colour
    const Region region{block.low, block.high};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool is_high : {false, true}) {
            const double at = (is_high ? block.high : block.low)[axis];
            if (is_high != seen.is_beyond(axis, at)) continue;
            std::vector<Point> corners = images(seen, rectangle_of(axis, at, region).corners());
            canvas.fill_polygon(corners, mix(theme.page, theme.wall, shares.at(axis)));
            hatch_polygon(canvas, corners, hatch_apart * u, 0.09 * u, theme.wall);
            corners.push_back(corners.front());
            canvas.stroke_path(corners, 0.14 * u, theme.wall);
        }
}

// Each at the middle of an edge on the outline of the picture: of x the lowest, of y the leftmost,
// of z the one furthest to the right below.
void SurfaceView::Brush::draw_names_of_axes() const {
    if (!view.names_axes_) return;
    const Perspective& seen = *map.space;
    const Region inside = view.extent_;
    const Point center = seen.at(0.5 * (inside.low + inside.high));
    TextStyle style = label_style(dc);
    style.color = theme.muted;
    style.align = Align::center;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [first, second] = other_axes(axis);
        Point best{};
        double most = -1e300;
        for (const bool high_first : {false, true})
            for (const bool high_second : {false, true}) {
                const bool first_faces = high_first ? seen.is_beyond(first, inside.high[first])
                                                    : !seen.is_beyond(first, inside.low[first]);
                const bool second_faces = high_second ? seen.is_beyond(second, inside.high[second])
                                                      : !seen.is_beyond(second, inside.low[second]);
                if (first_faces == second_faces) continue;
                Vec middle = 0.5 * (inside.low + inside.high);
                middle[first] = (high_first ? inside.high : inside.low)[first];
                middle[second] = (high_second ? inside.high : inside.low)[second];
                const Point at = seen.at(middle);
                const double rank = axis == 0 ? at.y : axis == 1 ? -at.x : at.y + 0.5 * at.x;
                if (rank > most) most = rank, best = at;
            }
        if (most == -1e300) continue;
        const double off = std::hypot(best.x - center.x, best.y - center.y);
        if (!(off > 0.0)) continue;
        const double out = 0.9 * u / off;
        draw_text(
            canvas,
            {best.x + out * (best.x - center.x), best.y + out * (best.y - center.y) + 0.35 * u},
            std::string("<i>") + name_of_axis(axis) + "</i>", style);
    }
}

}  // namespace carom

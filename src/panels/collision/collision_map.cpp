#include "panels/collision/collision_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "panels/collision/collision_map_key.h"
#include "panels/registry.h"

namespace carom {
namespace {

using Vector = Eigen::Array2d;

constexpr int ellipse_points = 240;

struct MapState : PanelState {
    std::size_t steps = 0;  // of the walk, so far
    int stage = 0;          // of the collision shown: 1 before, 2 after, 0 another flight
};

Point toward(const Point& from, const Point& to, double distance) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double share = length > 0.0 ? distance / length : 0.0;
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

Vector largest(const Vector& a, const Vector& b) { return a.abs().max(b.abs()); }

}  // namespace

CollisionMapPanel::CollisionMapPanel(const PanelContext& context, const PanelSpec& spec)
    : context_(context), spec_(spec), watch_(context, spec), walk_watch_(context, spec) {}

void CollisionMapPanel::survey(const FrameInput& input) {
    if (spec_.given) return;
    watch_.survey(input);
    if (is_walk()) walk_watch_.survey(input);
}

void CollisionMapPanel::fix_axes() {
    if (spec_.given) {
        motion_ = {.inverse_mass = spec_.given->inverse_mass, .before = spec_.given->velocity};
        motion_.after = (collision_matrix(motion_.inverse_mass) * motion_.before.matrix()).array();
    } else {
        met_ = watch_.collision();
        for (std::size_t k = 0; k < 2; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            number_[k] = met_->particle[k];
            motion_.inverse_mass[i] = context_.particles.inverse_mass[met_->particle[k]];
            motion_.before[i] = met_->before[k][0];
            motion_.after[i] = met_->after[k][0];
        }
    }
    if (motion_.has_infinite_mass() && (is_scaled() || is_walk())) {
        Diagnostic error = spec_.place;
        error.message = fmt::format(
            "a collision with an infinite mass has no ellipse of energy, "
            "which `{}` needs",
            spec_.scaled == true ? "scaled" : "walk");
        error.hint = "leave it out, or give a pair of finite masses";
        throw SceneError({error});
    }
    if (is_scaled()) factor_ = motion_.inverse_mass.rsqrt();
    if (is_walk()) walk_ = walk_watch_.steps();
    reach_ = largest(motion_.before, motion_.after);
    if (!motion_.has_infinite_mass())
        reach_ = (2.0 * motion_.energy() * motion_.inverse_mass).sqrt();
    reach_ = (factor_ * reach_).max(0.25 * (factor_ * reach_).maxCoeff());
}

std::shared_ptr<const PanelState> CollisionMapPanel::state(const FrameInput& input) {
    auto state = std::make_shared<MapState>();
    const double now = input.tick.time;
    while (state->steps < walk_.size() && walk_[state->steps].time <= now) ++state->steps;
    if (met_ && now >= met_->since && now <= met_->until) state->stage = now < met_->time ? 1 : 2;
    return state;
}

std::size_t CollisionMapPanel::steps_of(const PanelState& state) {
    return static_cast<const MapState&>(state).steps;
}

MapPlaces CollisionMapPanel::places(const DrawContext& dc) const {
    const std::vector<MapKeyEntry> entries = key(walk_.size());
    const double least = 3.0 * dc.unit;
    const Scale up = plane_in(map_places(dc, least, entries, reach_).plane).up();
    return map_places(dc, std::max(least, y_axis_space(up, axis_style(dc))), entries, reach_);
}

VelocityPlane CollisionMapPanel::plane_in(const Rect& area) const {
    return {area, factor_, scale_in(area, reach_)};
}

VelocityPlane CollisionMapPanel::plane(const DrawContext& dc) const {
    return plane_in(places(dc).plane);
}

void CollisionMapPanel::draw_axes(Canvas& canvas, const DrawContext& dc,
                                  const VelocityPlane& to) const {
    const double u = dc.unit;
    const Point zero = to(Vector::Zero());
    const Color faint = mix(dc.theme.muted, dc.theme.page, 0.6);
    canvas.stroke_line({to.area.x, zero.y}, {to.area.right(), zero.y}, 0.06 * u, faint);
    canvas.stroke_line({zero.x, to.area.y}, {zero.x, to.area.bottom()}, 0.06 * u, faint);
    const auto name = [&](std::size_t k) {
        return met_ ? colored(velocity_name(k), color_of(context_, *met_, k, dc.theme), dc.theme)
                    : velocity_name(k);
    };
    draw_x_axis(canvas, to.area, to.across(), name(0), axis_style(dc));
    draw_y_axis(canvas, to.area, to.up(), "", axis_style(dc));
    draw_text(canvas, {to.area.x + 0.4 * u, to.area.y - 0.4 * u}, name(1), label_style(dc));
}

std::vector<Eigen::Array2d> CollisionMapPanel::ellipse() const {
    const Vector half = (2.0 * motion_.energy() * motion_.inverse_mass).sqrt();
    std::vector<Vector> points;
    for (int i = 0; i <= ellipse_points; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / ellipse_points;
        points.push_back({half[0] * std::cos(turn), half[1] * std::sin(turn)});
    }
    return points;
}

// With an infinite mass the two speeds that the other can have, in its frame.
void CollisionMapPanel::draw_energy(Canvas& canvas, const DrawContext& dc,
                                    const VelocityPlane& to) const {
    const double width = 0.16 * dc.unit;
    if (!motion_.has_infinite_mass()) {
        std::vector<Point> path;
        for (const Vector& point : ellipse()) path.push_back(to(point));
        canvas.stroke_path(path, width, dc.theme.muted);
        return;
    }
    const Vector across = motion_.inverse_mass[0] > 0.0 ? Vector{0.0, 1.0} : Vector{1.0, 0.0};
    for (const Vector& through : {motion_.before, motion_.after})
        to.draw_line(canvas, through, across, width, dc.theme.muted, {});
}

void CollisionMapPanel::draw_collision(Canvas& canvas, const DrawContext& dc,
                                       const VelocityPlane& to) const {
    const double u = dc.unit;
    const Vector middle = Vector::Constant(motion_.mass_center_velocity());
    to.draw_line(canvas, motion_.before, motion_.turning(), 0.14 * u, momentum_color(dc),
                 momentum_dashes(dc));
    const Point center = to(middle), zero = to(Vector::Zero());
    if (distance(zero, center) > u) draw_arrow(canvas, zero, center, map_arrow_center(dc));
    const auto draw_part = [&](const Vector& end, const ArrowStyle& style) {
        const Point at = to(end);
        const double length = distance(center, at) - map_point_radius * u;
        if (length > 0.8 * u) draw_arrow(canvas, center, toward(center, at, length), style);
    };
    draw_part(motion_.before, map_arrow_before(dc));
    draw_part(motion_.after, map_arrow_after(dc));
    draw_map_point(canvas, dc, to(motion_.before), true);
    draw_map_point(canvas, dc, to(motion_.after), false);
}

void CollisionMapPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    draw_panel_title(
        canvas, dc,
        spec_.title ? escape_markup(*spec_.title) : fitting_title(dc, titles(dc.theme)));
    const VelocityPlane to = plane(dc);
    draw_axes(canvas, dc, to);
    to.draw_line(canvas, Vector::Zero(), Vector::Ones(), 0.1 * dc.unit, dc.theme.muted,
                 equal_dots(dc));
    draw_energy(canvas, dc, to);
    if (is_walk()) return;
    draw_collision(canvas, dc, to);
    draw_map_key(canvas, dc, key(0), places(dc));
}

void CollisionMapPanel::draw_walk(Canvas& canvas, const DrawContext& dc, const VelocityPlane& to,
                                  std::size_t steps) const {
    const double u = dc.unit;
    const double fine = std::sqrt(std::min(1.0, 40.0 / static_cast<double>(walk_.size())));
    for (std::size_t i = 1; i < steps; ++i) {
        const std::array line{to(walk_[i - 1].velocity), to(walk_[i].velocity)};
        if (walk_[i].cause == WalkStep::Cause::pair)
            canvas.stroke_path(line, 0.13 * fine * u, momentum_color(dc));
        else if (walk_[i].cause == WalkStep::Cause::wall)
            canvas.stroke_path(line, 0.11 * fine * u, dc.theme.muted, wall_dashes(dc));
    }
    for (std::size_t i = 0; i < steps; ++i)
        canvas.fill_circle(to(walk_[i].velocity), std::max(0.1, 0.22 * fine) * u,
                           momentum_color(dc));
    draw_map_point(canvas, dc, to(walk_.front().velocity), true);
    if (steps > 1) draw_map_point(canvas, dc, to(walk_[steps - 1].velocity), false);
}

void CollisionMapPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const MapState&>(state);
    const VelocityPlane to = plane(dc);
    if (is_walk()) {
        draw_walk(canvas, dc, to, now.steps);
        draw_map_key(canvas, dc, key(now.steps), places(dc));
        return;
    }
    if (now.stage == 0 || !context_.in_film) return;
    const Point at = to(now.stage == 1 ? motion_.before : motion_.after);
    canvas.stroke_circle(at, 0.75 * dc.unit, 0.12 * dc.unit, momentum_color(dc));
}

std::unique_ptr<Panel> make_collision_map(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<CollisionMapPanel>(context, spec);
}

}  // namespace carom

// The collision of two beads on a wire in the plane of their velocities: an ellipse of constant
// energy, a line of constant momentum, and their two intersections, the states before and after the
// collision. Alternatively, all collisions of the two beads as a walk on the ellipse.
#include "panels/collision/collision_map.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "panels/registry.h"
#include "scene/panel_kind.h"

namespace carom {
namespace collision_map {
namespace {

constexpr int ellipse_points = 240;
constexpr int depth_of_zero = 5, depth_of_equal = 4, depth_of_energy = 3, depth_of_lines = 2,
              depth_of_arrows = 1;

struct MapState : PanelState {
    std::size_t steps = 0;  // of the walk, so far
    int stage = 0;          // of the collision shown: 1 before, 2 after, 0 another flight
};

}  // namespace

void CollisionMapPanel::survey(const FrameInput& input) {
    if (options().given) return;
    watch_.survey(input);
    if (is_walk()) walk_watch_.survey(input);
}

void CollisionMapPanel::find_motion() {
    if (const auto& given = options().given) {
        motion_ = {.inverse_mass = given->inverse_mass, .before = given->velocity};
        motion_.after = (collision_matrix(motion_.inverse_mass) * motion_.before.matrix()).array();
        return;
    }
    met_ = watch_.collision();
    for (std::size_t k = 0; k < 2; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        number_[k] = met_->particle[k];
        motion_.inverse_mass[i] = context_.particles.inverse_mass[met_->particle[k]];
        motion_.before[i] = met_->before[k][0];
        motion_.after[i] = met_->after[k][0];
    }
}

void CollisionMapPanel::fix_axes() {
    find_motion();
    if (motion_.has_infinite_mass() && (is_scaled() || is_walk()))
        refuse(spec_.place,
               fmt::format(
                   "a collision with an infinite mass has no ellipse of energy, which `{}` needs",
                   options().scaled == true ? "scaled" : "walk"),
               "leave it out, or give a pair of finite masses");
    if (is_scaled()) factor_ = motion_.inverse_mass.rsqrt();
    if (is_walk()) walk_ = walk_watch_.steps();
    reach_ = motion_.before.abs().max(motion_.after.abs());
    if (!motion_.has_infinite_mass())
        reach_ = (2.0 * motion_.energy() * motion_.inverse_mass).sqrt();
    reach_ = (factor_ * reach_).max(0.25 * (factor_ * reach_).maxCoeff());
    make_plot();
}

std::shared_ptr<const PanelState> CollisionMapPanel::state(const FrameInput& input) {
    auto state = std::make_shared<MapState>();
    const double now = input.tick.time;
    while (state->steps < walk_.size() && walk_[state->steps].time <= now) ++state->steps;
    if (met_ && now >= met_->since && now <= met_->until) state->stage = now < met_->time ? 1 : 2;
    return state;
}

// The columns of some velocities, as the axes and the table show them.
std::vector<Column> CollisionMapPanel::columns(const std::vector<Vector>& velocities) const {
    std::vector<double> first, second;
    for (const Vector& velocity : velocities) {
        first.push_back(factor_[0] * velocity[0]);
        second.push_back(factor_[1] * velocity[1]);
    }
    return {column(column_of(0), std::move(first)), column(column_of(1), std::move(second))};
}

Polyline CollisionMapPanel::line(const std::vector<Vector>& through, Stroke stroke,
                                 int depth) const {
    const std::vector<Column> places = columns(through);
    Polyline line{{.depth = depth, .still = true}, places[0], places[1]};
    line.is_thinned = false;
    line.stroke = std::move(stroke);
    line.marks_exits = false;  // arrows are velocities
    return line;
}

Points CollisionMapPanel::points(const std::vector<Vector>& at, const plot::Dot& dot) const {
    const std::vector<Column> places = columns(at);
    Points points{{}, places[0], places[1]};
    points.dot = dot;
    return points;
}

Arrow CollisionMapPanel::arrow(const Vector& from, const Vector& to, const Role& role,
                               const Role& edge) const {
    const Vector start = factor_ * from, end = factor_ * to;
    return {{.depth = depth_of_arrows, .still = true},
            {start[0], start[1]},
            {end[0], end[1]},
            role,
            edge};
}

// For an infinite mass: the two velocities that the other bead can have, in the frame of the
// infinite mass.
void CollisionMapPanel::add_energy() {
    const Layer still{.depth = depth_of_energy, .still = true};
    if (motion_.has_infinite_mass()) {
        for (const Vector& through : {motion_.before, motion_.after})
            if (motion_.inverse_mass[0] > 0.0)
                whole_.layers.emplace_back(Marker{still, "", through[0], {}, of_energy});
            else
                whole_.layers.emplace_back(Level{still, "", through[1], of_energy});
        return;
    }
    const Vector half = (2.0 * motion_.energy() * motion_.inverse_mass).sqrt();
    std::vector<Vector> around;
    for (int i = 0; i <= ellipse_points; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / ellipse_points;
        around.push_back({half[0] * std::cos(turn), half[1] * std::sin(turn)});
    }
    Polyline ellipse = line(around, of_energy, depth_of_energy);
    ellipse.part = "curve";
    ellipse.of = "energy";
    whole_.layers.emplace_back(std::move(ellipse));
}

// The arrows from 0 to the motion of the centre of mass, and from there to the velocities before
// and after; in the table they list the centre of mass and the eigenvectors.
void CollisionMapPanel::add_collision() {
    const double time = met_ ? met_->time : std::nan("");
    const auto add_point = [&](const char* of, const Vector& at, const plot::Dot& dot) {
        Points point = points({at}, dot);
        static_cast<Layer&>(point) = {.part = "point", .of = of, .still = true};
        point.more = {column(whole_.columns[1], {time})};
        whole_.layers.emplace_back(std::move(point));
    };
    const auto add_arrow = [&](const char* part, const char* of, const Vector& listed,
                               Arrow arrow) {
        arrow.part = part;
        arrow.of = of;
        arrow.more = columns({listed});
        whole_.layers.emplace_back(std::move(arrow));
    };
    add_point("before", motion_.before, hollow);
    add_point("after", motion_.after, full);
    const Vector middle = Vector::Constant(motion_.mass_center_velocity());
    Arrow center = arrow(Vector::Zero(), middle, muted, page);
    Arrow before = arrow(middle, motion_.before, page, ink);
    Arrow after = arrow(middle, motion_.after, ink, page);
    center.shortest = 1.0;
    before.gap = after.gap = full.radius;
    before.shortest = after.shortest = 0.8;
    add_arrow("point", "centre of mass", middle, std::move(before));
    add_arrow("eigenvector", "1", Vector::Ones(), std::move(center));
    add_arrow("eigenvector", "-1", motion_.turning(), std::move(after));
    const Vector far =
        motion_.turning() * (10.0 * reach_.sum() / (factor_ * motion_.turning()).abs().maxCoeff());
    whole_.layers.emplace_back(
        line({motion_.before - far, motion_.before + far}, of_momentum(), depth_of_lines));
}

// Each row gives a velocity after a collision, as the axes show it, as a sum of those before it.
void CollisionMapPanel::add_matrix() {
    const Eigen::Matrix2d matrix = factor_.matrix().asDiagonal() *
                                   collision_matrix(motion_.inverse_mass) *
                                   factor_.inverse().matrix().asDiagonal();
    for (std::size_t k = 0; k < 2; ++k)
        whole_.columns.emplace_back(fmt::format("coefficient of {}", name_of(k)),
                                    quantities::coefficient);
    for (std::size_t row = 0; row < 2; ++row) {
        Layer numbers{.part = "matrix", .of = name_of(row)};
        for (std::size_t k = 0; k < 2; ++k)
            numbers.more.push_back(
                column(whole_.columns[2 + 2 + k],
                       {matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k))}));
        whole_.numbers.push_back(std::move(numbers));
    }
}

void CollisionMapPanel::make_plot() {
    whole_ = {.language = context_.language(),
              .titles = titles(),
              .x = axis(0),
              .y = axis(1),
              .has_equal_scales = true};
    whole_.columns = {{"step", quantities::ordinal}, quantities::time, column_of(0), column_of(1)};
    whole_.notes = {key(walk_.size())};
    const Layer zero{.depth = depth_of_zero, .still = true};
    const Stroke faint{.width = 0.06, .fade = 0.6};
    whole_.layers.emplace_back(Level{zero, "", 0.0, faint});
    whole_.layers.emplace_back(Marker{zero, "", 0.0, {}, faint});
    const Vector far = Vector::Constant(10.0 * reach_.sum() / factor_.maxCoeff());
    whole_.layers.emplace_back(line({-far, far}, of_equal, depth_of_equal));
    add_energy();
    if (!is_walk()) add_collision();
    add_matrix();
}

// Long walks are drawn finer.
void CollisionMapPanel::add_walk(Plot& plot, std::size_t steps) const {
    constexpr std::array causes{"start", "collision of the two", "wall", "reversal"};
    const double fine = std::sqrt(std::min(1.0, 40.0 / static_cast<double>(walk_.size())));
    const auto add_steps = [&](Cause cause, Stroke stroke) {
        std::vector<Vector> ends;
        std::vector<int> pieces;
        for (std::size_t i = 1; i < steps; ++i) {
            if (walk_[i].cause != cause) continue;
            ends.insert(ends.end(), {walk_[i - 1].velocity, walk_[i].velocity});
            pieces.insert(pieces.end(), 2, static_cast<int>(i));
        }
        stroke.width *= fine;
        Polyline line = this->line(ends, std::move(stroke), depth_of_lines);
        line.still = false;
        line.piece = std::make_shared<const std::vector<int>>(std::move(pieces));
        plot.layers.emplace_back(std::move(line));
    };
    add_steps(Cause::pair, of_steps);
    add_steps(Cause::wall, of_walls);
    std::vector<Vector> velocities;
    std::vector<double> numbers, times;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < steps; ++i) {
        velocities.push_back(walk_[i].velocity);
        numbers.push_back(static_cast<double>(i));
        times.push_back(walk_[i].time);
        names.emplace_back(causes.at(static_cast<std::size_t>(walk_[i].cause)));
    }
    Points all = points(velocities, {.role = of_steps.role, .radius = std::max(0.1, 0.22 * fine)});
    all.part = "point";
    all.of_each = std::move(names);
    all.more = {column(plot.columns[0], std::move(numbers)),
                column(plot.columns[1], std::move(times))};
    plot.layers.emplace_back(std::move(all));
    plot.layers.emplace_back(points({walk_.front().velocity}, hollow));
    if (steps > 1) plot.layers.emplace_back(points({walk_[steps - 1].velocity}, full));
}

std::optional<std::array<double, 2>> CollisionMapPanel::time_shown(double at) const {
    if (is_walk()) return {{0.0, at}};
    if (!met_) return {};
    return {{met_->time, met_->time}};
}

Plot CollisionMapPanel::plot(const PanelState* state) const {
    Plot plot = whole_;
    if (state == nullptr) return plot;
    const auto& now = static_cast<const MapState&>(*state);
    plot.account = account_of(now.steps);
    if (is_walk()) {
        plot.notes = {key(now.steps)};
        add_walk(plot, now.steps);
    } else if (now.stage > 0 && context_.in_film) {
        plot.layers.emplace_back(points({now.stage == 1 ? motion_.before : motion_.after},
                                        {.role = of_steps.role, .radius = 0.75, .ring = 0.12}));
    }
    return plot;
}

}  // namespace collision_map

namespace {

std::unique_ptr<Panel> make_collision_map(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<collision_map::CollisionMapPanel>(context, spec);
}

}  // namespace

PanelKind collision_map_kind() {
    using enum Ability;
    return {.name = "collision-map",
            .words = Phrase{"collision map"},
            .shows =
                "Collisions of two beads on a line, in the plane of their two velocities: see "
                "[Figures](figures.md#collision-maps).",
            .make = make_collision_map,
            .abilities = {of, pair},
            .keys = option_keys(collision_map_keys()),
            .rule = check_collision_map,
            .has_own_time =
                [](const PanelSpec& spec) { return !spec.options.as<CollisionMapOptions>().walk; },
            .work = always(PanelWork{.flights = PanelWork::Flights::recorded}),
            .in_space_instead = "give the box a `length` instead: it shows beads on a wire"};
}

}  // namespace carom

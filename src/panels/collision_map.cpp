#include "panels/collision_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "panels/bead_words.h"
#include "panels/registry.h"
#include "panels/velocity_arrows.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double above = 2.8, below = 1.6;                         // units: title and axis
constexpr double row = 1.5, sample = 2.0, gap = 0.5, apart = 1.4;  // units: of the key
constexpr double beyond = 1.15;                 // of the largest velocities, that the plane shows
constexpr double thinnest = 0.8, widest = 1.6;  // of the plane beside its key, width over height
constexpr int ellipse_points = 240;
constexpr double point_radius = 0.36;  // units

using Vector = Eigen::Array2d;
using Cause = WalkStep::Cause;

struct MapState : PanelState {
    std::size_t steps = 0;  // of the walk, so far
    int stage = 0;          // of the collision shown: 1 before, 2 after, 0 another flight
};

// Three digits, without zeros at the end.
std::string few_digits(double value) {
    return plain_number(std::stod(fmt::format("{:.3g}", off_the_tie(value))));
}

// Two momenta that cancel but for round-off are none.
std::string momentum_words(const PairMotion& motion) {
    const double least = 1e-12 * (motion.before / motion.inverse_mass).abs().maxCoeff();
    return few_digits(std::abs(motion.momentum()) < least ? 0.0 : motion.momentum());
}

Point toward(const Point& from, const Point& to, double distance) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const double share = length > 0.0 ? distance / length : 0.0;
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

ArrowStyle arrow_style(const Page& page, Color color, Color edge) {
    return collision_arrow(page, color, edge, 0.08);
}

ArrowStyle solid_arrow(const Page& page) {
    return arrow_style(page, page.theme.ink, page.theme.page);
}
ArrowStyle open_arrow(const Page& page) {
    return arrow_style(page, page.theme.page, page.theme.ink);
}
ArrowStyle grey_arrow(const Page& page) {
    return arrow_style(page, page.theme.muted, page.theme.page);
}

Color momentum_color(const Page& page) { return edge_of(page.theme.highlight, page.theme); }
std::vector<double> dots(const Page& page) { return {0.12 * page.unit, 0.3 * page.unit}; }
std::vector<double> dashes(const Page& page) { return {0.4 * page.unit, 0.3 * page.unit}; }

void draw_point(Canvas& canvas, const Page& page, Point at, double radius, bool hollow) {
    canvas.fill_circle(at, radius + 0.1 * page.unit, page.theme.page);
    canvas.fill_circle(at, radius, page.theme.ink);
    if (hollow) canvas.fill_circle(at, 0.58 * radius, page.theme.page);
}

Vector largest(const Vector& a, const Vector& b) { return a.abs().max(b.abs()); }

}  // namespace

Point VelocityPlane::operator()(const Eigen::Array2d& velocity) const {
    const Vector v = scale * factor * velocity;
    return {area.x + area.width / 2 + v[0], area.y + area.height / 2 - v[1]};
}

Scale VelocityPlane::across() const {
    const double end = area.width / 2 / scale;
    return {-end, end, area.x, area.right()};
}

Scale VelocityPlane::up() const {
    const double end = area.height / 2 / scale;
    return {-end, end, area.bottom(), area.y};
}

enum class MapMark { hollow, filled, energy, momentum, walls, equal, center, turning };

struct CollisionMapPanel::KeyEntry {
    MapMark mark;
    std::string words;  // markup
    bool is_point() const { return mark == MapMark::hollow || mark == MapMark::filled; }
};

struct CollisionMapPanel::Places {
    Rect plane;
    std::vector<Point> key;        // of as many entries as there is room for
    std::vector<double> sample{};  // width of the sample of each, units
};

struct CollisionMapPanel::Counts {
    std::int64_t pair = 0, wall = 0;
};

CollisionMapPanel::CollisionMapPanel(const Cast& cast, const PanelSpec& spec)
    : cast_(cast), spec_(spec), watch_(cast, spec), walk_watch_(cast, spec) {}

void CollisionMapPanel::survey(const Observation& observation) {
    if (spec_.given) return;
    watch_.survey(observation);
    if (is_walk()) walk_watch_.survey(observation);
}

void CollisionMapPanel::settle() {
    if (spec_.given) {
        motion_ = {.inverse_mass = spec_.given->inverse_mass, .before = spec_.given->velocity};
        motion_.after = (collision_matrix(motion_.inverse_mass) * motion_.before.matrix()).array();
    } else {
        met_ = watch_.meeting();
        for (std::size_t k = 0; k < 2; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            number_[k] = met_->particle[k];
            motion_.inverse_mass[i] = cast_.particles.inverse_mass[met_->particle[k]];
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

std::shared_ptr<const PanelState> CollisionMapPanel::state(const Observation& observation) {
    auto state = std::make_shared<MapState>();
    const double now = observation.tick.time;
    while (state->steps < walk_.size() && walk_[state->steps].time <= now) ++state->steps;
    if (met_ && now >= met_->since && now <= met_->until) state->stage = now < met_->time ? 1 : 2;
    return state;
}

CollisionMapPanel::Counts CollisionMapPanel::counts_of(std::size_t steps) const {
    Counts counts;
    for (std::size_t i = 0; i < steps; ++i) {
        if (walk_[i].cause == Cause::pair) ++counts.pair;
        if (walk_[i].cause == Cause::wall) ++counts.wall;
    }
    return counts;
}

std::string CollisionMapPanel::subscripted(const char* letter, std::size_t k) const {
    constexpr std::array lowered{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string words = letter;
    for (const char digit : std::to_string(number_[k]))
        words += lowered[static_cast<std::size_t>(digit - '0')];
    return words;
}

std::string CollisionMapPanel::velocity_name(std::size_t k) const {
    return (is_scaled() ? "√" + subscripted("m", k) + "\u2009" : "") + subscripted("v", k);
}

// Numbers that are 0 but for round-off are 0.
std::string CollisionMapPanel::vector_words(const Vector& velocity) const {
    const double least = 1e-9 * velocity.abs().maxCoeff();
    const auto words = [&](double v) { return few_digits(std::abs(v) < least ? 0.0 : v); };
    return "(" + words(velocity[0]) + ", " + words(velocity[1]) + ")";
}

std::string CollisionMapPanel::pair_title(const Theme& theme) const {
    if (met_) return names_of(cast_, *met_, theme);
    return fmt::format("masses {} and {}", mass_text(motion_.inverse_mass[0]),
                       mass_text(motion_.inverse_mass[1]));
}

std::vector<CollisionMapPanel::KeyEntry> CollisionMapPanel::key(std::size_t steps) const {
    const std::string v0 = subscripted("v", 0), v1 = subscripted("v", 1);
    if (is_walk()) {
        const Counts counts = counts_of(steps);
        return {{MapMark::hollow, "start"},
                {MapMark::filled, spec_.at ? "at time " + plain_number(*spec_.at) : "present"},
                {MapMark::energy, "energy " + few_digits(motion_.energy())},
                {MapMark::momentum, "with each other: " + grouped(counts.pair)},
                {MapMark::walls, "with a wall: " + grouped(counts.wall)},
                {MapMark::equal, v0 + " = " + v1}};
    }
    std::vector<KeyEntry> entries{{MapMark::hollow, "before " + vector_words(motion_.before)},
                                  {MapMark::filled, "after " + vector_words(motion_.after)}};
    if (motion_.has_infinite_mass()) {
        const std::size_t wall = motion_.inverse_mass[0] > 0.0 ? 1 : 0;
        const double velocity = motion_.before[static_cast<Eigen::Index>(wall)];
        entries.push_back({MapMark::energy, "no ellipse: |" + v0 + " − " + v1 +
                                                "| = " + few_digits(motion_.speed_apart())});
        entries.push_back(
            {MapMark::momentum, (wall == 0 ? v0 : v1) + " = " + few_digits(velocity) + ", mass ∞"});
    } else {
        entries.push_back({MapMark::energy, "energy " + few_digits(motion_.energy())});
        entries.push_back({MapMark::momentum, "momentum " + momentum_words(motion_)});
    }
    const Vector stays = factor_ / factor_[0];
    Vector turns = factor_ * motion_.turning();
    turns /= turns[0] != 0.0 ? turns[0] : turns[1];
    entries.push_back({MapMark::center, vector_words(stays) + " stays"});
    entries.push_back({MapMark::turning, vector_words(turns) + " turns round"});
    return entries;
}

// The key stands beside the plane or above it, whichever leaves the plane larger; `left` is for the
// labels of the axis.
CollisionMapPanel::Places CollisionMapPanel::places(const Page& page, double left) const {
    const double u = page.unit;
    const std::vector<KeyEntry> entries = key(walk_.size());
    std::vector<double> words, level, short_ones;  // in a column the words begin at one place
    for (const KeyEntry& entry : entries) {
        words.push_back(gap * u + measure_text(entry.words, label_style(page)).width);
        level.push_back(sample);
        short_ones.push_back(entry.is_point() ? 2.5 * point_radius : sample);
    }
    const Rect whole{page.area.x + left, page.area.y + above * u,
                     std::max(u, page.area.width - left),
                     std::max(u, page.area.height - (above + below) * u)};
    const Places beside = places_beside(page, whole, words, level);
    const Places over = places_over(page, whole, words, short_ones);
    const double gain = plane_in(beside.plane).scale - plane_in(over.plane).scale;
    return gain > 0.0 ? beside : over;
}

CollisionMapPanel::Places CollisionMapPanel::places_beside(
    const Page& page, const Rect& whole, const std::vector<double>& words,
    const std::vector<double>& samples) const {
    const double u = page.unit;
    const double column = *std::ranges::max_element(words) + (samples.front() + apart) * u;
    const double ratio = std::clamp(reach_[0] / reach_[1], thinnest, widest);
    Places found{whole, {}, samples};
    found.plane.width = std::clamp(whole.width - column, 0.1 * u, ratio * whole.height);
    Point at{found.plane.right() + apart * u, whole.y + u};
    for (std::size_t i = 0; i < words.size(); ++i, at.y += row * u) {
        if (at.y > whole.bottom()) at = {at.x + column, whole.y + u};
        if (at.x + samples[i] * u + words[i] > page.area.right() + 1e-6) break;
        found.key.push_back(at);
    }
    return found;
}

// In rows, as many as leave half of the height.
CollisionMapPanel::Places CollisionMapPanel::places_over(const Page& page, const Rect& whole,
                                                         const std::vector<double>& words,
                                                         const std::vector<double>& samples) const {
    const double u = page.unit;
    Places found{whole, {}, samples};
    Point at{page.area.x, whole.y - 0.05 * u};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const double width = samples[i] * u + words[i];
        if (at.x > page.area.x && at.x + width > page.area.right())
            at = {page.area.x, at.y + row * u};
        if (at.y > whole.y + 0.45 * whole.height || at.x + width > page.area.right()) break;
        found.key.push_back(at);
        at.x += width + apart * u;
    }
    if (found.key.empty()) return found;
    const double taken = found.key.back().y + 1.85 * u - whole.y;
    found.plane.y += taken;
    found.plane.height = std::max(u, whole.height - taken);
    return found;
}

CollisionMapPanel::Places CollisionMapPanel::places(const Page& page) const {
    const double least = 3.0 * page.unit;
    const Scale up = plane_in(places(page, least).plane).up();
    return places(page, std::max(least, y_axis_space(up, axis_style(page))));
}

VelocityPlane CollisionMapPanel::plane_in(const Rect& area) const {
    return {area, factor_,
            std::min(area.width / (2.0 * beyond * reach_[0]),
                     area.height / (2.0 * beyond * reach_[1]))};
}

VelocityPlane CollisionMapPanel::plane(const Page& page) const {
    return plane_in(places(page).plane);
}

void CollisionMapPanel::draw_sample(Canvas& canvas, const Page& page, const KeyEntry& entry,
                                    Point at, double wide) const {
    const double u = page.unit, y = at.y - 0.35 * u, end = at.x + wide * u;
    const Point middle{at.x + 0.5 * wide * u, y};
    const std::array line{Point{at.x, y}, Point{end, y}};
    const Color grey = page.theme.muted;
    switch (entry.mark) {
        case MapMark::hollow:
        case MapMark::filled:
            draw_point(canvas, page, middle, point_radius * u, entry.mark == MapMark::hollow);
            break;
        case MapMark::energy:
            canvas.stroke_line(line[0], line[1], 0.16 * u, grey);
            break;
        case MapMark::momentum:
            canvas.stroke_path(line, 0.14 * u, momentum_color(page),
                               is_walk() ? std::vector<double>{} : line_dashes(1, 2, page));
            break;
        case MapMark::walls:
            canvas.stroke_path(line, 0.11 * u, grey, dashes(page));
            break;
        case MapMark::equal:
            canvas.stroke_path(line, 0.1 * u, grey, dots(page));
            break;
        case MapMark::center:
            canvas.stroke_path(line, 0.1 * u, grey, dots(page));
            draw_arrow(canvas, line[0], {at.x + 0.6 * wide * u, y}, grey_arrow(page));
            break;
        case MapMark::turning:
            draw_arrow(canvas, middle, line[0], open_arrow(page));
            draw_arrow(canvas, middle, line[1], solid_arrow(page));
            break;
    }
}

void CollisionMapPanel::draw_key(Canvas& canvas, const Page& page, std::size_t steps) const {
    const std::vector<KeyEntry> entries = key(steps);
    const Places at = places(page);
    for (std::size_t i = 0; i < at.key.size(); ++i) {
        draw_sample(canvas, page, entries[i], at.key[i], at.sample[i]);
        draw_text(canvas, {at.key[i].x + (at.sample[i] + gap) * page.unit, at.key[i].y},
                  entries[i].words, label_style(page));
    }
}

void CollisionMapPanel::draw_axes(Canvas& canvas, const Page& page, const VelocityPlane& to) const {
    const double u = page.unit;
    const Point zero = to(Vector::Zero());
    const Color faint = mix(page.theme.muted, page.theme.page, 0.6);
    canvas.stroke_line({to.area.x, zero.y}, {to.area.right(), zero.y}, 0.06 * u, faint);
    canvas.stroke_line({zero.x, to.area.y}, {zero.x, to.area.bottom()}, 0.06 * u, faint);
    const auto name = [&](std::size_t k) {
        return met_ ? colored(velocity_name(k), color_of(cast_, *met_, k, page.theme), page.theme)
                    : velocity_name(k);
    };
    draw_x_axis(canvas, to.area, to.across(), name(0), axis_style(page));
    draw_y_axis(canvas, to.area, to.up(), "", axis_style(page));
    draw_text(canvas, {to.area.x + 0.4 * u, to.area.y - 0.4 * u}, name(1), label_style(page));
}

// A line across the whole plane.
void CollisionMapPanel::draw_along(Canvas& canvas, const VelocityPlane& to, const Vector& through,
                                   const Vector& direction, double width, Color color,
                                   std::span<const double> dashes) const {
    const Vector step = direction * ((to.area.width + to.area.height) / to.scale /
                                     (factor_ * direction).abs().maxCoeff());
    const std::array line{to(through - step), to(through + step)};
    canvas.clip_to(to.area);
    canvas.stroke_path(line, width, color, dashes);
    canvas.release_clip();
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
void CollisionMapPanel::draw_energy(Canvas& canvas, const Page& page,
                                    const VelocityPlane& to) const {
    const double width = 0.16 * page.unit;
    if (!motion_.has_infinite_mass()) {
        std::vector<Point> path;
        for (const Vector& point : ellipse()) path.push_back(to(point));
        canvas.stroke_path(path, width, page.theme.muted);
        return;
    }
    const Vector across = motion_.inverse_mass[0] > 0.0 ? Vector{0.0, 1.0} : Vector{1.0, 0.0};
    for (const Vector& through : {motion_.before, motion_.after})
        draw_along(canvas, to, through, across, width, page.theme.muted, {});
}

void CollisionMapPanel::draw_collision(Canvas& canvas, const Page& page,
                                       const VelocityPlane& to) const {
    const double u = page.unit;
    const Vector middle = Vector::Constant(motion_.mass_center_velocity());
    draw_along(canvas, to, motion_.before, motion_.turning(), 0.14 * u, momentum_color(page),
               line_dashes(1, 2, page));
    const Point center = to(middle), zero = to(Vector::Zero());
    if (distance(zero, center) > u) draw_arrow(canvas, zero, center, grey_arrow(page));
    const auto draw_part = [&](const Vector& end, const ArrowStyle& style) {
        const Point at = to(end);
        const double length = distance(center, at) - point_radius * u;
        if (length > 0.8 * u) draw_arrow(canvas, center, toward(center, at, length), style);
    };
    draw_part(motion_.before, open_arrow(page));
    draw_part(motion_.after, solid_arrow(page));
    draw_point(canvas, page, to(motion_.before), point_radius * u, true);
    draw_point(canvas, page, to(motion_.after), point_radius * u, false);
}

void CollisionMapPanel::draw_ground(Canvas& canvas, const Page& page) const {
    const std::string of = pair_title(page.theme);
    const std::vector<std::string> titles =
        is_walk() ? std::vector<std::string>{"Velocities of " + of + ", collision by collision",
                                             "Velocities, collision by collision", "Velocities"}
                  : std::vector<std::string>{"Velocities of " + of + " in their collision",
                                             "Velocities of " + of, "Velocities in a collision"};
    draw_panel_title(canvas, page,
                     spec_.title ? escape_markup(*spec_.title) : fitting_title(page, titles));
    const VelocityPlane to = plane(page);
    draw_axes(canvas, page, to);
    draw_along(canvas, to, Vector::Zero(), Vector::Ones(), 0.1 * page.unit, page.theme.muted,
               dots(page));
    draw_energy(canvas, page, to);
    if (is_walk()) return;
    draw_collision(canvas, page, to);
    draw_key(canvas, page, 0);
}

void CollisionMapPanel::draw_walk(Canvas& canvas, const Page& page, const VelocityPlane& to,
                                  std::size_t steps) const {
    const double u = page.unit;
    const double fine = std::sqrt(std::min(1.0, 40.0 / static_cast<double>(walk_.size())));
    for (std::size_t i = 1; i < steps; ++i) {
        const std::array line{to(walk_[i - 1].velocity), to(walk_[i].velocity)};
        if (walk_[i].cause == Cause::pair)
            canvas.stroke_path(line, 0.13 * fine * u, momentum_color(page));
        else if (walk_[i].cause == Cause::wall)
            canvas.stroke_path(line, 0.11 * fine * u, page.theme.muted, dashes(page));
    }
    for (std::size_t i = 0; i < steps; ++i)
        canvas.fill_circle(to(walk_[i].velocity), std::max(0.1, 0.22 * fine) * u,
                           momentum_color(page));
    draw_point(canvas, page, to(walk_.front().velocity), point_radius * u, true);
    if (steps > 1) draw_point(canvas, page, to(walk_[steps - 1].velocity), point_radius * u, false);
}

void CollisionMapPanel::draw(Canvas& canvas, const Page& page, const PanelState& state) const {
    const auto& now = static_cast<const MapState&>(state);
    const VelocityPlane to = plane(page);
    if (is_walk()) {
        draw_walk(canvas, page, to, now.steps);
        draw_key(canvas, page, now.steps);
        return;
    }
    if (now.stage == 0 || !cast_.in_film) return;
    const Point at = to(now.stage == 1 ? motion_.before : motion_.after);
    canvas.stroke_circle(at, 0.75 * page.unit, 0.12 * page.unit, momentum_color(page));
}

Table CollisionMapPanel::table(const PanelState& state, const Theme&) const {
    const auto column = [&](std::size_t k) {
        const auto number = number_[k];
        return is_scaled()
                   ? column_name(fmt::format("sqrt(m{0}) v{0}", number), "mass^0.5 length/time")
                   : column_name(fmt::format("v{}", number), reduced::speed);
    };
    Table table{
        {"part", "of", "step (number)", column_name("time", reduced::time), column(0), column(1)}};
    const auto add = [&](const char* part, const char* of, Cell step, double time,
                         const Vector& v) {
        const Vector at = factor_ * v;
        table.rows.push_back({part, of, std::move(step), time, at[0], at[1]});
    };
    const double none = std::nan("");
    if (!motion_.has_infinite_mass())
        for (const Vector& point : ellipse()) add("curve", "energy", {}, none, point);
    if (is_walk()) {
        constexpr std::array causes{"start", "collision of the two", "wall", "reversal"};
        for (std::size_t i = 0; i < static_cast<const MapState&>(state).steps; ++i)
            add("point", causes.at(static_cast<std::size_t>(walk_[i].cause)), std::int64_t(i),
                walk_[i].time, walk_[i].velocity);
        return table;
    }
    const double time = met_ ? met_->time : none;
    add("point", "before", {}, time, motion_.before);
    add("point", "after", {}, time, motion_.after);
    add("point", "centre of mass", {}, none, Vector::Constant(motion_.mass_center_velocity()));
    add("eigenvector", "1", {}, none, Vector::Ones());
    add("eigenvector", "-1", {}, none, motion_.turning());
    return table;
}

std::string CollisionMapPanel::account(const PanelState& state) const {
    const auto mass = [&](Eigen::Index k) {
        return motion_.inverse_mass[k] > 0.0 ? "mass " + mass_text(motion_.inverse_mass[k])
                                             : std::string("infinite mass");
    };
    const auto both = [](const Vector& v) {
        const double least = 1e-9 * v.abs().maxCoeff();
        const auto words = [&](double x) { return few_digits(std::abs(x) < least ? 0.0 : x); };
        return words(v[0]) + " and " + words(v[1]);
    };
    const std::string pair = fmt::format("Beads of {} and {}", mass(0), mass(1));
    if (is_walk()) {
        const std::size_t steps = static_cast<const MapState&>(state).steps;
        const Counts counts = counts_of(steps);
        return fmt::format(
            "{} at energy {}: {} collisions with one another and {} with a wall, from velocities "
            "{} to {}.",
            pair, few_digits(motion_.energy()), grouped(counts.pair), grouped(counts.wall),
            both(walk_.front().velocity), both(walk_[steps - 1].velocity));
    }
    const std::string kept =
        motion_.has_infinite_mass()
            ? fmt::format("the infinite mass goes on as before, and their relative speed stays {}",
                          few_digits(motion_.speed_apart()))
            : fmt::format("energy {} and momentum {} stay", few_digits(motion_.energy()),
                          momentum_words(motion_));
    return fmt::format("{} with velocities {} before their collision and {} after it: {}.", pair,
                       both(motion_.before), both(motion_.after), kept);
}

std::unique_ptr<Panel> make_collision_map(const Cast& cast, const PanelSpec& spec) {
    return std::make_unique<CollisionMapPanel>(cast, spec);
}

}  // namespace carom

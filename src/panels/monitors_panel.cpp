#include "panels/monitors_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "stats/speed_classes.h"
#include "util/text.h"

namespace carom {
namespace {

struct MonitorsState : PanelState {
    double time = 0.0;
    std::int64_t collisions = 0;
    double mean_speed = 0.0;
    double mean_energy = 0.0;
    std::array<double, 3> shares{};
    double arrow = 0.0;  // turn of the clock's arrow: 0 forward, 1 back
};

struct Column {
    const char* label;
    double left;  // share of the row's width
};
constexpr std::array columns{Column{"time", 0.0},         Column{"collisions", 0.15},
                             Column{"mean speed", 0.315}, Column{"mean energy", 0.48},
                             Column{"slow", 0.67},        Column{"medium", 0.79},
                             Column{"fast", 0.915}};

// As many decimals as show three digits of the largest value, so that only digits change.
std::string fixed_digits(double value, double largest) {
    if (!std::isfinite(value)) return "–";
    if (largest <= 0.0) return "0";
    const int before = static_cast<int>(std::floor(std::log10(largest))) + 1;
    if (before < -2 || before > 5) return three_digits(value);
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), std::max(0, 3 - before));
    return value < 0.0 ? "\u2212" + digits : digits;
}

// Whole per cent, one digit padded by a figure space.
std::string percent(double share) {
    const auto whole = std::to_string(std::lround(100.0 * share));
    std::string padding;
    for (std::size_t i = whole.size(); i < 2; ++i) padding += "\u2007";
    return padding + whole + "\u2009%";
}

// A triangle that points along the direction of time; `turn` from 0 (right) to 1 (left).
void draw_arrow(Canvas& canvas, Point center, double size, double turn, Color color) {
    std::array<Point, 3> corners;
    const double angle = turn * std::numbers::pi;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double a = angle + 2.0 * std::numbers::pi * static_cast<double>(i) / 3.0;
        corners[i] = {center.x + size * std::cos(a), center.y + size * std::sin(a)};
    }
    canvas.fill_polygon(corners, color);
}

}  // namespace

void MonitorsPanel::survey(const Observation& observation) {
    largest_speed_ = std::max(largest_speed_, observation.speed.mean());
    largest_energy_ = std::max(largest_energy_, observation.energy.mean());
}

std::shared_ptr<const PanelState> MonitorsPanel::state(const Observation& observation) {
    auto state = std::make_shared<MonitorsState>();
    state->time = folded_time(cast_.scene.run, observation.tick.time);
    state->collisions = observation.passage.counts.particle;
    state->mean_speed = observation.speed.mean();
    state->mean_energy = observation.energy.mean();
    state->shares = class_shares(observation.speed, state->mean_speed);
    const bool turning = observation.tick.phase == Phase::reversing;
    const int before = observation.tick.reversals - (turning && observation.tick.progress > 0.5);
    const double turned = turning ? observation.tick.progress : 0.0;
    state->arrow = before + turned * turned * (3.0 - 2.0 * turned);
    return state;
}

// In a row a number stands under its label, in a panel beside it, in two columns.
MonitorsPanel::Place MonitorsPanel::place(const Page& page, std::size_t index) const {
    const double u = page.unit;
    const Rect& area = page.area;
    if (in_row_) {
        const double x = area.x + columns[index].left * area.width;
        return {{x, area.y + u}, {x, area.y + 2.9 * u}};
    }
    const double left = area.x + (index < 4 ? 0.0 : 0.54 * area.width);
    const double step = std::min(2.9 * u, (area.height - 1.5 * u) / 3.0);
    const double y = area.y + 1.5 * u + step * static_cast<double>(index % 4);
    return {{left, y}, {left + (index < 4 ? 0.27 : 0.22) * area.width, y}};
}

void MonitorsPanel::draw_ground(Canvas& canvas, const Page& page) const {
    TextStyle style = label_style(page);
    style.size = 1.035 * page.unit;
    for (std::size_t i = 0; i < columns.size(); ++i)
        draw_text(canvas, place(page, i).label, columns[i].label, style);
}

void MonitorsPanel::draw(Canvas& canvas, const Page& page, const PanelState& state) const {
    const auto& now = static_cast<const MonitorsState&>(state);
    const std::array<std::string, columns.size()> numbers{
        fixed_digits(now.time, cast_.scene.run.until),
        now.collisions < 1'000'000 ? grouped(now.collisions)
                                   : three_digits(static_cast<double>(now.collisions)),
        fixed_digits(now.mean_speed, largest_speed_),
        fixed_digits(now.mean_energy, largest_energy_),
        percent(now.shares[0]),
        percent(now.shares[1]),
        percent(now.shares[2])};
    TextStyle style = title_style(page);
    style.size = 1.53 * page.unit;
    for (std::size_t i = 0; i < columns.size(); ++i)
        draw_text(canvas, place(page, i).number, numbers[i], style);
    if (cast_.scene.run.events.empty()) return;
    const Point time = place(page, 0).number;
    const double x = page.area.x + (in_row_ ? 0.112 : 0.48) * page.area.width;
    draw_arrow(canvas, {x, time.y - 0.55 * page.unit}, 0.6 * page.unit, now.arrow,
               page.theme.accent);
}

}  // namespace carom

#include "panels/plots/points_panel.h"

#include <algorithm>
#include <cmath>

#include "stats/histogram.h"

namespace carom {
namespace {

struct PointsState : PanelState {
    std::vector<std::vector<Point>> sets;
    std::size_t shown = 0;
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const std::vector<Point>& set : sets) sum += set.size() * sizeof(Point);
        return sum;
    }
};

constexpr std::size_t kept_a_frame = 200;   // numbers that the axis is fixed by
constexpr std::size_t longest_path = 5000;  // points: drawing must not grow with the film

}  // namespace

// What a film of many frames, or of many collisions, shows of a path.
std::pair<std::size_t, std::size_t> PointsPanel::Path::until(std::size_t frames) const {
    if (ends.empty()) return {0, 0};
    const std::size_t end = ends[std::min(frames, ends.size()) - 1];
    return {end > longest_path ? end - longest_path : 0, end};
}

struct PointsPanel::Scales {
    Rect area;
    Scale x, y;
    Point operator()(const Point& p) const {
        return {x(p.x), std::clamp(y(p.y), area.y, area.bottom())};
    }
};

const std::vector<Point>& PointsPanel::points(const PanelState& state, std::size_t set) {
    return static_cast<const PointsState&>(state).sets[set];
}

void PointsPanel::survey(const FrameInput& input) {
    paths_.resize(subject_.sets);
    for (std::size_t k = 0; k < subject_.sets; ++k) {
        const std::vector<Point> now = subject_.points(input, k);
        if (now.size() == 1) {
            std::vector<Point>& path = paths_[k].points;
            if (subject_.corners)
                for (const Point& corner : subject_.corners(input, k)) path.push_back(corner);
            path.push_back(now.front());
            paths_[k].ends.push_back(path.size());
        }
        const std::size_t stride = std::max<std::size_t>(1, now.size() / kept_a_frame);
        for (std::size_t i = surveyed_ % stride; i < now.size(); i += stride)
            pool_.push_back(std::abs(now[i].y));
    }
    ++surveyed_;
}

void PointsPanel::fix_axes() {
    if (subject_.height) {
        std::tie(low_, high_) = *subject_.height;
    } else {
        const double most = pool_.empty() ? 0.0 : 1.1 * quantile(pool_, 0.995);
        high_ = most > 0.0 && std::isfinite(most) ? round_up_for_axis(most) : 1.0;
        low_ = -high_;
    }
    pool_ = {};
}

std::shared_ptr<const PanelState> PointsPanel::state(const FrameInput& input) {
    auto state = std::make_shared<PointsState>();
    for (std::size_t k = 0; k < subject_.sets; ++k)
        state->sets.push_back(subject_.points(input, k));
    state->shown = ++seen_;
    return state;
}

PointsPanel::Scales PointsPanel::scales(const DrawContext& dc) const {
    const Rect area = plot_area(dc);
    return {area,
            {subject_.width.first, subject_.width.second, area.x, area.right()},
            {low_, high_, area.bottom(), area.y}};
}

void PointsPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    draw_panel_title(canvas, dc, fitting_title(dc, subject_.titles(dc.theme)));
    const Scales s = scales(dc);
    draw_x_axis(canvas, s.area, s.x, subject_.across, axis_style(dc));
    draw_y_axis(canvas, s.area, s.y, "", axis_style(dc));
    if (low_ < 0.0)
        canvas.stroke_dashed({s.area.x, s.y(0.0)}, {s.area.right(), s.y(0.0)}, 0.06 * dc.unit,
                             0.3 * dc.unit, dc.theme.muted);
    if (subject_.never_equal)
        canvas.stroke_dashed(s({subject_.width.first, subject_.width.first}),
                             s({subject_.width.second, subject_.width.second}), 0.06 * dc.unit,
                             0.3 * dc.unit, dc.theme.muted);
    draw_text(canvas, {s.area.x + 0.4 * dc.unit, s.area.y - 0.1 * dc.unit}, subject_.up,
              label_style(dc));
}

// Whether a step goes around the box.
bool PointsPanel::breaks_between(const Point& from, const Point& to) const {
    return (subject_.breaks_across > 0.0 && std::abs(to.x - from.x) > subject_.breaks_across) ||
           (subject_.breaks_up > 0.0 && std::abs(to.y - from.y) > subject_.breaks_up);
}

void PointsPanel::draw_path(Canvas& canvas, const DrawContext& dc, std::size_t set,
                            std::size_t shown) const {
    const Scales s = scales(dc);
    const std::vector<Point>& all = paths_[set].points;
    const auto [first, end] = paths_[set].until(shown);
    const Color color = edge_of(subject_.color(set, dc.theme), dc.theme);
    // Dashes of a path that goes to and fro add up to a thicket. Two are told apart by their greys,
    // and by the points at their ends.
    std::vector<double> dashes;
    if (subject_.sets > 2) dashes = line_dashes(set, subject_.sets, dc);
    std::vector<Point> path;
    for (std::size_t i = first; i < end; ++i) {
        if (!path.empty() && breaks_between(all[i - 1], all[i])) {
            canvas.stroke_path(path, 0.1 * dc.unit, color, dashes);
            path.clear();
        }
        path.push_back(s(all[i]));
    }
    if (!path.empty()) canvas.stroke_path(path, 0.1 * dc.unit, color, dashes);
}

void PointsPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const PointsState&>(state);
    const Scales s = scales(dc);
    for (std::size_t k = 0; k < now.sets.size(); ++k) draw_path(canvas, dc, k, now.shown);
    for (std::size_t k = 0; k < now.sets.size(); ++k) {
        const bool has_path = now.sets[k].size() == 1;
        const double radius = (has_path ? 0.35 : 0.16) * dc.unit;
        const Color color = subject_.color(k, dc.theme);
        const bool hollow = dc.theme.kind == ThemeKind::print && looks_hollow(color, dc.theme);
        for (const Point& point : now.sets[k]) {
            if (has_path)  // its own path and others' end before it
                canvas.fill_circle(s(point), radius + 0.12 * dc.unit, dc.theme.page);
            canvas.fill_circle(s(point), radius, edge_of(color, dc.theme));
            if (hollow) canvas.fill_circle(s(point), 0.6 * radius, dc.theme.page);
        }
    }
}

// A path that goes around the box has several pieces.
Table PointsPanel::table(const PanelState& state, const Theme&) const {
    Table table{{"part", "of", "piece (number)", subject_.columns.first, subject_.columns.second}};
    const auto& now = static_cast<const PointsState&>(state);
    for (std::size_t k = 0; k < now.sets.size(); ++k) {
        for (const Point& point : now.sets[k])
            table.rows.push_back({"point", subject_.names.at(k), {}, point.x, point.y});
        const std::vector<Point>& path = paths_[k].points;
        const auto [first, end] = paths_[k].until(now.shown);
        std::int64_t piece = 0;
        for (std::size_t i = first; i < end; ++i) {
            const Point& point = path[i];
            const bool stands = i > first && point.x == path[i - 1].x && point.y == path[i - 1].y;
            if (stands) continue;
            if (i > first && breaks_between(path[i - 1], point)) ++piece;
            table.rows.push_back({"path", subject_.names.at(k), piece, point.x, point.y});
        }
    }
    return table;
}

}  // namespace carom

// How far the gas is from where it was, on its way home after a reversal: the largest distance and
// the root of the mean square, over powers of ten, against the time since the reversal.
#include <algorithm>
#include <array>
#include <cmath>

#include "panels/registry.h"
#include "panels/way_home.h"
#include "util/text.h"

namespace carom {
namespace {

struct HomeState : PanelState {
    std::size_t shown = 0;  // steps
};

constexpr double floor_height = 1.5;  // of the band for distances of exactly 0

enum class Line { largest, root_mean_square };

const char* name_of(Line line) { return line == Line::largest ? "largest" : "root mean square"; }

double value_of(const WayHome::Step& step, Line line) {
    return line == Line::largest ? step.apart.largest : step.apart.root_mean_square;
}

// -infinity for 0; finite also where the value is too small for a double.
double log_of(const WayHome::Step& step, Line line) {
    return line == Line::largest ? step.apart.log10_largest : step.apart.log10_root_mean_square;
}

Color color_of(Line line, const Theme& theme) {
    return edge_of(line == Line::largest ? theme.highlight : theme.bar, theme);
}

double dash_of(Line line, double unit) { return line == Line::largest ? 0.0 : 0.5 * unit; }

class ReturnDistancePanel : public Panel {
  public:
    ReturnDistancePanel(const Cast& cast, const PanelSpec& spec)
        : cast_(cast), spec_(spec), way_home_(cast) {}

    void survey(const Observation& observation) override { way_home_.survey(observation); }
    void settle() override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

  private:
    struct Scales {
        Rect area;
        Scale x, y;  // y of decimal logarithms
        Point operator()(const WayHome::Step& step, Line line) const {
            const double power = log_of(step, line);
            const double height =
                std::isfinite(power) ? std::clamp(y(power), area.y, y.from) : area.bottom();
            return {x(step.since), height};
        }
    };
    Scales scales(const Page& page) const;
    void draw_floor(Canvas& canvas, const Page& page) const;
    void draw_note(Canvas& canvas, const Page& page) const;
    void draw_level(Canvas& canvas, const Page& page) const;
    void draw_home(Canvas& canvas, const Page& page) const;
    void draw_way(Canvas& canvas, const Page& page, std::size_t from, std::size_t to, Line line,
                  bool is_present) const;

    Cast cast_;
    PanelSpec spec_;
    WayHome way_home_;
    double low_ = -16.0, high_ = 0.0;  // powers of ten
    double last_ = 1.0;                // of the time axis
    double radius_ = 0.0;              // to compare with; 0: none
};

void ReturnDistancePanel::settle() {
    way_home_.settle();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double least = infinity, most = -infinity, last = 0.0;  // powers of ten, and a time
    for (const WayHome::Step& step : way_home_.steps()) {
        if (!step.is_known) continue;
        last = std::max(last, step.since);
        most = std::max(most, step.apart.log10_largest);
        for (const Line line : {Line::largest, Line::root_mean_square})
            if (std::isfinite(log_of(step, line))) least = std::min(least, log_of(step, line));
    }
    if (last > 0.0) last_ = last;
    radius_ = cast_.particles.count() > 0 ? cast_.particles.radius.mean() : 0.0;
    if (std::isfinite(most)) {
        low_ = std::floor(least);
        high_ = std::ceil(most);
    }
    if (radius_ > 0.0) high_ = std::max(high_, std::ceil(std::log10(radius_)));
    high_ = std::max(high_, low_ + 2.0);
}

std::shared_ptr<const PanelState> ReturnDistancePanel::state(const Observation& observation) {
    auto state = std::make_shared<HomeState>();
    state->shown = way_home_.shown(observation.tick.frame);
    return state;
}

ReturnDistancePanel::Scales ReturnDistancePanel::scales(const Page& page) const {
    Rect area = plot_area(page);
    const double left = 0.4 * page.unit;  // labels of powers of ten are long
    area.x += left;
    area.width -= left;
    const double note = note_height * page.unit;
    area.y += note;
    area.height = std::max(page.unit, area.height - note);
    const double floor = std::min(0.3 * area.height, floor_height * page.unit);
    return {area, {0.0, last_, area.x, area.right()}, {low_, high_, area.bottom() - floor, area.y}};
}

void ReturnDistancePanel::draw_ground(Canvas& canvas, const Page& page) const {
    const std::string title = "Distance from the way out";
    draw_panel_title(canvas, page, spec_.title ? escape_markup(*spec_.title) : title);
    draw_note(canvas, page);
    const Scales s = scales(page);
    draw_x_axis(canvas, s.area, s.x, "since the reversal", axis_style(page));
    const Rect above{s.area.x, s.area.y, s.area.width, s.y.from - s.area.y};
    draw_log_y_axis(canvas, above, s.y, "", axis_style(page));
    draw_floor(canvas, page);
    draw_level(canvas, page);
    draw_home(canvas, page);
}

// What lines mean, by samples of them.
void ReturnDistancePanel::draw_note(Canvas& canvas, const Page& page) const {
    const double u = page.unit;
    const double baseline = page.area.y + 2.7 * u;
    double x = page.area.x;
    for (const Line line : {Line::largest, Line::root_mean_square}) {
        const std::array sample{Point{x, baseline - 0.35 * u},
                                Point{x + 1.8 * u, baseline - 0.35 * u}};
        canvas.stroke_path(sample, 0.18 * u, color_of(line, page.theme), dash_of(line, u));
        x += 2.3 * u;
        x += draw_text(canvas, {x, baseline}, name_of(line), label_style(page)).width + 1.2 * u;
    }
}

// No power of ten is 0: it has a place of its own under the axis, which is broken there.
void ReturnDistancePanel::draw_floor(Canvas& canvas, const Page& page) const {
    const Scales s = scales(page);
    const double u = page.unit;
    const double middle = 0.5 * (s.y.from + s.area.bottom());
    for (const double y : {middle - 0.14 * u, middle + 0.14 * u})
        canvas.stroke_line({s.area.x - 0.35 * u, y + 0.12 * u}, {s.area.x + 0.35 * u, y - 0.12 * u},
                           0.07 * u, page.theme.muted);
    TextStyle style = label_style(page);
    style.align = Align::right;
    draw_text(canvas, {s.area.x - 0.65 * u, s.area.bottom() + 0.36 * u}, "0", style);
}

// A particle's radius: beyond it the way home is lost to the eye.
void ReturnDistancePanel::draw_level(Canvas& canvas, const Page& page) const {
    if (!(radius_ > 0.0) || std::log10(radius_) < low_) return;
    const Scales s = scales(page);
    const double u = page.unit;
    const double y = s.y(std::log10(radius_));
    canvas.stroke_dashed({s.area.x, y}, {s.area.right(), y}, 0.08 * u, 0.3 * u, page.theme.muted);
    const bool all_alike = (cast_.particles.radius == cast_.particles.radius[0]).all();
    TextStyle style = label_style(page);
    style.align = Align::right;  // at the left the lines are steep
    draw_text(canvas, {s.area.right() - 0.4 * u, y + 1.1 * u},
              all_alike ? "a radius" : "a mean radius", style);
}

void ReturnDistancePanel::draw_home(Canvas& canvas, const Page& page) const {
    const Scales s = scales(page);
    if (way_home_.reversals().empty()) return;
    const double home = way_home_.reversals().front();
    if (home > last_ * (1.0 + 1e-9)) return;
    const double u = page.unit;
    const double x = s.x(home);
    canvas.stroke_line({x, s.area.y}, {x, s.area.bottom()}, 0.08 * u, page.theme.muted);
    TextStyle style = label_style(page);
    style.align = Align::right;
    draw_text(canvas, {x - 0.4 * u, s.area.bottom() - 0.5 * u}, "home", style);
}

// The steps from `from` to `to` of one way back. Where the distance is exactly 0, marks instead of
// a line.
void ReturnDistancePanel::draw_way(Canvas& canvas, const Page& page, std::size_t from,
                                   std::size_t to, Line line, bool is_present) const {
    const Scales s = scales(page);
    const double u = page.unit;
    const Color own = color_of(line, page.theme);
    const Color color = is_present ? own : mix(own, page.theme.page, 0.4);
    std::vector<Point> path;
    const auto end_path = [&] {
        if (path.size() > 1) canvas.stroke_path(path, 0.18 * u, color, dash_of(line, u));
        path.clear();
    };
    Point last{}, mark{-1e9, -1e9};
    for (std::size_t k = from; k < to; ++k) {
        const WayHome::Step& step = way_home_.steps()[k];
        if (!step.is_known) break;
        last = s(step, line);
        if (std::isfinite(log_of(step, line))) {
            if (path.empty() || k + 1 == to || is_apart(path.back(), last, 0.08 * u))
                path.push_back(last);
            continue;
        }
        end_path();
        if (!is_apart(mark, last, 0.3 * u)) continue;
        canvas.stroke_circle(last, 0.2 * u, 0.1 * u, color);
        mark = last;
    }
    end_path();
    if (is_present) canvas.fill_circle(last, 0.3 * u, color);
}

void ReturnDistancePanel::draw(Canvas& canvas, const Page& page, const PanelState& state) const {
    const std::size_t shown = static_cast<const HomeState&>(state).shown;
    if (shown == 0) {
        const Scales s = scales(page);
        TextStyle style = label_style(page);
        style.align = Align::center;
        const Point middle{s.area.x + s.area.width / 2,
                           0.5 * (s.area.y + s.y.from) + 0.35 * page.unit};
        const std::string begins = "begins at time " + three_digits(way_home_.reversals().front());
        const std::string whole = begins + ", when all turn round";
        const bool fits = measure_text(whole, style).width <= s.area.width;
        style.max_width = s.area.width;
        draw_text(canvas, middle, fits ? whole : begins, style);
        return;
    }
    const std::vector<WayHome::Step>& steps = way_home_.steps();
    const std::size_t present = steps[shown - 1].reversal;
    for (std::size_t reversal = 0; reversal <= present; ++reversal) {
        const auto from = static_cast<std::size_t>(
            std::ranges::lower_bound(steps, reversal, {}, &WayHome::Step::reversal) -
            steps.begin());
        const auto to = static_cast<std::size_t>(
            std::ranges::upper_bound(steps, reversal, {}, &WayHome::Step::reversal) -
            steps.begin());
        for (const Line line : {Line::root_mean_square, Line::largest})
            draw_way(canvas, page, from, std::min(to, shown), line, reversal == present);
    }
}

Table ReturnDistancePanel::table(const PanelState& state, const Theme&) const {
    Table table{{"part", "of", "reversal (number)",
                 column_name("since the reversal", reduced::time),
                 column_name("distance", reduced::length)}};
    const std::size_t shown = static_cast<const HomeState&>(state).shown;
    for (const Line line : {Line::largest, Line::root_mean_square})
        for (std::size_t k = 0; k < shown; ++k) {
            const WayHome::Step& step = way_home_.steps()[k];
            if (step.is_known)
                table.rows.push_back({"line", name_of(line),
                                      static_cast<std::int64_t>(step.reversal) + 1, step.since,
                                      value_of(step, line)});
        }
    if (radius_ > 0.0 && std::log10(radius_) >= low_)
        for (const double since : {0.0, last_})
            table.rows.push_back({"level", "mean radius", {}, since, radius_});
    return table;
}

}  // namespace

std::unique_ptr<Panel> make_return_distance(const Cast& cast, const PanelSpec& spec) {
    return std::make_unique<ReturnDistancePanel>(cast, spec);
}

}  // namespace carom

// How return distances are drawn: lines over powers of ten, with a place of its own for 0.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "panels/echo/return_distance.h"
#include "panels/echo/return_distance_state.h"
#include "panels/plots/comparison.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double floor_height = 1.5;  // of the band for distances of exactly 0, in units
constexpr double line_width = 0.18, law_width = 0.1;  // in units

// Whether a straight piece of a line lies over a part of the picture.
bool meets(const Rect& part, const Point& a, const Point& b) {
    const double from = std::max(part.x, std::min(a.x, b.x));
    const double to = std::min(part.right(), std::max(a.x, b.x));
    if (from > to) return false;
    const double slope = a.x == b.x ? 0.0 : (b.y - a.y) / (b.x - a.x);
    const double first = a.x == b.x ? a.y : a.y + slope * (from - a.x);
    const double second = a.x == b.x ? b.y : a.y + slope * (to - a.x);
    return std::min(first, second) <= part.bottom() && std::max(first, second) >= part.y;
}

}  // namespace

struct ReturnDistancePanel::Scales {
    Rect area;
    Scale x, y;  // y of decimal logarithms
    double height(double power) const {
        return std::isfinite(power) ? std::clamp(y(power), area.y, y.from) : area.bottom();
    }
};

ReturnDistancePanel::Scales ReturnDistancePanel::scales(const DrawContext& dc) const {
    Rect area = plot_area(dc);
    const double left = 0.4 * dc.unit;  // labels of powers of ten are long
    area.x += left;
    area.width -= left;
    const int rows = 1 + (compares() ? key_rows(dc, names_) : 0);
    const double note = rows * note_height * dc.unit;
    area.y += note;
    area.height = std::max(dc.unit, area.height - note);
    const double floor = std::min(0.3 * area.height, floor_height * dc.unit);
    return {area, {0.0, last_, area.x, area.right()}, {low_, high_, area.bottom() - floor, area.y}};
}

ReturnDistancePanel::Look ReturnDistancePanel::look(Line line, std::size_t run,
                                                    const DrawContext& dc) const {
    if (compares()) return {compared_color(run, dc.theme), compared_dashes(run, dc)};
    if (line == Line::largest) return {edge_of(dc.theme.highlight, dc.theme), {}};
    return {edge_of(dc.theme.bar, dc.theme), {0.5 * dc.unit, 0.5 * dc.unit}};
}

// With the bits of the run's numbers, which are why it comes home or does not.
std::vector<std::string> ReturnDistancePanel::titles() const {
    const std::string title = "Distance from the way out";
    if (compares()) return {title};
    const int bits = context_.scene.run.bits.value_or(bits_of_double);
    return {fmt::format("{}, in numbers of {} bits", title, bits),
            fmt::format("{}, {} bits", title, bits), title};
}

// Of the horizontal axis: the longer words where they leave room for its numbers.
std::string ReturnDistancePanel::along_words(const DrawContext& dc) const {
    if (!spec_.against_collisions) return "since the reversal";
    const std::string all = "collisions of each since the reversal";
    const double room = 0.3 * scales(dc).area.width;
    return measure_text(all, label_style(dc)).width <= room ? all : "collisions of each";
}

void ReturnDistancePanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    draw_panel_title(canvas, dc,
                     spec_.title ? escape_markup(*spec_.title) : fitting_title(dc, titles()));
    draw_note(canvas, dc);
    const Scales s = scales(dc);
    draw_x_axis(canvas, s.area, s.x, along_words(dc), axis_style(dc));
    const Rect above{s.area.x, s.area.y, s.area.width, s.y.from - s.area.y};
    draw_log_y_axis(canvas, above, s.y, "", axis_style(dc));
    draw_floor(canvas, dc);
    draw_level(canvas, dc);
    if (!compares()) draw_home(canvas, dc);
}

// What lines mean, by samples of them: in the longest words that fit.
void ReturnDistancePanel::draw_note(Canvas& canvas, const DrawContext& dc) const {
    const double u = dc.unit;
    constexpr double sample_width = 1.8, gap = 0.5, between = 1.2;  // units
    struct Entry {
        Look look;
        double width;                     ///< of the line, in units; 0: words alone
        std::array<const char*, 2> name;  ///< from the longest on
    };
    std::vector<Entry> entries;
    if (compares())
        entries.push_back({{}, 0.0, {"the largest of all particles", "the largest"}});
    else
        for (const Line line : lines())
            entries.push_back({look(line, 0, dc), line_width,
                               line == Line::largest ? std::array{name_of(line), name_of(line)}
                                                     : std::array{name_of(line), "r.m.s."}});
    if (has_law())
        entries.push_back({{dc.theme.accent, {}}, law_width, {"growth law", "growth law"}});
    const auto words_at = [&](const Entry& entry) {
        return entry.width > 0.0 ? (sample_width + gap) * u : 0.0;
    };
    const TextStyle style = label_style(dc);
    double whole = -between * u;
    for (const Entry& entry : entries)
        whole += words_at(entry) + measure_text(entry.name[0], style).width + between * u;
    const std::size_t length = whole <= dc.area.width ? 0 : 1;
    Point at{dc.area.x, dc.area.y + 2.7 * u};
    for (const Entry& entry : entries) {
        if (entry.width > 0.0)
            canvas.stroke_path(std::array{Point{at.x, at.y - 0.35 * u},
                                          Point{at.x + sample_width * u, at.y - 0.35 * u}},
                               entry.width * u, entry.look.color, entry.look.dashes);
        at.x += words_at(entry);
        at.x += draw_text(canvas, at, entry.name[length], style).width + between * u;
    }
    if (compares()) draw_key_of_runs(canvas, dc, {dc.area.x, at.y + note_height * u}, names_);
}

// No power of ten is 0: it has a place of its own under the axis, which is broken there.
void ReturnDistancePanel::draw_floor(Canvas& canvas, const DrawContext& dc) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    const double middle = 0.5 * (s.y.from + s.area.bottom());
    for (const double y : {middle - 0.14 * u, middle + 0.14 * u})
        canvas.stroke_line({s.area.x - 0.35 * u, y + 0.12 * u}, {s.area.x + 0.35 * u, y - 0.12 * u},
                           0.07 * u, dc.theme.muted);
    TextStyle style = label_style(dc);
    style.align = Align::right;
    draw_text(canvas, {s.area.x - 0.65 * u, s.area.bottom() + 0.36 * u}, "0", style);
}

double ReturnDistancePanel::level_baseline(const DrawContext& dc) const {
    return scales(dc).y(std::log10(radius())) + 1.1 * dc.unit;
}

// A particle's radius: beyond it the way home is lost to the eye.
void ReturnDistancePanel::draw_level(Canvas& canvas, const DrawContext& dc) const {
    if (!(radius() > 0.0) || std::log10(radius()) < low_) return;
    for (const ReturnDistancePanel* run : runs_)
        if (run->radius() != radius()) return;
    const Scales s = scales(dc);
    const double u = dc.unit;
    const double y = s.y(std::log10(radius()));
    canvas.stroke_dashed({s.area.x, y}, {s.area.right(), y}, 0.08 * u, 0.3 * u, dc.theme.muted);
    const bool all_alike = (context_.particles.radius == context_.particles.radius[0]).all();
    const std::string words = all_alike ? "a radius" : "a mean radius";
    const TextStyle style = label_style(dc);
    const double width = measure_text(words, style).width, baseline = level_baseline(dc);
    const double last = s.area.right() - 0.4 * u - width;  // at the left the lines are steep
    double left = last;
    const auto crossed = [&] {
        return is_crossed({left - 0.3 * u, baseline - 0.9 * u, width + 0.6 * u, 1.2 * u}, dc);
    };
    while (crossed() && left > s.area.x + 1.4 * u) left -= u;
    draw_text(canvas, {crossed() ? last : left, baseline}, words, style);
}

// Whether any line will cross a part of the plot.
bool ReturnDistancePanel::is_crossed(const Rect& part, const DrawContext& dc) const {
    const Scales s = scales(dc);
    for (const ReturnDistancePanel* run : runs_) {
        const Steps steps = run->echo_.steps();
        for (std::size_t i = 1; i < steps.size(); ++i) {
            if (!steps[i].is_known || steps[i].reversal != steps[i - 1].reversal) continue;
            const auto at = [&](const EchoRecord::Step& step) {
                return Point{s.x(along(step)), s.height(log_of(step, Line::largest))};
            };
            if (meets(part, at(steps[i - 1]), at(steps[i]))) return true;
        }
        for (std::size_t reversal = 0; reversal < run->echo_.reversals().size(); ++reversal) {
            const std::vector<LawPoint> points = law(*run, reversal);
            for (std::size_t i = 1; i < points.size(); ++i)
                if (meets(part, {s.x(points[i - 1].along), s.height(points[i - 1].log10_distance)},
                          {s.x(points[i].along), s.height(points[i].log10_distance)}))
                    return true;
        }
    }
    return false;
}

void ReturnDistancePanel::draw_home(Canvas& canvas, const DrawContext& dc) const {
    if (echo_.reversals().empty()) return;
    const double home = echo_.reversals().front() * (1.0 - 1e-9);
    const Steps way = way_back(*this, 0);
    const auto there = std::ranges::find_if(
        way, [&](const EchoRecord::Step& step) { return step.is_known && step.since >= home; });
    if (there == way.end()) return;
    const Scales s = scales(dc);
    const double u = dc.unit;
    const double x = s.x(along(*there));
    canvas.stroke_line({x, s.area.y}, {x, s.area.bottom()}, 0.08 * u, dc.theme.muted);
    TextStyle style = label_style(dc);
    style.align = Align::right;
    draw_text(canvas, {x - 0.4 * u, s.area.bottom() - 0.5 * u}, "home", style);
}

void ReturnDistancePanel::draw_law(Canvas& canvas, const DrawContext& dc,
                                   const ReturnDistancePanel& run, std::size_t reversal) const {
    const Scales s = scales(dc);
    std::vector<Point> path;
    const std::vector<LawPoint> points = law(run, reversal);
    for (const LawPoint& point : points) {
        const Point at{s.x(point.along), s.height(point.log10_distance)};
        if (path.empty() || &point == &points.back() || is_apart(path.back(), at, 0.08 * dc.unit))
            path.push_back(at);
    }
    if (path.size() > 1) canvas.stroke_path(path, law_width * dc.unit, dc.theme.accent);
}

// Some steps of one way back. Where the distance is exactly 0, marks instead of a line.
void ReturnDistancePanel::draw_way(Canvas& canvas, const DrawContext& dc, Steps steps, Line line,
                                   const Look& look, bool is_present) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    const Color color = is_present ? look.color : mix(look.color, dc.theme.page, 0.4);
    std::vector<Point> path;
    const auto end_path = [&] {
        if (path.size() > 1) canvas.stroke_path(path, line_width * u, color, look.dashes);
        path.clear();
    };
    Point last{}, mark{-1e9, -1e9};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const EchoRecord::Step& step = steps[k];
        if (!step.is_known) break;
        last = {s.x(along(step)), s.height(log_of(step, line))};
        if (std::isfinite(log_of(step, line))) {
            if (path.empty() || k + 1 == steps.size() || is_apart(path.back(), last, 0.08 * u))
                path.push_back(last);
            continue;
        }
        end_path();
        if (!is_apart(mark, last, 0.3 * u)) continue;
        canvas.stroke_circle(last, 0.2 * u, 0.1 * u, color);
        mark = last;
    }
    end_path();
    if (is_present && !compares()) canvas.fill_circle(last, 0.3 * u, color);
}

void ReturnDistancePanel::draw_start(Canvas& canvas, const DrawContext& dc) const {
    const Scales s = scales(dc);
    TextStyle style = label_style(dc);
    style.align = Align::center;
    Point middle{s.area.x + s.area.width / 2, 0.5 * (s.area.y + s.y.from) + 0.35 * dc.unit};
    const double level = level_baseline(dc);  // whose words are not to be touched
    if (std::abs(middle.y - level) < 1.5 * dc.unit) middle.y = level + 1.5 * dc.unit;
    const std::string begins = "begins at time " + three_digits(echo_.reversals().front());
    const std::string whole = begins + ", when all turn round";
    const bool fits = measure_text(whole, style).width <= s.area.width;
    style.max_width = s.area.width;
    draw_text(canvas, middle, fits ? whole : begins, style);
}

void ReturnDistancePanel::draw_run(Canvas& canvas, const DrawContext& dc, std::size_t run,
                                   std::size_t shown) const {
    if (shown == 0) return;
    const ReturnDistancePanel& one = *runs_[run];
    const Steps all = Steps(one.echo_.steps()).first(shown);
    const std::size_t present = all.back().reversal;
    draw_law(canvas, dc, one, present);
    for (std::size_t reversal = 0; reversal <= present; ++reversal) {
        const auto way = std::ranges::equal_range(all, reversal, {}, &EchoRecord::Step::reversal);
        for (const Line line : {Line::root_mean_square, Line::largest})
            if (!compares() || line == Line::largest)
                draw_way(canvas, dc, {way.begin(), way.end()}, line, look(line, run, dc),
                         reversal == present);
    }
}

void ReturnDistancePanel::draw(Canvas& canvas, const DrawContext& dc,
                               const PanelState& state) const {
    const std::vector<std::size_t>& shown = static_cast<const ReturnDistanceState&>(state).shown;
    if (std::ranges::count(shown, std::size_t{0}) == std::ssize(shown))
        return draw_start(canvas, dc);
    for (std::size_t k = runs_.size(); k-- > 0;) draw_run(canvas, dc, k, shown.at(k));
}

}  // namespace carom

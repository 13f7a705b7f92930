#include "panels/histogram_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom {
namespace {

struct HistogramState : PanelState {
    Histogram histogram;
    double mean = 0.0;
    std::size_t bytes() const override {
        return histogram.counts.size() * sizeof(histogram.counts.front());
    }
};

constexpr std::size_t pool_size = 200'000;  // values kept of the whole run, for ranges and bins
constexpr double names_width = 10.6;        // of the means' names and numbers, in units
constexpr int probe_frames = 40;            // frames whose bars decide the height of the axis

}  // namespace

struct HistogramPanel::Scales {
    Rect area;
    Scale x, y;
};

HistogramPanel::HistogramPanel(const Cast& cast, const PanelSpec& spec, HistogramSubject subject)
    : spec_(spec),
      subject_(std::move(subject)),
      particles_(static_cast<double>(cast.particles.count())),
      sharing_(particles_),
      frames_(cast.frames) {
    if (!cast.equilibrium) return;
    sharing_ = 0.0;
    for (const MassGroup& group : cast.equilibrium->groups) sharing_ += group.count;
}

void HistogramPanel::survey(const Observation& observation) {
    const Eigen::ArrayXd& values = subject_.values(observation);
    if (surveyed_ == 0) mean_start_ = values.mean();
    const auto stride = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(particles_ * frames_ / static_cast<double>(pool_size)));
    for (Eigen::Index i = surveyed_ % stride; i < values.size(); i += stride)
        if (std::isfinite(values[i])) pool_.push_back(values[i]);  // moving infinite masses
    if (surveyed_ % std::max(1, frames_ / probe_frames) == 0) probes_.push_back(values);
    ++surveyed_;
}

void HistogramPanel::settle() {
    choose_bins();
    if (spec_.theory && subject_.density) {
        constexpr int points = 80;
        const double first = bins_.low + (subject_.probability ? 0.5 * bins_.width() : 0.0);
        for (int i = 0; i <= points; ++i) {
            const double value = first + (bins_.high - first) * i / points;
            curve_.push_back({value, sharing_ * expected_share(value)});
        }
    }
    choose_height();
    pool_ = {};
    probes_ = {};
}

// Of a bar around `value`: where a density is infinite at the first edge its bars are not, and a
// curve through their middles says what they will be.
double HistogramPanel::expected_share(double value) const {
    if (!subject_.probability) return bins_.width() * subject_.density(value);
    return subject_.probability(value - 0.5 * bins_.width(), value + 0.5 * bins_.width());
}

double HistogramPanel::curve_top() const {
    double top = 0.0;
    for (const Point& point : curve_)
        if (std::isfinite(point.y)) top = std::max(top, point.y);
    return top;
}

// The axis holds a quarter more than 97 of a hundred values of the whole run: 99 of a hundred of a
// gas in equilibrium, whatever the start. Those beyond are counted.
void HistogramPanel::choose_bins() {
    if (pool_.empty()) pool_.push_back(0.0);
    double high = 1.0;
    double low = 0.0;
    if (spec_.range) {
        std::tie(low, high) = *spec_.range;
    } else {
        high = 1.25 * quantile(pool_, 0.97);
        high = high > 0.0 ? round_up_for_axis(high) : 1.0;
    }
    const int count =
        spec_.bins ? *spec_.bins : freedman_diaconis(pool_, particles_, low, high, 12, 60);
    bins_ = {low, high, count};
    // Equal values at the start must not lie on an edge, where round-off would deal them out to two
    // bins.
    const double place = (mean_start_ - low) / bins_.width();
    if (!spec_.bins && std::abs(place - std::round(place)) < 1e-6) ++bins_.count;
}

// Room for the bars of most frames and for the whole curve; a start far from equilibrium, all in
// one bin, would flatten everything that follows: such bars are cut with a mark.
void HistogramPanel::choose_height() {
    std::vector<double> tops;
    for (const Eigen::ArrayXd& probe : probes_) {
        const Histogram bars = histogram(probe, bins_);
        tops.push_back(static_cast<double>(*std::ranges::max_element(bars.counts)));
    }
    const double curve = curve_top();
    const double bars = quantile(tops, curve > 0.0 ? 0.5 : 0.9);
    const double top = curve > 0.0 ? std::clamp(1.1 * bars, 1.2 * curve, 1.4 * curve) : 1.1 * bars;
    tallest_ = round_up_for_axis(std::max(1.0, top));
}

std::shared_ptr<const PanelState> HistogramPanel::state(const Observation& observation) {
    auto state = std::make_shared<HistogramState>();
    const Eigen::ArrayXd& values = subject_.values(observation);
    state->histogram = histogram(values, bins_);
    state->mean = values.mean();
    return state;
}

HistogramPanel::Scales HistogramPanel::scales(const Page& page) const {
    const Rect area = plot_area(page);
    return {area,
            {bins_.low, bins_.high, area.x, area.right()},
            {0.0, tallest_, area.bottom(), area.y}};
}

void HistogramPanel::draw_ground(Canvas& canvas, const Page& page) const {
    const std::string title = escape_markup(spec_.title.value_or(subject_.title));
    std::string words = fmt::format("{}: {}", title, colored("now", page.theme.bar));
    if (!curve_.empty()) words += " and " + colored("in equilibrium", page.theme.accent);
    draw_panel_title(canvas, page, words);
    const Scales s = scales(page);
    draw_x_axis(canvas, s.area, s.x, subject_.quantity, axis_style(page));
    draw_y_axis(canvas, s.area, s.y, "", axis_style(page));
}

void HistogramPanel::draw(Canvas& canvas, const Page& page, const PanelState& state) const {
    const auto& now = static_cast<const HistogramState&>(state);
    draw_bars(canvas, page, now.histogram);
    draw_ends(canvas, page, now.histogram);
    draw_curve(canvas, page);
    draw_means(canvas, page, now.mean);
}

void HistogramPanel::draw_bars(Canvas& canvas, const Page& page, const Histogram& now) const {
    const Scales s = scales(page);
    for (int i = 0; i < bins_.count; ++i) {
        const auto count = static_cast<double>(now.counts[static_cast<std::size_t>(i)]);
        if (count == 0.0) continue;
        // Whole pixels sideways: half-covered columns would show as seams between the bars.
        const double left = std::round(s.x(bins_.edge(i)));
        const double right = std::round(s.x(bins_.edge(i + 1)));
        const double top = s.y(std::min(count, tallest_));
        canvas.fill({left, top, right - left, s.area.bottom() - top}, page.theme.bar);
    }
}

// What the axes cannot hold is said: a bar that is cut, with its count, and how many lie beyond the
// end.
void HistogramPanel::draw_ends(Canvas& canvas, const Page& page, const Histogram& now) const {
    const Scales s = scales(page);
    const double u = page.unit;
    double free_from = s.area.x;  // counts of neighbours must not lie on each other
    for (int i = 0; i < bins_.count; ++i) {
        const std::int64_t count = now.counts[static_cast<std::size_t>(i)];
        if (static_cast<double>(count) <= tallest_) continue;
        const double left = s.x(bins_.edge(i));
        const double right = s.x(bins_.edge(i + 1));
        for (double y : {0.9 * u, 1.3 * u})
            canvas.stroke_line({left - 0.15 * u, s.area.y + y + 0.25 * u},
                               {right + 0.15 * u, s.area.y + y - 0.25 * u}, 0.14 * u,
                               page.theme.page);
        TextStyle style = label_style(page);
        style.color = page.theme.bar;
        if (left < free_from) continue;
        free_from = left + 0.4 * u +
                    draw_text(canvas, {left, s.area.y - 0.25 * u}, grouped(count), style).width;
    }
    std::string beyond;
    if (now.below > 0) beyond += fmt::format("← {} lower  ", grouped(now.below));
    if (now.above > 0) beyond += fmt::format("{} {} →", grouped(now.above), subject_.beyond);
    if (!beyond.empty())
        draw_name(canvas, page, {names_x(page) + 0.6 * u, s.area.y + 3.6 * u}, beyond,
                  page.theme.muted);
}

// Where the means' names stand: at the top right, where a tail leaves room, or at the left if the
// bars begin there.
double HistogramPanel::names_x(const Page& page) const {
    const Scales s = scales(page);
    const double right = s.area.right() - names_width * page.unit;
    const bool taken = s.x(mean_start_) > right - 2.5 * page.unit;
    return taken ? s.area.x + page.unit : right;
}

// On a plate of the page's colour, so that bars behind it do not cut it up.
void HistogramPanel::draw_name(Canvas& canvas, const Page& page, Point at, const std::string& words,
                               Color color) const {
    TextStyle style = label_style(page);
    style.color = color;
    style.max_width = names_width * page.unit;
    const double width = measure_text(words, style).width;
    canvas.fill(
        {at.x - 0.9 * page.unit, at.y - 1.05 * page.unit, width + 1.2 * page.unit, 1.4 * page.unit},
        with_alpha(page.theme.page, 0.8));
    draw_text(canvas, at, words, style);
}

void HistogramPanel::draw_curve(Canvas& canvas, const Page& page) const {
    if (curve_.empty()) return;
    const Scales s = scales(page);
    std::vector<Point> path;
    for (const Point& point : curve_)
        path.push_back({s.x(point.x), s.y(std::min(point.y, tallest_))});
    canvas.stroke_path(path, 0.16 * page.unit, page.theme.accent);
}

// The marks move; their names and numbers stand still.
void HistogramPanel::draw_means(Canvas& canvas, const Page& page, double mean_now) const {
    const Scales s = scales(page);
    const double u = page.unit;
    const auto line = [&](Point from, Point to, bool solid) {
        if (solid) canvas.stroke_line(from, to, 0.12 * u, page.theme.ink);
        if (!solid) canvas.stroke_dashed(from, to, 0.12 * u, 0.25 * u, page.theme.muted);
    };
    const auto mark = [&](double mean, const std::string& words, double row, bool solid) {
        const double x = s.x(mean);
        if (x >= s.area.x && x <= s.area.right()) line({x, s.area.bottom()}, {x, s.area.y}, solid);
        const Point sample{names_x(page), s.area.y + row * u};
        draw_name(canvas, page, {sample.x + 0.6 * u, sample.y}, words + " " + three_digits(mean),
                  solid ? page.theme.ink : page.theme.muted);
        line({sample.x, sample.y + 0.1 * u}, {sample.x, sample.y - 0.85 * u}, solid);
    };
    if (spec_.mean_start) mark(mean_start_, "mean at start", 2.2, false);
    if (spec_.mean_now) mark(mean_now, "mean now", 0.8, true);
}

}  // namespace carom

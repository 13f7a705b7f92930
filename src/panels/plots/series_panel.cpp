#include "panels/plots/series_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include "panels/plots/comparison.h"
#include "stats/histogram.h"
#include "stats/mean_error.h"
#include "util/text.h"

namespace carom {
namespace {

struct SeriesState : PanelState {
    std::vector<std::size_t> shown;  // of each run
};

// A tint for the way back, which lies inside a line of the colour itself: on any ground it is seen.
Color lighter(Color color) { return mix(color, rgb(0xFFFFFF), 0.7); }

constexpr double band_alpha = 0.3;  // of standard errors

}  // namespace

struct SeriesPanel::Scales {
    Rect area;
    Scale x, y;
    double height(double value, bool logarithmic) const {
        return std::clamp(y(logarithmic ? std::log10(value) : value), area.y, area.bottom());
    }
};

SeriesPanel::SeriesPanel(const PanelContext& context, SeriesSubject subject)
    : context_(context), subject_(std::move(subject)) {}

void SeriesPanel::survey(const FrameInput& input) {
    const std::vector<double> now = subject_.measure(input);
    history_.time.push_back(folded_time(context_.scene.run, input.tick.time));
    history_.leg.push_back(input.tick.reversals);
    history_.lines.resize(now.size());
    for (std::size_t k = 0; k < now.size(); ++k) history_.lines[k].push_back(now[k]);
}

// For longer than an instant.
bool SeriesPanel::rests_at_zero() const {
    constexpr double instant = 0.01;  // of the film
    return std::ranges::any_of(history_.lines, [](const std::vector<double>& line) {
        return static_cast<double>(std::ranges::count(line, 0.0)) >
               instant * static_cast<double>(line.size());
    });
}

void SeriesPanel::fix_axes() {
    std::vector<double> all;
    for (const History* history : histories())
        for (const std::vector<double>& line : history->lines)
            for (double value : line)
                if (value > 0.0 && std::isfinite(value)) all.push_back(value);
    for (std::size_t k = 0; k < history_.errors.size(); ++k)  // room for the bands
        for (std::size_t i = 0; i < history_.time.size(); ++i)
            if (const double top = history_.lines[k][i] + history_.errors[k][i];
                top > 0.0 && std::isfinite(top))
                all.push_back(top);
    first_ = *std::ranges::min_element(history_.time);
    last_ = *std::ranges::max_element(history_.time);
    for (const History& history : beside_) {
        first_ = std::min(first_, *std::ranges::min_element(history.time));
        last_ = std::max(last_, *std::ranges::max_element(history.time));
    }
    if (last_ <= first_) last_ = first_ + 1.0;
    if (subject_.reference && !reference_ && !compares()) reference_ = subject_.reference();
    if (subject_.top) high_ = *subject_.top;
    if (all.empty() || subject_.top) return;

    // Without a scale by powers of ten room is left over the lines, and what is beyond is cut.
    const double most = subject_.spreads ? *std::ranges::max_element(all)
                                         : 1.25 * std::max(quantile(all, 0.98), reference_value());
    const double least =
        quantile(all, 0.01);  // one particle's energy may touch zero for an instant
    constexpr double linear_up_to = 50.0;
    const double mean =
        std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
    // Powers of ten have no place for a line that lies at zero: without need they are not taken.
    const bool told_by_linear = rests_at_zero() && most <= linear_up_to * mean;
    logarithmic_ = subject_.spreads && most > linear_up_to * least && !told_by_linear;
    low_ = logarithmic_ ? std::floor(std::log10(least)) : 0.0;
    high_ = logarithmic_ ? std::ceil(std::log10(most)) : round_up_for_axis(most);
}

void SeriesPanel::settle_with(const std::vector<Panel*>& others) {
    const std::vector<SeriesPanel*> runs = runs_of(*this, others);
    if (subject_.reference) {
        std::vector<double> levels;
        for (SeriesPanel* run : runs)
            if (const auto level = run->subject_.reference()) levels.push_back(level->value);
        reference_ = subject_.reference();
        if (reference_) reference_->value = mean_error(levels).mean;
    }
    history_.errors = history_.lines;
    for (std::size_t k = 0; k < history_.lines.size(); ++k)
        for (std::size_t i = 0; i < history_.time.size(); ++i) {
            std::vector<double> values;
            for (const SeriesPanel* run : runs) values.push_back(run->history_.lines[k][i]);
            const MeanError mean = mean_error(values);
            history_.lines[k][i] = mean.mean;  // the last use of this run's own
            history_.errors[k][i] = mean.error;
        }
    tell_means(runs.size());
    fix_axes();
}

// One line of each run. A level that they do not share is each one's own.
void SeriesPanel::settle_beside(const std::vector<Panel*>& others,
                                const std::vector<std::string>& names) {
    const std::vector<SeriesPanel*> runs = runs_of(*this, others);
    names_ = names;
    for (SeriesPanel* run : runs) {
        run->history_.lines = {run->history_.lines[subject_.compared]};
        same_reversals_ &=
            reversal_times(run->context_.scene.run) == reversal_times(context_.scene.run);
        const auto level =
            run->subject_.reference ? run->subject_.reference() : std::optional<ReferenceLevel>{};
        levels_.push_back(level.value_or(ReferenceLevel{"", std::nan("")}));
        if (run != this) beside_.push_back(run->history_);
    }
    const std::string first = three_digits(levels_.front().value);
    if (std::ranges::all_of(levels_, [&](const ReferenceLevel& level) {
            return std::isfinite(level.value) && three_digits(level.value) == first;
        }))
        reference_ = levels_.front();
    if (reference_ || std::ranges::none_of(levels_, [](const ReferenceLevel& level) {
            return std::isfinite(level.value);
        }))
        levels_.clear();
    fix_axes();
}

std::shared_ptr<const PanelState> SeriesPanel::beside(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    return shown_of_each<SeriesState>(states);
}

// The last number of each that there is.
std::vector<std::string> SeriesPanel::told_of_runs(const PanelState& state) const {
    std::vector<std::string> told;
    const std::vector<const History*> all = histories();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::vector<double>& line = all[k]->lines.front();
        std::size_t last = static_cast<const SeriesState&>(state).shown.at(k);
        while (last > 0 && !std::isfinite(line[last - 1])) --last;
        const std::string quantity = subject_.column.substr(0, subject_.column.find(" ("));
        told.push_back(quantity + " " + (last == 0 ? "unknown" : three_digits(line[last - 1])));
    }
    return told;
}

std::vector<const SeriesPanel::History*> SeriesPanel::histories() const {
    std::vector<const History*> all{&history_};
    for (const History& history : beside_) all.push_back(&history);
    return all;
}

void SeriesPanel::tell_means(std::size_t runs) {
    const std::string mean = fmt::format("mean of {} runs", runs);
    const std::string whole = mean + " \u00B1 standard error";
    subject_.notes =
        subject_.notes.empty()
            ? std::vector<std::string>{whole, mean}
            : std::vector<std::string>{subject_.notes.front() + "; " + whole, whole, mean};
}

std::shared_ptr<const PanelState> SeriesPanel::state(const FrameInput&) {
    auto state = std::make_shared<SeriesState>();
    state->shown = {++seen_};
    return state;
}

double SeriesPanel::reference_value() const { return reference_ ? reference_->value : 0.0; }

SeriesPanel::Scales SeriesPanel::scales(const DrawContext& dc) const {
    Rect area = plot_area(dc);
    const int rows = (notes().empty() ? 0 : 1) + (compares() ? key_rows(dc, names_) : 0);
    const double note = rows * note_height * dc.unit;
    area.y += note;
    area.height = std::max(dc.unit, area.height - note);
    return {area, {first_, last_, area.x, area.right()}, {low_, high_, area.bottom(), area.y}};
}

// Under the title: the first that is not cut.
std::vector<std::string> SeriesPanel::notes() const {
    if (levels_.empty()) return subject_.notes;
    const std::string level = "thin: " + levels_.front().name;
    std::vector<std::string> notes;
    for (const std::string& note : subject_.notes) notes.push_back(note + "; " + level);
    notes.push_back(level);
    return notes;
}

void SeriesPanel::draw_ground(Canvas& canvas, const DrawContext& dc) const {
    const bool own_title = compares() && !subject_.compared_title.empty();
    draw_panel_title(canvas, dc, own_title ? subject_.compared_title : subject_.title(dc.theme));
    TextStyle note = label_style(dc);
    note.max_width = dc.area.width;
    const std::vector<std::string> remarks = notes();
    Point row{dc.area.x, dc.area.y + 2.5 * dc.unit};
    if (!remarks.empty()) {
        draw_text(canvas, row, fitting_title(dc, remarks), note);
        row.y += note_height * dc.unit;
    }
    if (compares()) draw_key_of_runs(canvas, dc, row, names_);
    const Scales s = scales(dc);
    draw_x_axis(canvas, s.area, s.x, "time", axis_style(dc));
    if (logarithmic_) draw_log_y_axis(canvas, s.area, s.y, "", axis_style(dc));
    if (!logarithmic_) draw_y_axis(canvas, s.area, s.y, "", axis_style(dc));
    if (same_reversals_) draw_reversals(canvas, dc);
    draw_reference(canvas, dc);
    draw_levels(canvas, dc);
}

// Each run's own, where they differ.
void SeriesPanel::draw_levels(Canvas& canvas, const DrawContext& dc) const {
    const Scales s = scales(dc);
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        if (!std::isfinite(levels_[k].value)) continue;
        const double y = s.height(levels_[k].value, logarithmic_);
        canvas.stroke_line({s.area.x, y}, {s.area.right(), y}, 0.07 * dc.unit,
                           compared_color(k, dc.theme));
    }
}

void SeriesPanel::draw_reference(Canvas& canvas, const DrawContext& dc) const {
    if (!reference_) return;
    const Scales s = scales(dc);
    const double u = dc.unit;
    const double y = s.height(reference_->value, logarithmic_);
    canvas.stroke_dashed({s.area.x, y}, {s.area.right(), y}, 0.08 * u, 0.3 * u, dc.theme.muted);
    const std::string words = reference_->name + " " + three_digits(reference_->value);
    const Point sample{s.area.right() - 10.3 * u, s.area.y + 0.8 * u};
    canvas.stroke_dashed({sample.x - 1.2 * u, sample.y - 0.35 * u},
                         {sample.x + 0.1 * u, sample.y - 0.35 * u}, 0.08 * u, 0.3 * u,
                         dc.theme.muted);
    draw_text(canvas, {sample.x + 0.6 * u, sample.y}, words, label_style(dc));
}

// Whether a line or a label would cross a part of the plot.
bool SeriesPanel::is_crossed(const Rect& part, const DrawContext& dc) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    const auto meets = [&](double x, double low, double high) {
        return x >= part.x && x <= part.right() && high >= part.y && low <= part.bottom();
    };
    if (reference_) {
        const double level = s.height(reference_->value, logarithmic_);
        if (meets(part.x, level, level) || part.y < s.area.y + u) return true;
    }
    for (const History* history : histories())
        for (const std::vector<double>& line : history->lines)
            for (std::size_t i = 1; i < line.size(); ++i) {
                if (!std::isfinite(line[i]) || !std::isfinite(line[i - 1])) continue;
                const double before = s.height(std::max(line[i - 1], 1e-300), logarithmic_);
                const double now = s.height(std::max(line[i], 1e-300), logarithmic_);
                if (meets(s.x(history->time[i]), std::min(before, now), std::max(before, now)))
                    return true;
            }
    return false;
}

// A thin line where the time axis turns back, with the word as low as no line crosses it.
void SeriesPanel::draw_reversals(Canvas& canvas, const DrawContext& dc) const {
    const Scales s = scales(dc);
    const double u = dc.unit;
    TextStyle style = label_style(dc);
    const double width = measure_text("reversed", style).width;
    for (const double at : reversal_times(context_.scene.run)) {
        const double x = s.x(folded_time(context_.scene.run, at));
        canvas.stroke_line({x, s.area.y}, {x, s.area.bottom()}, 0.08 * u, dc.theme.muted);
        const bool on_left = x > s.area.x + s.area.width / 2;
        const double left = on_left ? x - 0.4 * u - width : x + 0.4 * u;
        const double lowest = s.area.bottom() - 0.5 * u;
        double baseline = lowest;
        const auto crossed = [&] {
            return is_crossed({left, baseline - 1.1 * u, width, 1.5 * u}, dc);
        };
        while (crossed() && baseline - 1.6 * u > s.area.y) baseline -= 0.5 * u;
        if (crossed()) baseline = lowest;
        draw_text(canvas, {left, baseline}, "reversed", style);
    }
}

// `index`: of a line, or of a run beside others.
SeriesPanel::Look SeriesPanel::look(std::size_t index, const DrawContext& dc) const {
    if (compares()) return {compared_color(index, dc.theme), compared_dashes(index, dc)};
    return {subject_.color(index, dc.theme), line_dashes(index, history_.lines.size(), dc)};
}

void SeriesPanel::draw_line(Canvas& canvas, const DrawContext& dc, const History& history,
                            std::size_t index, const Look& look, std::size_t shown) const {
    const Scales s = scales(dc);
    const std::vector<double>& line = history.lines[index];
    const Color color = look.color;
    const Color edge = compares() ? color : edge_of(color, dc.theme);
    const bool has_edge = to_pixel(edge) != to_pixel(color);
    const std::vector<double>& dashes = look.dashes;
    std::vector<Point> path;
    for (std::size_t i = 0; i < shown; ++i) {
        if (!std::isfinite(line[i])) continue;
        const Point last{s.x(history.time[i]), s.height(std::max(line[i], 1e-300), logarithmic_)};
        const bool leg_ends = i + 1 == shown || history.leg[i + 1] != history.leg[i];
        // Points nearer than half the line's width show nothing new, and a long film has thousands.
        if (leg_ends || path.empty() || is_apart(path.back(), last, 0.08 * dc.unit))
            path.push_back(last);
        if (!leg_ends) continue;
        const bool way_back = history.leg[i] % 2 == 1;
        const double wider = way_back ? 0.1 * dc.unit : 0.0;
        const bool dashed = !dashes.empty();
        if (has_edge && !dashed) canvas.stroke_path(path, 0.26 * dc.unit + wider, edge);
        canvas.stroke_path(path, 0.16 * dc.unit + wider, dashed ? edge : color, dashes);
        if (way_back) canvas.stroke_path(path, 0.12 * dc.unit, lighter(color), dashes);
        path = {last};
    }
    if (path.empty()) return;
    canvas.fill_circle(path.back(), 0.3 * dc.unit, edge);
    canvas.fill_circle(path.back(), (has_edge ? 0.2 : 0.3) * dc.unit, color);
}

// Of a standard error to either side, leg by leg.
void SeriesPanel::draw_band(Canvas& canvas, const DrawContext& dc, std::size_t index,
                            std::size_t shown) const {
    const Scales s = scales(dc);
    const Color color = with_alpha(subject_.color(index, dc.theme), band_alpha);
    std::vector<Point> upper, lower;
    const auto end_band = [&] {
        upper.insert(upper.end(), lower.rbegin(), lower.rend());
        if (upper.size() > 3) canvas.fill_polygon(upper, color);
        upper.clear();
        lower.clear();
    };
    for (std::size_t i = 0; i < shown; ++i) {
        const double mean = history_.lines[index][i], error = history_.errors[index][i];
        const bool leg_ends = i + 1 == shown || history_.leg[i + 1] != history_.leg[i];
        if (std::isfinite(error)) {
            const double x = s.x(history_.time[i]);
            const Point high{x, s.height(std::max(mean + error, 1e-300), logarithmic_)};
            const Point low{x, s.height(std::max(mean - error, 1e-300), logarithmic_)};
            if (leg_ends || upper.empty() || is_apart(upper.back(), high, 0.08 * dc.unit)) {
                upper.push_back(high);
                lower.push_back(low);
            }
        }
        if (leg_ends || !std::isfinite(error)) end_band();
    }
}

void SeriesPanel::draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const {
    const auto& now = static_cast<const SeriesState&>(state);
    const std::size_t shown = now.shown.front();
    for (std::size_t k = 0; k < history_.errors.size(); ++k) draw_band(canvas, dc, k, shown);
    if (!compares())
        for (std::size_t k = history_.lines.size(); k-- > 0;)
            draw_line(canvas, dc, history_, k, look(k, dc), shown);
    const std::vector<const History*> runs = histories();
    for (std::size_t k = compares() ? runs.size() : 0; k-- > 0;)
        draw_line(canvas, dc, *runs[k], 0, look(k, dc), now.shown.at(k));
}

// Frames in which time stands show one point.
Table SeriesPanel::table(const PanelState& state, const Theme&) const {
    const auto& now = static_cast<const SeriesState&>(state);
    if (!compares()) return table_of(history_, now.shown.front(), reference_);
    Table all;
    const std::vector<const History*> runs = histories();
    for (std::size_t k = 0; k < runs.size(); ++k) {
        std::optional<ReferenceLevel> level = reference_;
        if (!levels_.empty() && std::isfinite(levels_[k].value)) level = levels_[k];
        add_table_of_run(all, names_[k], table_of(*runs[k], now.shown.at(k), level));
    }
    return all;
}

Table SeriesPanel::table_of(const History& history, std::size_t shown,
                            const std::optional<ReferenceLevel>& reference) const {
    Table table{
        {"part", "of", column_name("time", reduced::time), "reversals (count)", subject_.column}};
    if (!history.errors.empty()) table.columns.push_back("standard error of " + subject_.column);
    for (std::size_t k = 0; k < history.lines.size(); ++k) {
        const std::vector<double>& line = history.lines[k];
        for (std::size_t i = 0; i < shown; ++i) {
            const bool stands = i > 0 && history.time[i] == history.time[i - 1] &&
                                history.leg[i] == history.leg[i - 1] && line[i] == line[i - 1];
            if (!std::isfinite(line[i]) || stands) continue;
            table.rows.push_back({"line", subject_.names.at(compares() ? subject_.compared : k),
                                  history.time[i], std::int64_t{history.leg[i]}, line[i]});
            if (!history.errors.empty()) table.rows.back().emplace_back(history.errors[k][i]);
        }
    }
    if (reference)
        for (const double time : {first_, last_})
            table.rows.push_back({"reference", reference->name, time, {}, reference->value});
    if (same_reversals_)
        for (const double at : reversal_times(context_.scene.run))
            table.rows.push_back({"reversal", {}, folded_time(context_.scene.run, at), {}, {}});
    for (std::vector<Cell>& row : table.rows) row.resize(table.columns.size());
    return table;
}

}  // namespace carom

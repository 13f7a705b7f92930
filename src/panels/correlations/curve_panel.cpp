#include "panels/correlations/curve_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/axis.h"
#include "panels/archived.h"
#include "panels/chosen.h"
#include "panels/plot/window.h"
#include "physics/sample_times.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr int probes = 40;              // samples that decide the height of the axis
constexpr double settled = 0.3;         // share of the run before which probes are not taken
constexpr double alpha_of_steps = 0.3;  // of the area under steps
constexpr int depth_of_curves = 2;

}  // namespace

double CurveRecord::start() const {
    return std::ranges::min_element(runs, {}, &CurveRun::start)->start;
}

double CurveRecord::reach() const {
    return std::ranges::max_element(runs, {}, &CurveRun::reach)->reach;
}

CurveRecord mean_of(const std::vector<CurveRecord>& records) {
    CurveRecord mean = begun_mean(records);
    CurveRun& all = mean.runs.front();
    for (const CurveRecord& record : records) {
        const CurveRun& run = record.runs.front();
        all.start = std::min(all.start, run.start);
        if (!all.is_reach_its_own) all.reach = std::max(all.reach, run.reach);
        all.least = std::min(all.least, run.least);
        all.most = std::max(all.most, run.most);
        all.least_positive = std::min(all.least_positive, run.least_positive);
    }
    return mean;
}

void name_curves(CurveSubject& subject, const PanelContext& context, const PanelSpec& spec,
                 const std::string& what, const std::string& time) {
    const std::vector<Chosen> chosen = choices(spec);
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.lines.push_back(
            {column_name_of(context.scene, chosen[k]), "", role_among(context, chosen, k)});
    const plot::Text base = spec.title ? escape_markup(*spec.title) : what;
    const bool has_names = !spec.of.empty() && !spec.title;
    const plot::Text named = has_names ? shown_of(context, base, chosen, plot::Swatch::line) : base;
    if (!time.empty())
        subject.titles.push_back(
            plot::text_of(context.language(), Phrase{"{}: {}"}, {named, time}));
    subject.titles.push_back(named);
    subject.names_axis = spec.title.has_value();
    if (!has_names) return;
    subject.titles.push_back(base);
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.names.push_back(
            {.swatch = plot::Stroke{.role = subject.lines[k].role,
                                    .print_dashes = plot::dashes_in_print(k, chosen.size()),
                                    .shade = plot::Shade::legible},
             .words = {plot::named(name_of(context.scene, chosen[k]), subject.lines[k].role)}});
}

std::size_t CurveState::bytes() const {
    std::size_t sum = 0;
    for (const CurveValues& run : runs) sum += run.bytes();
    return 2 * sum;  // with the readouts
}

std::string percent_per(Language language, double width) {
    return say(language, "% per {}", localised(language, fmt::format("{:.3g}", width)));
}

CurvePanel::CurvePanel(const PanelContext& context, CurveSubject subject)
    : context_(context), subject_(std::move(subject)), surveyed_(subject_.meter()) {
    if (subject_.reach) surveyed_->fix_axis(0.0, *subject_.reach, subject_.points);
}

CurveValues CurvePanel::values_of(const CurveMeter& meter) const {
    CurveValues values{meter.measured()};
    values.x = places();
    if (subject_.laws) values.laws = subject_.laws(values);
    return values;
}

void CurvePanel::take_in(const Measured& values) {
    CurveRun& run = record_.runs.front();
    for (const std::vector<double>& curve : values.y)
        for (const double value : curve) {
            if (!std::isfinite(value)) continue;
            run.least = std::min(run.least, value);
            run.most = std::max(run.most, value);
            if (value > 0.0) run.least_positive = std::min(run.least_positive, value);
        }
}

void CurvePanel::survey(const FrameInput& input) {
    surveyed_->see(input);
    const auto samples = static_cast<int>(sample_count(context_.run()));
    const bool is_probe =
        samples_seen_ >= settled * samples && samples_seen_ % std::max(1, samples / probes) == 0;
    if (is_probe && subject_.reach) take_in(surveyed_->measured());
    ++samples_seen_;
}

void CurvePanel::finish_record() {
    CurveRun& run = record_.runs.front();
    run.start = subject_.reach ? 0.0 : surveyed_->start();
    run.reach = subject_.reach ? *subject_.reach : surveyed_->reach();
    run.points = subject_.points;
    run.is_reach_its_own = subject_.reach.has_value();
    if (!subject_.reach) surveyed_->fix_axis(run.start, run.reach, subject_.points);
    take_in(surveyed_->measured());
    surveyed_ = nullptr;
}

plot::Axis CurvePanel::axis_up() const {
    double least = 0.0, most = 0.0, least_positive = 1.0;
    for (const CurveRun& run : record_.runs) {
        least = std::min(least, run.least);
        most = std::max(most, run.most);
        least_positive = std::min(least_positive, run.least_positive);
    }
    plot::Axis axis;
    if (subject_.logarithmic) {
        constexpr double most_decades = 5.0;
        axis.kind = plot::Axis::Kind::logarithmic;
        axis.high = most > 0.0 ? std::ceil(std::log10(most)) : 0.0;
        axis.low = std::max(std::floor(std::log10(least_positive)), axis.high - most_decades);
        axis.low = std::min(axis.low, axis.high - 1.0);
        return axis;
    }
    axis.high = subject_.top
                    ? *subject_.top
                    : round_up_for_axis(1.05 * std::max({most, subject_.level.value_or(0.0),
                                                         subject_.least_top}));
    // Values less than a fiftieth of the axis below 0 are noise; the axis need not show them.
    constexpr double step = 0.2, noise = 0.02;
    if (least < -noise * axis.high) axis.low = step * std::floor(least / step);
    return axis;
}

// Compared runs have their own axes, which may be longer or finer than those of the others; runs
// that differ only in their seeds have the axis of the first.
void CurvePanel::make_axes() {
    const bool is_own = subject_.reach && record_.compares();
    shown_ = subject_.meter();
    shown_start_ = is_own ? 0.0 : record_.start();
    shown_reach_ = is_own ? *subject_.reach : record_.reach();
    shown_points_ = is_own ? subject_.points : record_.runs.front().points;
    shown_->fix_axis(shown_start_, shown_reach_, shown_points_);
    make_plot();
}

void CurvePanel::make_plot() {
    const Language language = context_.language();
    const bool is_steps = subject_.shape == CurveSubject::Shape::steps;
    whole_ = {};
    whole_.language = language;
    whole_.titles = subject_.titles;
    whole_.x = plot::axis_of(language, subject_.along, record_.start(), record_.reach());
    whole_.y = axis_up();
    whole_.y.quantity = subject_.up;
    if (subject_.height)
        whole_.y.title = subject_.height((record_.reach() - record_.start()) / subject_.points);
    else if (subject_.names_axis)
        whole_.y.title = say(language, subject_.up.word);
    if (subject_.names.size() > 1 && !record_.compares())
        whole_.notes.push_back({.entries = subject_.names, .wraps = true, .of_last_titles = 1});
    const std::string along(subject_.along.word.english);
    if (is_steps)
        whole_.columns = {
            {along + " from", subject_.along}, {along + " to", subject_.along}, subject_.up};
    else
        whole_.columns = {subject_.along, subject_.up};
    if (record_.runs_in_mean > 1) whole_.columns.push_back(standard_error_of(subject_.up));
    if (record_.compares()) plot::name_runs(whole_, record_.names());
    std::vector<double> levels;
    if (subject_.level) levels.push_back(*subject_.level);
    if (whole_.y.low < 0.0 && !subject_.logarithmic) levels.push_back(0.0);
    for (const double value : levels) {
        plot::Level level;
        level.still = true;
        level.value = value;
        level.stroke = {.width = 0.06, .dashes = {0.3, 0.4}};
        whole_.layers.emplace_back(std::move(level));
    }
}

std::shared_ptr<const PanelState> CurvePanel::state(const FrameInput& input) {
    shown_->see(input);
    auto state = std::make_shared<CurveState>();
    state->runs = {values_of(*shown_)};
    if (input.refreshes_readouts || !readouts_)
        readouts_ = std::make_shared<const CurveValues>(state->runs.front());
    state->readouts = readouts_;
    return state;
}

void CurvePanel::archive_progress(Archive& archive) {
    shown_->archive(archive);
    archive(readouts_);
}

std::shared_ptr<const PanelState> CurvePanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    std::vector<const CurveState*> all;
    for (const auto& state : states) all.push_back(&dynamic_cast<const CurveState&>(*state));
    auto both = std::make_shared<CurveState>();
    if (record_.compares()) {
        for (const CurveState* state : all) both->runs.push_back(state->runs.front());
        return both;
    }
    std::vector<const Measured*> measured;
    for (const CurveState* state : all) measured.push_back(&state->runs.front());
    CurveValues mean{mean_of(measured)};
    both->runs = {mean};
    both->readouts = std::make_shared<const CurveValues>(std::move(mean));
    return both;
}

// The horizontal positions of the points, or of the edges of the bins, of this panel's own run.
std::vector<double> CurvePanel::places() const {
    const bool is_steps = subject_.shape == CurveSubject::Shape::steps;
    const int steps = is_steps ? shown_points_ : shown_points_ - 1;
    std::vector<double> at;
    for (int k = 0; k <= steps; ++k)
        at.push_back(shown_start_ + (shown_reach_ - shown_start_) * k / steps);
    return at;
}

plot::Bars CurvePanel::bars_of(const CurveValues& run, std::size_t line) const {
    const std::vector<double>&at = run.x, &values = run.y[line];
    plot::Bars bars;
    bars.part = "bar";
    bars.from = plot::column(whole_.columns[0], {at.begin(), at.end() - 1});
    bars.to = plot::column(whole_.columns[1], {at.begin() + 1, at.end()});
    std::vector<double> heights;
    for (const double value : values) heights.push_back(std::isfinite(value) ? value : 0.0);
    bars.value = plot::column(whole_.columns[2], std::move(heights));
    return bars;
}

plot::Polyline CurvePanel::line_of(const CurveValues& run, std::size_t index) const {
    plot::Polyline line;
    line.part = "curve";
    line.x = plot::column(whole_.columns[0], run.x);
    line.y = plot::column(whole_.columns[1], run.y[index]);
    line.is_thinned = false;
    return line;
}

void CurvePanel::add_curve(plot::Plot& plot, const CurveState& state, std::size_t run,
                           std::size_t line) const {
    const bool compares = record_.compares();
    const std::size_t count = compares ? state.runs.size() : state.runs[run].y.size();
    const plot::Role role = subject_.lines[line].role;
    const NumberRows& errors = state.runs[run].error;
    plot::Stroke stroke = {.role = role,
                           .print_dashes = plot::dashes_in_print(line, count),
                           .shade = plot::Shade::legible};
    if (compares) stroke = plot::stroke_of_run(run);
    const auto add = [&](auto layer) {
        layer.of = subject_.lines[line].column;
        if (compares) layer.run = run;
        layer.depth = depth_of_curves + static_cast<int>(compares ? run : line);
        plot.layers.emplace_back(std::move(layer));
    };
    if (subject_.shape == CurveSubject::Shape::steps) {
        plot::Bars bars = bars_of(state.runs[run], line);
        bars.role = stroke.role;
        bars.alpha = count > 1 ? 0.0 : alpha_of_steps;
        bars.edge = stroke;
        if (!errors.empty()) bars.error = plot::column(whole_.columns[3], errors[line]);
        bars.error_stroke.role = {.of = plot::Role::Of::ink};
        add(std::move(bars));
        return;
    }
    plot::Polyline curve = line_of(state.runs[run], line);
    curve.stroke = stroke;
    if (!errors.empty()) {
        plot::Band band;
        band.x = curve.x;
        band.y = curve.y;
        band.error = plot::column(whole_.columns[2], errors[line]);
        band.role = role;
        curve.more = {band.error};
        add(std::move(band));
    }
    add(std::move(curve));
}

std::optional<std::array<double, 2>> CurvePanel::time_shown(double at) const {
    const auto start = start_of_mean(subject_.over, at);
    if (!start) return {};
    return {{std::min(at, std::max(*start, subject_.from)), at}};
}

plot::Plot CurvePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    const auto* shown = static_cast<const CurveState*>(state);
    const bool compares = record_.compares();
    if (!compares && subject_.add) subject_.add(shown ? shown->readouts.get() : nullptr, now);
    if (subject_.names.size() == 1 && !compares)  // less missed than what was added
        now.notes.push_back({.entries = subject_.names, .of_last_titles = 1});
    if (const std::string words = words_of_mean(context_.language(), record_.runs_in_mean);
        !words.empty())  // dropped first if there is no room
        now.notes.push_back({.entries = {{.words = {plot::Text(words)}}}});
    if (shown == nullptr) return now;
    for (std::size_t run = 0; run < shown->runs.size(); ++run) {
        const std::size_t lines = compares ? 1 : shown->runs[run].y.size();
        std::vector<std::string> accounts;
        for (std::size_t line = 0; line < lines; ++line) {
            add_curve(now, *shown, run, line);
            const std::string words =
                subject_.account ? subject_.account(shown->runs[run], line) : "";
            if (!words.empty()) accounts.push_back(words);
        }
        if (compares)
            now.accounts_of_runs.push_back(accounts.empty() ? say(context_.language(), "unknown")
                                                            : accounts.front());
        else
            for (const std::string& words : accounts)
                now.account += (now.account.empty() ? "" : " ") + capitalised(words) + ".";
    }
    return now;
}

Meter meter_of_curves(const CurveSubject& subject) {
    if (!subject.results.find) return {};
    Meter meter{.title = {}, .lines = subject.lines, .needs_collisions = true};
    for (MeterLine& line : meter.lines)
        if (meter.lines.size() > 1) line.name = line.column;
    const std::shared_ptr<CurveMeter> curves = subject.meter();
    meter.follow = [curves](const FrameInput& input) { curves->see(input); };
    meter.results.of = subject.results.of;
    meter.results.find = [curves, subject, has_axis = false]() mutable {
        if (!std::exchange(has_axis, true))
            curves->fix_axis(curves->start(), curves->reach(), subject.points);
        CurveValues now{curves->measured(), {}};
        if (subject.laws) now.laws = subject.laws(now);
        std::vector<std::vector<MeanError>> found;
        for (std::size_t line = 0; line < now.y.size(); ++line)
            found.push_back(subject.results.find(now, line));
        return found;
    };
    return meter;
}

}  // namespace carom

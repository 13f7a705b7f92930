// What a histogram shows in one frame, as a plot: bars, curves, fits and markers of means.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "panels/chosen.h"
#include "panels/gas/gas_colors.h"
#include "panels/plot/draw_bars.h"
#include "panels/plot/layers.h"
#include "panels/plots/histogram_panel.h"
#include "scene/film.h"
#include "util/text.h"

namespace carom {
namespace {

using namespace plot;

constexpr double line_width = 0.16, thin_width = 0.07, marker_width = 0.12;  // units
constexpr double tint_alpha = 0.3;        // of bars that others overlap
constexpr double told_beyond = 0.01;      // of all values: fewer beyond the axis are not mentioned
constexpr std::size_t most_fit_rows = 3;  // more would leave no room for the bars
// Depths of layers, from the bottom up; bars of compared runs are drawn from the last to the first.
constexpr int depth_of_bars = 3, depth_of_lines = 2, depth_of_starts = 1;

const Heading error_column{"standard error", quantities::count_per_bin};

Polyline line_of(const char* part, HistogramCurve curve, const Heading& x, const Heading& y) {
    Polyline line;
    line.part = part;
    line.x = column(x, std::move(curve.value));
    line.y = column(y, std::move(curve.count));
    line.is_thinned = false;
    line.depth = depth_of_lines;
    return line;
}

// The normal curve with the mean and the standard deviation of the values in the bars.
HistogramCurve normal_curve(const Bins& bins, const MeanHistogram& now, double values) {
    HistogramCurve curve;
    if (!(now.deviation > 0.0)) return curve;
    constexpr int points = 120;
    for (int i = 0; i <= points; ++i) {
        const double value = bins.low + (bins.high - bins.low) * i / points;
        const double z = (value - now.mean) / now.deviation;
        const double density =
            std::exp(-0.5 * z * z) / (now.deviation * std::sqrt(2.0 * std::numbers::pi));
        curve.value.push_back(value);
        curve.count.push_back(values * bins.width() * density);
    }
    return curve;
}

// The range of a number over runs, from the lowest to the highest, as text.
std::string range_of(Language language, const std::vector<MeanHistogram>& now,
                     double MeanHistogram::*beyond, const std::string& unit) {
    const auto [fewest, most] = std::ranges::minmax(now, {}, beyond);
    if (!(most.*beyond > 0.0)) return "";
    const std::string low = count_words(language, fewest.*beyond),
                      high = count_words(language, most.*beyond);
    return (low == high ? high : say(language, "{} to {}", low, high)) + unit;
}

}  // namespace

// One choice of particles has the colours of all histograms, several have their own.
HistogramPanel::Roles HistogramPanel::roles_of(std::size_t k) const {
    const Role run{.of = Role::Of::run, .index = k};
    if (compares()) return {run, run, run};
    if (count() == 1) return {{Role::Of::bar}, {Role::Of::accent}, {Role::Of::highlight}};
    const auto color = [&](std::size_t choice, const Theme& theme) {
        return color_of(role_of_choice(choice), theme);
    };
    const auto line = [&](double share) {
        return own_role(themes_of(context_.film()), [&, share](const Theme& theme) {
            std::vector<Color> tints{theme.page};
            for (std::size_t i = 0; i < count(); ++i)
                tints.push_back(mix(theme.page, color(i, theme), tint_alpha));
            return toward_ink(mix(color(k, theme), theme.ink, share), theme, tints,
                              least_contrast_of_marks);
        });
    };
    return {role_of_choice(k), line(0.4), line(0.7)};
}

HistogramPanel::SeriesLayers HistogramPanel::layers_of(std::size_t k) const {
    std::vector<double> from, to;
    for (int i = 0; i < axes_.bins.count; ++i) {
        from.push_back(axes_.bins.edge(i));
        to.push_back(axes_.bins.edge(i + 1));
    }
    Bars bars;
    bars.part = "bar";
    bars.from = column(from_column(), std::move(from));
    bars.to = column(to_column(), std::move(to));
    bars.role = roles_[k].bar;
    bars.error_stroke.role = count() > 1 ? roles_[k].curve : Role{Role::Of::ink};
    bars.depth = depth_of_bars;
    Polyline curve = line_of("curve", axes_.curves[k], from_column(), value_column());
    curve.stroke = {.role = roles_[k].curve, .width = compares() ? thin_width : line_width};
    if (compares()) {  // filled areas of more than two runs would hide each other
        bars.alpha = 0.0;
        bars.edge = stroke_of_run(k, line_width);
        bars.depth += static_cast<int>(k);
        curve.depth = depth_of_bars + static_cast<int>(count());
    } else if (count() > 1) {
        bars.alpha = tint_alpha;
        bars.edge = Stroke{.role = roles_[k].bar,
                           .width = 0.1,
                           .print_dashes = dashes_in_print(k, count()),
                           .shade = Shade::legible};
        curve.stroke.print_dashes = dashes_in_print(k, count());
        const auto is_hidden = [&](std::size_t other) {  // below this curve, if that were solid
            return axes_.curves[other].count == axes_.curves[k].count;
        };
        for (std::size_t other = 0; other < k; ++other)
            if (is_hidden(other)) curve.stroke.dashes = {0.8};
    }
    return {std::move(bars), std::move(curve)};
}

// Dashed if there is an equilibrium curve, which has the same colour in print.
plot::Stroke HistogramPanel::fit_stroke(std::size_t k) const {
    Stroke stroke{.role = roles_[k].fit, .width = line_width};
    if (!axes_.curves[k].empty()) stroke.dashes = {0.8};
    if (count() > 1) stroke.print_dashes = dashes_in_print(count() + k, 2 * count());
    return stroke;
}

plot::Note HistogramPanel::fit_note(std::size_t k, const MeanHistogram* now) const {
    Note note{.changes = true, .is_over_plot = true};
    if (now == nullptr) return note;
    const Language language = context_.language();
    const std::string whose = count() == 1 ? say(language, "normal curve") : name_of_series(k);
    const Wording wording = context_.wording();
    const Quantity& quantity = subject_.quantity;
    // The mean has the decimals of the deviation, unless it is larger.
    const std::string deviation =
        steady_number(wording, quantity, now->deviation, {0.0, now->deviation});
    const std::string mean = steady_number(wording, quantity, now->mean,
                                           {0.0, std::max(std::abs(now->mean), now->deviation)});
    const std::string numbers = say(language, "mean {}, standard deviation {}", mean, deviation);
    const std::string short_numbers = say(language, "mean {}, s.d. {}", mean, deviation);
    const Role& role = roles_[k].fit;
    KeyEntry entry{.words = {named(say(language, "{}: {}", whose, numbers), role),
                             named(say(language, "{}: {}", whose, short_numbers), role),
                             named(short_numbers, role)}};
    if (const Stroke stroke = fit_stroke(k); !stroke.dashes.empty() || !stroke.print_dashes.empty())
        entry.swatch = stroke;
    note.entries.push_back(std::move(entry));
    return note;
}

plot::Marker HistogramPanel::mean_marker(std::size_t k, double mean, bool is_start) const {
    Marker marker;
    marker.part = is_start ? "mean at start" : "mean";
    marker.column = from_column();
    marker.value = mean;
    marker.stroke.width = marker_width;
    marker.is_under_axis = true;
    if (is_start) marker.depth = depth_of_starts;
    if (is_start) marker.stroke.dashes = {0.25};
    if (count() > 1)
        marker.stroke.role = is_start ? roles_[k].bar : roles_[k].curve;
    else
        marker.stroke.role = {is_start ? Role::Of::muted : Role::Of::ink};
    return marker;
}

// A single choice of particles whose disks are coloured by what the bars count.
void HistogramPanel::take_colors(const GasColors& colors) {
    const bool is_single = count() == 1 && !compares();
    if (!is_single || !colors.has_bar() || subject_.colored_by != context_.film().color_by) return;
    const auto [light, dark, print] = themes_of(context_.film());
    const auto on = [&](const Theme* theme) { return scale_colors(context_.film(), *theme); };
    whole_.ramp =
        std::make_shared<const Ramp>(Ramp{{on(light), on(dark), on(print)}, colors.scale().top});
}

plot::Bars HistogramPanel::bars_of(const HistogramState& state, std::size_t k) const {
    const MeanHistogram& now = state.counts.series[k];
    Bars bars = layers_[k].bars;
    bars.value = column(value_column(), now.counts);
    bars.ramp = whole_.ramp;
    bars.below = now.below;
    bars.above = now.above;
    if (!state.counts.errors.empty()) bars.error = column(error_column, state.counts.errors[k]);
    for (std::size_t i = 0; i < now.counts.size(); ++i) {
        const bool is_taller =
            state.taller.empty() ? now.counts[i] > axes_.top : state.taller[k][i];
        bars.taller.push_back(
            is_taller ? count_words(context_.language(), state.readouts->series[k].counts[i]) : "");
    }
    return bars;
}

// Without a state only the equilibrium curve is added, of which words keep clear.
void HistogramPanel::add_series(Plot& plot, std::size_t k, const HistogramState* state) const {
    const HistogramSeries& series = axes_.series[k];
    const auto add = [&](auto layer) {
        layer.of = !compares() ? series.name
                   : parts_    ? parts_->names(Language::english).front()
                               : column_name_of(context_.scene, choices_.front().chosen);
        if (compares()) layer.run = k;
        plot.layers.emplace_back(std::move(layer));
    };
    if (state) add(bars_of(*state, k));
    if (!axes_.curves[k].empty()) add(layers_[k].curve);
    if (state == nullptr) return;
    const MeanHistogram& one = state->counts.series[k];
    if (options().fit) {
        for (const auto& [part, value] :
             {std::pair{"fit mean", one.mean}, {"fit standard deviation", one.deviation}})
            plot.numbers.push_back({.part = part,
                                    .of = compares() ? "" : series.name,
                                    .more = {column(from_column(), {value})}});
        Polyline fit = line_of(
            "fit",
            normal_curve(axes_.bins, one, parts_ ? one.values() : series.unit * series.values()),
            from_column(), value_column());
        fit.stroke = fit_stroke(k);
        add(std::move(fit));
    }
    if (marks_mean_now() && std::isfinite(one.mean)) add(mean_marker(k, one.mean, false));
    if (marks_mean_start() && std::isfinite(series.mean_start))
        add(mean_marker(k, series.mean_start, true));
}

// A dash: no values. The number of decimals is the same in all frames; for a mean near 0 it is no
// more than the axis shows.
std::string HistogramPanel::mean_words(std::size_t k, double mean) const {
    constexpr double least_of_axis = 0.1;
    if (!std::isfinite(mean)) return "\u2013";
    const HistogramSeries& series = axes_.series[k];
    const double least = least_of_axis * axes_.bins.high;
    return steady_number(context_.wording(), subject_.quantity, mean,
                         {std::min(series.lowest_mean, 0.0),
                          std::max({series.highest_mean, -series.lowest_mean, least})});
}

// A figure of one time has no "now".
std::vector<plot::BarNotes::Name> HistogramPanel::mean_names(const HistogramCounts* now) const {
    const Language language = context_.language();
    std::vector<BarNotes::Name> names;
    const auto add = [&](std::size_t k, const std::string& name, const std::string& short_name,
                         double mean, bool is_start) {
        names.push_back({mean_marker(k, mean, is_start).stroke, name, short_name,
                         now ? mean_words(k, mean) : ""});
    };
    const bool is_present = window() == 0.0 && !spec_.at;
    if (marks_mean_now())
        for (std::size_t k = 0; k < count(); ++k) {
            const double mean = now ? now->series[k].mean : 0.0;
            if (count() > 1)
                add(k, k == 0 ? say(language, "mean: {}", name_of_series(k)) : name_of_series(k),
                    name_of_series(k), mean, false);
            else
                add(k, say(language, is_present ? Phrase{"mean now"} : Phrase{"mean"}),
                    say(language, is_present ? Phrase{"now"} : Phrase{"mean"}), mean, false);
        }
    if (marks_mean_start() && count() == 1)
        add(0, say(language, "mean at start"), say(language, "start"),
            axes_.series.front().mean_start, true);
    if (marks_mean_start() && count() > 1) {  // their numbers would need a row each
        Stroke dashed = mean_marker(0, axes_.series.front().mean_start, true).stroke;
        dashed.role = {Role::Of::muted};
        names.push_back(
            {dashed, say(language, "means at the start"), say(language, "start"), "", false});
    }
    return names;
}

// Fits are written above the bars, and so are means that have no room beside the bars. With a fit
// such means are omitted, since the fit states the mean. The number of values beyond the axis may
// be a small fraction of 1 in a mean over time.
plot::BarNotes HistogramPanel::bar_notes(const HistogramCounts* now) const {
    BarNotes notes{.may_be_beside = !fills_the_middle() && !compares(),
                   .beyond = say(context_.language(), "off scale")};
    notes.are_in_a_row = count() > 1;
    if (!compares()) notes.names = mean_names(now);
    if (options().fit && !notes.may_be_beside) notes.names.clear();
    for (int i = 0; i < axes_.bins.count; ++i)
        notes.highest.push_back(
            {axes_.bins.edge(i), axes_.bins.edge(i + 1), axes_.highest.at(std::size_t(i))});
    double values = 0.0, below = 0.0, above = 0.0;
    for (std::size_t k = 0; k < count(); ++k) {
        const HistogramSeries& series = axes_.series[k];
        for (const double mean : {series.mean_start, series.lowest_mean, series.highest_mean})
            if (std::string words = mean_words(k, mean); words.size() > notes.typical_number.size())
                notes.typical_number = std::move(words);
        values += now && parts_ ? now->series[k].values() : series.values();
        if (now) below += now->series[k].below;
        if (now) above += now->series[k].above;
    }
    if (compares()) {
        const Language language = context_.language();
        const std::string unit = axes_.counts_per_cent() ? " %" : "";
        if (now) notes.below = range_of(language, now->series, &MeanHistogram::below, unit);
        if (now) notes.above = range_of(language, now->series, &MeanHistogram::above, unit);
        return notes;
    }
    const double least = window() == 0.0 ? 0.0 : told_beyond * values;
    if (below > 0.0 && below >= least) notes.below = count_words(context_.language(), below);
    if (above > 0.0 && above >= least) notes.above = count_words(context_.language(), above);
    return notes;
}

// The name of a curve: of a single choice that it is the curve of equilibrium; of one of several,
// the name of the choice, which without a curve stands at its highest bars.
plot::Label HistogramPanel::name_of_curve(std::size_t k) const {
    const HistogramCurve& curve = axes_.curves[k].empty() ? axes_.outlines[k] : axes_.curves[k];
    plot::Label label;
    label.still = true;
    const auto peak =
        static_cast<std::size_t>(std::ranges::max_element(curve.count) - curve.count.begin());
    const auto add = [&](std::size_t i, double across, double up, Align align) {
        label.anchors.push_back({.at = {curve.value[i], curve.count[i]},
                                 .offset = {across, up},
                                 .align = align,
                                 .is_inside = true});
    };
    const bool is_single = count() == 1;
    if (is_single) {
        label.role = {Role::Of::accent};
        label.words = {say(context_.language(), subject_.curve),
                       say(context_.language(), subject_.short_curve)};
    } else {
        label.is_name = true;
        label.swatch = *layers_[k].bars.edge;
        label.words = {named(name_of_series(k), roles_[k].curve, plot::Swatch::line, k)};
    }
    const std::size_t places = is_single ? 14 : 7;
    constexpr double least = 0.25;  // of the peak: beyond, curves are close to one another
    const std::size_t right = curve.value.size() - 1 - peak;
    for (double up = -0.5; up > (is_single ? -4.0 : -8.0); up -= 1.1) {
        if (!is_single) add(peak, 0.0, up, Align::center);
        for (std::size_t place = 1; place < places; ++place) {
            const std::size_t after = peak + right * place / places;
            const std::size_t before = peak - peak * place / places;
            if (is_single || curve.count[after] > least * curve.count[peak])
                add(after, 0.6, up, Align::left);
            if (!is_single && curve.count[before] > least * curve.count[peak])
                add(before, -0.6, up, Align::right);
        }
    }
    if (!subject_.shares.empty())  // beside bars that once were higher than the curve
        label.anchors.push_back({.at = {1.0, 0.0},
                                 .x_is_share = true,
                                 .y_is_share = true,
                                 .offset = {-0.5, 1.5},
                                 .align = Align::right,
                                 .is_inside = true});
    return label;
}

// Each choice is named at its curve, where these have places; what the curves are is said where
// there is room, from the top right on.
void HistogramPanel::add_names() {
    if (compares() || (!parts_ && !axes_.has_curves())) return;
    const bool has_gap = std::ranges::any_of(axes_.curves, &HistogramCurve::empty);
    if (count() == 1 ? has_gap : options().fit || (!parts_ && has_gap)) return;
    for (std::size_t k = 0; k < count(); ++k) whole_.layers.emplace_back(name_of_curve(k));
    if (count() == 1) return;
    const Language language = context_.language();
    plot::Label curves;
    curves.still = curves.is_name = true;
    curves.words = {say(language, "lines: equilibrium"), say(language, "equilibrium")};
    for (double down = 1.05; down < 12.0; down += 1.4)
        curves.anchors.push_back({.at = {1.0, 0.0},
                                  .x_is_share = true,
                                  .y_is_share = true,
                                  .offset = {-0.5, down},
                                  .align = Align::right,
                                  .step = {-1.0, 0.0},
                                  .is_inside = true});
    for (const double at : {1.0, 0.75, 0.5})  // over the top, where no title of an axis stands
        curves.anchors.push_back({.at = {at, 0.0},
                                  .x_is_share = true,
                                  .y_is_share = true,
                                  .offset = {-0.5, 0.25},
                                  .align = Align::right});
    if (axes_.has_curves()) whole_.layers.emplace_back(std::move(curves));
    plot::NamedAtLines at_lines;
    const plot::Text words = spec_.title ? plot::Text(escape_markup(*spec_.title))
                                         : plot::Text(say(language, subject_.title));
    at_lines.titles = titles_with_asides(
        words, spec_.title ? words : capitalised(say(language, subject_.quantity.word)));
    for (const BarNotes::Name& name : mean_names(nullptr))
        at_lines.means.push_back(name.has_number ? say(language, "mean") : name.short_name);
    whole_.at_lines = std::move(at_lines);
}

Heading HistogramPanel::from_column() const {
    return {std::string(subject_.quantity.word.english) + " from", subject_.quantity};
}

Heading HistogramPanel::to_column() const {
    return {std::string(subject_.quantity.word.english) + " to", subject_.quantity};
}

Heading HistogramPanel::value_column() const {
    return {"value", axes_.counts_per_cent() ? quantities::per_cent : quantities::count_per_bin};
}

void HistogramPanel::make_plot() {
    const Language language = context_.language();
    whole_.language = language;
    whole_.x = axis_of(language, subject_.quantity, axes_.bins.low, axes_.bins.high);
    whole_.y.title = height_name();
    whole_.y.high = axes_.top;
    whole_.y.quantity = value_column().quantity;
    whole_.y.is_whole = window() == 0.0 && axes_.runs == 1 && !axes_.counts_per_cent();
    for (std::size_t k = 0; k < count(); ++k) layers_.push_back(layers_of(k));
    const Text left_out = add_titles();
    add_names();
    whole_.columns = {from_column(), to_column(), value_column()};
    if (axes_.runs > 1) whole_.columns.push_back(error_column);
    std::vector<std::string> names;
    for (const auto& one : axes_.series) names.push_back(one.name);
    if (compares()) name_runs(whole_, std::move(names));
    if (Note note = note_of_short_title(); !note.entries.empty())
        whole_.notes.push_back(std::move(note));
    if (!left_out.empty())
        whole_.notes.push_back({.entries = {{{}, {left_out}}}, .of_last_titles = 1});
}

// "mean 1.25", with the standard error of a mean over runs, and the deviation of what is symmetric
// or fitted.
std::string HistogramPanel::account_of_series(const HistogramCounts& now, std::size_t k) const {
    const Language language = context_.language();
    const MeanHistogram& one = now.series[k];
    if (!std::isfinite(one.mean)) return compares() ? say(language, "unknown") : "";
    const double error = now.mean_errors.empty() ? NAN : now.mean_errors[k];
    // Without an error, a mean that is 0 within the rounding of its sum is 0.
    const bool is_small = subject_.symmetric && std::abs(one.mean) < one.deviation;
    const std::string mean =
        is_small && !(error > 0.0)
            ? steady_number(context_.wording(), subject_.quantity, one.mean, {0.0, one.deviation})
            : with_error(context_.wording(), subject_.quantity, one.mean, error);
    const std::string words =
        subject_.symmetric || options().fit
            ? say(language, "mean {}, standard deviation {}", mean,
                  three_digits(context_.wording(), subject_.quantity, one.deviation))
            : say(language, "mean {}", mean);
    if (compares() || count() == 1) return words;
    return say(language, "{}: {}", name_of_series(k), words);
}

std::vector<PanelNumber> HistogramPanel::scalars(const PanelState& state) const {
    std::vector<PanelNumber> all;
    const HistogramCounts& now = static_cast<const HistogramState&>(state).counts;
    for (std::size_t k = 0; k < count(); ++k) {
        const MeanHistogram& one = now.series[k];
        const std::string whose = count() > 1 ? axes_.series[k].name + "." : "";
        for (const std::string& of : {std::string(), std::string("fit.")}) {
            if (!of.empty() && !options().fit) continue;
            all.push_back({whose + of + "mean", subject_.quantity, one.mean});
            all.push_back({whose + of + "deviation", subject_.quantity, one.deviation});
        }
    }
    return all;
}

Plot HistogramPanel::plot(const PanelState* state) const {
    const auto* shown = static_cast<const HistogramState*>(state);
    const HistogramCounts* now = shown ? &shown->counts : nullptr;
    const HistogramCounts* told = shown ? shown->readouts.get() : nullptr;
    Plot plot = whole_;
    for (std::size_t k = 0; options().fit && k < std::min(count(), most_fit_rows); ++k)
        plot.notes.push_back(fit_note(k, told ? &told->series[k] : nullptr));
    plot.bar_notes = bar_notes(told);
    for (std::size_t k = 0; k < count(); ++k) add_series(plot, k, shown);
    if (now == nullptr) return plot;
    // Only figures give an account.
    for (std::size_t k = 0; !context_.in_film && k < count(); ++k) {
        const std::string words = account_of_series(*now, k);
        if (compares())
            plot.accounts_of_runs.push_back(words);
        else if (!words.empty())
            plot.account += (k > 0 ? " " : "") + capitalised(words) + ".";
    }
    if (spec_.test) plot.finding = test_words(*now);
    return plot;
}

}  // namespace carom

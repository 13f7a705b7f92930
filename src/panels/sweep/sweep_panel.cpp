#include "panels/sweep/sweep_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "draw/axis.h"
#include "panels/registry.h"
#include "panels/sweep/sweep_keys.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::Role;

// The range of an axis: a little beyond the values, and from 0 unless they would fill only a small
// part of it.
std::pair<double, double> range_of(double least, double most) {
    constexpr double small = 0.3, beyond = 0.06, equal = 1e-9;  // no more than round-off
    const double width = most - least, reach = std::max(std::abs(least), std::abs(most));
    if (!(width > small * reach)) {
        const double room =
            width > equal * reach ? 0.15 * width : 0.1 * (reach > 0.0 ? reach : 1.0);
        return {least - room, most + room};
    }
    const double low = std::min(least, 0.0), high = std::max(most, 0.0);
    const double room = beyond * (high - low);
    return {low < 0.0 ? low - room : 0.0, high > 0.0 ? high + room : 0.0};
}

// Names of numbers that have words in all languages; the others are shown in English.
constexpr std::array translated{Phrase{"wall pressure"}, Phrase{"virial pressure"},
                                Phrase{"collision rate"}, Phrase{"mean free path"}};

std::string words_of_number(Language language, const std::string& name) {
    const auto found = std::ranges::find(translated, name, &Phrase::english);
    return say(language, found == translated.end() ? Phrase{name} : *found);
}

plot::Stroke stroke_of_theory(std::vector<double> dashes) {
    return {.role = {.of = Role::Of::accent},
            .width = 0.1,
            .dashes = std::move(dashes),
            .shade = plot::Shade::legible};
}

/// A curve of a figure of one line, how it is drawn, and what its account says of it.
struct DrawnCurve {
    const SweptCurve* curve;
    std::vector<double> dashes;
    std::string (*account)(Language, const std::string& name);
};

std::vector<DrawnCurve> curves_of(const SweptLine& line) {
    using Name = const std::string&;
    std::vector<DrawnCurve> all{
        {&line.theory,
         {0.6, 0.4},
         [](Language language, Name name) { return say(language, "Dashed: {}.", name); }},
        {&line.coexistence,
         {},
         [](Language language, Name name) { return say(language, "Solid line: {}.", name); }},
        {&line.crystal,
         {1.4, 0.4},
         [](Language language, Name name) { return say(language, "Long dashes: {}.", name); }},
        {&line.ideal, {0.15, 0.35}, [](Language language, Name name) {
             return say(language, "Dotted: {}.", name);
         }}};
    // A single value makes no visible curve.
    std::erase_if(all, [](const DrawnCurve& one) { return one.curve->y.size() < 2; });
    return all;
}

struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    void take(double value) {
        if (!std::isfinite(value)) return;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    plot::Axis axis() const {
        if (!(least <= most)) return {};
        const auto [low, high] = range_of(least, most);
        return {.low = low, .high = high};
    }
};

}  // namespace

Role SweepPanel::role_of(std::size_t line, std::size_t lines) const {
    if (lines == 1) return {.of = Role::Of::bar};
    return {.of = Role::Of::run, .index = line};
}

plot::Dot SweepPanel::dot_of(std::size_t line, std::size_t lines) const {
    return {.role = role_of(line, lines), .radius = 0.26};
}

void SweepPanel::set_axes(const SweptNumbers& numbers) {
    Extent across, up;
    for (const SweptLine& line : numbers.lines) {
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            const double error = std::isfinite(line.error[i]) ? line.error[i] : 0.0;
            across.take(line.x[i]);
            up.take(line.mean[i] - error);
            up.take(line.mean[i] + error);
        }
        for (const SweptCurve* curve : {&line.theory, &line.coexistence, &line.crystal})
            for (const double value : curve->y) up.take(value);
    }
    plot_.x = across.axis();
    plot_.x.title = escape_markup(numbers.across);
    plot_.y = up.axis();
    plot_.y.quantity = numbers.number.quantity;
    if (title_) plot_.y.title = words_of_number(language_, numbers.number.name);
}

void SweepPanel::set_words(const SweptNumbers& numbers) {
    const std::string what = words_of_number(language_, numbers.number.name);
    plot_.titles = {escape_markup(capitalised(title_.value_or(what)))};
    std::int64_t least = std::numeric_limits<std::int64_t>::max(), most = 0;
    for (const SweptLine& line : numbers.lines)
        for (const std::int64_t runs : line.runs) {
            least = std::min(least, runs);
            most = std::max(most, runs);
        }
    const std::string runs =
        least == most ? fmt::format("{}", most) : say(language_, "{} to {}", least, most);
    plot_.account =
        most == 1
            ? say(language_, "{} against {}: one run each.", capitalised(what), numbers.across)
            : say(language_,
                  "{} against {}: means of {} independent runs each; bars, where they are "
                  "longer than the points, are one standard error.",
                  capitalised(what), numbers.across, runs);
    const SweptLine& first = numbers.lines.front();
    plot::Note key{.wraps = true};
    if (numbers.lines.size() > 1) return set_words_of_lines(numbers);
    for (const auto& [curve, dashes, account] : curves_of(first)) {
        const std::string name = say(language_, Phrase{curve->name});
        key.entries.push_back({.swatch = stroke_of_theory(dashes), .words = {escape_markup(name)}});
        plot_.account += " " + account(language_, name);
    }
    if (key.entries.empty()) return;
    key.of_last_titles = plot_.titles.size();  // unless the names are at the curves
    plot_.notes.push_back(std::move(key));
    // A title of one's own does not say what the vertical axis shows.
    if (!title_) plot_.at_lines = plot::NamedAtLines{.titles = plot_.titles};
}

// A key of the lines, which are theoretical curves if any are known, and otherwise join the points.
void SweepPanel::set_words_of_lines(const SweptNumbers& numbers) {
    std::vector<std::string> names;
    for (const SweptLine& line : numbers.lines) names.push_back(line.name);
    plot::name_runs(plot_, std::move(names));
    plot::Note& key = plot_.notes.back();
    for (std::size_t k = 0; k < numbers.lines.size(); ++k)
        key.entries[k].dot = dot_of(k, numbers.lines.size());
    const SweptCurve& theory = numbers.lines.front().theory;
    if (theory.y.size() < 2) return;
    const std::string name = say(language_, Phrase{theory.name});
    key.entries.push_back({.words = {escape_markup(say(language_, "lines: {}", name))}});
    plot_.account += " " + say(language_, "Lines: {}.", name);
}

void SweepPanel::add_curve(const SweptCurve& curve, const plot::Stroke& stroke,
                           const std::string& line) {
    if (curve.y.empty()) return;
    plot::Polyline drawn;
    drawn.part = curve.name;
    drawn.of = line;
    drawn.depth = 2;
    drawn.still = true;
    drawn.x = plot::column(plot_.columns[0], curve.x);
    drawn.y = plot::column(plot_.columns[1], curve.y);
    drawn.stroke = stroke;
    plot_.layers.emplace_back(std::move(drawn));
}

void SweepPanel::add_curves(const SweptLine& line, std::size_t k, std::size_t lines) {
    if (lines > 1) {
        const SweptCurve joined{.x = line.x, .y = line.mean};
        return add_curve(line.theory.y.size() > 1 ? line.theory : joined, plot::stroke_of_run(k),
                         line.column);
    }
    for (const auto& [curve, dashes, account] : curves_of(line)) {
        add_curve(*curve, stroke_of_theory(dashes), line.column);
        if (plot_.at_lines)
            plot::name_last_line(plot_, escape_markup(say(language_, Phrase{curve->name})));
    }
}

// A bar of an error is a piece of one line, from its lower end to its upper.
void SweepPanel::add_line(const SweptNumbers& numbers, std::size_t k) {
    const SweptLine& line = numbers.lines[k];
    const std::size_t lines = numbers.lines.size();
    plot::Polyline bars;
    std::vector<double> x, y, counts;
    std::vector<int> piece;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        counts.push_back(static_cast<double>(line.runs[i]));
        if (!std::isfinite(line.error[i]) || !std::isfinite(line.mean[i])) continue;
        for (const double end : {line.mean[i] - line.error[i], line.mean[i] + line.error[i]}) {
            x.push_back(line.x[i]);
            y.push_back(end);
            piece.push_back(static_cast<int>(i));
        }
    }
    bars.still = true;
    bars.depth = 1;
    bars.x = plot::column(plot_.columns[0], std::move(x));
    bars.y = plot::column(plot_.columns[1], std::move(y));
    bars.piece = std::make_shared<const std::vector<int>>(std::move(piece));
    bars.is_thinned = false;
    bars.stroke = {.role = role_of(k, lines), .width = 0.14, .shade = plot::Shade::legible};
    plot_.layers.emplace_back(std::move(bars));
    plot::Points points;
    points.part = "mean";
    points.of = line.column;
    points.still = true;
    points.x = plot::column(plot_.columns[0], line.x);
    points.y = plot::column(plot_.columns[1], line.mean);
    points.more = {plot::column(plot_.columns[2], line.error),
                   plot::column(plot_.columns[3], std::move(counts))};
    points.dot = dot_of(k, lines);
    plot_.layers.emplace_back(std::move(points));
}

void SweepPanel::show(const SweptNumbers& numbers) {
    plot_ = {.language = language_, .units = UnitSystem::reduced_names};
    plot_.columns = {numbers.column, numbers.number, standard_error_of(numbers.number), "runs"};
    set_axes(numbers);
    set_words(numbers);
    for (std::size_t k = 0; k < numbers.lines.size(); ++k) {
        add_curves(numbers.lines[k], k, numbers.lines.size());
        add_line(numbers, k);
    }
}

namespace {

std::unique_ptr<Panel> make_sweep(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<SweepPanel>(context, spec);
}

// The words of its axes, and the values in its legend.
std::vector<std::string> names_of_sweep(const PanelSpec& panel) {
    const auto& shown = panel.options.as<SweepShown>();
    std::vector<std::string> names{shown.across};
    for (const SweepAxis& axis : shown.sweep.axes)
        names.insert(names.end(), axis.values.begin(), axis.values.end());
    return names;
}

}  // namespace

PanelKind sweep_kind() {
    using enum Ability;
    return {.name = "sweep",
            .words = Phrase{"sweep"},
            .shows =
                "A number measured in many runs against a key that is varied, with its standard "
                "error and theory: see [Figures](figures.md#sweeps).",
            .make = make_sweep,
            .abilities = {theory, means, sweep},
            .keys = option_keys(sweep_keys()),
            .rule = check_sweep_figure,
            .has_own_time = always(true),
            .names = names_of_sweep,
            .in_films_instead = "a sweep is of many runs; it is a kind of figure"};
}

}  // namespace carom

// What quantities against time show, as a plot: lines with their names, levels of theory, turns and
// events.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/plot/window.h"
#include "panels/plots/series_panel.h"
#include "physics/units/unit_table.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::Role;

constexpr int depth_of_markers = 1;  // under levels and their words
constexpr int band_depth = 1000;     // behind all lines
const Role muted{.of = Role::Of::muted};

// A word beside a vertical line, at the lowest place that no line crosses: on the right, where what
// it says holds from then on, or on the left if there is no room.
plot::Label label_beside(double at, const std::string& word) {
    plot::Label label;
    label.words = {word};
    for (const bool on_left : {false, true})
        label.anchors.push_back({.at = {at, 1.0},
                                 .y_is_share = true,
                                 .offset = {on_left ? -0.4 : 0.4, -0.5},
                                 .align = on_left ? Align::right : Align::left,
                                 .step = {0.0, -0.5},
                                 .is_inside = true});
    return label;
}

// Adds a vertical line, whose words are placed after those of levels.
void add_marker(plot::Plot& plot, plot::Marker marker) {
    std::optional<plot::Label> words = std::exchange(marker.label, std::nullopt);
    marker.depth = depth_of_markers;
    plot.layers.emplace_back(std::move(marker));
    if (!words) return;
    words->still = true;
    plot.layers.emplace_back(std::move(*words));
}

}  // namespace

void SeriesPanel::make_plot() {
    growing_.clear();
    const bool compares = record_.compares();
    whole_.titles = subject_.titles;
    if (compares && subject_.compared_title)
        whole_.titles = {*subject_.compared_title};
    else if (compares && names_lines() && !is_titled_by_scene_)
        whole_.titles = {
            plot::text_of(context_.language(), Phrase{"{}: {}"},
                          {capitalised(say(context_.language(), meter().quantity.word)),
                           escape_markup(meter().lines.at(subject_.compared).name)})};
    whole_.columns = {*whole_.x.quantity, meter().quantity};
    if (!record_.runs.front().error.empty())
        whole_.columns.push_back(standard_error_of(meter().quantity));
    const bool has_names = compares || names_lines();
    if (compares)
        whole_.at_lines = plot::NamedAtLines{.titles = whole_.titles};
    else if (has_names && !is_titled_by_scene_)
        whole_.at_lines = plot::NamedAtLines{.titles = {meter().title}};
    if (const std::vector<std::string> words = notes(); !words.empty())
        whole_.notes.push_back({{{.words = {words.begin(), words.end()}}}});
    if (compares) {
        plot::name_runs(whole_, record_.names());
        whole_.notes.back().of_last_titles = whole_.titles.size();  // unless at the lines
    }
    for (std::size_t k = 0; k < record_.runs.size(); ++k) add_run(k);
    add_levels();  // words find their places in this order
    if (has_names) add_names();
    add_turns();
    add_events();
    if (subject_.add) subject_.add(record_, whole_);
}

// Each line's name in its colour, over or under the line where it is free, near its beginning if
// possible.
void SeriesPanel::add_names() {
    constexpr int places = 24;
    constexpr double over = -0.5, under = 1.25, farthest = 1.5;  // units, to the baseline
    for (const Growing& one : growing_) {
        const bool compares = record_.compares();
        if (!compares && meter().lines.at(one.line).name.empty()) continue;
        const auto& line = std::get<plot::Polyline>(whole_.layers[one.layer]);
        if (line.x.size() == 0) continue;
        plot::Label label;
        label.still = label.is_name = true;
        label.words = {compares ? plot::named(record_.runs.at(one.run).name, line.stroke.role)
                                : plot::named(meter().lines.at(one.line).name, line.stroke.role,
                                              plot::Swatch::line, one.line)};
        for (int k = 1; k < places; ++k) {
            const std::size_t i = (line.x.size() - 1) * static_cast<std::size_t>(k) / places;
            if (!std::isfinite(line.y[i])) continue;
            for (double away = 0.0; away <= farthest; away += 0.5)
                for (const double off : {over - away, under + away})
                    label.anchors.push_back({.at = {line.x[i], line.y[i]},
                                             .offset = {0.4, off},
                                             .align = Align::left,
                                             .is_inside = true});
        }
        label.swatch = line.stroke;
        label.line = one.layer;
        whole_.layers.emplace_back(std::move(label));
    }
}

// Whether any line, or any of theory, has a number in the film.
bool SeriesPanel::has_numbers(bool of_theory) const {
    const auto is_known = [](double value) { return std::isfinite(value); };
    for (const History& run : record_.runs)
        for (std::size_t k = 0; k < run.y.size(); ++k) {
            const std::size_t line = record_.compares() ? subject_.compared : k;
            if (of_theory && !meter().lines.at(line).is_theory) continue;
            if (std::ranges::any_of(run.y[k], is_known)) return true;
        }
    return false;
}

// Under the title: what the lines are, and what the mean is of.
std::vector<std::string> SeriesPanel::notes() const {
    const Language language = context_.language();
    if (!has_numbers()) return {say(language, "not defined for this gas")};
    std::vector<std::string> all = subject_.notes;
    if (!all.empty() && !subject_.theory_note.empty() && has_numbers(true))
        all.insert(all.begin(), all.front() + "; " + subject_.theory_note);
    const auto append = [&](const std::vector<std::string>& more) {
        std::vector<std::string> both;
        for (const std::string& note : all) both.push_back(note + "; " + more.front());
        both.insert(both.end(), more.begin(), more.end());
        all = std::move(both);
    };
    if (reader_.averages())
        append({words_of_window(context_.wording(), *meter().over, Phrase{"now"})});
    if (record_.runs_in_mean > 1) {
        const std::string mean = words_of_mean(language, record_.runs_in_mean);
        append({say(language, "{} \u00B1 standard error", mean), mean});
    }
    const ReferenceLevels& levels = record_.runs.front().levels;
    if (record_.compares() && !levels.empty() && record_.common_levels().empty())
        append({say(language, "thin: {}", say(language, Phrase{levels.back().name}))});
    return all;
}

void SeriesPanel::add_run(std::size_t k) {
    const History& run = record_.runs[k];
    const bool compares = record_.compares();
    const plot::Column time = plot::column(whole_.columns[0], run.x);
    for (std::size_t i = 0; i < run.y.size(); ++i) {
        const MeterLine& subject = meter().lines.at(compares ? subject_.compared : i);
        plot::Polyline line;
        line.part = "line";
        line.of = subject.column;
        if (compares) line.run = k;
        line.depth = static_cast<int>(compares ? k : i);
        line.x = time;
        line.y = plot::column(whole_.columns[1], run.y[i]);
        line.stroke = compares
                          ? plot::stroke_of_run(k)
                          : plot::Stroke{.role = subject.role,
                                         .print_dashes = plot::dashes_in_print(i, run.y.size()),
                                         .shade = plot::Shade::rimmed};
        if (subject.is_theory)
            line.stroke = {.role = subject.role, .width = 0.1, .dashes = {0.5, 0.35}};
        else
            line.head = plot::Dot{.role = line.stroke.role, .shade = line.stroke.shade};
        if (!run.error.empty()) {
            plot::Band band;
            band.x = line.x;
            band.y = line.y;
            band.error = plot::column(whole_.columns[2], run.error[i]);
            band.role = subject.role;
            band.depth = band_depth;
            line.more = {band.error};
            whole_.layers.emplace_back(std::move(band));
        }
        growing_.push_back({whole_.layers.size(), k, i});
        whole_.layers.emplace_back(std::move(line));
    }
}

plot::Level SeriesPanel::level_of(const ReferenceLevel& of) const {
    plot::Level level;
    level.part = "reference";
    level.of = of.name;
    level.stroke.role = {plot::Role::Of::accent};
    if (of.line) {
        level.of += ", " + meter().lines.at(*of.line).column;
        level.stroke.role = meter().lines[*of.line].role;
        level.stroke.shade = plot::Shade::legible;
    }
    level.still = true;
    level.x_column = whole_.columns[0];
    level.column = whole_.columns[1];
    level.value = of.value;
    return level;
}

// Adds the common levels of all runs with their values; if runs differ, the level of each run.
void SeriesPanel::add_levels() {
    if (const ReferenceLevels common = record_.common_levels(); !common.empty())
        return common.front().line ? add_levels_of_lines(common) : add_common_levels(common);
    for (std::size_t k = 0; k < record_.runs.size(); ++k) {
        const ReferenceLevels& own = record_.runs[k].levels;
        if (own.empty() || !std::isfinite(own.back().value)) continue;
        plot::Level level = level_of(own.back());
        level.run = k;
        level.stroke = {.role = plot::stroke_of_run(k).role, .width = 0.07};
        whole_.layers.emplace_back(std::move(level));
    }
}

// Levels of single lines have the colours of these.
void SeriesPanel::add_levels_of_lines(const ReferenceLevels& levels) {
    const Language language = context_.language();
    for (const ReferenceLevel& of : levels) {
        plot::Level level = level_of(of);
        const auto words = [&](const std::string& text) {
            return plot::named(text, level.stroke.role, plot::Swatch::line, *of.line);
        };
        const std::string number = three_digits(context_.wording(), meter().quantity, of.value);
        plot::name_level(level,
                         {words(say(language, Phrase{of.name}) + " " + number), words(number)});
        whole_.layers.emplace_back(std::move(level));
    }
}

// "1.25 ± 0.12", in real units with the unit of the level after both.
std::string SeriesPanel::with_deviation(const ReferenceLevel& level) const {
    const Language language = context_.language();
    const auto both = [&](double factor) {
        return three_digits(language, factor * level.value) + "\u2009\u00B1\u2009" +
               localised(language, fmt::format("{:.2g}", factor * level.deviation));
    };
    if (context_.wording().units != UnitSystem::real) return both(1.0);
    const ShownUnit unit = shown_unit(meter().quantity, UnitSystem::real, level.value);
    return fmt::format("({})\u00A0{}", both(unit.factor), unit.name);
}

// Levels are distinguished by their dashes; levels whose numbers look the same share one label.
void SeriesPanel::add_common_levels(const ReferenceLevels& levels) {
    static const std::vector<std::vector<double>> dashes{{0.3}, {0.9, 0.3}, {0.9, 0.3, 0.2, 0.3}};
    const Language language = context_.language();
    std::string names;
    const auto number_of = [&](double value) {
        return three_digits(context_.wording(), meter().quantity, value);
    };
    for (std::size_t k = 0; k < levels.size(); ++k) {
        plot::Level level = level_of(levels[k]);
        level.stroke.dashes = dashes[k % dashes.size()];
        add_band_about(level, levels[k].deviation);
        const std::string number = number_of(levels[k].value);
        names += (names.empty() ? "" : ", ") + say(language, Phrase{levels[k].name});
        if (k + 1 == levels.size() || number_of(levels[k + 1].value) != number) {
            std::vector<plot::Text> words{names + " " + number};
            if (levels[k].deviation > 0.0)
                words.insert(words.begin(), names + " " + with_deviation(levels[k]));
            plot::name_level(level, std::move(words), levels[k].deviation);
            names.clear();
        }
        whole_.layers.emplace_back(std::move(level));
    }
}

// The band of one standard deviation about a level, within which lines should be most of the time.
void SeriesPanel::add_band_about(const plot::Level& level, double deviation) {
    if (!(deviation > 0.0)) return;
    plot::Band band;
    band.part = "deviation";
    band.of = level.of;
    band.still = true;
    band.depth = band_depth + 1;
    band.x = plot::column(whole_.columns[0], {whole_.x.low, whole_.x.high});
    band.y = plot::column(whole_.columns[1], {level.value, level.value});
    const Heading column{"standard deviation of " + whole_.columns[1].name, meter().quantity};
    if (std::ranges::find(whole_.columns, column) == whole_.columns.end())
        whole_.columns.push_back(column);
    band.error = plot::column(column, {deviation, deviation});
    band.role = muted;
    band.alpha = 0.2;
    whole_.layers.emplace_back(std::move(band));
}

// A thin line where the velocities are reversed.
void SeriesPanel::add_turns() {
    for (const double at : record_.common_turns()) {
        plot::Marker marker;
        marker.part = "reversal";
        marker.still = true;
        marker.column = whole_.columns[0];
        marker.value = at;
        marker.label = label_beside(at, say(context_.language(), "reversed"));
        add_marker(whole_, std::move(marker));
    }
}

// The same, dashed, at times when a wall or a partition changes its behaviour or the gas is heated.
void SeriesPanel::add_events() {
    constexpr std::size_t most_named = 6;
    const auto events = record_.common_events();
    for (const auto& [at, words] : events) {
        plot::Marker marker;
        marker.part = "event";
        marker.of = fmt::format("{}", fmt::join(words, ", "));
        marker.still = true;
        marker.column = whole_.columns[0];
        marker.value = at;
        marker.stroke = {.width = 0.06, .dashes = {0.2, 0.4}};
        if (events.size() <= most_named) {
            std::vector<std::string> said;
            for (const std::string& word : words) {
                const std::string one =
                    localised(context_.language(), say(context_.language(), Phrase{word}));
                if (std::ranges::find(said, one) == said.end()) said.push_back(one);
            }
            marker.label = label_beside(at, fmt::format("{}", fmt::join(said, ", ")));
        }
        add_marker(whole_, std::move(marker));
    }
}

}  // namespace carom

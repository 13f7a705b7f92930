#include "panels/plots/series_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "draw/axis.h"
#include "panels/chosen.h"
#include "physics/reversal/mirrored_events.h"
#include "stats/histogram.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::Role;

constexpr int depth_of_markers = 1;  // under levels and their words
constexpr int band_depth = 1000;     // behind all lines
const Role muted{.of = Role::Of::muted};

// A word beside a vertical line, on the side with more room, at the lowest place that no line
// crosses.
plot::Label label_beside(const plot::Axis& axis, double at, const std::string& word) {
    const bool on_left = at > 0.5 * (axis.low + axis.high);
    plot::Label label;
    label.words = {word};
    label.anchors = {{.at = {at, 1.0},
                      .y_is_share = true,
                      .offset = {on_left ? -0.4 : 0.4, -0.5},
                      .align = on_left ? Align::right : Align::left,
                      .step = {0.0, -0.5}}};
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

void title_with_names(SeriesSubject& subject, Language language, const std::string& what) {
    std::vector<plot::Text> names;
    for (std::size_t k = 0; k < subject.names.size(); ++k)
        names.push_back(
            plot::named(subject.names[k], subject.lines.at(k).role, plot::Sample::line, k));
    subject.titles = {plot::text_of(language, Phrase{"{}: {}"}, {what, joined(language, names)}),
                      what};
    subject.last_title_names = false;
}

SeriesSubject subject_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title) {
    const std::vector<Chosen> chosen = choices(spec);
    const std::string what = say(context.language(), title);
    SeriesSubject subject{.titles = {what}};
    if (!spec.of.empty()) subject.titles = {shown_of(context, what, chosen, plot::Sample::line)};
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.lines.push_back(
            {column_name_of(context.scene, chosen[k]), role_among(context, chosen, k)});
    for (const Chosen& one : chosen) subject.names.push_back(name_of(context.scene, one));
    return subject;
}

std::string account_of_last(Language language, Phrase quantity, const std::vector<double>& values,
                            std::size_t shown) {
    while (shown > 0 && !std::isfinite(values[shown - 1])) --shown;
    return say(language, quantity) + " " +
           (shown == 0 ? say(language, "unknown") : three_digits(language, values[shown - 1]));
}

namespace {

// A word for an event; empty for an event that has its own mark, or none.
Phrase series_event_word(const RunEvent& event) {
    if (const auto* set = std::get_if<SetOpen>(&event.action))
        return set->is_open ? Phrase{"opened"} : Phrase{"closed"};
    if (const auto* heat = std::get_if<Heat>(&event.action)) {
        const double* energy = std::get_if<double>(&heat->amount);
        return energy != nullptr && *energy < 0.0 ? Phrase{"cooled"} : Phrase{"heated"};
    }
    if (const auto* move = std::get_if<MoveSurface>(&event.action))
        return move->velocity == 0.0 ? Phrase{"stopped"} : Phrase{"moved"};
    if (std::holds_alternative<HoldPiston>(event.action)) return Phrase{"held"};
    if (std::holds_alternative<ReleasePiston>(event.action)) return Phrase{"released"};
    if (std::holds_alternative<ChangeSurface>(event.action)) return Phrase{"wall changed"};
    return {};
}

}  // namespace

SeriesPanel::SeriesPanel(const PanelContext& context, const PanelSpec& spec, SeriesSubject subject)
    : context_(context), subject_(std::move(subject)), is_titled_by_scene_(spec.title.has_value()) {
    if (is_titled_by_scene_) {
        subject_.titles = {escape_markup(*spec.title)};
        subject_.compared_title.reset();
        subject_.last_title_names = false;
    }
    record_.compared = subject_.compared;
}

void SeriesPanel::survey(const FrameInput& input) {
    const std::vector<double> now = subject_.measure(input);
    SeriesRun& run = record_.runs.front();
    const auto add_to = [&](SeriesPoints& points) {
        points.time.push_back(input.tick.time);
        points.lines.resize(now.size());
        for (std::size_t k = 0; k < now.size(); ++k) points.lines[k].push_back(now[k]);
    };
    if (input.is_sample) add_to(run);
    if (input.is_frame) add_to(run.frames);
}

void SeriesPanel::finish_record() {
    SeriesRun& run = record_.runs.front();
    if (subject_.references) run.levels = subject_.references();
    if (subject_.numbers) run.numbers = subject_.numbers();
    if (subject_.laws) run.laws = subject_.laws();
    run.turns = reversal_times(context_.scene.run);
    const auto add = [&](double at, Phrase word) {
        if (!word.english.empty()) run.events.emplace_back(at, word.english);
    };
    const std::vector<RunEvent>& events = context_.scene.run.events;
    for (const RunEvent& event : events) add(event.at, series_event_word(event));
    for (const MirroredEvent& mirrored : mirrored_events(context_.scene.run)) {
        const RunEvent& event = events[mirrored.event];
        const auto opposite = mirrored.is_undone ? opposite_of(event) : event;
        const Phrase own = series_event_word(event);
        add(mirrored.at, opposite              ? series_event_word(*opposite)
                         : own.english.empty() ? own
                                               : Phrase{"undone"});
    }
}

void SeriesPanel::archive(Archive& archive) {
    archive(record_);
    if (archive.is_reading()) make_axes();
}

// Whether a line is at 0 for longer than an instant.
bool SeriesPanel::rests_at_zero() const {
    constexpr double instant = 0.01;  // of the film
    for (const SeriesRun& run : record_.runs)
        for (const std::vector<double>& line : run.lines)
            if (static_cast<double>(std::ranges::count(line, 0.0)) >
                instant * static_cast<double>(line.size()))
                return true;
    return false;
}

// A linear axis leaves room above the lines, and values beyond it are cut.
plot::Axis SeriesPanel::axis_up() const {
    if (subject_.top) return {.high = *subject_.top};
    std::vector<double> all;
    bool has_negative = false;
    const auto add = [&](double value) {
        has_negative = has_negative || (subject_.is_signed && value < 0.0);
        if (subject_.is_signed) value = std::abs(value);
        if (value > 0.0 && std::isfinite(value)) all.push_back(value);
    };
    for (const SeriesRun& run : record_.runs)
        for (std::size_t k = 0; k < run.lines.size(); ++k)
            for (std::size_t i = 0; i < run.time.size(); ++i) {
                add(run.lines[k][i]);
                if (!run.errors.empty()) add(run.lines[k][i] + run.errors[k][i]);  // for the bands
            }
    if (all.empty()) return {};
    constexpr double room_of_word = 0.2;
    const ReferenceLevels common = record_.common_levels();
    double reference = 0.0, room = 1.25;  // for words over the lines
    for (std::size_t k = 0; k < common.size(); ++k) {
        reference = std::max(reference, common[k].value + common[k].deviation);
        if (k > 0 && !common[k].line) room += room_of_word;
    }
    const double most = subject_.spreads ? *std::ranges::max_element(all)
                                         : room * std::max(quantile(all, 0.98), reference);
    const double least =
        quantile(all, 0.01);  // one particle's energy may touch zero for an instant
    constexpr double linear_up_to = 50.0;
    const double mean =
        std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
    // A logarithmic axis cannot show a line at zero, so it is avoided if a linear one suffices.
    const bool is_told_by_linear = rests_at_zero() && most <= linear_up_to * mean;
    if (subject_.spreads && most > linear_up_to * least && !is_told_by_linear)
        return {.low = std::floor(std::log10(least)),
                .high = std::ceil(std::log10(most)),
                .kind = plot::Axis::Kind::logarithmic};
    const double high = round_up_for_axis(most);
    return {.low = has_negative ? -high : 0.0, .high = high};
}

// The clock of a film runs backwards after a reversal, but this axis does not.
Phrase SeriesPanel::time_name() const {
    const bool turns =
        std::ranges::any_of(record_.runs, [](const SeriesRun& run) { return !run.turns.empty(); });
    return turns ? Phrase{"elapsed time"} : Phrase{"time"};
}

void SeriesPanel::make_axes() {
    whole_ = {};
    whole_.language = context_.language();
    whole_.x = {.title = say(context_.language(), time_name()), .low = INFINITY, .high = -INFINITY};
    for (const SeriesRun& run : record_.runs) {
        whole_.x.low = std::min(whole_.x.low, *std::ranges::min_element(run.time));
        whole_.x.high = std::max(whole_.x.high, *std::ranges::max_element(run.time));
    }
    if (whole_.x.high <= whole_.x.low) whole_.x.high = whole_.x.low + 1.0;
    whole_.y = axis_up();
    if (is_titled_by_scene_) whole_.y.title = say(context_.language(), subject_.quantity);
    make_plot();
}

void SeriesPanel::make_plot() {
    growing_.clear();
    const bool compares = record_.compares();
    const std::string column = column_name(std::string(subject_.quantity.english), subject_.unit);
    whole_.titles = subject_.titles;
    if (compares && subject_.compared_title)
        whole_.titles = {*subject_.compared_title};
    else if (compares && subject_.names.size() > 1 && !is_titled_by_scene_)
        whole_.titles = {plot::text_of(context_.language(), Phrase{"{}: {}"},
                                       {capitalised(say(context_.language(), subject_.quantity)),
                                        escape_markup(subject_.names.at(subject_.compared))})};
    whole_.columns = {column_name(std::string(time_name().english), reduced::time), column};
    if (!record_.runs.front().errors.empty())
        whole_.columns.push_back("standard error of " + column);
    const bool names_lines = !subject_.last_title_names && subject_.names.size() > 1 && !compares;
    if (names_lines) whole_.titles = {whole_.titles.back()};
    if (const std::vector<std::string> words = notes(); !words.empty())
        whole_.notes.push_back({{{.words = {words.begin(), words.end()}}}});
    std::vector<std::string> names;
    for (const auto& one : record_.runs) names.push_back(one.name);
    if (compares) plot::name_runs(whole_, std::move(names));
    for (std::size_t k = 0; k < record_.runs.size(); ++k) add_run(k);
    add_levels();  // words find their places in this order
    if (names_lines) add_names();
    add_turns();
    add_events();
    if (subject_.add) subject_.add(record_, whole_);
}

// Each line's name in its colour, over or under the line where it is free, near its beginning if
// possible.
void SeriesPanel::add_names() {
    constexpr int places = 12;
    constexpr double over = -0.5, under = 1.25;  // units, to the baseline
    for (const Growing& one : growing_) {
        if (one.line >= subject_.names.size() || subject_.lines.at(one.line).is_theory) continue;
        const auto& line = std::get<plot::Line>(whole_.layers[one.layer]);
        if (line.x.size() == 0) continue;
        plot::Label label;
        label.still = true;
        label.words = {plot::named(subject_.names.at(one.line), line.stroke.role,
                                   plot::Sample::line, one.line)};
        for (int k = 1; k < places; ++k) {
            const std::size_t i = (line.x.size() - 1) * static_cast<std::size_t>(k) / places;
            if (!std::isfinite(line.y[i])) continue;
            for (const double off : {over, under})
                label.anchors.push_back({.at = {line.x[i], line.y[i]},
                                         .offset = {0.4, off},
                                         .align = Align::left,
                                         .is_inside = true});
        }
        label.sample = line.stroke;
        if (!label.anchors.empty()) label.anchors.front().has_sample = true;
        whole_.layers.emplace_back(std::move(label));
    }
}

bool SeriesPanel::has_numbers() const {
    for (const SeriesRun& run : record_.runs)
        for (const std::vector<double>& line : run.lines)
            if (std::ranges::any_of(line, [](double value) { return std::isfinite(value); }))
                return true;
    return false;
}

// Under the title: what the lines are, and what the mean is of.
std::vector<std::string> SeriesPanel::notes() const {
    const Language language = context_.language();
    if (!has_numbers()) return {say(language, "not defined for this gas")};
    std::vector<std::string> all = subject_.notes;
    const auto append = [&](const std::vector<std::string>& more) {
        std::vector<std::string> both;
        for (const std::string& note : all) both.push_back(note + "; " + more.front());
        both.insert(both.end(), more.begin(), more.end());
        all = std::move(both);
    };
    if (record_.runs_in_mean > 1) {
        const std::string mean = counted(language, record_.runs_in_mean, Phrase{"mean of {} run"},
                                         Phrase{"mean of {} runs"});
        append({say(language, "{} \u00B1 standard error", mean), mean});
    }
    const ReferenceLevels& levels = record_.runs.front().levels;
    if (record_.compares() && !levels.empty() && record_.common_levels().empty())
        append({say(language, "thin: {}", say(language, Phrase{levels.back().name}))});
    return all;
}

void SeriesPanel::add_run(std::size_t k) {
    const SeriesRun& run = record_.runs[k];
    const bool compares = record_.compares();
    const plot::Column time = plot::column(whole_.columns[0], run.time);
    for (std::size_t i = 0; i < run.lines.size(); ++i) {
        const SeriesSubject::Line& subject = subject_.lines.at(compares ? record_.compared : i);
        plot::Line line;
        line.part = "line";
        line.of = subject.name;
        if (compares) line.run = k;
        line.depth = static_cast<int>(compares ? k : i);
        line.x = time;
        line.y = plot::column(whole_.columns[1], run.lines[i]);
        line.stroke = compares
                          ? plot::stroke_of_run(k)
                          : plot::Stroke{.role = subject.role,
                                         .print_dashes = plot::dashes_in_print(i, run.lines.size()),
                                         .shade = plot::Shade::rimmed};
        if (subject.is_theory)
            line.stroke = {.role = subject.role, .width = 0.1, .dashes = {0.5, 0.35}};
        else
            line.head = plot::Mark{.role = line.stroke.role, .shade = line.stroke.shade};
        if (!run.errors.empty()) {
            plot::Band band;
            band.x = line.x;
            band.y = line.y;
            band.error = plot::column(whole_.columns[2], run.errors[i]);
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
        level.of += ", " + subject_.lines.at(*of.line).name;
        level.stroke.role = subject_.lines[*of.line].role;
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

namespace {

// At the top right, in the row of this number from the top.
plot::Label label_of_levels(std::vector<plot::Text> words, const plot::Stroke& sample, double row) {
    constexpr double line_height = 1.4;  // units
    plot::Label label;
    label.role = {plot::Role::Of::accent};
    label.words = std::move(words);
    label.anchors = {{.at = {1.0, 0.0},
                      .x_is_share = true,
                      .y_is_share = true,
                      .offset = {-0.5, 0.8 + line_height * row},
                      .align = Align::right,
                      .has_sample = true}};
    label.sample = sample;
    return label;
}

}  // namespace

// Levels of single lines have the colours of these and share one label.
void SeriesPanel::add_levels_of_lines(const ReferenceLevels& levels) {
    const Language language = context_.language();
    plot::Text with_names, numbers;
    for (const ReferenceLevel& level : levels) {
        const plot::Role role = subject_.lines.at(*level.line).role;
        const std::string number = three_digits(language, level.value);
        const std::string comma = numbers.empty() ? "" : ", ";
        numbers += comma + plot::named(number, role, plot::Sample::line, *level.line);
        with_names += comma + plot::named(subject_.names.at(*level.line) + " " + number, role,
                                          plot::Sample::line, *level.line);
    }
    const plot::Text name = say(language, Phrase{levels.front().name});
    const auto after_name = [&](const plot::Text& text) {
        return plot::text_of(language, Phrase{"{}: {}"}, {name, text});
    };
    const plot::Stroke sample{.role = {plot::Role::Of::accent}, .width = 0.08, .dashes = {0.3}};
    for (std::size_t k = 0; k < levels.size(); ++k) {
        plot::Level level = level_of(levels[k]);
        if (k == 0)
            level.label =
                label_of_levels({after_name(with_names), after_name(numbers), name}, sample, 0.0);
        whole_.layers.emplace_back(std::move(level));
    }
}

// Levels are distinguished by their dashes; levels whose numbers look the same share one label.
void SeriesPanel::add_common_levels(const ReferenceLevels& levels) {
    static const std::vector<std::vector<double>> dashes{{0.3}, {0.9, 0.3}, {0.9, 0.3, 0.2, 0.3}};
    const Language language = context_.language();
    std::string names;
    double row = 0.0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        plot::Level level = level_of(levels[k]);
        level.stroke.dashes = dashes[k % dashes.size()];
        add_band_about(level, levels[k].deviation);
        const std::string number = three_digits(language, levels[k].value);
        names += (names.empty() ? "" : ", ") + say(language, Phrase{levels[k].name});
        if (k + 1 == levels.size() || three_digits(language, levels[k + 1].value) != number) {
            std::vector<plot::Text> words{names + " " + number};
            if (levels[k].deviation > 0.0)
                words.insert(words.begin(),
                             names + " " + number + "\u2009\u00B1\u2009" +
                                 localised(language, fmt::format("{:.2g}", levels[k].deviation)));
            level.label = label_of_levels(std::move(words), level.stroke, row++);
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
    const std::string column = "standard deviation of " + whole_.columns[1];
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
        marker.label = label_beside(whole_.x, at, say(context_.language(), "reversed"));
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
                const std::string one = say(context_.language(), Phrase{word});
                if (std::ranges::find(said, one) == said.end()) said.push_back(one);
            }
            marker.label = label_beside(whole_.x, at, fmt::format("{}", fmt::join(said, ", ")));
            plot::Anchor other_side = marker.label->anchors[0];
            other_side.offset.x = -other_side.offset.x;
            other_side.align = other_side.align == Align::left ? Align::right : Align::left;
            marker.label->anchors.push_back(other_side);
        }
        add_marker(whole_, std::move(marker));
    }
}

std::shared_ptr<const PanelState> SeriesPanel::state(const FrameInput&) {
    auto state = std::make_shared<ShownState>();
    state->shown = {++seen_};
    return state;
}

std::vector<std::string> SeriesPanel::accounts_of_runs(const ShownState& now) const {
    std::vector<std::string> accounts;
    for (std::size_t k = 0; k < record_.runs.size(); ++k)
        accounts.push_back(account_of_last(context_.language(), subject_.quantity,
                                           record_.runs[k].frames.lines.front(), now.shown.at(k)));
    return accounts;
}

// The number of samples up to the frame that is the last of so many.
std::size_t SeriesPanel::samples_until(std::size_t run, std::size_t shown) const {
    const SeriesRun& its = record_.runs.at(run);
    if (shown == 0 || its.frames.time.empty()) return 0;
    const double now = its.frames.time[std::min(shown, its.frames.time.size()) - 1];
    return static_cast<std::size_t>(std::ranges::upper_bound(its.time, now) - its.time.begin());
}

// The points of a line are those of samples and, at its end, the present.
void SeriesPanel::end_at_present(plot::Line& line, const Growing& of, std::size_t shown) const {
    const SeriesRun& run = record_.runs.at(of.run);
    const std::size_t samples = line.shown.end, frame = std::min(shown, run.frames.time.size()) - 1;
    if (samples == 0 || !(run.frames.time[frame] > run.time[samples - 1])) return;
    const auto extended = [&](const plot::Column& of_samples, double present) {
        std::vector<double> values(of_samples.values->begin(),
                                   of_samples.values->begin() + std::ptrdiff_t(samples));
        values.push_back(present);
        return plot::column(of_samples.name, std::move(values));
    };
    line.x = extended(line.x, run.frames.time[frame]);
    line.y = extended(line.y, run.frames.lines[of.line][frame]);
    if (!run.frames.errors.empty())
        line.more = {extended(line.more.front(), run.frames.errors[of.line][frame])};
    ++line.shown.end;
}

plot::Plot SeriesPanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const auto& shown = dynamic_cast<const ShownState&>(*state);
    for (plot::AnyLayer& layer : now.layers) {
        if (auto* line = std::get_if<plot::Line>(&layer)) {
            const std::size_t run = line->run.value_or(0);
            line->shown.end = samples_until(run, shown.shown.at(run));
        }
        if (auto* band = std::get_if<plot::Band>(&layer))
            band->shown.end = samples_until(0, shown.shown.front());
    }
    for (const Growing& one : growing_)
        end_at_present(std::get<plot::Line>(now.layers[one.layer]), one, shown.shown.at(one.run));
    if (record_.compares()) now.accounts_of_runs = accounts_of_runs(shown);
    return now;
}

}  // namespace carom

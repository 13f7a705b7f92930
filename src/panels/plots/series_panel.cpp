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
#include "util/overloaded.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::Role;

}  // namespace

void title_with_names(SeriesSubject& subject, Language language, const std::string& what) {
    std::vector<plot::Text> names;
    for (std::size_t k = 0; k < subject.names.size(); ++k)
        names.push_back(
            plot::named(subject.names[k], subject.lines.at(k).role, plot::Swatch::line, k));
    subject.titles = {plot::text_of(language, Phrase{"{}: {}"}, {what, joined(language, names)}),
                      what};
    subject.plain_title = what;
}

SeriesSubject subject_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title) {
    const std::vector<Chosen> chosen = choices(spec);
    const std::string what = say(context.language(), title);
    SeriesSubject subject{.titles = {what}};
    if (!spec.of.empty()) subject.titles = {shown_of(context, what, chosen, plot::Swatch::line)};
    for (std::size_t k = 0; k < chosen.size(); ++k)
        subject.lines.push_back(
            {column_name_of(context.scene, chosen[k]), role_among(context, chosen, k)});
    for (const Chosen& one : chosen) subject.names.push_back(name_of(context.scene, one));
    subject.plain_title = what;
    return subject;
}

std::string account_of_last(Language language, const Quantity& quantity,
                            const std::vector<double>& values, std::size_t shown) {
    while (shown > 0 && !std::isfinite(values[shown - 1])) --shown;
    return say(language, quantity.word) + " " +
           (shown == 0 ? say(language, "unknown") : three_digits(language, values[shown - 1]));
}

namespace {

Phrase phrase_of_event(const RunEvent& event) {
    return std::visit(
        Overloaded{
            [](const ReverseVelocities&) { return Phrase{}; },
            [](const Perturbation&) { return Phrase{}; },
            [](const SetOpen& its) { return its.is_open ? Phrase{"opened"} : Phrase{"closed"}; },
            [](const MoveSurface& its) {
                return its.velocity == 0.0 ? Phrase{"stopped"} : Phrase{"moved"};
            },
            [](const HoldPiston&) { return Phrase{"held"}; },
            [](const ReleasePiston&) { return Phrase{"released"}; },
            [](const ChangeSurface&) { return Phrase{"wall changed"}; },
            [](const Heat& its) {
                const double* energy = std::get_if<double>(&its.amount);
                return energy != nullptr && *energy < 0.0 ? Phrase{"cooled"} : Phrase{"heated"};
            }},
        event.action);
}

// A word for an event, in English, or what a wall becomes; empty for an event that has its own
// mark, or none.
std::string series_event_word(const RunEvent& event) {
    const auto given = given_behaviour(event);
    const auto* bath = given ? bath_of(given->second) : nullptr;
    return bath != nullptr ? "T = " + plain_number(bath->temperature)
                           : std::string(phrase_of_event(event).english);
}

}  // namespace

SeriesPanel::SeriesPanel(const PanelContext& context, const PanelSpec& spec, SeriesSubject subject)
    : context_(context),
      subject_(std::move(subject)),
      mean_(subject_.over.value_or(Over{})),
      is_titled_by_scene_(spec.title.has_value()) {
    if (is_titled_by_scene_) {
        subject_.titles = {escape_markup(*spec.title)};
        subject_.compared_title.reset();
    }
    record_.compared = subject_.compared;
}

bool SeriesPanel::is_mean() const {
    return subject_.over && subject_.over->since != Over::Since::now;
}

void SeriesPanel::survey(const FrameInput& input) {
    const std::vector<double> now =
        mean_(input.tick.time, subject_.measure(input), input.is_sample);
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
    if (is_mean())  // the deviations are those of single moments
        for (ReferenceLevel& level : run.levels) level.deviation = 0.0;
    std::erase_if(run.levels, [](const ReferenceLevel& of) { return !std::isfinite(of.value); });
    if (subject_.numbers) run.numbers = subject_.numbers();
    if (subject_.laws) run.laws = subject_.laws();
    run.turns = reversal_times(context_.run());
    const auto add = [&](double at, std::string word) {
        if (!word.empty()) run.events.emplace_back(at, std::move(word));
    };
    const std::vector<RunEvent>& events = context_.run().events;
    for (const RunEvent& event : events) add(event.at, series_event_word(event));
    for (const MirroredEvent& mirrored : mirrored_events(context_.run())) {
        const RunEvent& event = events[mirrored.event];
        const auto opposite = mirrored.is_undone ? opposite_of(event) : event;
        const std::string own = series_event_word(event);
        add(mirrored.at, opposite      ? series_event_word(*opposite)
                         : own.empty() ? own
                                       : std::string(Phrase{"undone"}.english));
    }
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
    const ReferenceLevels common = record_.common_levels();
    constexpr double room = 1.25;  // for words over the lines
    double reference = 0.0;
    for (const ReferenceLevel& level : common)
        reference = std::max(reference, level.value + level.deviation);
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
    whole_.x = plot::axis_of(context_.language(), quantities::time.named(time_name()), INFINITY,
                             -INFINITY);
    for (const SeriesRun& run : record_.runs) {
        whole_.x.low = std::min(whole_.x.low, *std::ranges::min_element(run.time));
        whole_.x.high = std::max(whole_.x.high, *std::ranges::max_element(run.time));
    }
    if (whole_.x.high <= whole_.x.low) whole_.x.high = whole_.x.low + 1.0;
    whole_.y = axis_up();
    whole_.y.quantity = subject_.quantity;
    if (is_titled_by_scene_) whole_.y.title = say(context_.language(), subject_.quantity.word);
    make_plot();
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
void SeriesPanel::end_at_present(plot::Polyline& line, const Growing& of, std::size_t shown) const {
    const SeriesRun& run = record_.runs.at(of.run);
    const std::size_t samples = line.shown.end, frame = std::min(shown, run.frames.time.size()) - 1;
    if (samples == 0 || !(run.frames.time[frame] > run.time[samples - 1])) return;
    const auto extended = [&](const plot::Column& of_samples, double present) {
        std::vector<double> values(of_samples.values->begin(),
                                   of_samples.values->begin() + std::ptrdiff_t(samples));
        values.push_back(present);
        return plot::column(of_samples.heading, std::move(values));
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
        if (auto* line = std::get_if<plot::Polyline>(&layer)) {
            const std::size_t run = line->run.value_or(0);
            line->shown.end = samples_until(run, shown.shown.at(run));
        }
        if (auto* band = std::get_if<plot::Band>(&layer))
            band->shown.end = samples_until(0, shown.shown.front());
    }
    for (const Growing& one : growing_)
        end_at_present(std::get<plot::Polyline>(now.layers[one.layer]), one,
                       shown.shown.at(one.run));
    if (record_.compares()) now.accounts_of_runs = accounts_of_runs(shown);
    return now;
}

}  // namespace carom

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

// The title with the names of the lines in their colours or, if that does not fit, the title alone
// with a key below.
std::vector<plot::Text> titles_with_names(const Meter& meter, Language language) {
    std::vector<plot::Text> names;
    for (std::size_t k = 0; k < meter.lines.size(); ++k)
        if (const MeterLine& line = meter.lines[k]; !line.name.empty())
            names.push_back(plot::named(line.name, line.role, plot::Swatch::line, k));
    if (names.empty()) return {meter.title};
    return {plot::text_of(language, Phrase{"{}: {}"}, {meter.title, joined(language, names)}),
            meter.title};
}

}  // namespace

SeriesSubject subject_of_choices(const PanelContext& context, const PanelSpec& spec, Phrase title,
                                 const Quantity& quantity) {
    SeriesSubject subject{meter_of_choices(context, spec, title, quantity)};
    subject.titles = {subject.title};
    if (!spec.of.empty())
        subject.titles = {shown_of(context, subject.title, choices(spec), plot::Swatch::line)};
    return subject;
}

std::string account_of_last(const Wording& language, const Quantity& quantity,
                            const std::vector<double>& values, std::size_t shown) {
    while (shown > 0 && !std::isfinite(values[shown - 1])) --shown;
    return say(language, quantity.word) + " " +
           (shown == 0 ? say(language, "unknown")
                       : three_digits(language, quantity, values[shown - 1]));
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
std::string series_event_word(const RunEvent& event, UnitSystem units) {
    const auto given = given_behaviour(event);
    const auto* bath = given ? bath_of(given->second) : nullptr;
    return bath != nullptr ? "T = " + plain_number(Wording{Language::english, units},
                                                   quantities::temperature, bath->temperature)
                           : std::string(phrase_of_event(event).english);
}

}  // namespace

SeriesPanel::SeriesPanel(const PanelContext& context, const PanelSpec& spec, SeriesSubject subject)
    : context_(context),
      subject_(std::move(subject)),
      reader_(subject_),
      is_titled_by_scene_(spec.title.has_value()) {
    if (subject_.titles.empty()) subject_.titles = titles_with_names(subject_, context.language());
    if (is_titled_by_scene_) {
        subject_.titles = {escape_markup(*spec.title)};
        subject_.compared_title.reset();
    }
    record_.compared = subject_.compared;
}

// Whether there are several lines with names, which stand in the title or at the lines.
bool SeriesPanel::names_lines() const {
    return std::ranges::count_if(meter().lines,
                                 [](const MeterLine& line) { return !line.name.empty(); }) > 1;
}

void SeriesPanel::survey(const FrameInput& input) {
    record_.runs.front().add(input.tick.time, reader_(input), input.is_sample, input.is_frame);
}

void SeriesPanel::finish_record() {
    History& run = record_.runs.front();
    if (meter().levels) run.levels = meter().levels();
    if (reader_.averages())  // the deviations are those of single moments
        for (ReferenceLevel& level : run.levels) level.deviation = 0.0;
    std::erase_if(run.levels, [](const ReferenceLevel& of) { return !std::isfinite(of.value); });
    if (meter().numbers) run.numbers = meter().numbers();
    if (meter().laws) run.laws = meter().laws();
    run.turns = reversal_times(context_.run());
    const auto add = [&](double at, std::string word) {
        if (!word.empty()) run.events.emplace_back(at, std::move(word));
    };
    const std::vector<RunEvent>& events = context_.run().events;
    const UnitSystem units = context_.wording().units;
    for (const RunEvent& event : events) add(event.at, series_event_word(event, units));
    for (const MirroredEvent& mirrored : mirrored_events(context_.run())) {
        const RunEvent& event = events[mirrored.event];
        const auto opposite = mirrored.is_undone ? opposite_of(event) : event;
        const std::string own = series_event_word(event, units);
        add(mirrored.at, opposite      ? series_event_word(*opposite, units)
                         : own.empty() ? own
                                       : std::string(Phrase{"undone"}.english));
    }
}

// Whether a line is at 0 for longer than an instant.
bool SeriesPanel::rests_at_zero() const {
    constexpr double instant = 0.01;  // of the film
    for (const History& run : record_.runs)
        for (const std::vector<double>& line : run.y)
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
    for (const History& run : record_.runs)
        for (std::size_t k = 0; k < run.y.size(); ++k)
            for (std::size_t i = 0; i < run.x.size(); ++i) {
                add(run.y[k][i]);
                if (!run.error.empty()) add(run.y[k][i] + run.error[k][i]);  // for the bands
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
        std::ranges::any_of(record_.runs, [](const History& run) { return !run.turns.empty(); });
    return turns ? Phrase{"elapsed time"} : Phrase{"time"};
}

void SeriesPanel::make_axes() {
    whole_ = {};
    whole_.language = context_.language();
    whole_.x = plot::axis_of(context_.language(), quantities::time.named(time_name()), INFINITY,
                             -INFINITY);
    for (const History& run : record_.runs) {
        whole_.x.low = std::min(whole_.x.low, *std::ranges::min_element(run.x));
        whole_.x.high = std::max(whole_.x.high, *std::ranges::max_element(run.x));
    }
    if (whole_.x.high <= whole_.x.low) whole_.x.high = whole_.x.low + 1.0;
    whole_.y = axis_up();
    whole_.y.quantity = meter().quantity;
    if (is_titled_by_scene_) whole_.y.title = say(context_.language(), meter().quantity.word);
    make_plot();
}

std::vector<std::string> SeriesPanel::accounts_of_runs(const ShownState& now) const {
    std::vector<std::string> accounts;
    for (std::size_t k = 0; k < record_.runs.size(); ++k)
        accounts.push_back(account_of_last(context_.wording(), meter().quantity,
                                           record_.runs[k].frames.y.front(), now.shown.at(k)));
    return accounts;
}

// The standard error of the last of some means since the start; NaN for other readings, and where
// something happens in the run, after which a mean may begin anew.
double SeriesPanel::error_of_mean(const std::vector<double>& x,
                                  const std::vector<double>& y) const {
    if (!reader_.averages_since_start() || !context_.run().events.empty()) return NAN;
    std::vector<double> times, integrals;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double integral = x[k] > 0.0 ? x[k] * y[k] : 0.0;
        if (!std::isfinite(integral) || (!times.empty() && !(x[k] > times.back()))) continue;
        times.push_back(x[k]);
        integrals.push_back(integral);
    }
    return error_of_time_average(times, integrals);
}

// "Temperature 1.02." or "Mean energy: light 2.19, heavy 2.21.", with standard errors of a mean
// over runs. Empty for many lines, and without a number.
std::string SeriesPanel::account_of(const Measured& now) const {
    constexpr std::ptrdiff_t most_lines = 4;
    const std::vector<MeterLine>& lines = meter().lines;
    if (std::ranges::count(lines, false, &MeterLine::is_theory) > most_lines || now.x.empty())
        return "";
    const Language language = context_.language();
    std::vector<std::string> numbers;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const double value = now.y[k].back();
        if (lines[k].is_theory || !std::isfinite(value)) continue;
        const double error =
            !now.error.empty() ? now.error[k].back() : error_of_mean(now.x, now.y[k]);
        const std::string number = with_error(context_.wording(), meter().quantity, value, error);
        numbers.push_back(lines[k].name.empty() ? number : lines[k].name + " " + number);
    }
    const std::string word = say(language, meter().quantity.word);
    if (numbers.empty() || word.empty()) return "";
    const bool is_one = numbers.size() == 1 && !names_lines();
    const std::string all = fmt::format("{}", fmt::join(numbers, ", "));
    return capitalised(is_one ? word + " " + all : say(language, "{}: {}", word, all)) + ".";
}

// Lines end at the present, bands of errors at the last sample.
plot::Plot SeriesPanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const auto& shown = dynamic_cast<const ShownState&>(*state);
    std::vector<Measured> runs;
    for (std::size_t run = 0; run < record_.runs.size(); ++run)
        runs.push_back(record_.runs[run].until(shown.shown.at(run)));
    for (const Growing& one : growing_) {
        auto& line = std::get<plot::Polyline>(now.layers[one.layer]);
        const Measured& run = runs[one.run];
        line.x = plot::column(line.x.heading, run.x);
        line.y = plot::column(line.y.heading, run.y[one.line]);
        if (!run.error.empty())
            line.more = {plot::column(line.more.front().heading, run.error[one.line])};
        line.shown.end = run.x.size();
    }
    const std::size_t samples = record_.runs.front().samples_until(shown.shown.front());
    for (plot::AnyLayer& layer : now.layers)
        if (auto* band = std::get_if<plot::Band>(&layer); band && !band->still)
            band->shown.end = samples;
    if (context_.in_film) return now;  // only figures give an account
    if (record_.compares())
        now.accounts_of_runs = accounts_of_runs(shown);
    else if (now.account.empty())
        now.account = account_of(runs.front());
    return now;
}

}  // namespace carom

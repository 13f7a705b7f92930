// What a histogram records of a run and counts in a frame. Axes are fixed in histogram_record.cpp,
// the plot is made in histogram_plot.cpp, and the goodness of fit is tested in histogram_test.cpp.
#include "panels/plots/histogram_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/archived.h"
#include "panels/chosen.h"
#include "panels/means/thinning.h"
#include "panels/plot/clock_samples.h"
#include "panels/plot/window.h"
#include "panels/surfaces/side_extent.h"
#include "physics/mechanics.h"
#include "physics/sample_times.h"
#include "scene/film.h"
#include "stats/means/mean_error.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double probe_samples = 40;       // least number, to determine the height of the axis
constexpr double most_in_probe = 100'000;  // values
constexpr double tall_seconds = 1;         // of film: how long a bar near the end fades out
constexpr double least_tall = 0.9;         // of the axis: lower bars never do

using Values = Eigen::Map<const Eigen::ArrayXd>;

double finite_mean(const Values& values) {
    const auto finite = values.isFinite();
    return finite.any() ? finite.select(values, 0.0).sum() / static_cast<double>(finite.count())
                        : 0.0;
}

// The values of `members` (ascending indices). For a part of the particles they are copied into
// `place`.
Values values_of(const std::vector<Eigen::Index>& members, const ValuesOfInput& all,
                 Eigen::ArrayXXd& place) {
    if (std::cmp_equal(members.size(), all.rows())) return {all.data(), all.size()};
    place = all(members, Eigen::seqN(0, all.cols()));
    return {place.data(), place.size()};
}

// Thins large samples: whole samples of a million values would take half of a film's memory.
HistogramProbe probe_of(double time, const Values& values) {
    const auto step = static_cast<Eigen::Index>(
        std::max(1.0, std::ceil(static_cast<double>(values.size()) / most_in_probe)));
    const Eigen::Index kept = (values.size() + step - 1) / step;
    const double stands_for =
        step == 1 ? 1.0 : static_cast<double>(values.size()) / static_cast<double>(kept);
    return {time, values(Eigen::seqN(0, kept, step)), stands_for};
}

std::vector<HistogramCounts> counts_of(
    const std::vector<std::shared_ptr<const PanelState>>& states) {
    std::vector<HistogramCounts> counts;
    for (const auto& state : states)
        counts.push_back(static_cast<const HistogramState&>(*state).counts);
    return counts;
}

std::shared_ptr<const PanelState> state_of(HistogramCounts counts) {
    auto state = std::make_shared<HistogramState>();
    state->counts = std::move(counts);
    state->readouts = std::make_shared<const HistogramCounts>(state->counts);
    return state;
}

}  // namespace

std::size_t HistogramState::bytes() const {
    std::size_t sum = 0;
    for (const MeanHistogram& one : counts.series) sum += one.counts.size() * sizeof(double);
    if (readouts) sum += sum;
    return sum;
}

HistogramPanel::HistogramPanel(const PanelContext& context, const PanelSpec& spec,
                               HistogramSubject subject)
    : context_(context),
      spec_(spec),
      subject_(std::move(subject)),
      members_(context, options().parts.any() ? std::vector<Chosen>{{}} : choices(spec)),
      paths_(context.box(), velocity_changes(context.run())) {
    record_.time = with_samples(context.wording(), time_words(context.wording(), spec),
                                options().by_clock, context.run());
    record_.pools.resize(1);
    if (options().parts.any()) parts_.emplace(context.box(), options().parts);
    for (std::size_t k = 0; parts_ && k < parts_->count(); ++k) {
        choices_.push_back({.within = parts_->regions({})[k],
                            .at_start = static_cast<double>(context.particles.count())});
        record_.series.push_back({.name = parts_->names(Language::english)[k],
                                  .particles = static_cast<double>(context.particles.count())});
    }
    for (const Chosen& chosen : parts_ ? std::vector<Chosen>{} : choices(spec)) {
        const Choice& choice = choices_.emplace_back(Choice{chosen, members(context, chosen)});
        choices_.back().at_start = static_cast<double>(choice.members.size());
        HistogramSeries series{.name = column_name_of(context.scene, chosen),
                               .particles = static_cast<double>(choice.members.size())};
        if (const Law found = law(context.gas, LawOf::distribution, {.of = choice.members}))
            series.equilibria.push_back(counted_motion(*found.equilibrium));
        if (spec.test) require_equilibrium(choice);
        record_.series.push_back(std::move(series));
    }
    take_members();
    record_.probes.resize(choices_.size());
}

void HistogramPanel::take_members() {
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        Choice& choice = choices_[k];
        const std::vector<Eigen::Index>& list = members_.lists()[parts_ ? 0 : k];
        choice.has = members_.flags(parts_ ? 0 : k);
        choice.missing = choice.at_start - static_cast<double>(list.size());
        if (!parts_) choice.members = list;
    }
}

// A mean count over time is relative to the particles at the start: those that have left since are
// elsewhere, and those that have come are so many more.
void HistogramPanel::add_missing(std::vector<HistogramOverTime>& bars,
                                 const FrameInput& input) const {
    const auto each = static_cast<double>(subject_.values(input).cols());
    for (std::size_t k = 0; k < bars.size(); ++k)
        if (choices_[k].missing != 0.0)
            bars[k].add_elsewhere(choices_[k].missing * each, members_since_, input.sample.time);
}

EquilibriumGas HistogramPanel::counted_motion(const EquilibriumGas& gas) const {
    return subject_.axes.empty() ? gas : motion_along(gas, subject_.axes);
}

const std::vector<MeanHistogram>& HistogramPanel::histograms(const PanelState& state) {
    return static_cast<const HistogramState&>(state).counts.series;
}

const std::vector<std::vector<double>>& HistogramPanel::errors(const PanelState& state) {
    return static_cast<const HistogramState&>(state).counts.errors;
}

std::optional<double> HistogramPanel::window() const {
    return window_of(spec_.over.value_or(Over{}));
}

double HistogramPanel::samples() const { return static_cast<double>(sample_count(context_.run())); }

bool HistogramPanel::shows_one_mean() const { return spec_.at && window() != 0.0; }

// The first sample is always a probe, as bins depend on it. With few particles every sample is one,
// since their bars fluctuate most. For a mean at one time, probes are taken within its window, and
// always at its end.
bool HistogramPanel::is_probe(double time, double numbers) const {
    if (surveyed_ == 0) return true;
    const auto probes = static_cast<int>(std::max(most_kept_of_film / numbers, probe_samples));
    double samples = this->samples();
    if (shows_one_mean()) {
        const double end = *spec_.at, length = window().value_or(end);
        if (time > end || time < end - length) return false;
        if (time == end) return true;
        samples *= std::min(1.0, length / context_.run().until);
    }
    return surveyed_ % std::max(1, static_cast<int>(samples) / probes) == 0;
}

void HistogramPanel::survey(const FrameInput& input) {
    const bool is_sample = input.is_sample;
    if (!is_sample && !(shows_one_mean() && input.tick.time == *spec_.at)) return;
    const ValuesOfInput all = subject_.values(input);
    Eigen::ArrayXXd place;
    for (HistogramSeries& one : record_.series) one.values_each = static_cast<double>(all.cols());
    span_ = input.tick.time;
    if (subject_.position_axis)
        widen_to_sides(*subject_.extent, context_.box(), *subject_.position_axis, input);
    find_members(input);
    if (surveyed_ == 0) find_law_of_parts(input);
    const double numbers = record_.values();
    const bool probe = is_probe(input.tick.time, numbers);
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        HistogramSeries& one = record_.series[k];
        const Values values = values_of(choices_[k].members, all, place);
        const double mean =
            parts_ && values.size() == 0 ? std::nan("") : finite_mean(values);  // an empty part
        if (surveyed_ == 0) one.mean_start = one.lowest_mean = one.highest_mean = mean;
        one.lowest_mean = std::fmin(one.lowest_mean, mean);  // of numbers: NaN is none
        one.highest_mean = std::fmax(one.highest_mean, mean);
        const auto keep = [&](Eigen::Index i) {
            if (std::isfinite(values[i]))  // of moving infinite masses some are not
                record_.pools.front().push_back(values[i]);
        };
        if (is_sample)
            for_each_kept(values.size(), numbers, surveyed_, static_cast<int>(samples()), keep);
        if (probe) record_.probes[k].push_back(probe_of(input.tick.time, values));
    }
    if (is_sample) ++surveyed_;
}

// The particles that belong to the choices, or are in parts of the box, at present.
void HistogramPanel::find_members(const FrameInput& input) {
    if (members_.see(input.sample)) take_members();
    if (!parts_) return;
    std::vector<std::vector<Eigen::Index>> now = parts_->members(input);
    for (std::size_t k = 0; k < choices_.size(); ++k) choices_[k].members = std::move(now[k]);
}

// The sides of a closed partition are gases of their own, whose energies are known at the start.
void HistogramPanel::find_law_of_parts(const FrameInput& input) {
    if (!parts_ || options().parts.surfaces.empty()) return;
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        const std::vector<Eigen::Index>& members = choices_[k].members;
        const Law found = law(
            context_.gas, LawOf::side_distribution,
            {.of = members,
             .thermal = thermal_motion(context_.box(), context_.particles, input.sample, members),
             .surface = options().parts.surfaces.front()});
        if (found) record_.series[k].equilibria.push_back(counted_motion(*found.equilibrium));
    }
}

// Successive samples are nearly the same: only every tenth one counts as independent.
void HistogramPanel::finish_record() {
    for (HistogramSeries& one : record_.series)
        if (std::isnan(one.lowest_mean)) one.lowest_mean = one.highest_mean = 0.0;  // ever empty
    const std::optional<double> back = window();
    const double share = !back ? 1.0 : span_ > 0.0 ? std::min(1.0, *back / span_) : 0.0;
    record_.independent = record_.values() / static_cast<double>(record_.series.size()) *
                          std::max(1.0, share * samples() / 10.0);
}

HistogramRules HistogramPanel::rules() const {
    HistogramRules rules{.range = options().range,
                         .bins = options().bins,
                         .symmetric = subject_.symmetric,
                         .window = window()};
    if (!rules.range) rules.range = subject_.extent;
    // A figure of one moment has the axis of the film, so that it can be compared with frames; a
    // mean over time has its own axis.
    rules.only_last = shows_one_mean();
    if (!spec_.theory) return rules;
    if (choices_.size() == 1 && !parts_ && !record_.compares) rules.shares = subject_.shares;
    rules.density = subject_.density;
    rules.probability = subject_.probability;
    return rules;
}

void HistogramPanel::make_axes() {
    axes_ = axes_of(record_, rules());
    begin_counting();
    if (spec_.test && !compares())
        for (const HistogramSeries& one : axes_.series) require_testable(one);
}

void HistogramPanel::take_axes(const RecordPanel& of) {
    axes_ = static_cast<const HistogramPanel&>(of).axes_;
    begin_counting();
}

void HistogramPanel::begin_counting() {
    record_ = {};
    members_ = Members(context_, parts_ ? std::vector<Chosen>{{}} : choices(spec_));
    members_since_ = 0.0;
    take_members();
    const Run& run = context_.run();
    bars_.assign(choices_.size(),
                 HistogramOverTime(axes_.bins, window(), {sample_interval(run), run.until},
                                   options().by_clock));
    for (std::size_t k = 0; k < count(); ++k) roles_.push_back(roles_of(k));
    make_plot();
}

void HistogramPanel::archive(Archive& archive) {
    archive(axes_);
    if (archive.is_reading()) begin_counting();
}

void HistogramPanel::add_to_bars(const PathPiece& piece, std::vector<HistogramOverTime>& bars) {
    const auto is_in = [&](const Choice& choice) {
        return choice.has.empty() || choice.has[static_cast<std::size_t>(piece.particle)];
    };
    for (std::size_t k = 0; parts_ && k < bars.size(); ++k) {
        if (!is_in(choices_[k])) continue;
        find_stays(context_.box(), *choices_[k].within, piece, stays_);
        for (const Stay& stay : stays_)
            subject_.courses(piece.part(stay.from, stay.to),
                             [&](const Course& course) { bars[k].add(course, stay.is_inside); });
    }
    if (parts_) return;
    subject_.courses(piece, [&](const Course& course) {
        for (std::size_t k = 0; k < bars.size(); ++k)
            if (is_in(choices_[k])) bars[k].add(course);
    });
}

void HistogramPanel::see(const FrameInput& input) {
    if (window() == 0.0) return;
    const auto take = [&](const PathPiece& piece) { add_to_bars(piece, bars_); };
    paths_.see_whole(input.sample, input.advanced.collisions, take);
    if (members_.see(input.sample)) {
        paths_.end_flights(input.sample, take);
        add_missing(bars_, input);
        members_since_ = input.sample.time;
        take_members();
    }
    for (HistogramOverTime& one : bars_) one.forget_before(input.tick.time);
    if (shows_one_mean()) follow_means(input);
}

void HistogramPanel::follow_means(const FrameInput& input) {
    const double time = input.tick.time, from = *spec_.at - window().value_or(*spec_.at);
    if (time < from || time > *spec_.at) return;
    const ValuesOfInput all = subject_.values(input);
    Eigen::ArrayXXd place;
    find_members(input);
    means_.resize(choices_.size());
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        MeanOverTime& one = means_[k];
        const double now = values_of(choices_[k].members, all, place).mean();
        if (!std::isfinite(now) || (!one.times.empty() && !(time > one.times.back()))) continue;
        one.integrals.push_back(one.times.empty()
                                    ? 0.0
                                    : one.integrals.back() +
                                          0.5 * (one.last + now) * (time - one.times.back()));
        one.times.push_back(time);
        one.last = now;
    }
}

std::shared_ptr<const PanelState> HistogramPanel::state(const FrameInput& input) {
    see(input);
    std::vector<HistogramOverTime> now = bars_;
    if (window() != 0.0) {
        paths_.see_open([&](const PathPiece& piece) { add_to_bars(piece, now); });
        add_missing(now, input);
    }
    auto state = std::make_shared<HistogramState>();
    const ValuesOfInput all = subject_.values(input);
    Eigen::ArrayXXd place;
    find_members(input);
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        const Values values = values_of(choices_[k].members, all, place);
        const double absent = parts_ ? static_cast<double>(all.size() - values.size())
                                     : choices_[k].missing * static_cast<double>(all.cols());
        state->counts.series.push_back(now[k].mean(input.tick.time, values, absent));
        if (k < means_.size())
            state->counts.mean_errors.push_back(
                error_of_time_average(means_[k].times, means_[k].integrals));
    }
    if (input.refreshes_readouts || !readouts_)
        readouts_ = std::make_shared<const HistogramCounts>(state->counts);
    state->readouts = readouts_;
    taller_until_.resize(state->counts.series.size());
    for (std::size_t k = 0; k < taller_until_.size(); ++k)
        state->taller.push_back(tall_bars(state->counts.series[k], input.tick.frame, k));
    return state;
}

void HistogramPanel::archive_progress(Archive& archive) {
    for (HistogramOverTime& one : bars_) archive(one);
    archive(members_, members_since_, paths_, readouts_, taller_until_);
    if (archive.is_reading()) take_members();
}

// The bars that exceed the axis, and those near its end that exceeded it a moment ago.
// This hysteresis keeps a bar that fluctuates about the end of the axis from changing in every
// frame.
std::vector<bool> HistogramPanel::tall_bars(const MeanHistogram& now, int frame, std::size_t k) {
    const int hold = static_cast<int>(std::lround(tall_seconds * context_.film().fps));
    std::vector<int>& until = taller_until_[k];
    until.resize(now.counts.size(), -1);
    std::vector<bool> taller;
    for (std::size_t i = 0; i < now.counts.size(); ++i) {
        if (now.counts[i] > axes_.top)
            until[i] = frame + (context_.in_film ? hold : 0);
        else if (now.counts[i] <= least_tall * axes_.top)
            until[i] = -1;
        taller.push_back(frame <= until[i]);
    }
    return taller;
}

std::shared_ptr<const PanelState> HistogramPanel::state_of_runs(
    const std::vector<std::shared_ptr<const PanelState>>& states) const {
    return state_of(compares() ? compare(counts_of(states), axes_) : mean_of(counts_of(states)));
}

}  // namespace carom

// What the kinds of histogram share: their keys, and the test of their fit, Pearson's chi-squared
// test, with conservation laws taken into account.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "panels/plot/clock_samples.h"
#include "panels/plots/histogram_panel.h"
#include "panels/plots/suits.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/keys/check.h"
#include "scene/keys/unit_conversion.h"
#include "scene/reading/gas_reading.h"
#include "util/text.h"

namespace carom {
namespace {

LawOf law_of_bars(const PanelSpec& panel) {
    const bool has_parts = panel.options.as<HistogramOptions>().parts.any();
    return has_parts ? LawOf::side_distribution : LawOf::distribution;
}

// The message below states these values.
static_assert(fewest_classes == 3 && least_expected == 5.0);

// A first check only: the pooling of bars, which may leave too few, is not known before the run.
void check_test_of(const PanelSpec& panel, int values_each, const Node& node, Reading& reading) {
    const Node* asked = given(node, "test");
    std::optional<std::int64_t> fewest = particles_in(reading.gas);
    if (asked == nullptr || !panel.test || !fewest || panel.joined) return;
    for (const Chosen& chosen : panel.of) fewest = std::min(fewest, count_of(chosen, reading.gas));
    if (static_cast<double>(*fewest * panel.seeds * values_each) < fewest_classes * least_expected)
        reading.errors.add(*asked,
                           "too few particles for `test`: three bars need 5 expected counts each",
                           "leave it out, show more particles, or take more `seeds`");
}

Notation<std::pair<double, double>> histogram_range() {
    const auto rising = [](const TwoNumbers& ends, const Node& node, Reading& reading) {
        constexpr double least_width = 1e-9;  // of the numbers: edges have sixteen digits
        if (ends[0] >= ends[1])
            reading.errors.add(node, "expected [low, high] with low < high for `range`",
                               "write the smaller one first");
        else if (ends[1] - ends[0] < least_width * std::max(std::abs(ends[0]), std::abs(ends[1])))
            reading.errors.add(node,
                               "the edges of `range` agree in nine digits: bars would be "
                               "narrower than rounding errors",
                               "take a wider range");
    };
    return mapped(checked(pair_of(number_of_any_quantity(any_number), "[low, high]"), rising),
                  [](const TwoNumbers& ends) { return std::pair(ends[0], ends[1]); });
}

// These stand before the key of theory.
std::vector<Binding<HistogramOptions>> bar_keys() {
    return {bind_key("bins", &HistogramOptions::bins, whole(1, most_bins), "The number of bars.")
                .default_text("chosen by rule from the whole run"),
            bind_key("range", &HistogramOptions::range, histogram_range(),
                     "The first and the last edge of the bars.")
                .default_text("chosen by rule from the whole run"),
            bind_key("fit", &HistogramOptions::fit, flag(),
                     "Whether to draw the normal curve with the same mean and standard deviation, "
                     "and show both values."),
            bind_key("mean_now", &HistogramOptions::mean_now, flag(), "Whether to mark the mean.")
                .default_text("true for speeds and energies"),
            bind_key("mean_start", &HistogramOptions::mean_start, flag(),
                     "Whether to mark the mean at the start.")
                .default_text("true for speeds and energies")};
}

std::vector<Binding<HistogramOptions>> histogram_keys() {
    return joined<HistogramOptions>(std::vector{samples_key(&HistogramOptions::by_clock)},
                                    bind_within(&HistogramOptions::parts, part_keys()));
}

// The key is one for all kinds, so that its unit is known only here.
void check_unit_of_range(const Quantity& quantity, const Node& node, Reading& reading) {
    const Node* range = given(node, "range");
    if (range == nullptr || !range->is_list()) return;
    for (const Node& end : range->items) {
        const auto written = number_with_unit(end.written);
        const Unit* unit = written ? unit_named(written->unit) : nullptr;
        if (unit == nullptr || measures(*unit, quantity)) continue;
        reading.errors.add(end,
                           fmt::format("expected {} for `range`, found {}",
                                       quantity_words(quantity), described(end)),
                           fmt::format("for instance `{}`", unit_example(quantity)));
    }
}

void check_range(const HistogramOptions& options, const Node& node, Reading& reading) {
    const auto& range = options.range;
    if (!range || range->first >= 0.0 || range->first >= range->second) return;
    const Node& written = *given(node, "range");
    reading.errors.add(written,
                       fmt::format("expected [low, high] from 0 on for `range`, found {}",
                                   in_quotes(written.items[0].text)),
                       "speeds and energies are never negative");
}

// Reports a missing equilibrium curve only if the scene asks for it; if it is merely the default,
// it is left out, and `check` lists it.
void check_equilibrium(const PanelSpec& panel, const Node& node, Reading& reading) {
    const Node* asked = given(node, "theory");
    if (asked == nullptr || !panel.theory) return;
    if (asked->source->origin == Origin::template_file || reading.gas.species.empty()) return;
    const SurfaceNumbers& surfaces = panel.options.as<HistogramOptions>().parts.surfaces;
    const Asked of{.surface = surfaces.empty() ? 0 : surfaces.front()};
    if (const auto reason = why_no_law(reading.gas, reading.run, law_of_bars(panel), of))
        reading.errors.add(*asked,
                           "there is no equilibrium curve for this gas: " +
                               to_text(Language::english, *reason, reading.gas.species),
                           "leave out `theory`; the curve is then drawn where there is one");
}

// A histogram takes particles, regions, or the sides of a partition that stays in its place.
void check_parts(PanelSpec& panel, const Node& node, Reading& reading) {
    const bool has_surfaces = is_written(node, "surfaces");
    const char* parts = has_surfaces ? "surfaces" : "regions";
    if (!is_written(node, parts)) return;
    const std::vector<const char*> others =
        has_surfaces ? std::vector{"of", "regions", "compare"} : std::vector{"of", "test"};
    for (const char* other : others)
        if (is_written(node, other))
            return refuse_together(reading.errors, *find(node, other), {other, parts});
    if (!has_surfaces) return;
    const SuitableSurface fixed{
        [&](std::int32_t surface) {
            return !reading.box().surfaces.is_side(surface) && !may_move(reading, surface);
        },
        "a partition that does not move",
        fmt::format("name another one, or parts by `regions: [{{name: left, within: {}}}]`",
                    corners(reading.box().dimension))};
    SurfaceNumbers& surfaces = panel.options.change<HistogramOptions>().parts.surfaces;
    keep_suitable(panel, surfaces, fixed, node, reading);
    require_one(panel, surfaces, node, reading);
}

}  // namespace

PanelKind histogram_kind(PanelKind kind, const Quantity& quantity, bool is_from_zero,
                         std::function<int(const PanelSpec&, const Gas&)> values_each) {
    kind.shows_units = true;
    kind.bar_keys = option_keys(bar_keys());
    kind.keys = option_keys(histogram_keys());
    const bool has_law = kind.can(Ability::equilibrium);
    kind.rule = [=](PanelSpec& panel, const Node& node, Reading& reading) {
        const auto& options = panel.options.as<HistogramOptions>();
        check_unit_of_range(quantity, node, reading);
        if (is_from_zero) check_range(options, node, reading);
        if (has_law) check_equilibrium(panel, node, reading);
        check_parts(panel, node, reading);
        if (options.by_clock) check_samples_of_bars(panel, node, reading);
        if (has_law) check_test_of(panel, values_each(panel, reading.gas), node, reading);
    };
    if (has_law) {
        kind.suits = speeds_spread;
        kind.laws = [](const PanelSpec& panel, const Gas&) {
            return std::vector{law_of_bars(panel)};
        };
    }
    kind.measured_at = measured_at(&HistogramOptions::parts);
    kind.numbers = {"mean", "deviation", "fit.mean", "fit.deviation"};
    return kind;
}

// The expected counts in all runs together.
Expected HistogramPanel::expected(const HistogramSeries& series) const {
    std::vector<double> edges;
    for (int i = 0; i <= axes_.bins.count; ++i) edges.push_back(axes_.bins.edge(i));
    std::vector<Expected> runs;
    for (const EquilibriumGas& gas : series.equilibria)
        runs.push_back(
            expected_counts(gas, *subject_.tested, edges, series.particles, series.values_each));
    return runs.size() == 1 ? std::move(runs.front()) : together(runs);
}

void HistogramPanel::require_equilibrium(const Choice& choice) const {
    const Law found = law(context_.gas, LawOf::goodness_of_fit, {.of = choice.members});
    if (found) return;
    const bool is_mixed = found.none->why == NoLaw::Why::unequal_masses ||
                          found.none->why == NoLaw::Why::fixed_particles;
    if (is_mixed)
        refuse(spec_.place, "the test is for particles of one finite mass",
               "choose them in `of`: the name of one species");
    refuse(spec_.place,
           "there is no equilibrium that these bars could be tested against: " +
               to_text(Language::english, *found.none, context_.species()),
           "leave out `test`, or change the gas so that it comes to one");
}

void HistogramPanel::require_testable(const HistogramSeries& series) const {
    const Expected classes = expected(series);
    if (!pearson(classes.count, classes))
        refuse(spec_.place,
               "too few particles for the test: fewer than three bars have 5 expected counts",
               "leave out `test`, or give the gas more particles");
}

std::optional<ChiSquared> HistogramPanel::test_of(const HistogramCounts& counts,
                                                  std::size_t series) const {
    const MeanHistogram& now = counts.series[series];
    std::vector<double> observed{now.below};
    observed.insert(observed.end(), now.counts.begin(), now.counts.end());
    observed.push_back(now.above);
    for (double& count : observed) count *= static_cast<double>(axes_.runs);
    return pearson(observed, expected(axes_.series[series]));
}

std::optional<ChiSquared> HistogramPanel::test(const PanelState& state, std::size_t series) const {
    return test_of(static_cast<const HistogramState&>(state).counts, series);
}

std::string HistogramPanel::test_words(const HistogramCounts& now) const {
    const Language language = context_.language();
    std::string results;
    for (std::size_t k = 0; k < count(); ++k) {
        const ChiSquared found = test_of(now, k).value();
        const std::string result =
            say(language, "\u03C7\u00B2 = {} for {} degrees of freedom, p = {}",
                three_digits(language, found.statistic), three_digits(language, found.freedom),
                three_digits(language, found.p));
        results += k == 0 ? "" : "; ";
        results += count() > 1 ? say(language, "{}, {}", name_of_series(k), result) : result;
    }
    return say(
        language,
        "Pearson\u2019s chi-squared test against equilibrium: {} (bars are pooled until 5 are "
        "expected in each; conserved quantities lower the degrees of freedom).",
        results);
}

}  // namespace carom

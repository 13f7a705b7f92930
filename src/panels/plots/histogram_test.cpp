// What is checked of a histogram: its keys, and the goodness of its fit, by Pearson's chi-squared
// test, with conservation laws taken into account.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "panels/plot/clock_samples.h"
#include "panels/plots/histogram_panel.h"
#include "scene/instruments/instrument_reading.h"
#include "scene/reading/gas_reading.h"
#include "util/text.h"

namespace carom {
namespace {

// The message below states these values.
static_assert(fewest_classes == 3 && least_expected == 5.0);

// A first check only: the pooling of bars, which may leave too few, is not known before the run.
void check_test_of(const PanelSpec& panel, int values_each, const Node& node, Reading& reading) {
    const Node* asked = given(node, "test");
    std::optional<std::int64_t> fewest = particles_in(reading.gas);
    if (asked == nullptr || !panel.test || !fewest || panel.sweep.from) return;
    for (const Chosen& chosen : panel.of) fewest = std::min(fewest, count_of(chosen, reading.gas));
    if (static_cast<double>(*fewest * panel.seeds * values_each) < fewest_classes * least_expected)
        reading.errors.add(*asked,
                           "too few particles for `test`: three bars need 5 expected counts each",
                           "leave it out, show more particles, or take more `seeds`");
}

}  // namespace

void check_scalar_histogram(PanelSpec& panel, const Node& node, Reading& reading) {
    check_position_histogram(panel, node, reading);
    check_test_of(panel, 1, node, reading);
}

void check_velocity_histogram(PanelSpec& panel, const Node& node, Reading& reading) {
    const bool both = panel.component.value_or(Component::both) == Component::both;
    check_position_histogram(panel, node, reading);
    check_test_of(panel, both ? reading.gas.box.dimension : 1, node, reading);
}

void check_position_histogram(PanelSpec& panel, const Node& node, Reading& reading) {
    check_parts(panel, node, reading);
    check_samples_of_bars(panel, node, reading);
}

std::vector<LawOf> laws_of_histogram(const PanelSpec& panel, const Gas&) {
    return {panel.shows_parts() ? LawOf::side_distribution : LawOf::distribution};
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
               to_text(Language::english, *found.none, context_.scene.gas.species),
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

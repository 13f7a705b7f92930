// How well a histogram fits its curve: Pearson's test, with what is conserved taken into account.
#include <fmt/format.h>

#include "panels/chosen.h"
#include "panels/plots/histogram_panel.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {

Expected HistogramPanel::expected_in_run(const Series& series, const EquilibriumGas& gas) const {
    std::vector<double> edges;
    for (int i = 0; i <= bins_.count; ++i) edges.push_back(bins_.edge(i));
    return expected_counts(gas, *subject_.law, edges, static_cast<double>(series.members.size()),
                           numbers_each_);
}

// In all runs together: each has its own conserved sums, which have the same part in its counts.
Expected HistogramPanel::expected(const Series& series) const {
    const auto add = [](std::vector<double>& sum, const std::vector<double>& more) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
    };
    Expected all = expected_in_run(series, *series.equilibrium);
    for (const EquilibriumGas& gas : series.others) {
        const Expected one = expected_in_run(series, gas);
        add(all.count, one.count);
        for (std::size_t c = 0; c < all.conserved.size(); ++c)
            add(all.conserved[c].moment, one.conserved[c].moment);
    }
    return all;
}

// Particles of several masses, with so many of each, do not make counts of one law; and fixed ones
// have no part in the energy.
void HistogramPanel::require_testable(const Series& series) const {
    Diagnostic error = spec_.place;
    if (!series.equilibrium || series.others.size() + 1 < runs_) {
        error.message = "there is no equilibrium that these bars could be tested against";
        error.hint = "leave out `test`, or change the gas so that it comes to one";
        throw SceneError({error});
    }
    const std::vector<MassGroup>& groups = series.equilibrium->groups;
    if (groups.size() > 1 || groups.front().count < static_cast<double>(series.members.size())) {
        error.message = "the test is for particles of one finite mass";
        error.hint = "choose them in `of`: the name of one species";
        throw SceneError({error});
    }
    const Expected law = expected(series);
    if (pearson(law.count, law)) return;
    error.message = "too few particles for the test: not three bars have 5 expected in each";
    error.hint = "leave out `test`, or give the gas more particles";
    throw SceneError({error});
}

std::optional<ChiSquared> HistogramPanel::test(const PanelState& state, std::size_t series) const {
    const MeanHistogram& now = histograms(state)[series];
    std::vector<double> observed{now.below};
    observed.insert(observed.end(), now.counts.begin(), now.counts.end());
    observed.push_back(now.above);
    for (double& count : observed) count *= static_cast<double>(runs_);
    return pearson(observed, expected(series_[series]));
}

std::string HistogramPanel::finding(const PanelState& state) const {
    if (!spec_.test) return "";
    std::string words = "Pearson\u2019s chi-squared test against equilibrium";
    for (std::size_t k = 0; k < series_.size(); ++k) {
        const ChiSquared found = test(state, k).value();
        words += fmt::format(
            "{}{} \u03C7\u00B2 = {} for {} degrees of freedom, p = {}", k == 0 ? ":" : ";",
            series_.size() > 1 ? " " + name_of(context_, series_[k].chosen) + "," : "",
            three_digits(found.statistic), three_digits(found.freedom), three_digits(found.p));
    }
    return words +
           " (bars pooled until 5 are expected in each; what is conserved lowers the degrees of "
           "freedom).";
}

}  // namespace carom

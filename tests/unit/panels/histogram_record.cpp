// What histograms record of runs, and how the records of several are combined: plain values,
// without a panel.
#include "panels/plots/histogram_record.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "draw/axis.h"
#include "stats/running_histogram.h"
#include "support/relative.h"

using namespace carom;
using test::relative;

namespace {

EquilibriumGas gas_of(double energy, double count) {
    return {.energy = energy, .beta = count - 1.0, .groups = {{1.0, count}}};
}

HistogramRecord record_of(double mean_start, double particles, double energy,
                          const std::vector<double>& pool) {
    HistogramRecord record;
    record.series = {{.name = "all",
                      .particles = particles,
                      .mean_start = mean_start,
                      .lowest_mean = mean_start - 1.0,
                      .highest_mean = mean_start + 1.0,
                      .equilibria = {gas_of(energy, particles)}}};
    record.probes = {{{0.0, Eigen::Map<const Eigen::ArrayXd>(pool.data(), std::ssize(pool))}}};
    record.pools = {pool};
    record.independent = particles;
    record.time = "at time 3";
    return record;
}

// The height of the curve is the energy of the gas, in each bin.
HistogramRules rules_with_energies() {
    return {.range = std::pair{0.0, 4.0},
            .bins = 4,
            .density = [](const EquilibriumGas& gas, double) { return gas.energy; }};
}

MeanHistogram bars(std::vector<double> counts, double below, double above, double mean,
                   double deviation) {
    return {.bins = {0.0, 4.0, static_cast<int>(counts.size())},
            .counts = std::move(counts),
            .below = below,
            .above = above,
            .mean = mean,
            .deviation = deviation};
}

}  // namespace

TEST_CASE("the record of a mean holds the values of all runs, and means of their starts") {
    const HistogramRecord mean =
        mean_of(std::vector{record_of(2.0, 10, 3.0, {1, 2}), record_of(3.0, 10, 5.0, {4})});
    CHECK(mean.runs == 2);
    CHECK(!mean.compares);
    CHECK(mean.time == "at time 3");
    CHECK(mean.pools == std::vector<std::vector<double>>{{1, 2, 4}});
    REQUIRE(mean.series.size() == 1);
    CHECK(mean.series[0].mean_start == 2.5);
    CHECK(mean.series[0].lowest_mean == 1.0);
    CHECK(mean.series[0].highest_mean == 4.0);
    CHECK(mean.series[0].equilibria.size() == 2);
    const HistogramAxes axes = axes_of(mean, rules_with_energies());
    CHECK(axes.has_curves());
    CHECK(!axes.counts_per_cent());
    for (const double count : axes.curves.at(0).count)
        CHECK(count == relative(10 * 0.5 * (3 + 5), 1e-14));
}

TEST_CASE("runs of equal numbers are compared by counts, others by shares") {
    const std::vector<HistogramRecord> equal{record_of(2.0, 10, 3.0, {1, 2}),
                                             record_of(3.0, 10, 5.0, {4})};
    const HistogramRecord counts = compare(equal, {"cold", "hot"});
    CHECK(counts.compares);
    CHECK(counts.series[0].name == "cold");
    CHECK(counts.series[1].name == "hot");
    CHECK(counts.series[1].unit == 1.0);
    CHECK(counts.pools == std::vector<std::vector<double>>{{1, 2}, {4}});
    CHECK(counts.time == "at time 3");
    CHECK(!axes_of(counts, rules_with_energies()).counts_per_cent());

    HistogramRecord few = record_of(3.0, 5, 5.0, {40});
    few.time = "at time 2";
    const HistogramRecord shares = compare({equal[0], few}, {"many", "few"});
    CHECK(shares.independent == 5.0);
    CHECK(shares.time.empty());
    CHECK(shares.series[0].unit == 10.0);
    CHECK(shares.series[1].unit == 20.0);
    const HistogramAxes axes = axes_of(shares, rules_with_energies());
    CHECK(axes.counts_per_cent());
    CHECK(axes.curves.at(0).count.front() == relative(10.0 * 10 * 3.0, 1e-14));
    CHECK(axes.curves.at(1).count.front() == relative(20.0 * 5 * 5.0, 1e-14));
    const HistogramCounts shown =
        compare({HistogramCounts{{bars({4, 6}, 0, 0, 1, 1)}}, {{bars({1, 3}, 1, 0, 1, 1)}}}, axes);
    CHECK(shown.series[0].counts == std::vector{40.0, 60.0});
    CHECK(shown.series[1].counts == std::vector{20.0, 60.0});
    CHECK(shown.series[1].below == 20.0);
    CHECK(shown.errors.empty());
}

TEST_CASE("an axis has room for the values of every run that is compared") {
    const std::vector<HistogramRecord> runs{record_of(1.0, 3, 1.0, {1, 1, 2}),
                                            record_of(9.0, 3, 1.0, {8, 9, 10})};
    CHECK(axes_of(runs[0], {}).bins.high < 4.0);
    CHECK(axes_of(compare(runs, {"slow", "fast"}), {}).bins.high >= 1.25 * 9.9);
    CHECK(axes_of(compare({runs[1], runs[0]}, {"fast", "slow"}), {}).bins.high >= 1.25 * 9.9);
}

TEST_CASE("mean counts have errors, and a deviation about the mean of all runs") {
    const HistogramCounts mean = mean_of(std::vector<HistogramCounts>{
        {{bars({2, 8}, 1, 0, 1.0, 0.5)}}, {{bars({4, 6}, 0, 2, 3.0, 0.5)}}});
    const MeanHistogram& one = mean.series.at(0);
    CHECK(one.counts == std::vector{3.0, 7.0});
    CHECK(mean.errors.at(0)[0] == relative(1.0, 1e-14));
    CHECK(mean.errors.at(0)[1] == relative(1.0, 1e-14));
    CHECK(one.below == 0.5);
    CHECK(one.above == 1.0);
    CHECK(one.mean == 2.0);
    CHECK(one.deviation == relative(std::sqrt(0.25 + 1.0), 1e-14));
}

namespace {

// A run that starts with these values and goes on with others.
HistogramRecord run_from(std::vector<double> start, std::vector<double> later) {
    HistogramRecord record = record_of(start.front(), double(start.size()), 1.0, later);
    const Eigen::ArrayXd values = Eigen::Map<const Eigen::ArrayXd>(start.data(), std::ssize(start));
    record.probes = {{{0.0, values}}};
    record.independent = 2000;
    return record;
}

std::vector<double> spread(double low, double high) {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) values.push_back(low + (high - low) * i / 1000);
    return values;
}

bool is_whole(double number) { return std::abs(number - std::round(number)) < 1e-9; }

}  // namespace

TEST_CASE("bins have round widths, with edges on the ticks of the axis") {
    for (const double high : {0.031, 0.7, 2.3, 2.9, 5.5, 8.1, 640.0}) {
        CAPTURE(high);
        const Bins bins = axes_of(run_from(spread(0, high), spread(0, high)), {}).bins;
        const double digits = bins.width() / std::pow(10, std::floor(std::log10(bins.width())));
        CAPTURE(bins.width());
        CHECK(is_whole(digits * 2));
        CHECK(bins.count >= 12);
        CHECK(bins.count <= 60);
        for (const TickMark& tick : ticks(bins.low, bins.high))
            CHECK(is_whole(tick.value / bins.width()));
    }
}

TEST_CASE("an equal start is in the middle of its bar") {
    for (const double speed : {0.5, 1.0, 1.5, 2.0, 5.0, 0.25}) {
        CAPTURE(speed);
        const Bins bins =
            axes_of(run_from({speed, speed, speed}, spread(0.4 * speed, 1.6 * speed)), {}).bins;
        CHECK(is_whole(speed / bins.width() - 0.5));
    }
    const HistogramRules symmetric{.symmetric = true};
    const Bins beams = axes_of(run_from({1.0, -1.0, 1.0}, spread(-2, 2)), symmetric).bins;
    CHECK(is_whole((1.0 - beams.low) / beams.width() - 0.5));
    const Bins rest = axes_of(run_from({0.0, 0.0, 0.0}, spread(-2, 2)), symmetric).bins;
    CHECK(is_whole((0.0 - rest.low) / rest.width() - 0.5));
}

TEST_CASE("the bars of a settled gas fit under the end of the axis, with all that they waver") {
    HistogramRecord record = run_from(spread(0, 1), spread(0, 4));
    record.probes.front().clear();
    for (int i = 0; i < 40; ++i) {
        const double last = i < 10 ? 0.2 : 3.0 + 0.5 * std::sin(i);
        const std::vector<double> now = spread(0, last);
        record.probes.front().push_back(
            {double(i), Eigen::Map<const Eigen::ArrayXd>(now.data(), std::ssize(now))});
    }
    const HistogramAxes axes = axes_of(record, {});
    for (int i = 10; i < 40; ++i) {
        RunningHistogram running(axes.bins, 0.0);
        running.add(i, record.probes.front()[std::size_t(i)].values);
        CHECK(std::ranges::max(running.mean().counts) <= axes.top);
    }
    // Nor is the axis as long as the start would ask for.
    CHECK(axes.top < 400);
}

// Of 40 probes the first 25 are an eighth as wide as the others.
TEST_CASE("where a mean is shown at one time only, its bars fill the height") {
    HistogramRecord record = run_from(spread(0, 1), spread(0, 4));
    record.probes.front().clear();
    const auto record_until = [&](int last) {
        HistogramRecord its = record;
        for (int i = 0; i <= last; ++i) {
            const std::vector<double> now = spread(0, i < 25 ? 0.5 : 4.0);
            its.probes.front().push_back(
                {double(i), Eigen::Map<const Eigen::ArrayXd>(now.data(), std::ssize(now))});
        }
        return its;
    };
    const auto axes = [&](const HistogramRecord& its, bool only_last) {
        return axes_of(its, {.bins = 8, .window = 10.0, .only_last = only_last});
    };
    const auto tallest = [&](const HistogramRecord& its) {
        RunningHistogram running(axes(its, false).bins, 10.0);
        for (const HistogramProbe& probe : its.probes.front())
            running.add(probe.time, probe.values);
        return std::ranges::max(running.mean().counts);
    };
    for (const int last : {20, 39}) {
        CAPTURE(last);
        const HistogramRecord its = record_until(last);
        CHECK(axes(its, true).top >= tallest(its));
        CHECK(axes(its, true).top <= 2.0 * tallest(its));
    }
    // Of a film, in which those before are seen.
    const HistogramRecord whole = record_until(39);
    CHECK(axes(whole, false).top > 2.0 * tallest(whole));
    // A comparison has room for the tallest bars of each, which has probes of its own.
    for (const bool narrow_first : {true, false}) {
        CAPTURE(narrow_first);
        const HistogramRecord narrow = record_until(20);
        const HistogramRecord both = narrow_first ? compare({narrow, whole}, {"a", "b"})
                                                  : compare({whole, narrow}, {"b", "a"});
        const double top = axes(both, true).top;
        CHECK(top >= tallest(narrow));
        CHECK(top <= 2.0 * tallest(narrow));
    }
}

TEST_CASE("probes of a part of all values give the axis that whole ones give") {
    const std::vector<double> all = spread(0, 1);
    const auto top_with = [&](Eigen::Index step) {
        HistogramRecord record = run_from(all, all);
        const Eigen::ArrayXd whole = Eigen::Map<const Eigen::ArrayXd>(all.data(), std::ssize(all));
        const Eigen::ArrayXd part = whole(Eigen::seq(0, whole.size() - 1, step));
        record.probes.front().assign(
            9, {0.0, part, static_cast<double>(whole.size()) / static_cast<double>(part.size())});
        return axes_of(record, {}).top;
    };
    // A bar more or less of the part is a few per cent, and the end of the axis is a round number.
    CHECK(top_with(10) == doctest::Approx(top_with(1)).epsilon(0.2));
}

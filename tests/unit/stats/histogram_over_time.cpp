#include "stats/histogram_over_time.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/relative.h"
#include "util/random.h"

using namespace carom;
using test::relative;

namespace {

constexpr double end = 10.0;
const SampleClock usual{0.125, end};
const Bins bins{-2.0, 3.0, 20};

// A particle whose value changes now and then and is constant in between.
std::vector<Course> steps(Random& random) {
    std::vector<Course> all;
    double time = 0.0;
    while (time < end) {
        const double until = std::min(end, time - std::log(1.0 - random.uniform()) * 0.3);
        all.push_back({time, until, {6.0 * random.uniform() - 2.5, 0.0, 0.0}});
        time = until;
    }
    return all;
}

// The time that each value lasts in [from, now], added to its bin, one course after another.
MeanHistogram slowly(const std::vector<Course>& courses, double from, double now) {
    MeanHistogram mean{.bins = bins, .counts = std::vector<double>(std::size_t(bins.count))};
    double sum = 0.0, squares = 0.0;
    const double all = now - from;
    for (const Course& one : courses) {
        const double time = std::min(one.to, now) - std::max(one.from, from);
        if (!(time > 0.0)) continue;
        const double value = one.coefficients[0];
        const auto bin = std::floor((value - bins.low) / bins.width());
        if (bin < 0.0)
            mean.below += time / all;
        else if (bin >= bins.count)
            mean.above += time / all;
        else
            mean.counts[std::size_t(bin)] += time / all;
        sum += time * value;
        squares += time * value * value;
    }
    double weight = 0.0;
    for (const Course& one : courses)
        weight += std::max(0.0, std::min(one.to, now) - std::max(one.from, from));
    mean.mean = sum / weight;
    mean.deviation = std::sqrt(squares / weight - mean.mean * mean.mean);
    return mean;
}

void check_same(const MeanHistogram& mean, const MeanHistogram& expected, double near) {
    for (std::size_t k = 0; k < expected.counts.size(); ++k) {
        CAPTURE(k);
        CHECK(std::abs(mean.counts[k] - expected.counts[k]) < near);
    }
    CHECK(std::abs(mean.below - expected.below) < near);
    CHECK(std::abs(mean.above - expected.above) < near);
    CHECK(std::abs(mean.mean - expected.mean) < near);
    CHECK(std::abs(mean.deviation - expected.deviation) < 10.0 * near);
}

// Courses that begin before a time, cut there.
HistogramOverTime up_to(double now, const std::vector<Course>& courses,
                        std::optional<double> window, bool at_clock) {
    HistogramOverTime histogram(bins, window, usual, at_clock);
    for (Course one : courses) {
        one.to = std::min(one.to, now);
        if (one.to > one.from) histogram.add(one);
        histogram.forget_before(std::min(one.from, now));
    }
    return histogram;
}

Eigen::ArrayXd value_at(const std::vector<Course>& courses, double now) {
    for (const Course& one : courses)
        if (now >= one.from && (now < one.to || one.to == end))
            return Eigen::ArrayXd::Constant(1, one.value(now - one.from));
    return {};
}

}  // namespace

TEST_CASE("a value that is constant for a time counts as long as it lasts") {
    Random random(3, "histogram over time");
    const std::vector<Course> courses = steps(random);
    for (const double now : {0.01, 3.0, 7.3, end}) {
        CAPTURE(now);
        const Eigen::ArrayXd present = value_at(courses, now);
        check_same(up_to(now, courses, {}, false).mean(now, present), slowly(courses, 0.0, now),
                   1e-12);
        for (const double window : {0.125, 2.0, 20.0}) {  // the start is at a time of the clock
            const double at = std::round(now / 0.125) * 0.125;
            if (at == 0.0) continue;
            CAPTURE(window);
            check_same(up_to(at, courses, window, false).mean(at, value_at(courses, at)),
                       slowly(courses, std::max(0.0, at - window), at), 1e-12);
        }
    }
}

TEST_CASE("a value that is elsewhere for a time counts only while it is here") {
    Random random(5, "histogram over time");
    const std::vector<Course> courses = steps(random);
    const auto is_here = [](std::size_t k) { return k % 3 != 1; };
    for (const std::optional<double> window : {std::optional<double>(), std::optional(2.0)}) {
        const double now = 7.0, from = window ? now - *window : 0.0;
        HistogramOverTime histogram(bins, window, usual, false);
        std::vector<double> counts(std::size_t(bins.count));
        double sum = 0.0, time = 0.0;
        for (std::size_t k = 0; k < courses.size(); ++k) {
            Course one = courses[k];
            one.to = std::min(one.to, now);
            if (!(one.to > one.from)) continue;
            histogram.add(one, is_here(k));
            const double lasts = one.to - std::max(one.from, from), value = one.coefficients[0];
            if (!is_here(k) || !(lasts > 0.0)) continue;
            sum += lasts * value;
            time += lasts;
            const double place = std::floor((value - bins.low) / bins.width());
            if (place >= 0.0 && place < bins.count) counts[std::size_t(place)] += lasts;
        }
        const MeanHistogram mean = histogram.mean(now, Eigen::ArrayXd(), 1.0);
        for (std::size_t k = 0; k < counts.size(); ++k)
            CHECK(std::abs(mean.counts[k] - counts[k] / (now - from)) < 1e-12);
        CHECK(mean.values() == relative(time / (now - from), 1e-12));
        CHECK(mean.mean == relative(sum / time, 1e-12));
    }
}

TEST_CASE("a window that begins between two times of the clock takes a share of what lies there") {
    HistogramOverTime histogram({0.0, 3.0, 3}, 1.0, {0.5, 10.0}, false);
    histogram.add({0.0, 1.0, {0.5, 0.0, 0.0}});
    histogram.add({1.0, 2.0, {1.5, 0.0, 0.0}});
    histogram.add({2.0, 2.2, {2.5, 0.0, 0.0}});
    const MeanHistogram mean = histogram.mean(2.2, Eigen::ArrayXd::Constant(1, 2.5));
    CHECK(mean.counts[0] == doctest::Approx(0.0));
    CHECK(mean.counts[1] == doctest::Approx(0.8));  // 0.3 of the interval from 1 to 1.5, and 0.5
    CHECK(mean.counts[2] == doctest::Approx(0.2));
}

TEST_CASE("of a value that changes by itself the time in each bin is exact") {
    HistogramOverTime histogram({0.0, 2.0, 4}, {}, usual, false);
    const Eigen::ArrayXd none = Eigen::ArrayXd::Constant(1, 0.0);
    SUBCASE("a velocity that grows evenly") {
        histogram.add({0.0, 2.0, {-0.5, 1.0, 0.0}});  // from -0.5 to 1.5
        const MeanHistogram mean = histogram.mean(2.0, none);
        CHECK(mean.below == relative(0.25, 1e-12));
        for (const std::size_t k : {0, 1, 2}) CHECK(mean.counts[k] == relative(0.25, 1e-12));
        CHECK(mean.counts[3] == doctest::Approx(0.0));
        CHECK(mean.mean == relative(0.5, 1e-12));
        CHECK(mean.deviation == relative(1.0 / std::sqrt(3.0), 1e-12));
    }
    SUBCASE("a place that turns") {
        histogram.add({0.0, 2.0, {0.0, 2.0, -1.0}});  // 1 - (t - 1)^2
        const MeanHistogram mean = histogram.mean(2.0, none);
        CHECK(mean.counts[1] == relative(std::sqrt(0.5), 1e-12));
        CHECK(mean.counts[0] == relative(1.0 - std::sqrt(0.5), 1e-12));
        CHECK(mean.mean == relative(2.0 / 3.0, 1e-12));
        CHECK(mean.deviation == relative(std::sqrt(4.0 / 45.0), 1e-12));
    }
    SUBCASE("a speed") {
        Course speed{0.0, 2.0, {2.0, -2.0, 1.0}, true};  // sqrt(1 + (t - 1)^2)
        histogram.add(speed);
        const MeanHistogram mean = histogram.mean(2.0, none);
        CHECK(mean.counts[2] == relative(1.0, 1e-12));  // 1 to sqrt(2)
        const double exact = 0.5 * (std::numbers::sqrt2 + std::asinh(1.0));
        CHECK(mean.mean == relative(exact, 1e-12));
        CHECK(mean.deviation == relative(std::sqrt(4.0 / 3.0 - exact * exact), 1e-9));
    }
}

TEST_CASE("times in bins agree with values at very many times") {
    Random random(5, "histogram over time");
    for (int trial = 0; trial < 40; ++trial) {
        const bool is_root = trial % 2 == 1;
        const auto any = [&] { return 6.0 * random.uniform() - 3.0; };
        Course course{0.0, 1.0 + random.uniform(), {any(), any(), any()}, is_root};
        if (is_root) {  // the square of a vector that changes evenly
            const double a = any(), b = any(), c = any(), d = any();
            course.coefficients = {a * a + b * b, 2.0 * (a * c + b * d), c * c + d * d};
        }
        HistogramOverTime histogram(bins, {}, usual, false);
        histogram.add(course);
        constexpr int count = 200'000;
        Eigen::ArrayXd values(count);
        for (int i = 0; i < count; ++i) values[i] = course.value((i + 0.5) / count * course.to);
        const Histogram fine = carom::histogram(values, bins);
        const MeanHistogram mean = histogram.mean(course.to, values.head(1));
        CAPTURE(trial);
        const double near = 10.0 / count;  // of each bin, as many edges are passed
        for (std::size_t k = 0; k < mean.counts.size(); ++k)
            CHECK(std::abs(mean.counts[k] - double(fine.counts[k]) / count) < near);
        CHECK(std::abs(mean.mean - values.mean()) < 1e-7);
        const double deviation = std::sqrt((values - values.mean()).square().mean());
        CHECK(std::abs(mean.deviation - deviation) < 1e-6);
    }
}

TEST_CASE("at the times of a clock, values count once each") {
    Random random(7, "histogram over time");
    const std::vector<Course> courses = steps(random);
    for (const std::optional<double> window : {std::optional<double>{}, {2.0}})
        for (const double now : {0.0, 0.06, 4.0, 7.3, end}) {
            CAPTURE(now);
            std::vector<double> values;
            for (int k = 0; k * 0.125 <= now; ++k)
                if (!window || k * 0.125 > now - *window)
                    values.push_back(value_at(courses, k * 0.125)[0]);
            const Eigen::ArrayXd all =
                Eigen::Map<Eigen::ArrayXd>(values.data(), Eigen::Index(values.size()));
            const Histogram expected = histogram(all, bins);
            const MeanHistogram mean =
                up_to(now, courses, window, true).mean(now, value_at(courses, now));
            for (std::size_t k = 0; k < mean.counts.size(); ++k)
                CHECK(mean.counts[k] ==
                      doctest::Approx(double(expected.counts[k]) / double(values.size())));
            CHECK(mean.mean == doctest::Approx(all.mean()));
        }
}

TEST_CASE("values that are not finite count beyond the bins, and in no mean") {
    HistogramOverTime histogram({0.0, 1.0, 1}, {}, usual, false);
    histogram.add({0.0, 1.0, {INFINITY, NAN, NAN}});
    histogram.add({0.0, 1.0, {0.5, 0.0, 0.0}});
    const MeanHistogram mean = histogram.mean(1.0, Eigen::Array2d(INFINITY, 0.5));
    CHECK(mean.above == relative(1.0, 1e-12));
    CHECK(mean.counts[0] == relative(1.0, 1e-12));
    CHECK(mean.mean == 0.5);
    CHECK(mean.deviation == 0.0);
}

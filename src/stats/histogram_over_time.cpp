#include "stats/histogram_over_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "util/bin_number.h"

namespace carom {
namespace {

constexpr double rounding = 1e-9;  // of an interval of the clock

double place_of(const Bins& bins, double value) { return (value - bins.low) / bins.width(); }

// The time until a polynomial that is monotone from `from` to `to` has risen by `rise` since
// `from`: 2 s / (v0 + v), where both slopes have the same sign.
double time_to_rise(const Course& course, double from, double rise) {
    const double slope = course.coefficients[1] + 2.0 * from * course.coefficients[2];
    const double square = slope * slope + 4.0 * course.coefficients[2] * rise;
    const double sum = std::abs(slope) + std::sqrt(std::max(0.0, square));
    return sum > 0.0 ? 2.0 * std::abs(rise) / sum : std::numeric_limits<double>::infinity();
}

// The integral of sqrt(a + u^2) over u from 0.
double integral_of_root(double a, double u) {
    const double root = std::sqrt(a + u * u);
    return 0.5 * (u * root + (a > 0.0 ? a * std::asinh(u / std::sqrt(a)) : 0.0));
}

// The mean of the root of a polynomial whose last coefficient is positive.
double mean_of_root(const Course& course, double from, double to) {
    const auto [c0, c1, c2] = course.coefficients;
    const double least = std::max(0.0, c0 - 0.25 * c1 * c1 / c2), rate = std::sqrt(c2);
    const auto at = [&](double since) { return rate * (since + 0.5 * c1 / c2); };
    return (integral_of_root(least, at(to)) - integral_of_root(least, at(from))) /
           (rate * (to - from));
}

}  // namespace

HistogramOverTime::HistogramOverTime(const Bins& bins, std::optional<double> window,
                                     const SampleClock& clock, bool at_clock)
    : bins_(bins), window_(window), clock_(clock), at_clock_(at_clock) {
    constexpr double most_intervals = 1000.0;
    if (!window_) return;
    length_ = clock_.every;
    if (!at_clock_)
        length_ *= std::max(1.0, std::ceil(*window_ / (most_intervals * clock_.every) - rounding));
}

// Moments that can be combined: those of two sets of values give those of the union (Chan, Golub
// and LeVeque 1983).
void HistogramOverTime::Slot::join(double of_weight, double of_mean, double of_squares) {
    const double total = weight + of_weight;
    if (!(total > 0.0)) return;
    const double apart = of_mean - mean;
    mean += apart * of_weight / total;
    squares += of_squares + apart * apart * weight * of_weight / total;
    weight = total;
}

void HistogramOverTime::Slot::add(const Slot& other, double share) {
    counts.resize(other.counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += share * other.counts[k];
    below += share * other.below;
    above += share * other.above;
    elsewhere += share * other.elsewhere;
    join(share * other.weight, other.mean, share * other.squares);
}

// Whether there is a count for each bin in each slot, and no slot is missing in between.
bool HistogramOverTime::fits_together() const {
    for (std::size_t k = 0; k < slots_.size(); ++k)
        if (std::cmp_not_equal(slots_[k].counts.size(), bins_.count) ||
            slots_[k].number != slots_.front().number + static_cast<std::int64_t>(k))
            return false;
    return true;
}

// Null if it has been dropped.
HistogramOverTime::Slot* HistogramOverTime::slot(std::int64_t number) {
    const auto add = [&](std::int64_t its) {
        slots_.push_back(
            {.number = its, .counts = std::vector<double>(static_cast<std::size_t>(bins_.count))});
    };
    if (slots_.empty()) add(number);
    while (slots_.back().number < number) add(slots_.back().number + 1);
    if (number < slots_.front().number) return nullptr;
    return &slots_[static_cast<std::size_t>(number - slots_.front().number)];
}

// Calls `add(slot, from, to)` for each part of a time that belongs to a slot.
void HistogramOverTime::for_each_slot(double from, double to, const auto& add) {
    if (length_ == 0.0) return add(*slot(0), from, to);
    auto number = static_cast<std::int64_t>(std::floor(from / length_));
    number = std::max(number, slots_.front().number);
    for (; start_of(number) < to; ++number) {
        const double begin = std::max(from, start_of(number));
        const double end = std::min(to, start_of(number + 1));
        if (end > begin) add(*slot(number), begin, end);
    }
}

// Calls `add(slot, time)` for each sample of a time up to its end, excluded; the last sample, at
// the end of the run, is that of the present.
void HistogramOverTime::for_each_sample(double from, double to, const auto& add) {
    auto number = static_cast<std::int64_t>(std::ceil(from / clock_.every - 1.0));
    number = std::max<std::int64_t>(0, number);
    for (;; ++number) {
        const double time = static_cast<double>(number) * clock_.every;
        if (time >= to || time >= clock_.until - rounding * clock_.every) return;
        if (time < from) continue;
        if (Slot* its = slot(window_ ? number : 0)) add(*its, time);
    }
}

void HistogramOverTime::add(const Course& course, bool counted) {
    if (slots_.empty()) slot(0);  // the first course may not be that of the first interval
    if (at_clock_)
        return for_each_sample(course.from, course.to, [&](Slot& its, double time) {
            if (!counted) {
                its.elsewhere += 1.0;
                return;
            }
            const double value = course.value(time - course.from);
            count(its, value, 1.0);
            if (std::isfinite(value)) its.join(1.0, value, 0.0);
        });
    for_each_slot(course.from, course.to, [&](Slot& its, double from, double to) {
        if (counted)
            add_to(its, course, from - course.from, to - course.from);
        else
            its.elsewhere += to - from;
    });
}

void HistogramOverTime::add_elsewhere(double values, double from, double to) {
    if (slots_.empty()) slot(0);
    if (at_clock_)
        return for_each_sample(from, to, [&](Slot& its, double) { its.elsewhere += values; });
    for_each_slot(from, to, [&](Slot& its, double begin, double end) {
        its.elsewhere += values * (end - begin);
    });
}

// From and to are times since the start of the course.
void HistogramOverTime::add_to(Slot& slot, const Course& course, double from, double to) const {
    const auto [c0, c1, c2] = course.coefficients;
    if (!std::isfinite(c0) || (c1 == 0.0 && c2 == 0.0)) {
        count(slot, course.value(from), to - from);
        if (std::isfinite(c0)) slot.join(to - from, course.value(from), 0.0);
        return;
    }
    const double turn = c2 != 0.0 ? -0.5 * c1 / c2 : from;
    const double middle = turn > from && turn < to ? turn : to;
    add_monotone(slot, course, from, middle);
    if (middle < to) add_monotone(slot, course, middle, to);
}

// Splits the time at the edges of bins that the quantity passes.
void HistogramOverTime::add_monotone(Slot& slot, const Course& course, double from,
                                     double to) const {
    const double begin = course.value(from), end = course.value(to);
    const double direction = end >= begin ? 1.0 : -1.0, start = course.polynomial(from);
    const auto clamped = [&](double place) {
        return std::clamp(place, -1.0, static_cast<double>(bins_.count) + 1.0);
    };
    double edge = direction > 0.0 ? std::floor(clamped(place_of(bins_, begin))) + 1.0
                                  : std::ceil(clamped(place_of(bins_, begin))) - 1.0;
    double last = begin, reached = from;
    for (; edge >= 0.0 && edge <= bins_.count; edge += direction) {
        const double value = bins_.low + edge * bins_.width();
        if ((end - value) * direction <= 0.0 || (course.is_root && value <= 0.0)) break;
        const double rise = (course.is_root ? value * value : value) - start;
        const double time = std::clamp(from + time_to_rise(course, from, rise), reached, to);
        count(slot, 0.5 * (last + value), time - reached);
        last = value;
        reached = time;
    }
    count(slot, 0.5 * (last + end), to - reached);
    add_moments(slot, course, from, to);
}

void HistogramOverTime::count(Slot& slot, double value, double weight) const {
    const int bin = bin_among(place_of(bins_, value), bins_.count);
    if (bin < 0)
        slot.below += weight;
    else if (bin < bins_.count)
        slot.counts[static_cast<std::size_t>(bin)] += weight;
    else
        slot.above += weight;
}

// Gauss' rule with three points integrates polynomials up to the fifth power exactly: the quantity
// and its square, unless it is a root.
void HistogramOverTime::add_moments(Slot& slot, const Course& course, double from,
                                    double to) const {
    const double half = 0.5 * (to - from), middle = 0.5 * (from + to), off = std::sqrt(0.6) * half;
    constexpr std::array weights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const std::array values{course.value(middle - off), course.value(middle),
                            course.value(middle + off)};
    double mean = 0.0, square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) mean += weights.at(k) * values.at(k);
    constexpr double nearly_straight = 0.01;  // relative change: the rule has an error of 1e-13
    const double change = std::abs(values[2] - values[0]);
    if (!course.is_root || change <= nearly_straight * std::min(values[0], values[2])) {
        for (std::size_t k = 0; k < 3; ++k)
            square += weights.at(k) * (values.at(k) - mean) * (values.at(k) - mean);
    } else {
        double of_square = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            of_square += weights.at(k) * values.at(k) * values.at(k);
        mean = mean_of_root(course, from, to);
        square = std::max(0.0, of_square - mean * mean);
    }
    slot.join(to - from, mean, square * (to - from));
}

// The share of an interval, up to the present, that is in the window.
double HistogramOverTime::share_of(const Slot& slot, double now) const {
    if (!window_) return 1.0;
    const double start = now - *window_;
    if (at_clock_)
        return static_cast<double>(slot.number) * clock_.every > start + rounding * clock_.every
                   ? 1.0
                   : 0.0;
    const double from = start_of(slot.number), to = std::min(now, start_of(slot.number + 1));
    if (!(to > from)) return 0.0;
    const double share = (to - std::max(from, start)) / (to - from);
    return share < rounding ? 0.0 : std::min(1.0, share);
}

void HistogramOverTime::forget_before(double now) {
    while (slots_.size() > 1 && window_ &&
           start_of(slots_.front().number + 1) <= now - *window_ - length_)
        slots_.pop_front();
}

MeanHistogram HistogramOverTime::mean(double now, const Eigen::ArrayXd& present,
                                      double absent) const {
    Slot all{.counts = std::vector<double>(static_cast<std::size_t>(bins_.count))};
    for (const Slot& slot : slots_)
        if (const double share = share_of(slot, now); share > 0.0) all.add(slot, share);
    const double nearest = std::round(now / clock_.every) * clock_.every;
    const bool is_sample = at_clock_ && (now >= clock_.until || now == nearest);
    const auto in_all = [&] {
        double sum = all.below + all.above + all.elsewhere;
        for (const double one : all.counts) sum += one;
        return sum;
    };
    if (is_sample || in_all() == 0.0) {
        all.elsewhere += absent;
        for (const double value : present) {
            count(all, value, 1.0);
            if (std::isfinite(value)) all.join(1.0, value, 0.0);
        }
    }
    MeanHistogram result{.bins = bins_, .mean = std::numeric_limits<double>::quiet_NaN()};
    const double unit = (static_cast<double>(present.size()) + absent) / std::max(in_all(), 1e-300);
    for (const double one : all.counts) result.counts.push_back(one * unit);
    result.below = all.below * unit;
    result.above = all.above * unit;
    if (all.weight > 0.0) {
        result.mean = all.mean;
        result.deviation = std::sqrt(all.squares / all.weight);
    }
    return result;
}

}  // namespace carom

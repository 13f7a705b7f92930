#include "stats/running_histogram.h"

#include <cmath>
#include <limits>

namespace carom {
void RunningHistogram::Sum::add(const Piece& piece, double sign) {
    const Histogram& both = piece.both.histogram;
    const double times = sign * piece.weight;
    for (std::size_t k = 0; k < counts.size(); ++k)
        counts[k] += times * static_cast<double>(both.counts[k]);
    below += times * static_cast<double>(both.below);
    above += times * static_cast<double>(both.above);
    weight += 2.0 * times;  // of both
}

RunningHistogram::RunningHistogram(const Bins& bins, std::optional<double> window)
    : bins_(bins),
      window_(window),
      sum_{std::vector<double>(static_cast<std::size_t>(bins.count))} {}

void RunningHistogram::Moments::join(const Moments& other) {
    const double total = count + other.count;
    if (total == 0.0) return;
    const double apart = other.mean - mean;
    mean += apart * other.count / total;
    squares += other.squares + apart * apart * count * other.count / total;
    count = total;
}

RunningHistogram::Moments RunningHistogram::moments_of(const Eigen::ArrayXd& values) {
    Moments moments;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        moments.count += 1.0;
        moments.mean += value;
    }
    if (moments.count == 0.0) return moments;
    moments.mean /= moments.count;
    for (const double value : values)
        if (std::isfinite(value))
            moments.squares += (value - moments.mean) * (value - moments.mean);
    return moments;
}

void RunningHistogram::add(double time, const Eigen::ArrayXd& values) {
    if (window_)
        while (!pieces_.empty() && pieces_.front().end <= time - *window_) drop_first();
    Sampled now{histogram(values, bins_), moments_of(values)};
    if (time_ && time > *time_ && (!window_ || time - *time_ <= *window_)) add_piece(time, now);
    last_ = std::move(now);
    time_ = time;
}

void RunningHistogram::add_piece(double time, const Sampled& now) {
    Piece piece{time, 0.5 * (time - *time_), now};
    Sampled& both = piece.both;
    for (std::size_t k = 0; k < both.histogram.counts.size(); ++k)
        both.histogram.counts[k] += last_.histogram.counts[k];
    both.histogram.below += last_.histogram.below;
    both.histogram.above += last_.histogram.above;
    both.moments.join(last_.moments);
    both.moments.count *= piece.weight;
    both.moments.squares *= piece.weight;
    sum_.add(piece, 1.0);
    newer_.join(both.moments);
    if (window_) pieces_.push_back(std::move(piece));
}

// Rounding errors in the sums are cleared whenever all pieces have become older ones.
void RunningHistogram::drop_first() {
    if (older_.empty()) {
        Moments from_here;
        sum_ = {std::vector<double>(sum_.counts.size())};
        for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
            from_here.join(piece->both.moments);
            older_.push_back(from_here);
            sum_.add(*piece, 1.0);
        }
        newer_ = {};
    }
    older_.pop_back();
    sum_.add(pieces_.front(), -1.0);
    pieces_.pop_front();
    if (pieces_.empty()) sum_ = {std::vector<double>(sum_.counts.size())};
}

RunningHistogram::Moments RunningHistogram::moments() const {
    Moments all = older_.empty() ? Moments{} : older_.back();
    all.join(newer_);
    return all;
}

MeanHistogram RunningHistogram::mean() const {
    const bool is_alone = sum_.weight <= 0.0;
    const Moments all = is_alone ? last_.moments : moments();
    MeanHistogram result{.bins = bins_, .mean = std::numeric_limits<double>::quiet_NaN()};
    if (all.count > 0.0) {
        result.mean = all.mean;
        result.deviation = std::sqrt(all.squares / all.count);
    }
    if (is_alone) {
        const Histogram& one = last_.histogram;
        result.counts.assign(one.counts.begin(), one.counts.end());
        result.below = static_cast<double>(one.below);
        result.above = static_cast<double>(one.above);
        return result;
    }
    // A number below this is a rounding error left by subtraction.
    constexpr double none = 1e-12;
    const auto share = [&](double sum) {
        const double number = sum / sum_.weight;
        return number < none ? 0.0 : number;
    };
    for (const double sum : sum_.counts) result.counts.push_back(share(sum));
    result.below = share(sum_.below);
    result.above = share(sum_.above);
    return result;
}

}  // namespace carom

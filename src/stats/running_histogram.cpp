#include "stats/running_histogram.h"

#include <cmath>
#include <limits>

namespace carom {
namespace {

void add_counts(Histogram& sum, const Histogram& more) {
    for (std::size_t k = 0; k < sum.counts.size(); ++k) sum.counts[k] += more.counts[k];
    sum.below += more.below;
    sum.above += more.above;
}

}  // namespace

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
    Entry entry{time, histogram(values, bins_), moments_of(values)};
    samples_ += 1.0;
    if (!window_ && !entries_.empty()) return join(entry);
    if (window_)
        while (!entries_.empty() && entries_.front().time <= time - *window_) entries_.pop_front();
    entries_.push_back(std::move(entry));
    if (window_) samples_ = static_cast<double>(entries_.size());
}

void RunningHistogram::join(const Entry& entry) {
    add_counts(entries_.front().histogram, entry.histogram);
    entries_.front().moments.join(entry.moments);
}

MeanHistogram RunningHistogram::mean() const {
    Histogram sum{bins_, std::vector<std::int64_t>(static_cast<std::size_t>(bins_.count)), 0, 0};
    Moments moments;
    for (const Entry& entry : entries_) {
        add_counts(sum, entry.histogram);
        moments.join(entry.moments);
    }
    MeanHistogram result{bins_,
                         {},
                         static_cast<double>(sum.below) / samples_,
                         static_cast<double>(sum.above) / samples_,
                         moments.count,
                         moments.mean,
                         moments.count > 0.0 ? std::sqrt(moments.squares / moments.count) : 0.0};
    if (moments.count == 0.0) result.mean = std::numeric_limits<double>::quiet_NaN();
    for (const std::int64_t count : sum.counts)
        result.counts.push_back(static_cast<double>(count) / samples_);
    return result;
}

}  // namespace carom

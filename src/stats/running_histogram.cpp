#include "stats/running_histogram.h"

#include <cmath>
#include <limits>

namespace carom {
namespace {

void add_counts(Histogram& sum, const Histogram& more, std::int64_t times) {
    for (std::size_t k = 0; k < sum.counts.size(); ++k) sum.counts[k] += times * more.counts[k];
    sum.below += times * more.below;
    sum.above += times * more.above;
}

}  // namespace

RunningHistogram::RunningHistogram(const Bins& bins, std::optional<double> window)
    : bins_(bins),
      window_(window),
      sum_{bins, std::vector<std::int64_t>(static_cast<std::size_t>(bins.count)), 0, 0} {}

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
        while (!entries_.empty() && entries_.front().time <= time - *window_) drop_first();
    Entry entry{time, histogram(values, bins_), moments_of(values)};
    add_counts(sum_, entry.histogram, 1);
    newer_.join(entry.moments);
    samples_ += 1.0;
    if (window_) entries_.push_back(std::move(entry));
}

void RunningHistogram::drop_first() {
    if (older_.empty()) {
        Moments from_here;
        for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
            from_here.join(entry->moments);
            older_.push_back(from_here);
        }
        newer_ = {};
    }
    older_.pop_back();
    add_counts(sum_, entries_.front().histogram, -1);
    entries_.pop_front();
    samples_ -= 1.0;
}

MeanHistogram RunningHistogram::mean() const {
    Moments moments = older_.empty() ? Moments{} : older_.back();
    moments.join(newer_);
    MeanHistogram result{bins_,
                         {},
                         static_cast<double>(sum_.below) / samples_,
                         static_cast<double>(sum_.above) / samples_,
                         moments.count,
                         moments.mean,
                         moments.count > 0.0 ? std::sqrt(moments.squares / moments.count) : 0.0};
    if (moments.count == 0.0) result.mean = std::numeric_limits<double>::quiet_NaN();
    for (const std::int64_t count : sum_.counts)
        result.counts.push_back(static_cast<double>(count) / samples_);
    return result;
}

}  // namespace carom

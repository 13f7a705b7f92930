// Sums over a window of time before the present, or over all time since the start.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>

namespace carom {

/// A sum of arrays over the window, whose start is resolved to 1/32 of its length.
class SlidingSum {
  public:
    SlidingSum(Eigen::Index size, std::optional<double> window)
        : none_(Eigen::ArrayXd::Zero(size)), window_(window) {}

    /// The array to which values at a time are to be added. What is added at times that are a
    /// window before the latest is lost. The reference is valid until the next call.
    Eigen::ArrayXd& at(double time) {
        const std::int64_t number = slice_of(time);
        if (slices_.empty() || slices_.back().number < number) {
            slices_.push_back({number, none_});
            while (slices_.front().number <= number - slices_in_window) slices_.pop_front();
        }
        auto slice = slices_.end() - 1;
        while (slice != slices_.begin() && slice->number > number) --slice;
        if (slice->number == number) return slice->sums;
        if (number <= slices_.back().number - slices_in_window) return lost_ = none_;
        if (slice->number < number) ++slice;
        return slices_.insert(slice, {number, none_})->sums;
    }

    /// The end of the part of a window, or of all, in which the moment just after a time counts.
    double end_of_slice(double time) const {
        if (!window_) return std::numeric_limits<double>::infinity();
        const double number = std::floor(time * slices_in_window / *window_);
        const double end = (number + 1.0) * *window_ / slices_in_window;
        return end > time ? end : (number + 2.0) * *window_ / slices_in_window;
    }

    Eigen::ArrayXd sum() const {
        Eigen::ArrayXd all = none_;
        for (const Slice& slice : slices_) all += slice.sums;
        return all;
    }

    /// Writes or reads the accumulated sums; the window is not part of it.
    void archive(auto& archive) { archive(slices_); }

  private:
    static constexpr int slices_in_window = 32;
    std::int64_t slice_of(double time) const {
        return static_cast<std::int64_t>(window_ ? std::floor(time * slices_in_window / *window_)
                                                 : 0.0);
    }
    struct Slice {
        std::int64_t number;
        Eigen::ArrayXd sums;
        void archive(auto& archive) { archive(number, sums); }
    };
    Eigen::ArrayXd none_;
    std::optional<double> window_;  ///< none: since the start
    std::deque<Slice> slices_;      ///< in order
    Eigen::ArrayXd lost_ = {};      ///< scratch
};

}  // namespace carom

// Sums over a window of time before the present, or over all time since the start.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>

namespace carom {

/// A sum of arrays over the window, whose start is resolved to 1/32 of its length.
class SlidingSum {
  public:
    SlidingSum(Eigen::Index size, std::optional<double> window)
        : none_(Eigen::ArrayXd::Zero(size)), window_(window) {}

    /// The array to which values at a time are to be added; times must not decrease. The reference
    /// is valid until the next call.
    Eigen::ArrayXd& at(double time) {
        constexpr double slices = 32.0;
        const auto number =
            static_cast<std::int64_t>(window_ ? std::floor(time * slices / *window_) : 0.0);
        if (slices_.empty() || slices_.back().number != number) slices_.push_back({number, none_});
        while (slices_.front().number <= number - static_cast<std::int64_t>(slices))
            slices_.pop_front();
        return slices_.back().sums;
    }

    Eigen::ArrayXd sum() const {
        Eigen::ArrayXd all = none_;
        for (const Slice& slice : slices_) all += slice.sums;
        return all;
    }

    /// Writes or reads the accumulated sums; the window is not part of it.
    void archive(auto& archive) { archive(slices_); }

  private:
    struct Slice {
        std::int64_t number;
        Eigen::ArrayXd sums;
        void archive(auto& archive) { archive(number, sums); }
    };
    Eigen::ArrayXd none_;
    std::optional<double> window_;  ///< none: since the start
    std::deque<Slice> slices_;
};

}  // namespace carom

// The mean of a histogram over time, exact: of a quantity of particles that is known along pieces
// of their paths, by the time that it spends in each bin, or at the times of a clock. Also the mean
// and standard deviation of the values. See histogram.h for the other histograms.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "stats/paths/course.h"
#include "stats/running_histogram.h"

namespace carom {

/// The times 0, `every`, 2 `every`, ..., and the end.
struct SampleClock {
    double every = 1.0, until = 1.0;
};

class HistogramOverTime {
  public:
    /// Averages over the time since the start, or over `window` before the present. The window is
    /// exact if it begins at a time of the clock. Otherwise the interval of the clock in which it
    /// begins counts by the share of it that is in the window; a window of more than a thousand
    /// intervals takes several of them as one. With `at_clock`, values at the times of the clock
    /// are counted, not the time for which they last.
    HistogramOverTime(const Bins& bins, std::optional<double> window, const SampleClock& clock,
                      bool at_clock);

    /// Adds a piece. Courses of different particles may come in any order. A value that is not
    /// `counted` is elsewhere for this time: it is in no bin, and lowers the mean counts.
    void add(const Course& course, bool counted = true);

    /// Lets so many values be elsewhere between two times that have passed; negative: so many more
    /// than usual are here. For choices of particles whose number changes.
    void add_elsewhere(double values, double from, double to);

    /// The mean over the time up to `now`, to which all courses must have been added; `present`,
    /// the values now, is the mean while no time has passed. `absent`: the number of values that
    /// are elsewhere now, as for add_elsewhere(); with those present, the same at all times.
    MeanHistogram mean(double now, const Eigen::ArrayXd& present, double absent = 0.0) const;

    /// Drops what no mean from `now` on needs.
    void forget_before(double now);

    /// Writes or reads the sums so far; what the constructor takes is not part of it.
    void archive(auto& archive) {
        archive(slots_);
        if (archive.is_reading() && !fits_together())
            archive.refuse("its histograms do not fit together");
    }

  private:
    /// Sums over an interval of time, or over one sample.
    struct Slot {
        std::int64_t number = 0;
        std::vector<double> counts = {};
        double below = 0.0, above = 0.0, elsewhere = 0.0;
        double weight = 0.0, mean = 0.0, squares = 0.0;  ///< of finite values
        void join(double of_weight, double of_mean, double of_squares);
        void add(const Slot& other, double share);
        void archive(auto& archive) {
            archive(number, counts, below, above, elsewhere, weight, mean, squares);
        }
    };
    bool fits_together() const;
    Slot* slot(std::int64_t number);
    double start_of(std::int64_t number) const { return static_cast<double>(number) * length_; }
    void for_each_slot(double from, double to, const auto& add);
    void for_each_sample(double from, double to, const auto& add);
    void add_to(Slot& slot, const Course& course, double from, double to) const;
    void add_monotone(Slot& slot, const Course& course, double from, double to) const;
    void count(Slot& slot, double value, double weight) const;
    void add_moments(Slot& slot, const Course& course, double from, double to) const;
    double share_of(const Slot& slot, double now) const;

    Bins bins_;
    std::optional<double> window_;
    SampleClock clock_;
    bool at_clock_;
    double length_ = 0.0;     ///< of an interval; 0: one for all time
    std::deque<Slot> slots_;  ///< in order of their numbers
};

}  // namespace carom

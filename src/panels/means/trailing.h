// Sums that accumulate in the course of a run, over the window of time that a panel looks back.
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "physics/run.h"
#include "scene/panel_spec.h"

namespace carom {

/// The default averaging window of a reading: a twentieth of the run.
inline Over usual_window(const Run& run) { return {Over::Since::window, 0.05 * run.until}; }

/// The same for a profile: a tenth.
inline Over usual_window_of_profile(const Run& run) {
    return {Over::Since::window, 0.1 * run.until};
}

/// Accumulated sums of a run, each with its `time`; kept as far back as the difference of two of
/// them over the window needs. Windows begin at samples of the run, so that they do not depend on
/// what is shown in between.
template <class Account>
class Trailing {
  public:
    explicit Trailing(Over over) : over_(over) {}

    void clear() {
        all_.clear();
        between_.reset();
    }

    /// Adds sums in order of time, of a sample or of a moment between samples; sums of the same
    /// time as the last sample are ignored. From sample to sample, moments in between do not count.
    void add(Account account, bool is_sample) {
        between_.reset();
        const bool is_new = all_.empty() || account.time > all_.back().time;
        if (is_sample && is_new) {
            all_.push_back(std::move(account));
            drop_old();
        } else if (is_new && over_.since != Over::Since::now) {
            between_ = std::move(account);
        }
    }
    bool empty() const { return all_.empty(); }

    /// The sums of the last sample.
    const Account& last() const { return all_.back(); }

    /// to() gives the present sums; from() gives those of the last sample that is at least one
    /// window old (for Since::now the previous one, for Since::start the first). Both are the same
    /// while no time has passed.
    const Account& from() const {
        std::size_t first = 0;
        while (between_ && over_.since == Over::Since::window && first + 1 < all_.size() &&
               all_[first + 1].time <= between_->time - over_.window)
            ++first;
        return all_[first];
    }
    const Account& to() const { return between_ ? *between_ : all_.back(); }

  private:
    void drop_old() {
        if (over_.since == Over::Since::start) {
            while (all_.size() > 2) all_.erase(all_.begin() + 1);
            return;
        }
        const double since = all_.back().time - over_.window;
        const std::size_t least = over_.since == Over::Since::now ? 2 : 1;
        while (all_.size() > least && all_[1].time <= since) all_.pop_front();
        while (over_.since == Over::Since::now && all_.size() > 2) all_.pop_front();
    }

    Over over_;
    std::deque<Account> all_;         ///< of samples
    std::optional<Account> between_;  ///< of the present, if that is no sample
};

}  // namespace carom

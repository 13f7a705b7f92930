// Sums that accumulate in the course of a run, over the window of time that a panel looks back.
#pragma once

#include <deque>
#include <utility>

#include "scene/scene.h"

namespace carom {

/// The default averaging window of a reading: a twentieth of the run.
inline Over usual_window(const Run& run) { return {Over::Since::window, 0.05 * run.until}; }

/// Accumulated sums of a run, each with its `time`; kept as far back as the difference of two of
/// them over the window needs.
template <class Account>
class Trailing {
  public:
    explicit Trailing(Over over) : over_(over) {}

    void clear() { all_.clear(); }

    /// Adds sums in order of time; sums of the same time as the last are ignored.
    void add(Account account) {
        if (all_.empty() || account.time > all_.back().time) all_.push_back(std::move(account));
        drop_old();
    }
    bool empty() const { return all_.empty(); }

    /// to() gives the present sums; from() gives the last ones that are at least one window old
    /// (for Since::now the previous ones, for Since::start the first). Both are the same while no
    /// time has passed.
    const Account& from() const { return all_.front(); }
    const Account& to() const { return all_.back(); }

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
    std::deque<Account> all_;
};

}  // namespace carom

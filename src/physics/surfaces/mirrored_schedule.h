// A schedule of past and known future changes of a run, so that a reversed run goes back through
// them: reversing the run exchanges what lies behind the present and what lies ahead.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace carom {

/// Requires a function invert(What&), which turns a change into the one that undoes it.
template <typename Time, typename What>
class MirroredSchedule {
  public:
    struct Entry {
        Time time;
        What what;

        template <class Archive>
        void archive(Archive& archive) {
            archive(time, what);
        }
    };

    void add_ahead(Entry entry) {
        const auto later = [&](const Entry& other) { return other.time > entry.time; };
        ahead_.insert(std::ranges::find_if(ahead_, later), std::move(entry));
    }
    void add_behind(Entry entry) { behind_.push_back(std::move(entry)); }

    /// Time of the next change; infinite if there is none.
    Time next_time() const {
        return ahead_.empty() ? Time(std::numeric_limits<double>::infinity()) : ahead_[0].time;
    }

    /// Removes and returns the next change. It counts as past once the caller adds it with
    /// add_behind().
    Entry take_next() {
        Entry entry = std::move(ahead_.front());
        ahead_.erase(ahead_.begin());
        return entry;
    }

    void erase_if(const auto& predicate) {
        for (auto* entries : {&ahead_, &behind_})
            std::erase_if(*entries, [&](const Entry& other) { return predicate(other.what); });
    }

    void shift_epoch(const Time& shift) {
        for (auto* entries : {&ahead_, &behind_})
            for (Entry& other : *entries) other.time -= shift;
    }

    /// Reverses the run at `now`: past changes become future ones, inverted.
    void reverse(const Time& now) {
        ahead_.swap(behind_);
        for (auto* entries : {&ahead_, &behind_}) {
            std::ranges::reverse(*entries);
            for (Entry& other : *entries) {
                other.time = 2.0 * now - other.time;
                invert(other.what);
            }
        }
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(ahead_, behind_);
    }

  private:
    std::vector<Entry> ahead_, behind_;  ///< in order of time
};

}  // namespace carom

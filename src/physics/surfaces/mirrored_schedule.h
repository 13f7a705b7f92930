// What has happened in a run and what is known to come, so that a reversed run goes back through
// it: reversing the run exchanges what is behind the present and what is ahead.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace carom {

/// invert(What&) makes it what undoes it.
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
        const auto later = [&](const Entry& one) { return one.time > entry.time; };
        ahead_.insert(std::ranges::find_if(ahead_, later), std::move(entry));
    }
    void add_behind(Entry entry) { behind_.push_back(std::move(entry)); }

    /// When the next one is due, infinite if there is none.
    Time next_time() const {
        return ahead_.empty() ? Time(std::numeric_limits<double>::infinity()) : ahead_[0].time;
    }

    /// Takes the next one away. It is behind the run once it is added there.
    Entry take_next() {
        Entry entry = std::move(ahead_.front());
        ahead_.erase(ahead_.begin());
        return entry;
    }

    void erase_if(const auto& predicate) {
        for (auto* entries : {&ahead_, &behind_})
            std::erase_if(*entries, [&](const Entry& one) { return predicate(one.what); });
    }

    void shift_epoch(const Time& shift) {
        for (auto* entries : {&ahead_, &behind_})
            for (Entry& one : *entries) one.time -= shift;
    }

    /// The run goes back at `now`: what was behind it comes again, the other way round.
    void reverse(const Time& now) {
        ahead_.swap(behind_);
        for (auto* entries : {&ahead_, &behind_}) {
            std::ranges::reverse(*entries);
            for (Entry& one : *entries) {
                one.time = 2.0 * now - one.time;
                invert(one.what);
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

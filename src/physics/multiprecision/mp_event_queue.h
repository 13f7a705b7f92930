// The priority queue of events for multiprecision times, with the interface of event_queue.h, which
// is made for doubles and for speed. Here a comparison of two times may cost as much as the rest,
// so times are compared as doubles, and with all bits only where these are equal. Does not know
// what an event means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/multiprecision/multiprecision.h"

namespace carom {

class MpEventQueue {
  public:
    /// No event at all; reset() gives all their times.
    explicit MpEventQueue(std::int32_t count);

    /// Replaces all events at once; a time is infinite where nothing will ever happen.
    void reset(std::vector<Real> times);

    /// Replaces the event of `particle`.
    void schedule(std::int32_t particle, Real time);

    const Real& time(std::int32_t particle) const { return times_[index(particle)]; }

    /// The particle whose event is the earliest (at equal times the lowest number), or -1 when
    /// there is none.
    std::int32_t earliest() const;

    template <class Archive>
    void archive(Archive& archive) {
        archive(times_, keys_, winner_);
    }

  private:
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    std::int32_t earlier(std::int32_t a, std::int32_t b) const;
    void play(std::size_t match) {
        winner_[match] = earlier(winner_[2 * match], winner_[2 * match + 1]);
    }

    std::vector<Real> times_;
    std::vector<double> keys_;  ///< the time of each, rounded down
    /// A tournament: of each match the particle with the earlier event; the matches 2 k and 2 k + 1
    /// come before match k, and the last is 1. The particles themselves stand from their number on.
    std::vector<std::int32_t> winner_;
};

}  // namespace carom

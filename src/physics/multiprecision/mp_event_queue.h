// The priority queue of events for multiprecision times, with the interface of event_queue.h, which
// is designed for doubles and for speed. Here the comparison of two times may cost as much as
// everything else, so times are compared as doubles first, and with all bits only if these are
// equal. The queue does not know what an event means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/multiprecision/multiprecision.h"

namespace carom {

class MpEventQueue {
  public:
    /// Creates a queue without events; reset() sets all times.
    explicit MpEventQueue(std::int32_t count);

    /// Replaces all events; particles without an event have an infinite time.
    void reset(std::vector<Real> times);

    /// Replaces the event of `particle`.
    void schedule(std::int32_t particle, Real time);

    const Real& time(std::int32_t particle) const { return times_[index(particle)]; }

    /// The particle whose event is the earliest (at equal times the lowest number), or -1 when
    /// there is none.
    std::int32_t earliest() const;

    /// As in EventQueue; here has_another_until() is cheap enough.
    static bool may_have_another_until(double) { return true; }

    /// Whether a particle with concerns(particle) has an event at a time <= `time`.
    template <typename Concerns>
    bool has_another_until(double time, const Concerns& concerns) const {
        return !times_.empty() && has_until(1, time, concerns);
    }

    template <class Archive>
    void archive(Archive& archive) {
        archive(times_, keys_, winner_);
    }

  private:
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    std::int32_t earlier(std::int32_t a, std::int32_t b) const;
    template <typename Concerns>
    bool has_until(std::size_t match, double time, const Concerns& concerns) const {
        const std::int32_t winner = winner_[match];
        if (keys_[index(winner)] > time) return false;
        if (match >= times_.size()) return concerns(winner);
        return has_until(2 * match, time, concerns) || has_until(2 * match + 1, time, concerns);
    }
    void play(std::size_t match) {
        winner_[match] = earlier(winner_[2 * match], winner_[2 * match + 1]);
    }

    std::vector<Real> times_;
    std::vector<double> keys_;  ///< the times rounded down to doubles
    /// A tournament tree: for each match the particle with the earlier event. The winners of the
    /// matches 2 k and 2 k + 1 meet in match k, and match 1 is the final. The particles themselves
    /// form the leaves, which come last.
    std::vector<std::int32_t> winner_;
};

}  // namespace carom

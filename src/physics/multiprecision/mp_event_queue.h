// The priority queue of events for multiprecision times: a heap of all particles. event_queue.h is
// made for doubles and for speed; here a comparison of two times may cost as much as the rest, so
// times are compared as doubles, and with all bits only where these are equal. Does not know what
// an event means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "physics/multiprecision/multiprecision.h"

namespace carom {

/// What happens next to a particle, at `time`: a contact with `partner`, or reaching a border. A
/// contact that would come after the border is predicted when that has been crossed.
struct MpEvent {
    static constexpr double never = std::numeric_limits<double>::infinity();
    explicit MpEvent(int bits = 53) : time(never, bits) {}

    bool is_contact() const { return partner >= 0; }

    Real time;
    double late = never;  ///< a double not before `time`
    std::int32_t partner = -1;
    std::uint32_t partner_collisions : 29 = 0;
    std::uint32_t border : 3 = 0;
};

class MpEventQueue {
  public:
    explicit MpEventQueue(std::int32_t count);

    /// Replaces all events at once.
    void reset(const std::vector<MpEvent>& events);

    /// Replaces the event of `particle`.
    void schedule(std::int32_t particle, MpEvent event);

    const MpEvent& event(std::int32_t particle) const { return events_[index(particle)]; }

    const Real& time(std::int32_t particle) const { return event(particle).time; }

    /// The particle whose event is the earliest (at equal times the lowest number), or -1 when
    /// there is none.
    std::int32_t earliest() const;

  private:
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    bool earlier(std::int32_t a, std::int32_t b) const;
    void put(std::size_t place, std::int32_t particle);
    void rise(std::size_t place);
    void sink(std::size_t place);

    std::vector<MpEvent> events_;
    std::vector<double> keys_;         ///< the time of each, rounded down
    std::vector<std::int32_t> heap_;   ///< each no earlier than the one at half its place
    std::vector<std::size_t> places_;  ///< of each particle in it
};

}  // namespace carom

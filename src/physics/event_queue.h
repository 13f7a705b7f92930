// The next event of each particle, and which particle's comes first. One event per particle: a new
// one replaces the old. Times are local (local_clock.h) and lie in laps.
//
// A calendar: a lap is cut into buckets of equal width, each an unsorted doubly linked list through
// the events themselves, and the earliest of the present bucket is looked for among the few in it.
// So scheduling costs the same for any number of particles. A present bucket with too many events
// (a lattice that starts all at once) is ordered in a heap. Events beyond the lap wait in one more
// list until begin_lap(). Does not know what an event means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "util/large_pages.h"

namespace carom {

/// What happens next to a particle: at `time`, the earlier of a contact with another and of
/// reaching a border. The queue orders the times; the rest is for the owner's use.
struct Event {
    static constexpr double never = std::numeric_limits<double>::infinity();
    double time = never;          ///< local
    double contact_time = never;  ///< of the contact foreseen, which may come after the border
    std::int32_t partner = 0;     ///< in that contact
    std::uint32_t partner_collisions : 29 = 0;
    std::uint32_t border : 3 = 0;

    bool is_contact() const { return contact_time <= time; }
};

class EventQueue {
  public:
    explicit EventQueue(std::int32_t count);

    /// Replaces all events at once, in laps suited to their times; the present is time 0.
    void reset(const std::vector<Event>& events);

    /// Replaces the event of `particle`; its time must not lie before that of the last earliest().
    void schedule(std::int32_t particle, const Event& event);

    const Event& event(std::int32_t particle) const { return nodes_[index(particle)].event; }

    /// The particle whose event is the earliest in this lap (at equal times the lowest number), or
    /// -1 when the lap is over.
    std::int32_t earliest();

    /// The present bucket, and how many there are in a lap.
    std::int32_t bucket() const { return bucket_; }
    std::int32_t buckets() const { return buckets_; }

    /// The first bucket from `bucket` on that has events, or buckets() if none in this lap has; and
    /// one of its particles. For those who fetch ahead what these events will need.
    std::int32_t next_occupied(std::int32_t bucket) const;
    std::int32_t first_in(std::int32_t bucket) const { return heads_[index(bucket)]; }

    /// When the lap is over, how far the next begins after it: a whole number of laps, so that an
    /// event lies in it; infinity when there is no event at all.
    double next_lap() const;

    /// Counts all times from `shift` later on (from next_lap()), and adapts the width of the
    /// buckets to the events seen.
    void begin_lap(double shift);

  private:
    struct Node {
        Event event;
        std::int32_t previous = unlisted;  ///< or ~list at the head of a list, or unlisted
        std::int32_t next = 0;             ///< or nobody()
    };
    struct Present {
        double time;
        std::int32_t particle;
    };
    static constexpr std::int32_t unlisted = std::numeric_limits<std::int32_t>::min();

    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    std::int32_t nobody() const { return count_; }
    std::int32_t beyond_lap() const { return buckets_; }
    bool is_current(const Present& entry) const;
    void clear();
    void set_width(double width);
    void insert(std::int32_t particle);
    void link(std::int32_t particle, std::int32_t list);
    void unlink(std::int32_t particle);
    std::int32_t earliest_in_heap();
    void order_present_bucket();
    void forget_replaced();

    // Which list comes next, whether it is empty, who stands at its head: the processor cannot
    // foretell any of it, so lists are handled without branches. They end in nobody, which has a
    // node of its own to be written to.
    std::int32_t count_;
    LargeVector<Node> nodes_;
    LargeVector<std::int32_t> heads_;      ///< of the buckets, then of the list beyond the lap
    LargeVector<std::uint64_t> occupied_;  ///< a bit for each bucket with events; one that is
                                           ///< always set for the list beyond
    std::vector<Present> heap_;  ///< of a crowded bucket; entries replaced since are dropped
                                 ///< when met
    bool crowded_ = false;       ///< the present bucket is in the heap, not in its list
    std::int32_t buckets_;
    std::int32_t bucket_ = 0;  ///< the present one
    double width_ = 1.0;       ///< a power of two, so that laps add up exactly
    double per_width_ = 1.0;
    double lap_ = 1.0;
    std::int64_t events_in_lap_ = 0;
};

}  // namespace carom

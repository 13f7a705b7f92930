// When the next event of each particle comes, and which particle's comes first. One event per
// particle: a new one replaces the old. Times are local (local_clock.h) and lie in laps.
//
// A calendar: a lap is cut into days, a day into hours of half an event each. Each hour of the
// present day has an unsorted doubly linked list through their times themselves, and the earliest
// of the present hour is looked for among the few in it. Whoever has an event on a later day is
// noted down at the end of that day's notes, where it stays whatever becomes of the event; when the
// day begins, those noted that are still due then go to its hours. So only the events of one day,
// which fit into the processor's nearest caches, are linked in no order; the notes are written and
// read on end. Scheduling costs the same for any number of particles. A present hour with too many
// events (a lattice that starts all at once) is ordered in a heap. Events beyond the lap are found
// by begin_lap(). Does not know what an event means.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/collision/pair_collision.h"
#include "util/large_pages.h"

namespace carom {

class EventQueue {
  public:
    explicit EventQueue(std::int32_t count);

    /// Replaces all events at once, in laps suited to their times (infinite where nothing will ever
    /// happen); the present is time 0.
    void reset(const std::vector<double>& times);

    /// Gives the particles new numbers: k is who was before[k]. The present is time 0.
    void renumber(const std::vector<std::int32_t>& before);

    /// Replaces the event of `particle`; `time` must not lie before that of the last earliest().
    void schedule(std::int32_t particle, double time);

    double time(std::int32_t particle) const { return nodes_[index(particle)].time; }

    /// The particle whose event is the earliest in this lap (at equal times the lowest number), or
    /// -1 when the lap is over.
    std::int32_t earliest();

    /// Writes down to `who` whose events come next in the hours not told of yet, at most three, and
    /// returns how many: none when these are more than `hours` away or on another day. Not all are
    /// told of, and others may still come between. For those who fetch ahead what these events will
    /// need, and who call this for each event that they process.
    std::uint32_t look_ahead(std::int32_t hours, std::array<std::int32_t, 3>& who);

    /// How many hours look_ahead() has come ahead.
    std::int32_t hours_told() const { return ahead_ - (hour_ - midnight_); }

    /// Asks the processor for the time of a particle.
    void fetch(std::int32_t particle) const { __builtin_prefetch(&nodes_[index(particle)]); }

    /// When the lap is over, how far the next begins after it: a whole number of laps, so that an
    /// event lies in it; infinity when there is no event at all.
    double next_lap() const;

    /// Counts all times from `shift` later on (from next_lap()), and adapts the width of the
    /// hours to the events seen.
    void begin_lap(double shift);

  private:
    struct Node {
        double time = never<double>;
        std::int32_t previous = 0;  ///< in the list, or ~list at its head
        std::int32_t next = 0;      ///< or nobody()
    };
    struct Present {
        double time;
        std::int32_t particle;
    };
    /// Particles noted down for a day, and the leaf of it that was filled before, or none.
    struct alignas(64) Leaf {
        static constexpr std::int32_t most = 15;
        std::array<std::int32_t, most> particle{};
        std::int32_t before = none;
    };
    struct Day {
        std::int32_t leaf;  ///< the last one
        std::int32_t used;  ///< of it
    };
    static constexpr std::int32_t none = -1;

    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    std::int32_t nobody() const { return count_; }
    std::int32_t hour_of(double time) const;
    bool is_elsewhere(const Node& node) const { return node.previous == ~elsewhere_; }
    bool is_current(const Present& entry) const;
    void clear();
    void set_width(double width);
    void insert(std::int32_t particle, double time);
    void insert_into_heap(std::int32_t particle);
    void link(std::int32_t particle, std::int32_t list);
    void unlink(std::int32_t particle);
    void set_elsewhere(Node& node);
    void note(std::int32_t hour, bool keep, std::int32_t particle);
    std::int32_t new_leaf(std::int32_t before);
    std::size_t most_leaves() const;
    void note_all_anew();
    void forget_notes();
    void begin_day();
    bool step_ahead(std::int32_t& from, std::int32_t hours) const;
    std::int32_t next_occupied(std::int32_t hour_of_day) const;
    std::int32_t earliest_in_heap();
    void order_present_hour();
    void forget_replaced();

    // Which list comes next, whether it is empty, who stands at its head: the processor cannot
    // foretell any of it, so lists are handled without branches. They end in nobody, which has a
    // node of its own to be written to; and who is in no list, since its event is in the heap, on a
    // later day or beyond the lap, has links as if it were alone in one more list, elsewhere.
    std::int32_t count_;
    LargeVector<Node> nodes_;
    LargeVector<Leaf> leaves_;
    std::int32_t free_leaf_ = none;    ///< the first of those free, each with the next in `before`
    std::vector<Day> days_;            ///< and one more, of which nothing is kept
    std::vector<std::int32_t> heads_;  ///< of the hours of the present day, and elsewhere
    std::vector<std::uint64_t> occupied_;  ///< a bit for each hour of the present day with events;
                                           ///< one that is always set for elsewhere
    std::vector<Present> heap_;  ///< of a crowded hour; entries replaced since are dropped when met
    bool crowded_ = false;       ///< the present hour is in the heap, not in its list
    std::int32_t hours_;         ///< of a lap
    double hours_in_lap_;        ///< the same, as times are compared with it
    int day_bits_;               ///< the logarithm of those of a day to base 2
    std::int32_t elsewhere_;     ///< the number of the list after those of a day's hours
    std::int32_t hour_ = 0;      ///< the present one
    std::int32_t midnight_ = 0;  ///< the first of the present day
    std::int32_t ahead_ = -1;    ///< hour of the day up to which look_ahead() has told, and
    std::int32_t asked_ = -1;    ///< up to which it has asked the processor for the first in line
    double width_ = 1.0;         ///< of an hour: a power of two, so that laps add up exactly
    double per_width_ = 1.0;
    double lap_ = 1.0;
    std::int64_t events_in_lap_ = 0;
};

}  // namespace carom

// The priority queue of events: one event per particle; a new one replaces the old. Times are local
// (local_clock.h). The queue does not know what an event means.
//
// A calendar queue (R. Brown, Comm. ACM 31, 1220 (1988)) with a third level. The width of a bucket
// is chosen so that it holds half an event on average; 2^13 buckets form a year; the years up to a
// fixed horizon form a cycle.
// - The events of the present year are in unsorted, doubly linked lists, one per bucket; the
//   earliest event of the present bucket is found by a linear search through the few in it. A
//   bucket with too many events (for example a lattice in which all start at once) is sorted.
// - Events of later years are deferred: the particle's number is appended to that year's chunks and
//   stays there even if the event is replaced. When the year begins, those events that are still
//   due in it are linked into its buckets. Thus the lists of one year fit into the nearest caches
//   of the processor, and deferred numbers are written and read sequentially.
// - Events beyond the cycle are found by a pass over all particles in begin_cycle().
// The cost of scheduling an event does not depend on the number of particles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "physics/collision/pair_collision.h"
#include "util/memory/large_pages.h"

namespace carom {

class EventQueue {
  public:
    explicit EventQueue(std::int32_t count);

    /// Replaces all events (with an infinite time for particles that have none) and derives the
    /// bucket width from their times; the present is time 0.
    void reset(std::vector<double> times);

    /// Renumbers the particles: particle k is the one that had the number before[k]. The present is
    /// time 0.
    void renumber(const std::vector<std::int32_t>& before);

    /// Replaces the event of `particle`; `time` must not lie before that of the last earliest().
    void schedule(std::int32_t particle, double time);

    double time(std::int32_t particle) const { return nodes_[index(particle)].time; }

    /// The particle whose event is the earliest in this cycle (at equal times the lowest number),
    /// or -1 when the cycle is over.
    std::int32_t earliest();

    /// Whether another particle than that of the last earliest() may have an event at a time <=
    /// `time`. May be true if there is none, but is seldom so for a `time` soon after the present.
    bool may_have_another_until(double time) const { return quiet_until_ <= time; }

    /// Whether a particle with concerns(particle), which is false for that of the last earliest(),
    /// has an event at a time <= `time`; may be true without one if `time` lies in a later year.
    template <typename Concerns>
    [[gnu::noinline]] bool has_another_until(double time, const Concerns& concerns) const;

    /// For prefetching; to be called once for each event processed. Stores in `who` the particles
    /// of the next nonempty bucket that has not been reported yet, at most three, and returns their
    /// number. Returns 0 if that bucket is more than `buckets` ahead or in another year. The result
    /// is only a hint: events beyond the first three are left out, and earlier events may still be
    /// inserted.
    std::uint32_t look_ahead(std::int32_t buckets, std::array<std::int32_t, 3>& who);

    /// How many buckets look_ahead() is ahead of the present one.
    std::int32_t buckets_looked_at() const { return looked_at_ - (bucket_ - year_begin_); }

    /// Prefetches the time of a particle.
    void fetch(std::int32_t particle) const { __builtin_prefetch(&nodes_[index(particle)]); }

    /// After the end of a cycle: the time from its beginning to that of the next cycle that
    /// contains an event, which is a whole number of cycle lengths; infinity if there are no
    /// events.
    double next_cycle() const;

    /// Starts the next cycle: shifts the time origin by `shift`, the result of next_cycle(), and
    /// adapts the bucket width to the number of events in the last cycle.
    void begin_cycle(double shift);

    /// Writes or reads everything except the progress of look_ahead().
    template <class Archive>
    void archive(Archive& archive) {
        archive(nodes_, chunks_, free_chunk_, years_, heads_, occupied_, crowd_, bucket_,
                year_begin_, width_, per_width_, cycle_, events_in_cycle_);
        looked_at_ = prefetched_ = -1;
    }

  private:
    struct Node {
        double time = never<double>;
        std::int32_t previous = 0;  ///< in the list, or ~list at its head
        std::int32_t next = 0;      ///< or null_link()

        template <class Archive>
        void archive(Archive& archive) {
            archive(time, previous, next);
        }
    };
    /// Particles deferred to a year, and the chunk of that year that was filled before, or none.
    struct alignas(64) Chunk {
        static constexpr std::int32_t most = 15;
        std::array<std::int32_t, most> particle{};
        std::int32_t before = none;

        template <class Archive>
        void archive(Archive& archive) {
            archive(particle, before);
        }
    };
    struct Year {
        std::int32_t chunk;  ///< the last one
        std::int32_t used;   ///< of it

        template <class Archive>
        void archive(Archive& archive) {
            archive(chunk, used);
        }
    };
    static constexpr std::int32_t none = -1;

    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    std::int32_t null_link() const { return count_; }
    std::int32_t bucket_of(double time) const;
    bool is_in_overflow(const Node& node) const { return node.previous == ~overflow_; }
    void clear();
    void set_width(double width);
    void insert(std::int32_t particle, double time);
    // Not inlined: they are rarely called, and the code of the common case becomes faster.
    [[gnu::noinline]] void join_crowd(std::int32_t particle);
    [[gnu::noinline]] void leave_crowd(std::int32_t particle);
    [[gnu::noinline]] void move_to_crowd(std::int32_t list);
    void link(std::int32_t particle, std::int32_t list);
    void unlink(std::int32_t particle);
    void defer(std::int32_t bucket, bool keep, std::int32_t particle);
    std::int32_t new_chunk(std::int32_t before);
    std::size_t most_chunks() const;
    void defer_all_again();
    void clear_deferred();
    void begin_year();
    bool step_ahead(std::int32_t& from, std::int32_t buckets) const;
    std::int32_t next_occupied(std::int32_t bucket_in_year) const;

    // The processor cannot predict which list comes next, whether it is empty and which particle is
    // at its head, so lists are handled without branches. They end in the null link, which has its
    // own node that may be written to. A particle in no list, because its event is in the crowd,
    // deferred or beyond the cycle, has links as if it were alone in an additional list, the
    // overflow list.
    std::int32_t count_;
    LargeVector<Node> nodes_;
    LargeVector<Chunk> chunks_;
    std::int32_t free_chunk_ = none;   ///< first free chunk; `before` of each links to the next
    std::vector<Year> years_;          ///< plus an extra one whose contents are discarded
    std::vector<std::int32_t> heads_;  ///< list heads: the present year's buckets and the overflow
                                       ///< list
    std::vector<std::uint64_t> occupied_;  ///< one bit for each of these lists: whether it has
                                           ///< events; always set for the overflow list
    std::set<std::pair<double, std::int32_t>> crowd_;  ///< sorted events of the present bucket, if
                                                       ///< they are too many for its list
    std::int32_t buckets_;                             ///< of a cycle
    double buckets_in_cycle_;      ///< the same as a double, for comparison with times
    int year_bits_;                ///< base-2 logarithm of the number of buckets in a year
    std::int32_t overflow_;        ///< number of the overflow list: after those of a year's buckets
    std::int32_t bucket_ = 0;      ///< the present bucket, counted from the beginning of the cycle
    std::int32_t year_begin_ = 0;  ///< the first bucket of the present year
    std::int32_t looked_at_ = -1;  ///< bucket of the year up to which look_ahead() has reported
    std::int32_t prefetched_ = -1;  ///< bucket of the year whose first particle was prefetched last
    double width_ = 1.0;  ///< of a bucket: a power of two, so that shifts by cycles are exact
    double per_width_ = 1.0;
    double cycle_ = 1.0;                   ///< length of a cycle
    double quiet_until_ = -never<double>;  ///< no event but that of the last earliest() comes
                                           ///< before
    std::int64_t events_in_cycle_ = 0;
};

// The events of later years are not sorted.
template <typename Concerns>
bool EventQueue::has_another_until(double time, const Concerns& concerns) const {
    for (const auto& [when, who] : crowd_) {
        if (when > time) break;
        if (concerns(who)) return true;
    }
    const std::int32_t end = bucket_of(time) - year_begin_;
    if (end >= overflow_) return true;
    for (std::int32_t list = bucket_ - year_begin_; list <= end; ++list)
        for (std::int32_t i = heads_[index(list)]; i != null_link(); i = nodes_[index(i)].next)
            if (nodes_[index(i)].time <= time && concerns(i)) return true;
    return false;
}

}  // namespace carom

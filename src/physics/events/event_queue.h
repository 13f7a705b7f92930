// A priority queue of the next event of each particle: one event per particle, a new one replaces
// the old. Times are local (local_clock.h). Does not know what an event means.
//
// A calendar queue (R. Brown, Comm. ACM 31, 1220 (1988)) with a third level. A bucket is as wide as
// half an event on average; 2^13 buckets make a year; the years up to a fixed horizon make a cycle.
// - The events of the present year are in unsorted, doubly linked lists, one for each bucket; the
//   earliest of the present bucket is found by a search through the few in it. A bucket with too
//   many events (a lattice that starts all at once) is sorted.
// - Events of later years are deferred: the particle's number is appended to that year's chunks and
//   stays there whatever becomes of the event. When the year begins, those still due in it are
//   linked into its buckets. So the lists of one year fit into the processor's nearest caches,
//   and deferred numbers are written and read in sequence.
// - Events beyond the cycle are found by a pass over all particles, in begin_cycle().
// Scheduling costs the same for any number of particles.
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

    /// Replaces all events at once (a time is infinite where nothing will ever happen) and chooses
    /// the width of the buckets by them; the present is time 0.
    void reset(std::vector<double> times);

    /// Gives the particles new numbers: k is the one that was before[k]. The present is time 0.
    void renumber(const std::vector<std::int32_t>& before);

    /// Replaces the event of `particle`; `time` must not lie before that of the last earliest().
    void schedule(std::int32_t particle, double time);

    double time(std::int32_t particle) const { return nodes_[index(particle)].time; }

    /// The particle whose event is the earliest in this cycle (at equal times the lowest number),
    /// or -1 when the cycle is over.
    std::int32_t earliest();

    /// For prefetching, once for each event processed: sets `who` to the particles of the next
    /// bucket with events that was not returned before, at most three, and returns how many; 0 when
    /// that bucket is more than `buckets` ahead or in another year. A hint: events beyond three are
    /// left out, and others may still come between.
    std::uint32_t look_ahead(std::int32_t buckets, std::array<std::int32_t, 3>& who);

    /// How far look_ahead() is ahead of the present bucket.
    std::int32_t buckets_looked_at() const { return looked_at_ - (bucket_ - year_begin_); }

    /// Prefetches the time of a particle.
    void fetch(std::int32_t particle) const { __builtin_prefetch(&nodes_[index(particle)]); }

    /// When the cycle is over: the time from its begin to that of the next cycle with an event, a
    /// whole number of cycles; infinity when there is no event at all.
    double next_cycle() const;

    /// Counts all times from `shift` later on (of next_cycle()), and adapts the width of the
    /// buckets to the number of events in the last cycle.
    void begin_cycle(double shift);

    /// All but what look_ahead() has reported.
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
    // Out of line: they are rare, and what always happens is the faster for it.
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

    // Which list comes next, whether it is empty and who is at its head cannot be predicted by the
    // processor, so lists are handled without branches: they end in the null link, which has a node
    // of its own that may be written to; and a particle in no list, since its event is in the
    // crowd, deferred or beyond the cycle, has links as if it were alone in one more list, the
    // overflow list.
    std::int32_t count_;
    LargeVector<Node> nodes_;
    LargeVector<Chunk> chunks_;
    std::int32_t free_chunk_ = none;   ///< the first of those free, each with the next in `before`
    std::vector<Year> years_;          ///< and one more, of which nothing is kept
    std::vector<std::int32_t> heads_;  ///< of the present year's buckets and the overflow list
    std::vector<std::uint64_t> occupied_;  ///< a bit for each of these lists: whether it has
                                           ///< events; always set for the overflow list
    std::set<std::pair<double, std::int32_t>> crowd_;  ///< the events of the present bucket, if
                                                       ///< they are too many for its list
    std::int32_t buckets_;                             ///< of a cycle
    double buckets_in_cycle_;                          ///< the same, as times are compared with it
    int year_bits_;                                    ///< a year has two to this power buckets
    std::int32_t overflow_;        ///< number of the overflow list: after those of a year's buckets
    std::int32_t bucket_ = 0;      ///< the present one, counted in the cycle
    std::int32_t year_begin_ = 0;  ///< the first bucket of the present year
    std::int32_t looked_at_ = -1;  ///< bucket of the year up to which look_ahead() has reported
    std::int32_t prefetched_ = -1;  ///< bucket of the year whose first particle was prefetched last
    double width_ = 1.0;            ///< of a bucket: a power of two, so that cycles add up exactly
    double per_width_ = 1.0;
    double cycle_ = 1.0;  ///< length of a cycle
    std::int64_t events_in_cycle_ = 0;
};

}  // namespace carom

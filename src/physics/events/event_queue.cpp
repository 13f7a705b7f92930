#include "physics/events/event_queue.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace carom {
namespace {

// Low enough to find the earliest event quickly, high enough to avoid stepping through many empty
// buckets.
constexpr double events_per_bucket = 0.5;
constexpr int most_in_list = 32;

// A cycle covers several events of each particle, so that the cost of starting one is small per
// event.
constexpr std::uint64_t buckets_per_particle = 16;
constexpr std::uint64_t least_buckets = 8, most_buckets = std::uint64_t{1} << 30;

// Base-2 logarithm of the number of buckets in a year, unless a cycle has fewer.
constexpr int most_year_bits = 13;

// Maximum average number of deferred entries per particle; about one and a half are typical.
constexpr std::size_t deferred_per_particle = 4;

double power_of_two_near(double value) {
    const int exponent = std::ilogb(std::clamp(value, 0x1p-900, 0x1p900));
    return std::ldexp(1.0, exponent);
}

// Half of the events lie before the median of their times.
double width_for(std::vector<double> times) {
    std::erase_if(times, [](double time) { return !(time > 0.0 && std::isfinite(time)); });
    if (times.empty()) return 1.0;
    const auto median = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), median, times.end());
    return events_per_bucket * 2.0 * *median / static_cast<double>(times.size());
}

}  // namespace

EventQueue::EventQueue(std::int32_t count)
    : count_(count),
      nodes_(index(count) + 1),
      buckets_(static_cast<std::int32_t>(std::bit_ceil(
          std::clamp(buckets_per_particle * index(count), least_buckets, most_buckets)))),
      buckets_in_cycle_(buckets_),
      year_bits_(std::min(most_year_bits, std::countr_zero(static_cast<std::uint32_t>(buckets_)))),
      overflow_(1 << year_bits_) {
    clear();
}

void EventQueue::clear() {
    clear_deferred();
    heads_.assign(index(overflow_) + 1, null_link());
    nodes_[index(null_link())].next = null_link();
    occupied_.assign(index(overflow_) / 64 + 1, 0);
    occupied_.back() = std::uint64_t{1} << (index(overflow_) % 64);
    crowd_.clear();
    bucket_ = year_begin_ = 0;
    looked_at_ = prefetched_ = -1;
    events_in_cycle_ = 0;
}

void EventQueue::set_width(double width) {
    width_ = power_of_two_near(width);
    per_width_ = 1.0 / width_;
    cycle_ = width_ * buckets_;
}

void EventQueue::reset(std::vector<double> times) {
    assert(times.size() == index(count_));
    for (std::size_t i = 0; i < times.size(); ++i) nodes_[i] = Node{.time = times[i]};
    set_width(width_for(std::move(times)));
    clear();
    for (std::int32_t i = 0; i < count_; ++i) insert(i, time(i));
}

void EventQueue::renumber(const std::vector<std::int32_t>& before) {
    std::vector<double> times(before.size());
    for (std::size_t k = 0; k < before.size(); ++k) times[k] = time(before[k]);
    reset(std::move(times));
}

// The bucket of a time within the cycle, or buckets_ for a later time.
std::int32_t EventQueue::bucket_of(double time) const {
    double due = time * per_width_;
    due = due < buckets_in_cycle_ ? due : buckets_in_cycle_;
#ifdef __x86_64__
    asm("" : "+x"(due));  // so that the compiler does not turn it into a branch
#endif
    return static_cast<std::int32_t>(due);
}

inline void EventQueue::link(std::int32_t particle, std::int32_t list) {
    std::int32_t& head = heads_[index(list)];
    Node& node = nodes_[index(particle)];
    node.previous = ~list;
    node.next = head;
    nodes_[index(head)].previous = particle;
    head = particle;
    occupied_[index(list) / 64] |= std::uint64_t{1} << (index(list) % 64);
}

inline void EventQueue::unlink(std::int32_t particle) {
    const Node& node = nodes_[index(particle)];
    const std::int32_t at_head = node.previous < 0 ? -1 : 0;
    const std::int32_t list = ~node.previous & at_head;
    const std::array<std::int32_t*, 2> links{&nodes_[index(node.previous & ~at_head)].next,
                                             &heads_[index(list)]};
    *links[index(-at_head)] = node.next;
    nodes_[index(node.next)].previous = node.previous;
    const bool emptied = (at_head != 0) & (node.next == null_link()) & (list != overflow_);
    occupied_[index(list) / 64] &= ~(std::uint64_t{emptied} << (index(list) % 64));
}

// The processor cannot predict either whether the event lies in the present year, in a later one or
// beyond the cycle. The particle is therefore always linked, if necessary into the overflow list,
// and always deferred, if necessary to a slot that will be overwritten.
inline void EventQueue::insert(std::int32_t particle, double time) {
    const std::int32_t bucket = std::max(bucket_, bucket_of(time));
    if (!crowd_.empty() && bucket == bucket_) [[unlikely]] {
        join_crowd(particle);
        return;
    }
    const std::int32_t bucket_in_year = bucket - year_begin_;
    link(particle, std::min(bucket_in_year, overflow_));
    heads_[index(overflow_)] = null_link();
    defer(bucket, (bucket_in_year >= overflow_) & (bucket < buckets_), particle);
}

void EventQueue::join_crowd(std::int32_t particle) {
    Node& node = nodes_[index(particle)];
    node.previous = ~overflow_;
    node.next = null_link();
    crowd_.emplace(node.time, particle);
}

void EventQueue::leave_crowd(std::int32_t particle) {
    crowd_.erase({nodes_[index(particle)].time, particle});
}

// The number is always written; unless `keep` is set the next one overwrites it.
void EventQueue::defer(std::int32_t bucket, bool keep, std::int32_t particle) {
    Year& year = years_[index(bucket >> year_bits_)];
    chunks_[index(year.chunk)].particle[index(year.used)] = particle;
    year.used += keep;
    if (year.used < Chunk::most) [[likely]]
        return;
    if (free_chunk_ == none && chunks_.size() > most_chunks())
        defer_all_again();
    else
        year = {new_chunk(year.chunk), 0};
}

// A few chunks per particle and one for each year: enough unless a few particles collide very
// often.
std::size_t EventQueue::most_chunks() const {
    return years_.size() + 16 + deferred_per_particle * index(count_) / Chunk::most;
}

void EventQueue::defer_all_again() {
    clear_deferred();
    for (std::int32_t i = 0; i < count_; ++i) {
        const Node& node = nodes_[index(i)];
        const std::int32_t bucket = bucket_of(node.time);
        if (is_in_overflow(node) && bucket - year_begin_ >= overflow_)
            defer(bucket, bucket < buckets_, i);
    }
}

void EventQueue::clear_deferred() {
    chunks_.clear();
    free_chunk_ = none;
    years_.clear();
    for (std::int32_t year = 0; year <= buckets_ >> year_bits_; ++year)
        years_.push_back({new_chunk(none), 0});
}

std::int32_t EventQueue::new_chunk(std::int32_t before) {
    std::int32_t chunk = free_chunk_;
    if (chunk == none) {
        chunk = static_cast<std::int32_t>(chunks_.size());
        chunks_.emplace_back();
    } else {
        free_chunk_ = chunks_[index(chunk)].before;
        __builtin_prefetch(&chunks_[index(std::max(free_chunk_, 0))]);
    }
    chunks_[index(chunk)].before = before;
    return chunk;
}

// Links the events deferred to this year. Some numbers occur twice, and some events are no longer
// due in this year.
void EventQueue::begin_year() {
    looked_at_ = prefetched_ = -1;
    const std::int32_t year = year_begin_ >> year_bits_;
    Year& its = years_[index(year)];
    // Prefetches the nodes of a chunk's particles two chunks ahead and the chunks themselves four
    // ahead, since the link to the previously filled chunk is known only once a chunk has arrived.
    std::int32_t soon = its.chunk, later = its.chunk;
    const auto fetch_ahead = [&] {
        for (const std::int32_t particle : chunks_[index(soon)].particle)
            __builtin_prefetch(&nodes_[index(particle)]);
        soon = later;
        const std::int32_t before = chunks_[index(later)].before;
        later = before == none ? later : before;
        __builtin_prefetch(&chunks_[index(later)]);
    };
    for (int k = 0; k < 3; ++k) fetch_ahead();
    while (true) {
        fetch_ahead();
        Chunk& chunk = chunks_[index(its.chunk)];
        for (std::int32_t k = 0; k < its.used; ++k) {
            const std::int32_t particle = chunk.particle[index(k)];
            const Node& node = nodes_[index(particle)];
            const std::int32_t bucket = bucket_of(node.time);
            // without a branch, which the processor could not predict
            const std::int32_t due =
                -static_cast<std::int32_t>((bucket >> year_bits_ == year) & is_in_overflow(node));
            link((particle & due) | (null_link() & ~due),
                 ((bucket - year_begin_) & due) | (overflow_ & ~due));
            heads_[index(overflow_)] = null_link();
        }
        const std::int32_t before = chunk.before;
        if (before == none) break;
        chunk.before = free_chunk_;
        free_chunk_ = its.chunk;
        its = {before, Chunk::most};
    }
    its.used = 0;
}

void EventQueue::schedule(std::int32_t particle, double time) {
    unlink(particle);
    if (!crowd_.empty()) [[unlikely]]
        leave_crowd(particle);
    nodes_[index(particle)].time = time;
    insert(particle, time);
    ++events_in_cycle_;
}

// The first nonempty bucket from the given one of the year on; the overflow list if there is none.
std::int32_t EventQueue::next_occupied(std::int32_t bucket_in_year) const {
    std::size_t word = index(bucket_in_year) / 64;
    const std::uint64_t bits = occupied_[word] >> (index(bucket_in_year) % 64);
    if (bits != 0) return bucket_in_year + std::countr_zero(bits);
    while (occupied_[++word] == 0) {
    }
    return static_cast<std::int32_t>(64 * word) + std::countr_zero(occupied_[word]);
}

// Moves to the next nonempty bucket, if it is at most `buckets` ahead. Without branches: the
// processor cannot predict the distance.
inline bool EventQueue::step_ahead(std::int32_t& from, std::int32_t buckets) const {
    const std::int32_t present = bucket_ - year_begin_;
    from = std::max(from, present);
    const std::int32_t next = next_occupied(std::min(from + 1, overflow_));
    const bool near = next <= std::min(present + buckets, overflow_ - 1);
    from ^= (from ^ next) & -static_cast<std::int32_t>(near);
    return near;
}

std::uint32_t EventQueue::look_ahead(std::int32_t buckets, std::array<std::int32_t, 3>& who) {
    step_ahead(prefetched_, buckets + buckets / 2);
    fetch(heads_[index(prefetched_)]);
    const std::uint32_t any = step_ahead(looked_at_, buckets) ? 1 : 0;
    who[0] = heads_[index(looked_at_)];
    who[1] = nodes_[index(who[0])].next;
    who[2] = nodes_[index(who[1])].next;
    return any + (any & (who[1] != null_link() ? 1U : 0U)) +
           (any & (who[2] != null_link() ? 1U : 0U));
}

void EventQueue::move_to_crowd(std::int32_t list) {
    while (heads_[index(list)] != null_link()) {
        const std::int32_t particle = heads_[index(list)];
        unlink(particle);
        join_crowd(particle);
    }
}

std::int32_t EventQueue::earliest() {
    while (true) {
        if (!crowd_.empty()) [[unlikely]] {
            quiet_until_ = -never<double>;
            return crowd_.begin()->second;
        }
        const std::int32_t list = next_occupied((bucket_ - year_begin_));
        if (list == overflow_) {
            bucket_ = year_begin_ + overflow_;
            if (bucket_ == buckets_) {
                --bucket_;
                return -1;
            }
            year_begin_ = bucket_;
            begin_year();
            continue;
        }
        bucket_ = year_begin_ + list;
        // mostly there is one, sometimes a second, otherwise the null link in its place
        std::int32_t best = heads_[index(list)];
        std::int32_t i = nodes_[index(best)].next;
        double time = nodes_[index(best)].time;
        double second = width_ * (bucket_ + 1);  // those of later buckets come after it
        int count = 0;
        do {
            const double its = nodes_[index(i)].time;
            second = std::min(second, std::max(its, time));
            const bool earlier = (its < time) | ((its == time) & (i < best));
            const std::int32_t mask = -static_cast<std::int32_t>(earlier);
            time = std::min(its, time);
            best ^= (best ^ i) & mask;
            i = nodes_[index(i)].next;
            ++count;
        } while (i != null_link());
        quiet_until_ = second;
        if (count <= most_in_list) return best;
        move_to_crowd(list);
    }
}

// After the end of a cycle all events lie beyond it.
double EventQueue::next_cycle() const {
    double first = never<double>;
    for (std::size_t i = 0; i < index(count_); ++i) first = std::min(first, nodes_[i].time);
    const double cycles = std::floor(first / cycle_);
    return std::isfinite(cycles * cycle_) ? std::min(first, cycles * cycle_) : first;
}

// The cycle is over: every event that is left lies beyond it.
void EventQueue::begin_cycle(double shift) {
    const double width = events_per_bucket * shift / static_cast<double>(events_in_cycle_ + 1);
    // A width wrong by a factor of two does no harm, and each change of width costs exactness.
    if (width > 2.0 * width_ || width < 0.5 * width_) set_width(width);
    bucket_ = year_begin_ = 0;
    looked_at_ = prefetched_ = -1;
    events_in_cycle_ = 0;
    for (std::int32_t i = 0; i < count_; ++i) {
        Node& node = nodes_[index(i)];
        node.time -= shift;
        insert(i, node.time);
    }
}

}  // namespace carom

#include "physics/event_queue.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace carom {
namespace {

// Few enough to find the earliest quickly, enough not to step through empty buckets.
constexpr double events_per_bucket = 0.5;
constexpr int most_in_list = 32;

double power_of_two_near(double value) {
    const int exponent = std::ilogb(std::clamp(value, 0x1p-900, 0x1p900));
    return std::ldexp(1.0, exponent);
}

// Half of the events lie before the median of their times.
double width_for(const std::vector<Event>& events) {
    std::vector<double> times;
    for (const Event& event : events)
        if (event.time > 0.0 && std::isfinite(event.time)) times.push_back(event.time);
    if (times.empty()) return 1.0;
    const auto median = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), median, times.end());
    return events_per_bucket * 2.0 * *median / static_cast<double>(times.size());
}

bool later(double time_a, std::int32_t a, double time_b, std::int32_t b) {
    return time_a > time_b || (time_a == time_b && a > b);
}

constexpr auto is_later = [](const auto& a, const auto& b) {
    return later(a.time, a.particle, b.time, b.particle);
};

}  // namespace

EventQueue::EventQueue(std::int32_t count)
    : count_(count),
      nodes_(index(count) + 1),
      buckets_(static_cast<std::int32_t>(
          std::bit_ceil(std::max(8U, 2U * static_cast<std::uint32_t>(count))))) {
    clear();
}

void EventQueue::clear() {
    heads_.assign(index(buckets_) + 1, nobody());
    occupied_.assign(index(beyond_lap()) / 64 + 1, 0);
    occupied_.back() = std::uint64_t{1} << (index(beyond_lap()) % 64);
    heap_.clear();
    crowded_ = false;
    bucket_ = 0;
    events_in_lap_ = 0;
}

void EventQueue::set_width(double width) {
    width_ = power_of_two_near(width);
    per_width_ = 1.0 / width_;
    lap_ = width_ * buckets_;
}

void EventQueue::reset(const std::vector<Event>& events) {
    assert(events.size() == index(count_));
    set_width(width_for(events));
    clear();
    for (std::size_t i = 0; i < events.size(); ++i) {
        nodes_[i] = Node{.event = events[i]};
        insert(static_cast<std::int32_t>(i));
    }
}

void EventQueue::schedule(std::int32_t particle, const Event& event) {
    unlink(particle);
    nodes_[index(particle)].event = event;
    insert(particle);
    ++events_in_lap_;
}

void EventQueue::insert(std::int32_t particle) {
    const double time = nodes_[index(particle)].event.time;
    // The list beyond the lap is one more bucket.
    const double due = std::min(time * per_width_, static_cast<double>(beyond_lap()));
    const auto bucket = std::max(bucket_, static_cast<std::int32_t>(due));
    if (bucket > bucket_ || !crowded_) [[likely]] {
        link(particle, bucket);
        return;
    }
    heap_.push_back({time, particle});
    std::push_heap(heap_.begin(), heap_.end(), is_later);
    if (heap_.size() > 2 * nodes_.size() + 64) forget_replaced();
}

void EventQueue::link(std::int32_t particle, std::int32_t list) {
    std::int32_t& head = heads_[index(list)];
    Node& node = nodes_[index(particle)];
    node.previous = ~list;
    node.next = head;
    nodes_[index(head)].previous = particle;
    head = particle;
    occupied_[index(list) / 64] |= std::uint64_t{1} << (index(list) % 64);
}

void EventQueue::unlink(std::int32_t particle) {
    Node& node = nodes_[index(particle)];
    if (node.previous == unlisted) [[unlikely]]
        return;
    const std::int32_t at_head = node.previous < 0 ? -1 : 0;
    const std::int32_t list = ~node.previous & at_head;
    const std::array<std::int32_t*, 2> links{&nodes_[index(node.previous & ~at_head)].next,
                                             &heads_[index(list)]};
    std::int32_t* const link = links[index(-at_head)];
    *link = node.next;
    nodes_[index(node.next)].previous = node.previous;
    const bool emptied = (at_head != 0) & (node.next == nobody()) & (list != beyond_lap());
    occupied_[index(list) / 64] &= ~(std::uint64_t{emptied} << (index(list) % 64));
    node.previous = unlisted;
}

std::int32_t EventQueue::next_occupied(std::int32_t bucket) const {
    std::size_t word = index(bucket) / 64;
    const std::uint64_t bits = occupied_[word] >> (index(bucket) % 64);
    if (bits != 0) return bucket + std::countr_zero(bits);
    while (occupied_[++word] == 0) {
    }
    return static_cast<std::int32_t>(64 * word) + std::countr_zero(occupied_[word]);
}

bool EventQueue::is_current(const Present& entry) const {
    const Node& node = nodes_[index(entry.particle)];
    return node.previous == unlisted && node.event.time == entry.time;
}

void EventQueue::forget_replaced() {
    std::erase_if(heap_, [this](const Present& entry) { return !is_current(entry); });
    std::sort(heap_.begin(), heap_.end(), [](const Present& a, const Present& b) {
        return later(b.time, b.particle, a.time, a.particle);
    });
    const auto same = [](const Present& a, const Present& b) { return a.particle == b.particle; };
    heap_.erase(std::unique(heap_.begin(), heap_.end(), same), heap_.end());
}

void EventQueue::order_present_bucket() {
    crowded_ = true;
    while (heads_[index(bucket_)] != nobody()) {
        const std::int32_t particle = heads_[index(bucket_)];
        heap_.push_back({nodes_[index(particle)].event.time, particle});
        unlink(particle);
    }
    std::make_heap(heap_.begin(), heap_.end(), is_later);
}

std::int32_t EventQueue::earliest_in_heap() {
    while (!heap_.empty()) {
        if (is_current(heap_.front())) return heap_.front().particle;
        std::pop_heap(heap_.begin(), heap_.end(), is_later);
        heap_.pop_back();
    }
    crowded_ = false;
    return -1;
}

std::int32_t EventQueue::earliest() {
    while (true) {
        if (crowded_) {
            const std::int32_t particle = earliest_in_heap();
            if (particle >= 0) return particle;
        }
        bucket_ = next_occupied(bucket_);
        if (bucket_ == beyond_lap()) {
            bucket_ = buckets_ - 1;
            return -1;
        }
        std::int32_t best = heads_[index(bucket_)];
        double time = nodes_[index(best)].event.time;
        int count = 1;
        for (std::int32_t i = nodes_[index(best)].next; i != nobody(); i = nodes_[index(i)].next) {
            ++count;
            const double its = nodes_[index(i)].event.time;
            const bool earlier = (its < time) | ((its == time) & (i < best));
            time = earlier ? its : time;
            best = earlier ? i : best;
        }
        if (count <= most_in_list) return best;
        order_present_bucket();
    }
}

// When the lap is over all events lie beyond it.
double EventQueue::next_lap() const {
    double first = Event::never;
    for (std::size_t i = 0; i < index(count_); ++i) first = std::min(first, nodes_[i].event.time);
    const double laps = std::floor(first / lap_);
    return std::isfinite(laps * lap_) ? std::min(first, laps * lap_) : first;
}

// The lap is over: whoever has an event has it beyond.
void EventQueue::begin_lap(double shift) {
    const double width = events_per_bucket * shift / static_cast<double>(events_in_lap_ + 1);
    // Twice too wide or too narrow does no harm, and a width that changes often costs exactness.
    if (width > 2.0 * width_ || width < 0.5 * width_) set_width(width);
    heads_[index(beyond_lap())] = nobody();
    bucket_ = 0;
    events_in_lap_ = 0;
    for (std::int32_t i = 0; i < count_; ++i) {
        Node& node = nodes_[index(i)];
        if (node.previous == unlisted) continue;
        node.event.time -= shift;
        node.event.contact_time -= shift;
        insert(i);
    }
}

}  // namespace carom

#include "physics/event_queue.h"

#include <algorithm>
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
    : nodes_(index(count)),
      buckets_(static_cast<std::int32_t>(
          std::bit_ceil(std::max(8U, 2U * static_cast<std::uint32_t>(count))))) {
    heads_.assign(index(buckets_) + 1, -1);
}

void EventQueue::set_width(double width) {
    width_ = power_of_two_near(width);
    per_width_ = 1.0 / width_;
    lap_ = width_ * buckets_;
}

void EventQueue::reset(const std::vector<Event>& events) {
    assert(events.size() == nodes_.size());
    set_width(width_for(events));
    std::fill(heads_.begin(), heads_.end(), -1);
    heap_.clear();
    crowded_ = false;
    bucket_ = 0;
    first_beyond_ = Event::never;
    events_in_lap_ = 0;
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
    if (!(time < lap_)) {
        if (!std::isfinite(time)) return;
        first_beyond_ = std::min(first_beyond_, time);
        link(particle, beyond_lap());
        return;
    }
    const std::int32_t bucket =
        std::max(bucket_, static_cast<std::int32_t>(std::max(0.0, time) * per_width_));
    if (bucket > bucket_ || !crowded_) {
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
    node.previous = -2 - list;
    node.next = head;
    if (head >= 0) nodes_[index(head)].previous = particle;
    head = particle;
}

void EventQueue::unlink(std::int32_t particle) {
    Node& node = nodes_[index(particle)];
    if (node.previous == unlisted) return;
    if (node.previous >= 0)
        nodes_[index(node.previous)].next = node.next;
    else
        heads_[index(-2 - node.previous)] = node.next;
    if (node.next >= 0) nodes_[index(node.next)].previous = node.previous;
    node.previous = unlisted;
    node.next = -1;
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
    std::int32_t particle = heads_[index(bucket_)];
    heads_[index(bucket_)] = -1;
    while (particle >= 0) {
        Node& node = nodes_[index(particle)];
        heap_.push_back({node.event.time, particle});
        particle = node.next;
        node.previous = unlisted;
        node.next = -1;
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
        std::int32_t best = heads_[index(bucket_)];
        if (best >= 0) {
            double time = nodes_[index(best)].event.time;
            int count = 1;
            for (std::int32_t i = nodes_[index(best)].next; i >= 0; i = nodes_[index(i)].next) {
                ++count;
                const double its = nodes_[index(i)].event.time;
                if (its > time || (its == time && i > best)) continue;
                time = its;
                best = i;
            }
            if (count <= most_in_list) return best;
            order_present_bucket();
            continue;
        }
        do ++bucket_;
        while (bucket_ < buckets_ && heads_[index(bucket_)] < 0);
        if (bucket_ >= buckets_) {
            bucket_ = buckets_ - 1;
            return -1;
        }
    }
}

double EventQueue::next_lap() const {
    if (heads_[index(beyond_lap())] < 0) return Event::never;
    const double laps = std::floor(first_beyond_ / lap_);
    return std::isfinite(laps * lap_) ? std::min(first_beyond_, laps * lap_) : first_beyond_;
}

// The lap is over: whoever has an event has it beyond.
void EventQueue::begin_lap(double shift) {
    const double width = events_per_bucket * shift / static_cast<double>(events_in_lap_ + 1);
    // Twice too wide or too narrow does no harm, and a width that changes often costs exactness.
    if (width > 2.0 * width_ || width < 0.5 * width_) set_width(width);
    heads_[index(beyond_lap())] = -1;
    bucket_ = 0;
    first_beyond_ = Event::never;
    events_in_lap_ = 0;
    const auto count = static_cast<std::int32_t>(nodes_.size());
    for (std::int32_t i = 0; i < count; ++i) {
        Node& node = nodes_[index(i)];
        if (node.previous == unlisted) continue;
        node.previous = unlisted;
        node.next = -1;
        node.event.time -= shift;
        node.event.contact_time -= shift;
        insert(i);
    }
}

}  // namespace carom

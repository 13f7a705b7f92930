#include "physics/event_queue.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace carom {
namespace {

// Few enough to order quickly, enough not to step through empty buckets.
constexpr double events_per_bucket = 2.0;

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
      buckets_(static_cast<std::int32_t>(std::bit_ceil(static_cast<std::uint32_t>(count) | 7U))) {
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
    present_.clear();
    bucket_ = 0;
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
        if (std::isfinite(time)) link(particle, beyond_lap());
        return;
    }
    const std::int32_t bucket = time > 0.0 ? static_cast<std::int32_t>(time * per_width_) : 0;
    if (bucket > bucket_) {
        link(particle, bucket);
        return;
    }
    present_.push_back({time, particle});
    std::push_heap(present_.begin(), present_.end(), is_later);
    if (present_.size() > 2 * nodes_.size() + 64) forget_replaced();
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
    std::erase_if(present_, [this](const Present& entry) { return !is_current(entry); });
    std::sort(present_.begin(), present_.end(), [](const Present& a, const Present& b) {
        return later(b.time, b.particle, a.time, a.particle);
    });
    const auto same = [](const Present& a, const Present& b) { return a.particle == b.particle; };
    present_.erase(std::unique(present_.begin(), present_.end(), same), present_.end());
}

void EventQueue::open_bucket(std::int32_t bucket) {
    bucket_ = bucket;
    std::int32_t particle = heads_[index(bucket)];
    heads_[index(bucket)] = -1;
    while (particle >= 0) {
        Node& node = nodes_[index(particle)];
        present_.push_back({node.event.time, particle});
        particle = node.next;
        node.previous = unlisted;
        node.next = -1;
    }
    std::make_heap(present_.begin(), present_.end(), is_later);
}

std::int32_t EventQueue::earliest() {
    while (true) {
        while (!present_.empty()) {
            if (is_current(present_.front())) return present_.front().particle;
            std::pop_heap(present_.begin(), present_.end(), is_later);
            present_.pop_back();
        }
        std::int32_t bucket = bucket_ + 1;
        while (bucket < buckets_ && heads_[index(bucket)] < 0) ++bucket;
        if (bucket >= buckets_) {
            bucket_ = buckets_ - 1;
            return -1;
        }
        open_bucket(bucket);
    }
}

double EventQueue::next_lap() const {
    double first = std::numeric_limits<double>::infinity();
    for (std::int32_t i = heads_[index(beyond_lap())]; i >= 0; i = nodes_[index(i)].next)
        first = std::min(first, nodes_[index(i)].event.time);
    if (!std::isfinite(first)) return first;
    const double laps = std::floor(first / lap_);
    return std::isfinite(laps * lap_) ? std::min(first, laps * lap_) : first;
}

void EventQueue::begin_lap(double shift) {
    const double width = events_per_bucket * shift / static_cast<double>(events_in_lap_ + 1);
    // Twice too wide or too narrow does no harm, and a width that changes often costs exactness.
    if (width > 2.0 * width_ || width < 0.5 * width_) set_width(width);
    std::int32_t particle = heads_[index(beyond_lap())];
    heads_[index(beyond_lap())] = -1;
    present_.clear();
    bucket_ = 0;
    events_in_lap_ = 0;
    while (particle >= 0) {
        Node& node = nodes_[index(particle)];
        const std::int32_t next = node.next;
        node.previous = unlisted;
        node.next = -1;
        node.event.time -= shift;
        node.event.contact_time -= shift;
        insert(particle);
        particle = next;
    }
}

}  // namespace carom

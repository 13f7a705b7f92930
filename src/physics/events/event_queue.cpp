#include "physics/events/event_queue.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace carom {
namespace {

// Few enough to find the earliest quickly, enough not to step through empty hours.
constexpr double events_per_hour = 0.5;
constexpr int most_in_list = 32;

// A lap is as long as several events of each particle, so that beginning one costs each event
// little.
constexpr std::uint64_t hours_per_particle = 16;
constexpr std::uint64_t least_hours = 8, most_hours = std::uint64_t{1} << 30;

// Hours of a day, as a power of two, unless the lap has fewer.
constexpr int most_day_bits = 13;

// At most, on average; one and a half are usual.
constexpr std::size_t notes_per_particle = 4;

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
    return events_per_hour * 2.0 * *median / static_cast<double>(times.size());
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
      hours_(static_cast<std::int32_t>(
          std::bit_ceil(std::clamp(hours_per_particle * index(count), least_hours, most_hours)))),
      hours_in_lap_(hours_),
      day_bits_(std::min(most_day_bits, std::countr_zero(static_cast<std::uint32_t>(hours_)))),
      elsewhere_(1 << day_bits_) {
    clear();
}

void EventQueue::clear() {
    forget_notes();
    heads_.assign(index(elsewhere_) + 1, nobody());
    nodes_[index(nobody())].next = nobody();
    occupied_.assign(index(elsewhere_) / 64 + 1, 0);
    occupied_.back() = std::uint64_t{1} << (index(elsewhere_) % 64);
    heap_.clear();
    crowded_ = false;
    hour_ = midnight_ = 0;
    ahead_ = asked_ = -1;
    events_in_lap_ = 0;
}

void EventQueue::set_width(double width) {
    width_ = power_of_two_near(width);
    per_width_ = 1.0 / width_;
    lap_ = width_ * hours_;
}

void EventQueue::reset(const std::vector<double>& times) {
    assert(times.size() == index(count_));
    set_width(width_for(times));
    clear();
    for (std::size_t i = 0; i < times.size(); ++i) {
        nodes_[i] = Node{.time = times[i]};
        insert(static_cast<std::int32_t>(i), times[i]);
    }
}

void EventQueue::renumber(const std::vector<std::int32_t>& before) {
    std::vector<double> times(before.size());
    for (std::size_t k = 0; k < before.size(); ++k) times[k] = time(before[k]);
    reset(times);
}

// In the lap, or hours_ for a time beyond.
std::int32_t EventQueue::hour_of(double time) const {
    double due = time * per_width_;
    due = due < hours_in_lap_ ? due : hours_in_lap_;
#ifdef __x86_64__
    asm("" : "+x"(due));  // lest the compiler makes a branch of it
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
    const bool emptied = (at_head != 0) & (node.next == nobody()) & (list != elsewhere_);
    occupied_[index(list) / 64] &= ~(std::uint64_t{emptied} << (index(list) % 64));
}

// Whether it is for the present day, for a later one or beyond the lap the processor cannot
// foretell either: it is always linked, be it elsewhere, and always noted, be it for nothing.
inline void EventQueue::insert(std::int32_t particle, double time) {
    const std::int32_t hour = std::max(hour_, hour_of(time));
    if (crowded_ && hour == hour_) [[unlikely]] {
        insert_into_heap(particle);
        return;
    }
    const std::int32_t hour_of_day = hour - midnight_;
    link(particle, std::min(hour_of_day, elsewhere_));
    heads_[index(elsewhere_)] = nobody();
    note(hour, (hour_of_day >= elsewhere_) & (hour < hours_), particle);
}

void EventQueue::insert_into_heap(std::int32_t particle) {
    set_elsewhere(nodes_[index(particle)]);
    heap_.push_back({nodes_[index(particle)].time, particle});
    std::push_heap(heap_.begin(), heap_.end(), is_later);
    if (heap_.size() > 2 * nodes_.size() + 64) forget_replaced();
}

void EventQueue::set_elsewhere(Node& node) {
    node.previous = ~elsewhere_;
    node.next = nobody();
}

// It is written down in any case, and written over by the next unless it is to be kept.
void EventQueue::note(std::int32_t hour, bool keep, std::int32_t particle) {
    Day& day = days_[index(hour >> day_bits_)];
    leaves_[index(day.leaf)].particle[index(day.used)] = particle;
    day.used += keep;
    if (day.used < Leaf::most) [[likely]]
        return;
    if (free_leaf_ == none && leaves_.size() > most_leaves())
        note_all_anew();
    else
        day = {new_leaf(day.leaf), 0};
}

// Some for each particle and one more for each day: enough unless a few collide very often.
std::size_t EventQueue::most_leaves() const {
    return days_.size() + 16 + notes_per_particle * index(count_) / Leaf::most;
}

void EventQueue::note_all_anew() {
    forget_notes();
    for (std::int32_t i = 0; i < count_; ++i) {
        const Node& node = nodes_[index(i)];
        const std::int32_t hour = hour_of(node.time);
        if (is_elsewhere(node) && hour - midnight_ >= elsewhere_) note(hour, hour < hours_, i);
    }
}

void EventQueue::forget_notes() {
    leaves_.clear();
    free_leaf_ = none;
    days_.clear();
    for (std::int32_t day = 0; day <= hours_ >> day_bits_; ++day)
        days_.push_back({new_leaf(none), 0});
}

std::int32_t EventQueue::new_leaf(std::int32_t before) {
    std::int32_t leaf = free_leaf_;
    if (leaf == none) {
        leaf = static_cast<std::int32_t>(leaves_.size());
        leaves_.emplace_back();
    } else {
        free_leaf_ = leaves_[index(leaf)].before;
        __builtin_prefetch(&leaves_[index(std::max(free_leaf_, 0))]);
    }
    leaves_[index(leaf)].before = before;
    return leaf;
}

// Some are noted twice, some are due at another time now.
void EventQueue::begin_day() {
    ahead_ = asked_ = -1;
    const std::int32_t day = midnight_ >> day_bits_;
    Day& its = days_[index(day)];
    // Two leaves ahead their particles' nodes are asked for, and four ahead the leaves: no sooner
    // is a leaf there than it tells which was filled before.
    std::int32_t soon = its.leaf, later = its.leaf;
    const auto fetch_ahead = [&] {
        for (const std::int32_t particle : leaves_[index(soon)].particle)
            __builtin_prefetch(&nodes_[index(particle)]);
        soon = later;
        const std::int32_t before = leaves_[index(later)].before;
        later = before == none ? later : before;
        __builtin_prefetch(&leaves_[index(later)]);
    };
    for (int k = 0; k < 3; ++k) fetch_ahead();
    while (true) {
        fetch_ahead();
        Leaf& leaf = leaves_[index(its.leaf)];
        for (std::int32_t k = 0; k < its.used; ++k) {
            const std::int32_t particle = leaf.particle[index(k)];
            const Node& node = nodes_[index(particle)];
            const std::int32_t hour = hour_of(node.time);
            // without a branch, which the processor could not foretell
            const std::int32_t due =
                -static_cast<std::int32_t>((hour >> day_bits_ == day) & is_elsewhere(node));
            link((particle & due) | (nobody() & ~due),
                 ((hour - midnight_) & due) | (elsewhere_ & ~due));
            heads_[index(elsewhere_)] = nobody();
        }
        const std::int32_t before = leaf.before;
        if (before == none) break;
        leaf.before = free_leaf_;
        free_leaf_ = its.leaf;
        its = {before, Leaf::most};
    }
    its.used = 0;
}

void EventQueue::schedule(std::int32_t particle, double time) {
    unlink(particle);
    nodes_[index(particle)].time = time;
    insert(particle, time);
    ++events_in_lap_;
}

// From an hour of the day on; elsewhere_ when there is none.
std::int32_t EventQueue::next_occupied(std::int32_t hour_of_day) const {
    std::size_t word = index(hour_of_day) / 64;
    const std::uint64_t bits = occupied_[word] >> (index(hour_of_day) % 64);
    if (bits != 0) return hour_of_day + std::countr_zero(bits);
    while (occupied_[++word] == 0) {
    }
    return static_cast<std::int32_t>(64 * word) + std::countr_zero(occupied_[word]);
}

// On to the next hour with events, if it is not more than `hours` ahead. Without branches: how far
// it is the processor cannot foretell.
inline bool EventQueue::step_ahead(std::int32_t& from, std::int32_t hours) const {
    const std::int32_t present = hour_ - midnight_;
    from = std::max(from, present);
    const std::int32_t next = next_occupied(std::min(from + 1, elsewhere_));
    const bool near = next <= std::min(present + hours, elsewhere_ - 1);
    from ^= (from ^ next) & -static_cast<std::int32_t>(near);
    return near;
}

std::uint32_t EventQueue::look_ahead(std::int32_t hours, std::array<std::int32_t, 3>& who) {
    step_ahead(asked_, hours + hours / 2);
    fetch(heads_[index(asked_)]);
    const std::uint32_t any = step_ahead(ahead_, hours) ? 1 : 0;
    who[0] = heads_[index(ahead_)];
    who[1] = nodes_[index(who[0])].next;
    who[2] = nodes_[index(who[1])].next;
    return any + (any & (who[1] != nobody() ? 1U : 0U)) + (any & (who[2] != nobody() ? 1U : 0U));
}

bool EventQueue::is_current(const Present& entry) const {
    const Node& node = nodes_[index(entry.particle)];
    return is_elsewhere(node) && node.time == entry.time;
}

void EventQueue::forget_replaced() {
    std::erase_if(heap_, [this](const Present& entry) { return !is_current(entry); });
    std::sort(heap_.begin(), heap_.end(), [](const Present& a, const Present& b) {
        return later(b.time, b.particle, a.time, a.particle);
    });
    const auto same = [](const Present& a, const Present& b) { return a.particle == b.particle; };
    heap_.erase(std::unique(heap_.begin(), heap_.end(), same), heap_.end());
}

void EventQueue::order_present_hour() {
    crowded_ = true;
    const std::int32_t list = (hour_ - midnight_);
    while (heads_[index(list)] != nobody()) {
        const std::int32_t particle = heads_[index(list)];
        heap_.push_back({nodes_[index(particle)].time, particle});
        unlink(particle);
        set_elsewhere(nodes_[index(particle)]);
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
        const std::int32_t list = next_occupied((hour_ - midnight_));
        if (list == elsewhere_) {
            hour_ = midnight_ + elsewhere_;
            if (hour_ == hours_) {
                --hour_;
                return -1;
            }
            midnight_ = hour_;
            begin_day();
            continue;
        }
        hour_ = midnight_ + list;
        // there is mostly one, sometimes a second, who is nobody otherwise
        std::int32_t best = heads_[index(list)];
        std::int32_t i = nodes_[index(best)].next;
        double time = nodes_[index(best)].time;
        int count = 0;
        do {
            const double its = nodes_[index(i)].time;
            const bool earlier = (its < time) | ((its == time) & (i < best));
            const std::int32_t mask = -static_cast<std::int32_t>(earlier);
            time = std::min(its, time);
            best ^= (best ^ i) & mask;
            i = nodes_[index(i)].next;
            ++count;
        } while (i != nobody());
        if (count <= most_in_list) return best;
        order_present_hour();
    }
}

// When the lap is over all events lie beyond it.
double EventQueue::next_lap() const {
    double first = never<double>;
    for (std::size_t i = 0; i < index(count_); ++i) first = std::min(first, nodes_[i].time);
    const double laps = std::floor(first / lap_);
    return std::isfinite(laps * lap_) ? std::min(first, laps * lap_) : first;
}

// The lap is over: whoever has an event has it beyond.
void EventQueue::begin_lap(double shift) {
    const double width = events_per_hour * shift / static_cast<double>(events_in_lap_ + 1);
    // Twice too wide or too narrow does no harm, and a width that changes often costs exactness.
    if (width > 2.0 * width_ || width < 0.5 * width_) set_width(width);
    hour_ = midnight_ = 0;
    ahead_ = asked_ = -1;
    events_in_lap_ = 0;
    for (std::int32_t i = 0; i < count_; ++i) {
        Node& node = nodes_[index(i)];
        node.time -= shift;
        insert(i, node.time);
    }
}

}  // namespace carom

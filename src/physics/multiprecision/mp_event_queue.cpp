#include "physics/multiprecision/mp_event_queue.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace carom {

MpEventQueue::MpEventQueue(std::int32_t count)
    : events_(index(count)), keys_(index(count)), heap_(index(count)), places_(index(count)) {}

// Rounding keeps the order: only times that become one double need be looked at in full.
bool MpEventQueue::earlier(std::int32_t a, std::int32_t b) const {
    const double key_a = keys_[index(a)], key_b = keys_[index(b)];
    if (key_a != key_b) return key_a < key_b;
    const auto order = events_[index(a)].time <=> events_[index(b)].time;
    return order < 0 || (order == 0 && a < b);
}

void MpEventQueue::reset(const std::vector<MpEvent>& events) {
    assert(events.size() == events_.size());
    events_ = events;
    for (std::size_t i = 0; i < events_.size(); ++i) keys_[i] = events_[i].time.rounded_down();
    std::iota(heap_.begin(), heap_.end(), 0);
    std::iota(places_.begin(), places_.end(), std::size_t{0});
    for (std::size_t place = heap_.size() / 2; place-- > 0;) sink(place);
}

void MpEventQueue::schedule(std::int32_t particle, MpEvent event) {
    keys_[index(particle)] = event.time.rounded_down();
    events_[index(particle)] = std::move(event);
    rise(places_[index(particle)]);
    sink(places_[index(particle)]);
}

std::int32_t MpEventQueue::earliest() const {
    return heap_.empty() || std::isinf(keys_[index(heap_[0])]) ? -1 : heap_[0];
}

void MpEventQueue::put(std::size_t place, std::int32_t particle) {
    heap_[place] = particle;
    places_[index(particle)] = place;
}

void MpEventQueue::rise(std::size_t place) {
    const std::int32_t particle = heap_[place];
    while (place > 0) {
        const std::size_t above = (place - 1) / 2;
        if (!earlier(particle, heap_[above])) break;
        put(place, heap_[above]);
        place = above;
    }
    put(place, particle);
}

void MpEventQueue::sink(std::size_t place) {
    const std::int32_t particle = heap_[place];
    while (2 * place + 1 < heap_.size()) {
        std::size_t below = 2 * place + 1;
        if (below + 1 < heap_.size() && earlier(heap_[below + 1], heap_[below])) ++below;
        if (!earlier(heap_[below], particle)) break;
        put(place, heap_[below]);
        place = below;
    }
    put(place, particle);
}

}  // namespace carom

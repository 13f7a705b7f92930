#include "physics/multiprecision/mp_event_queue.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace carom {

MpEventQueue::MpEventQueue(std::int32_t count)
    : times_(index(count)), keys_(index(count)), winner_(2 * index(count)) {
    std::iota(winner_.begin() + count, winner_.end(), 0);
}

// The particle with the earlier event, at equal times the lower number. Rounding preserves the
// order, so only times that round to the same double need a full comparison.
std::int32_t MpEventQueue::earlier(std::int32_t a, std::int32_t b) const {
    const double key_a = keys_[index(a)], key_b = keys_[index(b)];
    if (key_a != key_b) return key_a < key_b ? a : b;
    const auto order = time(a) <=> time(b);
    return order < 0 || (order == 0 && a < b) ? a : b;
}

void MpEventQueue::reset(std::vector<Real> times) {
    assert(times.size() == times_.size());
    times_ = std::move(times);
    for (std::size_t i = 0; i < times_.size(); ++i) keys_[i] = times_[i].rounded_down();
    for (std::size_t match = times_.size(); match-- > 1;) play(match);
}

void MpEventQueue::schedule(std::int32_t particle, Real time) {
    keys_[index(particle)] = time.rounded_down();
    times_[index(particle)] = std::move(time);
    for (std::size_t k = (times_.size() + index(particle)) / 2; k > 0; k /= 2) play(k);
}

std::int32_t MpEventQueue::earliest() const {
    return times_.empty() || std::isinf(keys_[index(winner_[1])]) ? -1 : winner_[1];
}

}  // namespace carom

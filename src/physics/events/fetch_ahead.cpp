#include "physics/events/fetch_ahead.h"

#include <algorithm>

namespace carom {
namespace {

// Prefetch distances: bodies are prefetched this many buckets ahead (half an event each); their
// partners, the cells around both, and the bodies in these cells follow this many bodies later.
// Each distance exceeds the latency of memory.
constexpr std::int32_t buckets_ahead = 48;
constexpr std::uint32_t partner_after = 2;
constexpr std::uint32_t cells_after = 4;
constexpr std::uint32_t neighbours_after = 6;

// If more bodies than this are waiting, two are prefetched at a time. The maximum number waiting
// leaves room in the ring buffer for the six bodies before them.
constexpr std::uint32_t many_waiting = 6;
constexpr std::uint32_t most_waiting = 32;

}  // namespace

template <typename Geometry>
void FetchAhead<Geometry>::ask(const Bodies& bodies, Geometry& geometry, EventQueue& queue) {
    look_ahead(bodies, queue);
    // when a year begins none of its buckets has been looked at
    if (queue.buckets_looked_at() < buckets_ahead / 2) look_ahead(bodies, queue);
    if (begin_ == end_) return;
    if (end_ - begin_ > most_waiting) begin_ = end_ - most_waiting;
    fetch(bodies, geometry, queue);
    if (end_ - begin_ > many_waiting) fetch(bodies, geometry, queue);
}

// Numbers above those of the bodies belong to events of surfaces, which need no body.
template <typename Geometry>
void FetchAhead<Geometry>::look_ahead(const Bodies& bodies, EventQueue& queue) {
    std::array<std::int32_t, 3> who;
    const std::uint32_t more = queue.look_ahead(buckets_ahead, who);
    const auto last = static_cast<std::int32_t>(bodies.size()) - 1;
    for (std::uint32_t k = 0; k < who.size(); ++k) coming(end_ + k) = std::min(who[k], last);
    end_ += more;
}

template <typename Geometry>
void FetchAhead<Geometry>::fetch(const Bodies& bodies, Geometry& geometry, EventQueue& queue) {
    const std::uint32_t k = begin_++;
    geometry.fetch_body_ahead(bodies, coming(k));
    const std::int32_t second = coming(k - partner_after);
    const std::int32_t partner = Geometry::partner_ahead(bodies, second, queue.time(second));
    geometry.fetch_body_ahead(bodies, partner);
    queue.fetch(partner);
    const std::int32_t third = coming(k - cells_after), last = coming(k - neighbours_after);
    geometry.fetch_cells_ahead(bodies, third, queue.time(third));
    geometry.fetch_neighbours_ahead(bodies, last, queue.time(last));
}

template class FetchAhead<PlainSpace<2>>;
template class FetchAhead<PlainSpace<3>>;
template class FetchAhead<OpenSpace<double, 2>>;
template class FetchAhead<OpenSpace<double, 3>>;

}  // namespace carom

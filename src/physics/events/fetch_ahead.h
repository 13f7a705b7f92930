// Prefetching: if there are many bodies, most are not in a nearby cache. The event queue knows
// which bodies have the next events, so the data needed for these are prefetched in time and in
// stages, each stage after the data of the previous one have arrived. Does not change any result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/cells/plain_space.h"
#include "physics/events/event_queue.h"
#include "physics/surfaces/open_space.h"

namespace carom {

/// For boxes whose neighbour search is a PairSearch; for other geometries the class exists but its
/// functions are not used.
template <typename Geometry>
class FetchAhead {
  public:
    using Bodies = typename Geometry::Bodies;

    /// To be called for each event. Does nothing for a few bodies, which stay in the caches.
    void step(const Bodies& bodies, Geometry& geometry, EventQueue& queue) {
        if (bodies.size() >= least) ask(bodies, geometry, queue);
    }

  private:
    static constexpr std::size_t least = 32768;

    void look_ahead(const Bodies& bodies, EventQueue& queue);  ///< adds the bodies of the next
                                                               ///< events to the ring
    void fetch(const Bodies& bodies, Geometry& geometry, EventQueue& queue);
    void ask(const Bodies& bodies, Geometry& geometry, EventQueue& queue);
    std::int32_t& coming(std::uint32_t k) { return coming_[k % coming_.size()]; }

    std::array<std::int32_t, 64> coming_{};  ///< ring buffer of the bodies of the next events
    std::uint32_t begin_ = 0, end_ = 0;      ///< range that is still to be prefetched
};

extern template class FetchAhead<PlainSpace<2>>;
extern template class FetchAhead<PlainSpace<3>>;
extern template class FetchAhead<OpenSpace<double, 2>>;
extern template class FetchAhead<OpenSpace<double, 3>>;

}  // namespace carom

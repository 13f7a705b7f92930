// Prefetching: of many disks most are in distant memory. The event queue knows which disks have the
// next events, so what these will need is prefetched in time, one thing after the other, each when
// the one before has arrived. Changes no result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/events/event_queue.h"
#include "physics/plane/plane.h"
#include "physics/surfaces/open_plane.h"

namespace carom {

/// Of a plane whose disks are found by a PairSearch; for others there is only the class.
template <typename Geometry>
class FetchAhead {
  public:
    using Bodies = typename Geometry::Bodies;

    /// To be called for each event. Does nothing for a few disks, which stay in the caches.
    void step(const Bodies& bodies, Geometry& plane, EventQueue& queue) {
        if (bodies.size() >= least) ask(bodies, plane, queue);
    }

  private:
    static constexpr std::size_t least = 32768;

    void look_ahead(const Bodies& bodies, EventQueue& queue);  ///< adds the disks of the next
                                                               ///< events to the ring
    void fetch(const Bodies& bodies, Geometry& plane, EventQueue& queue);
    void ask(const Bodies& bodies, Geometry& plane, EventQueue& queue);
    std::int32_t& coming(std::uint32_t k) { return coming_[k % coming_.size()]; }

    std::array<std::int32_t, 64> coming_{};  ///< ring buffer of the disks of the next events, and
    std::uint32_t begin_ = 0, end_ = 0;      ///< the part of it that has not been prefetched yet
};

extern template class FetchAhead<Plane>;
extern template class FetchAhead<OpenPlane<double>>;

}  // namespace carom

// Fetching ahead: of many disks most lie far from the processor. The calendar tells whose events
// are near, so what these will need is asked for in time, one thing after the other, each when the
// one before has come. Changes nothing but when things are done.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/events/event_queue.h"
#include "physics/plane/plane.h"

namespace carom {

class FetchAhead {
  public:
    /// To be called for each event. Does nothing for a few disks, which lie near anyhow.
    void step(const Plane::Bodies& bodies, Plane& plane, EventQueue& queue) {
        if (bodies.size() >= least) ask(bodies, plane, queue);
    }

  private:
    static constexpr std::size_t least = 32768;

    void listen(EventQueue& queue);  ///< who comes next?
    void fetch(const Plane::Bodies& bodies, Plane& plane, EventQueue& queue);
    void ask(const Plane::Bodies& bodies, Plane& plane, EventQueue& queue);
    std::int32_t& coming(std::uint32_t k) { return coming_[k % coming_.size()]; }

    std::array<std::int32_t, 64> coming_{};  ///< the last disks told of, and
    std::uint32_t begin_ = 0, end_ = 0;      ///< those of them that nothing has been asked for yet
};

}  // namespace carom

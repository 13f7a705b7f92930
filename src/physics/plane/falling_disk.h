// A disk that may fall, or a bead on a line that does, as the event loop has it in a box whose
// surfaces act. Of a bead only the first coordinate counts, the other is 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/collision/loop_types.h"
#include "physics/plane/cell_grid.h"

namespace carom {

template <typename Scalar>
struct FallingDisk {
    std::array<Scalar, 2> x{}, v{};  ///< at its own time
    std::array<Scalar, 2> a{};       ///< 0 while it rests on a floor
    Scalar time = 0.0;               ///< local
    double radius = 0.0, inverse_mass = 0.0;
    std::uint32_t collisions = 0;
    Cell cell{};
    std::int32_t species = 0;
    std::int32_t passing = -1;  ///< the barrier that it was let through by and has not left
    std::int32_t turns = 0;     ///< of a bead: how often it has gone round a periodic line
    Prediction prediction{};    ///< partner < 0: barrier -1 - partner
};

template <typename Scalar>
Scalar position_at(const FallingDisk<Scalar>& d, std::size_t axis, const Scalar& now) {
    const Scalar t = now - d.time;
    return d.x[axis] + t * (d.v[axis] + 0.5 * t * d.a[axis]);
}

template <typename Scalar>
Scalar velocity_at(const FallingDisk<Scalar>& d, std::size_t axis, const Scalar& now) {
    return d.v[axis] + d.a[axis] * (now - d.time);
}

template <typename Scalar>
void advance_body(FallingDisk<Scalar>& d, const Scalar& now) {
    for (std::size_t k = 0; k < 2; ++k) {
        d.x[k] = position_at(d, k, now);
        d.v[k] = velocity_at(d, k, now);
    }
    d.time = now;
}

}  // namespace carom

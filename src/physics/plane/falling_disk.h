// A disk, or a bead on a line, that may fall: the state in the event loop for boxes with active
// surfaces. Of a bead only the first coordinate is used; the other is 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "physics/collision/loop_types.h"
#include "physics/plane/cell_grid.h"
#include "physics/plane/disk_state.h"

namespace carom {

/// The counterpart of DiskState for multiprecision.
template <typename Scalar>
struct PreciseDiskState {
    std::array<Scalar, 2> x{}, v{};
    Scalar time = 0.0;
    std::uint32_t collisions = 0;
    Cell cell{};
    Prediction prediction{};

    template <class Archive>
    void archive(Archive& archive) {
        archive(x, v, time, collisions, cell, prediction);
    }
};

/// In its prediction a partner < 0 denotes barrier -1 - partner. The members that a contact search
/// needs for most disks come first, in one cache line; the search assumes that all disks fall.
template <typename Scalar>
struct FallingDisk
    : std::conditional_t<std::is_same_v<Scalar, double>, DiskState, PreciseDiskState<Scalar>> {
    std::array<Scalar, 2> a{};  ///< acceleration; 0 while the disk rests on a floor
    double radius = 0.0, inverse_mass = 0.0;
    std::int32_t species = 0;
    std::int32_t turns = 0;  ///< of a bead: number of turns around a periodic line
    /// Bit k modulo 64 is set if surface k has let the disk through and not reflected it since.
    /// While the disk still overlaps the surface, all parts of the surface let it through.
    std::uint64_t passing = 0;
    bool is_at_rest = false;  ///< rests on a floor and therefore does not fall

    template <class Archive>
    void archive(Archive& archive) {
        std::conditional_t<std::is_same_v<Scalar, double>, DiskState,
                           PreciseDiskState<Scalar>>::archive(archive);
        archive(a, radius, inverse_mass, species, turns, passing, is_at_rest);
    }
};

using FallingDisks = LargeVector<FallingDisk<double>>;

/// Position and velocity of a disk with this acceleration at a time, computed in pairs as the disk
/// stores them (disk_state.h).
[[gnu::always_inline]] inline void fall(const DiskState& d, double now,
                                        const std::array<double, 2>& a, std::array<double, 2>& x,
                                        std::array<double, 2>& v) {
    const double t = now - d.time;
    const TwoLanes before = load_two(d.v.data()), gain = t * load_two(a.data());
    store_two(load_two(d.x.data()) + t * (before + 0.5 * gain), x.data());
    store_two(before + gain, v.data());
}

/// As advance_body(), but with the acceleration given by the caller: only the first cache line of
/// the disk is read.
inline void advance_body(DiskState& d, double now, const std::array<double, 2>& a) {
    fall(d, now, a, d.x, d.v);
    d.time = now;
}

/// Adds a multiple of a vector to the velocity.
template <typename Scalar>
inline void accelerate(FallingDisk<Scalar>& d, const Scalar& factor,
                       const std::array<Scalar, 2>& r) {
    for (std::size_t k = 0; k < 2; ++k) d.v[k] += factor * r[k];
}
inline void accelerate(DiskState& d, double factor, const std::array<double, 2>& r) {
    store_two(load_two(d.v.data()) + factor * TwoLanes{r[0], r[1]}, d.v.data());
}

/// A disk in doubles, advanced to the present.
struct DiskView {
    std::array<double, 2> x, v, a;

    template <typename Scalar>
    DiskView(const FallingDisk<Scalar>& d, const Scalar& time) {
        for (std::size_t k = 0; k < 2; ++k) {
            x[k] = static_cast<double>(position_at(d, k, time));
            v[k] = static_cast<double>(velocity_at(d, k, time));
            a[k] = static_cast<double>(d.a[k]);
        }
    }
    /// With a known acceleration, as for advance_body().
    DiskView(const DiskState& d, double time, const std::array<double, 2>& gravity) : a(gravity) {
        fall(d, time, gravity, x, v);
    }
};

}  // namespace carom

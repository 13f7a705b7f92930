// A disk, a sphere or a bead on a line that may fall: the state in the event loop for boxes with
// active surfaces. A bead is stored as a disk of which only the first coordinate is used; the other
// is 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "physics/cells/body_state.h"
#include "physics/cells/cell_grid.h"
#include "physics/collision/loop_types.h"

namespace carom {

/// The counterpart of BodyState for multiprecision.
template <typename Scalar, int Dimension>
struct PreciseBodyState {
    static constexpr std::size_t axes = static_cast<std::size_t>(Dimension);
    std::array<Scalar, axes> x{}, v{};
    Scalar time = 0.0;
    std::uint32_t collisions = 0;
    CellOf<Dimension> cell{};
    Prediction prediction{};

    template <class Archive>
    void archive(Archive& archive) {
        archive(x, v, time, collisions, cell, prediction);
    }
};

/// In its prediction a partner < 0 denotes barrier -1 - partner. The members that a contact search
/// needs for most bodies come first, in one cache line; the search assumes that all bodies fall.
template <typename Scalar, int Dimension>
using FallingState = std::conditional_t<std::is_same_v<Scalar, double>, BodyState<Dimension>,
                                        PreciseBodyState<Scalar, Dimension>>;

template <typename Scalar, int Dimension = 2>
struct FallingBody : FallingState<Scalar, Dimension> {
    /// Acceleration; 0 while the body rests on a floor.
    std::array<Scalar, static_cast<std::size_t>(Dimension)> a{};
    double radius = 0.0, inverse_mass = 0.0;
    std::int32_t species = 0;
    std::int32_t turns = 0;  ///< of a bead: number of turns around a periodic line
    /// Bit k modulo 64 is set if surface k has let the body through and not reflected it since.
    /// While it still overlaps the surface, all parts of the surface let it through.
    std::uint64_t passing = 0;
    bool is_at_rest = false;  ///< rests on a floor and therefore does not fall

    template <class Archive>
    void archive(Archive& archive) {
        FallingState<Scalar, Dimension>::archive(archive);
        archive(a, radius, inverse_mass, species, turns, passing, is_at_rest);
    }
};

/// Position and velocity of a body with this acceleration at a time, computed in pairs as the body
/// stores them (body_state.h).
template <int Dimension>
[[gnu::always_inline]] inline void fall(const BodyState<Dimension>& b, double now,
                                        const std::array<double, BodyState<Dimension>::axes>& a,
                                        std::array<double, BodyState<Dimension>::axes>& x,
                                        std::array<double, BodyState<Dimension>::axes>& v) {
    const double t = now - b.time;
    const TwoLanes before = load_two(b.v.data()), gain = t * load_two(a.data());
    store_two(load_two(b.x.data()) + t * (before + 0.5 * gain), x.data());
    store_two(before + gain, v.data());
    if constexpr (Dimension == 3) {
        const double up_before = b.v[2], up_gain = t * a[2];
        x[2] = b.x[2] + t * (up_before + 0.5 * up_gain);
        v[2] = up_before + up_gain;
    }
}

/// As advance_body(), but with the acceleration given by the caller: only what a contact search
/// needs of the body is read.
template <int Dimension>
inline void advance_body(BodyState<Dimension>& b, double now,
                         const std::array<double, BodyState<Dimension>::axes>& a) {
    fall(b, now, a, b.x, b.v);
    b.time = now;
}

/// As that of BodyState.
template <typename Scalar, int Dimension>
inline void accelerate(PreciseBodyState<Scalar, Dimension>& b, const Scalar& factor,
                       const std::array<Scalar, BodyState<Dimension>::axes>& r) {
    for (std::size_t k = 0; k < r.size(); ++k) b.v[k] += factor * r[k];
}

/// A body in doubles, advanced to the present.
template <int Dimension>
struct BodyView {
    using Point = std::array<double, static_cast<std::size_t>(Dimension)>;
    Point x, v, a;

    template <typename Scalar>
    BodyView(const FallingBody<Scalar, Dimension>& b, const Scalar& time) {
        for (std::size_t k = 0; k < x.size(); ++k) {
            x[k] = static_cast<double>(position_at(b, k, time));
            v[k] = static_cast<double>(velocity_at(b, k, time));
            a[k] = static_cast<double>(b.a[k]);
        }
    }
    /// With a known acceleration, as for advance_body().
    BodyView(const BodyState<Dimension>& b, double time, const Point& gravity) : a(gravity) {
        fall(b, time, gravity, x, v);
    }
};

}  // namespace carom

// The state of a disk or a sphere in the event loop, and the constant properties of all of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/cells/cell_grid.h"
#include "physics/collision/lanes.h"
#include "physics/collision/loop_types.h"
#include "physics/particles.h"
#include "util/memory/large_pages.h"

namespace carom {

/// All that is needed to test and collide a pair of equal disks, in one cache line; of spheres all
/// that is needed to test a pair is in the first of two.
template <int Dimension>
struct BodyState;

template <>
struct alignas(64) BodyState<2> {
    static constexpr std::size_t axes = 2;
    std::array<double, 2> x;  ///< at the disk's own time; may lie a little outside a periodic box
    std::array<double, 2> v;
    double time;  ///< local
    std::uint32_t collisions;
    CellOf<2> cell;
    Prediction prediction;

    template <class Archive>
    void archive(Archive& archive) {
        archive(x, v, time, collisions, cell, prediction);
    }
};
static_assert(sizeof(BodyState<2>) == 64);

template <>
struct alignas(64) BodyState<3> {
    static constexpr std::size_t axes = 3;
    std::array<double, 3> x, v;
    double time;
    Prediction prediction;  ///< begins with the time of its contact
    std::uint32_t collisions;
    CellOf<3> cell;

    template <class Archive>
    void archive(Archive& archive) {
        archive(x, v, time, collisions, cell, prediction);
    }
};
static_assert(offsetof(BodyState<3>, prediction) == 56 && sizeof(BodyState<3>) == 128);

/// As the generic advance_body(). Values that are read as a pair are also written as a pair: a
/// processor can forward only what was stored as a unit.
template <int Dimension>
inline void advance_body(BodyState<Dimension>& b, double now) {
    const double age = now - b.time;
    store_two(load_two(b.x.data()) + load_two(b.v.data()) * age, b.x.data());
    if constexpr (Dimension == 3) b.x[2] += b.v[2] * age;
    b.time = now;
}

/// Adds a multiple of a vector to the velocity.
template <int Dimension>
[[gnu::always_inline]] inline void accelerate(
    BodyState<Dimension>& b, double factor,
    const std::array<double, BodyState<Dimension>::axes>& r) {
    store_two(load_two(b.v.data()) + factor * TwoLanes{r[0], r[1]}, b.v.data());
    if constexpr (Dimension == 3) b.v[2] += factor * r[2];
}

template <int Dimension>
using BodyStates = LargeVector<BodyState<Dimension>>;

/// The properties of each body, stored only once if all are alike.
class BodyProperties {
  public:
    explicit BodyProperties(const Particles& particles);

    const Properties& operator[](std::int32_t i) const {
        return each_[static_cast<std::size_t>(i) & mask_];
    }
    const Properties& operator[](std::size_t i) const { return each_[i & mask_]; }

    /// Whether all have the same nonzero radius and the same finite mass.
    bool alike() const { return alike_; }

    /// Renumbers the bodies: body k is the one that had the number before[k].
    void renumber(const std::vector<std::int32_t>& before);

    /// In the order that the bodies have.
    template <class Archive>
    void archive(Archive& archive) {
        archive(each_);
    }

  private:
    LargeVector<Properties> each_;
    std::size_t mask_ = 0;  ///< applied to numbers: 0 if there is only one entry
    bool alike_ = false;
};

}  // namespace carom

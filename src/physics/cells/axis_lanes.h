// Vectors of the plane or of space as lanes, one for each axis; in space the fourth lane is not
// used. To be used as those of lanes.h.
#pragma once

#include <array>
#include <type_traits>

#include "physics/cells/cell_grid.h"
#include "physics/collision/lanes.h"

namespace carom {

template <int Dimension>
using AxisLanes = std::conditional_t<Dimension == 2, TwoLanes, FourLanes>;
template <int Dimension>
using AxisMasks = std::conditional_t<Dimension == 2, TwoMasks, FourMasks>;

/// A vector as lanes; the fourth lane is 0.
[[gnu::always_inline]] inline TwoLanes lanes_of(const std::array<double, 2>& x) {
    return load_two(x.data());
}
[[gnu::always_inline]] inline FourLanes lanes_of(const std::array<double, 3>& x) {
    return FourLanes{x[0], x[1], x[2], 0.0};
}
[[gnu::always_inline]] inline TwoLanes lanes_of(const CellOf<2>& cell) {
    return TwoLanes{static_cast<double>(cell[0]), static_cast<double>(cell[1])};
}
[[gnu::always_inline]] inline FourLanes lanes_of(const CellOf<3>& cell) {
    return FourLanes{static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                     static_cast<double>(cell[2]), 0.0};
}

/// The lower side of each axis.
[[gnu::always_inline]] inline void set_lower_sides(TwoMasks& sides) { sides = TwoMasks{0, 2}; }
[[gnu::always_inline]] inline void set_lower_sides(FourMasks& sides) {
    sides = FourMasks{0, 2, 4, 6};
}

/// The least of the times, in all lanes, with its side; the processor cannot predict which it is.
[[gnu::always_inline]] inline void take_first(TwoLanes& time, TwoMasks& side) {
    const TwoMasks other_first = swapped(time) < time;
    side = other_first ? swapped(side) : side;
    time = select(other_first, swapped(time), time);
}
[[gnu::always_inline]] inline void take_first(FourLanes& time, FourMasks& side) {
    const FourLanes next = __builtin_shufflevector(time, time, 1, 0, 3, 2);
    const FourMasks next_side = __builtin_shufflevector(side, side, 1, 0, 3, 2);
    const FourMasks next_first = next < time;
    side = next_first ? next_side : side;
    time = select(next_first, next, time);
    const FourLanes other = __builtin_shufflevector(time, time, 2, 3, 0, 1);
    const FourMasks other_side = __builtin_shufflevector(side, side, 2, 3, 0, 1);
    const FourMasks other_first = other < time;
    side = other_first ? other_side : side;
    time = select(other_first, other, time);
}

}  // namespace carom

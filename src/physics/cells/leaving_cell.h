// When a disk or a sphere that moves freely, or falls, leaves its cell of the grid. Free functions
// on lanes. Times are counted from the present.
#pragma once

#include <cstdint>

#include "physics/cells/axis_lanes.h"
#include "physics/collision/pair_collision.h"

namespace carom {

/// When and through which side a body leaves its cell. This has no physical meaning, and a cell is
/// slightly wider than necessary, so doubles with their round-off are sufficient.
struct Leaving {
    double time;
    std::uint32_t side;
};

/// The cell of a body along all axes, and the body in it. All in lanes and branchless, because the
/// processor cannot predict where the body goes.
template <int Dimension>
struct InCell {
    AxisLanes<Dimension> low, high;        ///< the borders
    AxisMasks<Dimension> no_low, no_high;  ///< where there is no border
    AxisLanes<Dimension> x, v;
};

/// The first of the times at which it leaves its cell along each axis, upwards or downwards.
template <typename Lanes, typename Masks>
[[gnu::always_inline]] inline Leaving first_of(const Lanes& times, const Masks& upwards) {
    Lanes time = times;
    Masks side;
    set_lower_sides(side);
    side = side - upwards;
    take_first(time, side);
    return {time[0], static_cast<std::uint32_t>(side[0])};
}

/// For a body that moves in a straight line.
template <int Dimension>
[[gnu::always_inline]] inline Leaving leaving_straight(const InCell<Dimension>& in) {
    using Lanes = AxisLanes<Dimension>;
    using Masks = AxisMasks<Dimension>;
    const Lanes zero{}, none = zero + never<double>;
    const Masks upwards = in.v > zero;
    const Lanes ahead = (select_bits(upwards, in.high, in.low) - in.x) / in.v;
    const Masks stays = select_bits(upwards, in.no_high, in.no_low) | (in.v == zero);
    return first_of(select_bits(stays, none, select_bits(ahead > zero, ahead, zero)), upwards);
}

/// For a body with the acceleration `a`. Coordinates are mirrored if necessary so that the body
/// falls downwards; it may rise first, to the border above or to a turning point below it.
template <int Dimension>
[[gnu::always_inline]] inline Leaving leaving_in_fall(const InCell<Dimension>& in,
                                                      const AxisLanes<Dimension>& a) {
    using Lanes = AxisLanes<Dimension>;
    using Masks = AxisMasks<Dimension>;
    const Lanes zero{}, none = zero + never<double>;
    const Masks mirrored = a > zero;
    const Lanes v = select_bits(mirrored, -in.v, in.v), g = abs(a);
    Lanes below = in.x - in.low, above = in.high - in.x;
    const Lanes kept = below;
    below = select_bits(mirrored, above, below);
    above = select_bits(mirrored, kept, above);
    below = select_bits(below > zero, below, zero);
    above = select_bits(above > zero, above, zero);
    const Masks no_below = select_bits(mirrored, in.no_high, in.no_low);
    const Masks no_above = select_bits(mirrored, in.no_low, in.no_high);
    const Lanes over = v * v - 2.0 * g * above;
    const Masks rises = v > zero, arrives = rises & (over > zero) & ~no_above;
    const Lanes root = sqrt(select_bits(arrives, over, v * v + 2.0 * g * below));
    const Masks returns = rises & ~arrives;
    const Lanes way = select_bits(returns, v + root, 2.0 * select_bits(arrives, above, below));
    const Lanes speed = select_bits(returns, g, select_bits(arrives, v + root, root - v));
    const Masks stays = (~arrives & no_below) | ((v == zero) & (g == zero));
    const Lanes time = select_bits(way > zero, way / speed, zero);
    return first_of(select_bits(stays, none, time), arrives ^ mirrored);
}

}  // namespace carom

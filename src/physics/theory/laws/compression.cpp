// The laws of a gas that a moving side squeezes or lets out: isotherm and adiabat through the
// start, whatever moves the side.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "physics/theory/laws/laws.h"

namespace carom::laws {
namespace {

int axis_across(const BoxedGas& gas, const Asked& asked) {
    return gas.box.surfaces.axis_of(asked.surface);
}

bool is_ideal(const BoxedGas& gas, const Asked& asked) {
    return asked.as_points || gas.are_points();
}

// The mean force on the side, divided by the temperature, times the length of the box across it:
// the number of particles of an ideal gas. Nothing if they have no room, or freeze.
std::optional<double> push(const BoxedGas& gas, const Asked& asked, double length) {
    if (is_ideal(gas, asked)) return gas.finite;
    if (gas.box.dimension == 1) {
        const double free = length - 2.0 * gas.particles->radius.sum();
        return free > 0.0 ? std::optional(gas.finite * length / free) : std::nullopt;
    }
    Box box = gas.box;
    box.size[axis_across(gas, asked)] = length;
    const auto force = force_of_fluid(asked.equation, box, *gas.particles, axis_across(gas, asked));
    return force ? std::optional(*force * length) : std::nullopt;
}

// Whether a side may move along another axis.
bool moves_across(const BoxedGas& gas, int axis) {
    const auto sides = gas.box.surfaces.numbered_sides();
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const bool may_move = carom::moves(sides[side]);
        if (may_move && gas.box.surfaces.axis_of(side) != axis) return true;
    }
    return false;
}

// Only of a gas that fills its box, with energy that its motion along all axes shares.
std::optional<NoLaw> why_no_compression(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason =
            first_of(gas, {Why::moving_infinite_mass, Why::partitions, Why::obstacles, Why::gravity,
                           Why::no_finite_mass, Why::fixed_particles}))
        return reason;
    if (gas.influences.bath && gas.influences.bath_temperatures.empty())
        return NoLaw{Why::baths_differ};
    if (!gas.box.surfaces.is_side(asked.surface)) return NoLaw{Why::partitions};
    if (!(gas.energy > 0.0)) return NoLaw{Why::at_rest};
    if (!(gas.freedoms() > 0.0)) return NoLaw{Why::no_freedom};
    if (gas.box.dimension > 1) {
        if (gas.finite == 1.0) return NoLaw{gas.keeps_axes() ? Why::keeps_axes : Why::few};
        if (gas.has_points()) return NoLaw{Why::points};
    }
    if (is_ideal(gas, asked)) return std::nullopt;
    if (gas.box.dimension > 1) {
        if (!are_equal(gas.particles->radius)) return NoLaw{Why::unequal_radii};
        // The form of the box does not follow from the place of one side.
        if (moves_across(gas, axis_across(gas, asked))) return NoLaw{Why::driven};
    }
    const auto start = push(gas, asked, gas.box.length(axis_across(gas, asked)));
    if (!start) return NoLaw{gas.box.dimension == 1 ? Why::no_room : Why::freezes};
    if (gas.box.dimension > 1 && is_few(*start / gas.finite, gas.finite)) return NoLaw{Why::few};
    return std::nullopt;
}

// The logarithm of the temperature over that at the start, at each length. At constant entropy E^(D
// / 2) Q is constant, with D degrees of freedom and the configuration integral Q; the force is T
// d(ln Q)/dL, so that d(ln T) / d(ln L) = -2 / D times the push. For D = d N this is the d(ln T) =
// -2 Z / d d(ln V) of thermodynamics; points in space have T V^(2/3) constant. Integrated from the
// start both ways, by Simpson's rule.
std::vector<double> heating(const BoxedGas& gas, const Asked& asked) {
    constexpr double longest_step = 0.02;  // of ln L
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double start = gas.box.length(axis_across(gas, asked));
    const auto at = [&](double logarithm) {
        return push(gas, asked, start * std::exp(logarithm)).value_or(none);
    };
    std::vector<double> found(asked.lengths.size(), none);
    const auto integrate = [&](std::size_t first, std::size_t end, bool upward) {
        double from = 0.0, sum = 0.0, low = at(0.0);
        for (std::size_t n = 0; n < end - first; ++n) {
            const std::size_t k = upward ? first + n : end - 1 - n;
            const double to = std::log(asked.lengths[k] / start);
            const int steps =
                std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / longest_step)));
            const double step = (to - from) / steps;
            for (int i = 0; i < steps; ++i) {
                const double high = at(from + step * (i + 1));
                sum += step / 6.0 * (low + 4.0 * at(from + step * (i + 0.5)) + high);
                low = high;
            }
            from = to;
            found[k] = -2.0 / gas.freedoms() * sum;
        }
    };
    const auto above = std::ranges::lower_bound(asked.lengths, start);
    const auto split = static_cast<std::size_t>(above - asked.lengths.begin());
    integrate(split, asked.lengths.size(), true);
    integrate(0, split, false);
    return found;
}

// The pressure at a length and a temperature.
double pressure_at(const BoxedGas& gas, const Asked& asked, double length, double temperature) {
    const double side = gas.box.content_across(axis_across(gas, asked));
    const auto found = push(gas, asked, length);
    return found ? *found * temperature / (length * side)
                 : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Law isotherm(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason = why_no_compression(gas, asked)) return none(*reason);
    Law law;
    for (const double length : asked.lengths)
        law.curve.push_back(pressure_at(gas, asked, length, gas.thermal.temperature()));
    law.temperatures = gas.influences.bath_temperatures;
    return law;
}

Law adiabat(const BoxedGas& gas, const Asked& asked) {
    if (const auto reason = why_no_compression(gas, asked)) return none(*reason);
    Law law;
    const std::vector<double> hotter = heating(gas, asked);
    for (std::size_t k = 0; k < hotter.size(); ++k) {
        law.temperatures.push_back(gas.thermal.temperature() * std::exp(hotter[k]));
        law.curve.push_back(pressure_at(gas, asked, asked.lengths[k], law.temperatures[k]));
    }
    return law;
}

}  // namespace carom::laws

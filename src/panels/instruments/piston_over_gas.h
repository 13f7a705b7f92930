// A free piston over a gas, as theory knows it.
#pragma once

#include <optional>

#include "panels/panel.h"
#include "physics/theory/piston_law.h"

namespace carom {

/// The law of a side that moves freely, over an ideal gas with the energy of a run's.
struct PistonOverGas {
    PistonLaw law;
    double mass = 1.0, gas_mass = 1.0;
    /// Of the particles; infinite on a line, where these only exchange velocities.
    double free_path = 0.0;
    double zero = 0.0;       ///< the place where h is 0
    double direction = 1.0;  ///< of h

    void archive(auto& archive) { archive(law, mass, gas_mass, free_path, zero, direction); }

    double mean_place() const { return zero + direction * law.mean(); }
    double density_at(double place) const { return law.density(direction * (place - zero)); }

    /// The period of its slow oscillations. None where the gas weighs so much that it matters how
    /// sound goes through it, and sound does not, as disks fly too far between their collisions.
    std::optional<double> period() const {
        constexpr double light = 0.1, dense = 0.2;
        const bool carries_sound = free_path < dense * law.mean();
        if (!carries_sound && gas_mass > light * mass) return std::nullopt;
        return law.period(mass, gas_mass);
    }
};

/// Whether nothing but the gas and a constant force acts on this surface, a free side, and nothing
/// but it and walls at rest on the gas, which shares its energy: not one disk alone, and not a gas
/// that keeps its momentum between periodic sides.
bool is_over_gas_alone(const PanelContext& context, std::int32_t surface);

/// From the state at the start; none unless is_over_gas_alone().
std::optional<PistonOverGas> piston_over_gas(const PanelContext& context, std::int32_t surface,
                                             const FrameInput& start);

}  // namespace carom

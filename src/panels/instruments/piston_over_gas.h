// A free piston over a gas, as theory knows it.
#pragma once

#include <optional>

#include "panels/panel.h"
#include "physics/theory/piston_law.h"

namespace carom {

/// The law of a side that moves freely, over an ideal gas with the energy of a run's.
struct PistonOverGas {
    PistonLaw law;
    double mass = 1.0;
    double zero = 0.0;       ///< the place where h is 0
    double direction = 1.0;  ///< of h

    void archive(auto& archive) { archive(law, mass, zero, direction); }

    double mean_place() const { return zero + direction * law.mean(); }
    double density_at(double place) const { return law.density(direction * (place - zero)); }
};

/// Whether nothing but the gas and a constant force acts on this surface, a free side, and nothing
/// but it and walls at rest on the gas.
bool is_over_gas_alone(const PanelContext& context, std::int32_t surface);

/// From the state at the start; none unless is_over_gas_alone().
std::optional<PistonOverGas> piston_over_gas(const PanelContext& context, std::int32_t surface,
                                             const FrameInput& start);

}  // namespace carom

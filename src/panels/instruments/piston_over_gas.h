// The theory of a free piston over a gas.
#pragma once

#include <optional>

#include "panels/panel.h"
#include "physics/theory/piston_law.h"

namespace carom {

/// The law of a freely moving side over an ideal gas that has the energy of the run.
struct PistonOverGas {
    PistonLaw law;
    double mass = 1.0, gas_mass = 1.0;
    /// The mean free path of the particles; infinite on a line, where they only exchange
    /// velocities.
    double free_path = 0.0;
    double zero = 0.0;       ///< the place where h is 0
    double direction = 1.0;  ///< of h

    void archive(auto& archive) { archive(law, mass, gas_mass, free_path, zero, direction); }

    double mean_place() const { return zero + direction * law.mean(); }
    double density_at(double place) const { return law.density(direction * (place - zero)); }

    /// The period of the slow oscillations of the piston. None if the gas is so heavy that the
    /// propagation of sound through it matters, but cannot carry sound because the mean free path
    /// is too long.
    std::optional<double> period() const {
        constexpr double light = 0.1, dense = 0.2;
        const bool carries_sound = free_path < dense * law.mean();
        if (!carries_sound && gas_mass > light * mass) return std::nullopt;
        return law.period(mass, gas_mass);
    }
};

/// Returns the law for the state at the start, where there is one (LawOf::piston).
std::optional<PistonOverGas> piston_over_gas(const PanelContext& context, std::int32_t surface,
                                             const FrameInput& start);

}  // namespace carom

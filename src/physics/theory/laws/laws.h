// The laws of each kind, for law() only: each decides for one quantity whether there is a law, and
// gives it. The gas is known: law() has refused a picture without one.
#pragma once

#include <optional>
#include <vector>

#include "physics/theory/law.h"

namespace carom::laws {

using Why = NoLaw::Why;

inline Law none(Why why) { return {.none = NoLaw{why}}; }
inline Law none(const NoLaw& reason) { return {.none = reason}; }
inline Law value(double value) { return {.value = value}; }

inline bool are_equal(const Eigen::ArrayXd& values) { return (values == values[0]).all(); }

/// The particles of finite mass among those asked for.
std::vector<Eigen::Index> members(const BoxedGas& gas, const Asked& asked);

/// Whether theory for many particles errs too much for so few, where interactions make a pressure
/// so many times that of an ideal gas.
bool is_few(double relative_to_ideal, double count);

/// Whether a particle ever moves.
bool moves(const BoxedGas& gas);

/// The temperature that baths alone give the gas: all the same, and nothing else acts.
std::optional<double> bath_temperature(const BoxedGas& gas);

// Energies and velocities (energy.cpp).
Law mean_energy(const BoxedGas& gas, const Asked& asked);
Law mean_speed(const BoxedGas& gas, const Asked& asked);
Law bath(const BoxedGas& gas, const Asked& asked);
Law temperature(const BoxedGas& gas, const Asked& asked);
Law distribution(const BoxedGas& gas, const Asked& asked);
Law side_distribution(const BoxedGas& gas, const Asked& asked);
Law goodness_of_fit(const BoxedGas& gas, const Asked& asked);
Law velocity_entropy(const BoxedGas& gas, const Asked& asked);

// Pressure and places (structure.cpp).
Law ideal_pressure(const BoxedGas& gas, const Asked& asked);
Law pressure(const BoxedGas& gas, const Asked& asked);
Law contact(const BoxedGas& gas, const Asked& asked);
Law position_entropy(const BoxedGas& gas, const Asked& asked);
Law heights(const BoxedGas& gas, const Asked& asked);
Law side_count(const BoxedGas& gas, const Asked& asked);
Law side_energy(const BoxedGas& gas, const Asked& asked);
Law side_temperature(const BoxedGas& gas, const Asked& asked);
Law binomial(const BoxedGas& gas, const Asked& asked);  // galton_board.cpp

// Collisions and paths (motion.cpp).
Law collision_rate(const BoxedGas& gas, const Asked& asked);
Law mean_free_path(const BoxedGas& gas, const Asked& asked);
Law displacement(const BoxedGas& gas, const Asked& asked);
Law diffusion(const BoxedGas& gas, const Asked& asked);
Law autocorrelation(const BoxedGas& gas, const Asked& asked);
Law free_flight(const BoxedGas& gas, const Asked& asked);
Law memoryless(const BoxedGas& gas, const Asked& asked);
Law error_growth(const BoxedGas& gas, const Asked& asked);

// Walls and lines (walls.cpp, compression.cpp).
Law flux(const BoxedGas& gas, const Asked& asked);
Law gap_flux(const BoxedGas& gas, const Asked& asked);
Law piston(const BoxedGas& gas, const Asked& asked);
Law isotherm(const BoxedGas& gas, const Asked& asked);
Law adiabat(const BoxedGas& gas, const Asked& asked);

}  // namespace carom::laws

// What theory knows of a quantity of a gas between its walls: a value, a distribution, or the
// reason why there is none. Panels, captions, checks and reports ask here and decide nothing
// themselves. Nothing is measured here. All functions may be called from any thread.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "physics/run.h"
#include "physics/theory/boxed_gas.h"
#include "physics/theory/equation_of_state.h"
#include "physics/theory/no_law.h"
#include "physics/theory/theory.h"

namespace carom {

struct Gas;

/// The quantities. Means are over time, in the equilibrium that the gas comes to or in the steady
/// state with its walls, and exact for any number of particles unless stated otherwise.
enum class LawOf {
    mean_energy,        ///< kinetic energy of a particle, averaged over those asked for
    mean_speed,         ///< speed of a particle, averaged over those asked for
    bath,               ///< temperature of the heat baths, if all have the same
    temperature,        ///< twice the energy per degree of freedom (ThermalMotion)
    distribution,       ///< of energies, speeds and velocities: Law::equilibrium
    side_distribution,  ///< the same of the particles on one side of a closed partition, Asked::of,
                        ///< with their energy, Asked::thermal
    goodness_of_fit,    ///< the same, where the test of counts against it holds (stats/goodness.h)
    velocity_entropy,   ///< of counts in velocity cells (velocity_entropy.h), with Law::error
    position_entropy,   ///< of counts of independent points in Asked::cells; exact for points
    collision_rate,     ///< collisions per particle and time; an estimate (collision_rate.h)
    mean_free_path,     ///< between collisions of particles; an estimate
    ideal_pressure,     ///< of points with the energy Asked::thermal
    pressure,           ///< of particles with it; of disks and spheres by equations of state
    contact,            ///< pair correlation of equal particles at contact; an estimate
    displacement,  ///< mean squared displacement: holds where it grows as 2 d D t for ever. Where
                   ///< walls bound it there is none, and Law::value is its plateau
    autocorrelation,  ///< initial slope of the velocity autocorrelation: the factor by which
                      ///< finite numbers change the loss of velocity per collision
    free_flight,  ///< exact mean free path of one particle among obstacles (mean_path_of_billiard)
    memoryless,   ///< exponential law of free flights with the measured mean; an idealisation
    flux,         ///< particles, and energy, across a line or plane, in each direction and time
    gap_flux,     ///< through gaps of a partition, from the present state of each side
    side_count,   ///< particles in one of two equal halves, with Law::deviation
    side_energy,  ///< mean energy there
    side_temperature,  ///< temperature there, with Law::deviation
    piston,            ///< place of a free side over an ideal gas (piston_law.h)
    isotherm,          ///< pressure on a side at Asked::lengths, at the temperature of the start:
                       ///< Law::curve, in proportion to the temperature; of disks and spheres
                       ///< by equations of state. Law::temperatures: those at which baths keep
                       ///< the gas in turn
    adiabat,           ///< the same after slow work without heat, with Law::temperatures
    binomial,          ///< places of points that a Galton board sends left or right at each row
                       ///< anew: Law::places and their shares, Law::curve; an idealisation
    heights,           ///< density of an ideal gas along Asked::axis under gravity: Law::curve
    error_growth,      ///< bits that small differences gain per collision; a fit (error_growth.h)
    diffusion,         ///< diffusion coefficient of equal spheres; a fit (collision_rate.h)
};
inline constexpr std::size_t laws_count = static_cast<std::size_t>(LawOf::diffusion) + 1;

/// What a quantity depends on besides the gas.
struct Asked {
    std::optional<std::vector<Eigen::Index>> of = {};  ///< the particles; none: all
    int axis = 0;                                      ///< along which
    std::optional<ThermalMotion> thermal = {};         ///< measured; none: at the start
    std::optional<double> collisions = {};  ///< of each particle until now, with others; none: as
                                            ///< many as it takes
    int cells = 0, cells_up = 1, cells_deep = 1;  ///< of the box along x, y and z; slabs along
                                                  ///< `axis`
    std::int32_t surface = 0;                     ///< a side or a partition
    std::optional<double> at = {};                ///< place of a line or plane across `axis`
    bool is_whole_line = true;                    ///< from wall to wall
    bool ends_at_walls = false;                   ///< free flights
    std::vector<double> lengths = {};             ///< of the box across `surface`, in rising order
    bool as_points = false;  ///< an ideal gas in place of particles that collide
    EquationOfState equation = EquationOfState::accurate;  ///< of disks or spheres
    PhaseOfSpheres phase = PhaseOfSpheres::fluid;          ///< for which a pressure is asked
};

/// What theory knows of a quantity.
struct Law {
    std::optional<NoLaw> none = {};  ///< the reason why there is no law
    double value = std::numeric_limits<double>::quiet_NaN();
    double error = 0.0;      ///< standard error of `value`, where it is computed by sampling
    double deviation = 0.0;  ///< standard deviation of single values about it; 0: unknown
    double energy = std::numeric_limits<double>::quiet_NaN();  ///< carried by a flux
    std::optional<EquilibriumGas> equilibrium = {};
    std::vector<double> curve = {};         ///< NaN where theory ends
    std::vector<double> places = {};        ///< at equal distances
    std::vector<double> temperatures = {};  ///< along an adiabat, or of isotherms

    explicit operator bool() const { return !none; }
};

Law law(const BoxedGas& gas, LawOf quantity, const Asked& asked = {});

/// The same before the particles of a gas are placed, for all of them: the reason why there will be
/// no law. Positions of which not all are listed are assumed to allow one. Returns nothing if there
/// is a law, or if the gas cannot be drawn.
std::optional<NoLaw> why_no_law(const Gas& gas, const Run& run, LawOf quantity,
                                const Asked& asked = {});

}  // namespace carom

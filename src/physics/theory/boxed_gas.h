// A gas in its box at the start of its run, as theory sees it: what acts at its walls, what is
// conserved, and how many particles share it. Everything that decides which laws hold (law.h).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

#include "physics/box.h"
#include "physics/mechanics.h"
#include "physics/particles.h"
#include "physics/run.h"
#include "physics/theory/no_law.h"
#include "physics/theory/theory.h"

namespace carom {

/// What acts on a gas in the course of its run, by its box and by events.
struct Influences {
    bool bath = false, driven = false, piston = false, membrane = false;  ///< at any time
    bool diffuse = false;
    bool partitions = false;  ///< open or closed
    bool divided = false;     ///< by a partition without gaps that no event opens
    bool obstacles = false;
    std::array<bool, 3> gravity{};
    bool wall_event = false;  ///< an event opens, closes, moves or changes a wall
    bool heat_event = false;  ///< an event heats or cools
    bool velocities = false;  ///< an event reverses velocities or displaces a particle
    /// The temperatures that all baths have together, one after the other, each once; empty where
    /// baths differ at one time.
    std::vector<double> bath_temperatures = {};

    bool has_gravity() const { return gravity[0] || gravity[1] || gravity[2]; }
    bool baths_differ() const { return bath && bath_temperatures.size() != 1; }
};

/// Made once from the start of a run. Refers to the particles, which must outlive it. Copies are
/// independent of each other.
struct BoxedGas {
    /// No gas: there is no law for any quantity of it.
    BoxedGas() = default;

    /// `start`: velocities and positions at time 0. Positions that are all 0 are not known yet:
    /// they are taken to allow what other positions allow.
    BoxedGas(const Box& its_box, const std::vector<RunEvent>& events,
             const Particles& its_particles, const Sample& start);

    Box box;
    const Particles* particles = nullptr;  ///< none: no gas
    Influences influences;
    std::array<bool, 3> conserves{};   ///< momentum, along each axis
    double finite = 0.0, fixed = 0.0;  ///< numbers of particles of finite and of infinite mass
    std::optional<std::size_t> moving_infinite_mass;  ///< the species of one
    double mass = 0.0;                                ///< of all finite masses
    double energy = 0.0;                              ///< kinetic, of finite masses
    double falling_energy = 0.0;                      ///< of gravity, from the lowest place of each
    ThermalMotion thermal;
    Vec drift = {};          ///< of the centre of mass, where it is conserved
    bool drifts = false;     ///< more than round-off does
    Vec mean_place = {};     ///< of all particles, at the start
    Sample line;             ///< the start of beads on a line; else empty
    bool is_placed = false;  ///< whether positions are known
    std::optional<NoLaw> no_equilibrium = NoLaw{NoLaw::Why::unknown_gas};
    std::optional<EquilibriumGas> equilibrium;  ///< of all finite masses; none if no_equilibrium

    /// The degrees of freedom of the velocities: d for each finite mass, less the conserved
    /// momenta.
    double freedoms() const { return thermal.degrees_of_freedom; }
    bool conserves_all() const { return conserved() == box.dimension; }
    bool conserves_some() const { return conserved() > 0.0 && !conserves_all(); }
    /// The number of axes along which momentum is conserved.
    double conserved() const {
        return double(conserves[0]) + double(conserves[1]) + double(conserves[2]);
    }
    /// Whether momentum is conserved along an axis other than this one.
    bool conserves_across(int axis) const {
        return conserved() > (conserves.at(static_cast<std::size_t>(axis)) ? 1.0 : 0.0);
    }
    /// Whether it is a single particle that keeps the energy of its motion along each axis, which
    /// diffuse walls would mix.
    bool keeps_axes() const { return finite == 1.0 && box.dimension > 1 && !influences.diffuse; }
    /// Whether a particle has more than walls to collide with.
    bool has_partner() const { return finite + fixed > 1.0 || influences.obstacles; }
    bool are_points() const { return (particles->radius == 0.0).all(); }  ///< all of them
    bool has_points() const { return !(particles->radius > 0.0).all(); }  ///< some of them
};

/// The first of these reasons that holds for a gas, by what acts on it and of what it consists; the
/// first group of NoLaw::Why, without `reversal`, and `no_finite_mass`. Throws std::logic_error for
/// other reasons.
std::optional<NoLaw> first_of(const BoxedGas& gas, std::initializer_list<NoLaw::Why> reasons);

/// Why the energy of the particles is not constant and shared by all in a box with nothing but
/// reflecting or periodic sides; nothing if it is.
std::optional<NoLaw> why_not_isolated(const BoxedGas& gas);

/// An equilibrium for only those of its particles that are listed by number; nothing if none of
/// these has a finite mass.
std::optional<EquilibriumGas> among(const EquilibriumGas& gas, const Particles& particles,
                                    const std::vector<Eigen::Index>& chosen);

}  // namespace carom

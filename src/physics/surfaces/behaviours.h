// How a side of the box or a partition acts on a particle that hits it, as plain values, and what
// several parts of the program ask about it. Every question is answered for each alternative by a
// visit without a generic function, so that a new alternative does not compile until all of them
// are; questions of one place are visited there. Which alternative a behaviour is, is asked only
// here. All functions may be called from any thread.
#pragma once

#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "util/overloaded.h"

namespace carom {

/// Reflects specularly: reverses the normal component of the velocity.
struct Reflecting {};

/// A heat bath. A particle leaves it as if it came from a gas of this temperature: the normal
/// velocity v has the distribution of the flux, (v m / T) exp(-m v^2 / 2T); each component
/// along the wall is normally distributed.
struct Bath {
    double temperature = 1.0;
};

/// Moves along its normal at a prescribed velocity, unaffected by collisions; from `until` on it
/// stands still.
struct Driven {
    double velocity = 0.0;
    double until = std::numeric_limits<double>::infinity();

    double velocity_at(double time) const { return time < until ? velocity : 0.0; }
};

/// Moves freely along its normal, driven by particle impacts and a constant force.
struct Piston {
    double mass = 1.0;
    double force = 0.0;     ///< signed, along its normal
    double velocity = 0.0;  ///< at the start

    /// The total constant force on the piston, if gravity has the component `gravity` along its
    /// normal.
    double force_in(double gravity) const { return force + mass * gravity; }
    double kinetic_energy(double its_velocity) const {
        return 0.5 * mass * its_velocity * its_velocity;
    }
    /// Potential energy in the constant forces on the piston.
    double potential_energy(double place, double gravity) const {
        return -force_in(gravity) * place;
    }
};

/// Lets particles through or reflects them. Particles of the listed species always pass; others
/// pass in a given direction if their speed lies between the two bounds for that direction.
struct Membrane {
    struct Speeds {
        double faster_than = std::numeric_limits<double>::infinity();
        double slower_than = std::numeric_limits<double>::infinity();
        bool admits(double speed) const { return speed > faster_than && speed < slower_than; }
        bool admits_some() const { return faster_than < slower_than; }
    };
    std::vector<std::int32_t> species = {};  ///< indices into Gas::species
    Speeds upward = {};                      ///< for particles that move towards larger x, y or z
    Speeds downward = {};

    /// Whether it selects particles by speed, like Maxwell's demon.
    bool is_demon() const { return upward.admits_some() || downward.admits_some(); }
};

/// Reflects diffusely: a particle keeps its speed and leaves in a random direction by the cosine
/// law: its angle to the normal has the density cos(angle) / 2 in the plane, and 2 sin(angle)
/// cos(angle) in space. Stands still; not on a line.
struct Diffuse {};

using Behaviour = std::variant<Reflecting, Bath, Driven, Piston, Membrane, Diffuse>;

/// Whether it is a wall at rest that reflects specularly, and nothing else.
inline bool only_reflects(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return true; }, [](const Bath&) { return false; },
                   [](const Driven&) { return false; }, [](const Piston&) { return false; },
                   [](const Membrane&) { return false; }, [](const Diffuse&) { return false; }},
        behaviour);
}

/// Whether it moves.
inline bool moves(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return false; }, [](const Bath&) { return false; },
                   [](const Driven&) { return true; }, [](const Piston&) { return true; },
                   [](const Membrane&) { return false; }, [](const Diffuse&) { return false; }},
        behaviour);
}

/// The velocity along its normal with which it begins to act at a time.
inline double velocity_from(const Behaviour& behaviour, double time) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return 0.0; }, [](const Bath&) { return 0.0; },
                   [&](const Driven& driven) { return driven.velocity_at(time); },
                   [](const Piston& piston) { return piston.velocity; },
                   [](const Membrane&) { return 0.0; }, [](const Diffuse&) { return 0.0; }},
        behaviour);
}

/// Whether it is smooth: a particle keeps the component of its velocity along it.
inline bool is_smooth(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return true; }, [](const Bath&) { return false; },
                   [](const Driven&) { return true; }, [](const Piston&) { return true; },
                   [](const Membrane&) { return true; }, [](const Diffuse&) { return false; }},
        behaviour);
}

/// Whether a particle leaves it in a random direction, which does not show how it came.
inline bool is_random(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return false; }, [](const Bath&) { return true; },
                   [](const Driven&) { return false; }, [](const Piston&) { return false; },
                   [](const Membrane&) { return false; }, [](const Diffuse&) { return true; }},
        behaviour);
}

/// Whether it reflects all particles at their own speed: nothing passes it, and no energy is
/// exchanged.
inline bool is_elastic(const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[](const Reflecting&) { return true; }, [](const Bath&) { return false; },
                   [](const Driven&) { return false; }, [](const Piston&) { return false; },
                   [](const Membrane&) { return false; }, [](const Diffuse&) { return true; }},
        behaviour);
}

// The values of one alternative, for what only this one has; null for all others.
inline const Bath* bath_of(const Behaviour& behaviour) { return std::get_if<Bath>(&behaviour); }
inline const Driven* driven_of(const Behaviour& behaviour) {
    return std::get_if<Driven>(&behaviour);
}
inline const Piston* piston_of(const Behaviour& behaviour) {
    return std::get_if<Piston>(&behaviour);
}
inline const Membrane* membrane_of(const Behaviour& behaviour) {
    return std::get_if<Membrane>(&behaviour);
}

}  // namespace carom

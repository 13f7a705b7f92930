// The gas as plain values: its box (box.h), and the species with their rules for radius, mass,
// velocity and position. The particles themselves (particles.h) are drawn from these rules by
// place(). All quantities are in reduced units: length, mass and time in units of the user's
// choice, with Boltzmann's constant = 1.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "physics/box.h"
#include "physics/temperature.h"
#include "physics/value_rule.h"
#include "physics/vec.h"

namespace carom {

struct Infinite {};
struct Density {
    ValueRule value;  ///< mass = density * 4/3 pi r^3 in 3-D, pi r^2 in 2-D, 2 r in 1-D
};
using MassRule = std::variant<ValueRule, Density, Infinite>;

struct AtRest {};
struct Speed {
    ValueRule value;  ///< in random directions, uniform on the circle or on the sphere
};
struct Velocity {
    std::vector<Vec> values;  ///< one for all, or one for each particle
};
using VelocityRule = std::variant<AtRest, Speed, Velocity, Temperature>;

struct RandomPlaces {};
/// On a hexagonal lattice in 2-D, on a face-centred cubic one in 3-D, evenly spread in 1-D.
struct LatticePlaces {};
struct WithinRegion {
    Region region;  ///< random positions with the particles entirely inside the region
};
struct Places {
    std::vector<Vec> values;  ///< one for each particle
};
using PositionRule = std::variant<RandomPlaces, LatticePlaces, WithinRegion, Places>;

struct Species {
    std::string name;
    std::int64_t count = 0;
    ValueRule radius = 0.5;
    MassRule mass = ValueRule{1.0};
    VelocityRule velocity = AtRest{};
    PositionRule position = RandomPlaces{};
};

struct Gas {
    Box box;
    std::vector<Species> species;
    std::uint64_t seed = 1;
};

}  // namespace carom

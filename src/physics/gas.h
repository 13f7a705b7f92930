// The gas as plain values: the box, its walls, and the species with their rules for radius, mass,
// velocity and position. The particles themselves (particles.h) are drawn from these rules by
// place(). All quantities are in reduced units: length, mass and time in units of the user's
// choice, with Boltzmann's constant = 1.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/surface.h"

namespace carom {

enum class Wall { solid, periodic };

/// The box [0, size_x] x [0, size_y], or the line [0, size_x] when `dimension` is 1.
struct Box {
    int dimension = 2;
    Eigen::Array2d size{0.0, 0.0};
    std::array<Wall, 2> walls{Wall::solid, Wall::solid};  ///< the pair of sides perpendicular to x,
                                                          ///< and to y
    Surfaces surfaces = {};  ///< behaviour of the sides, partitions, obstacles, gravity

    bool is_periodic(std::integral auto axis) const {
        return walls[static_cast<std::size_t>(axis)] == Wall::periodic;
    }

    /// Its size along an axis.
    double length(std::integral auto axis) const { return size[static_cast<Eigen::Index>(axis)]; }

    /// Whether the box has this side, partition or obstacle: a line has no bottom and no top.
    bool has_surface(std::integral auto surface) const {
        return dimension == 2 || std::cmp_less(surface, 2);
    }
    /// Initial position of a side or a partition on the axis that it is perpendicular to.
    double place_of(std::integral auto surface) const {
        const Partition* line = surfaces.partition(surface);
        if (line != nullptr) return line->at;
        return Surfaces::is_far_side(surface) ? length(surface / 2) : 0.0;
    }

    /// Wraps a coordinate into [0, length) on a periodic axis; otherwise returns it unchanged.
    double wrapped(std::integral auto axis, double x) const {
        if (!is_periodic(axis)) return x;
        const double inside = x - length(axis) * std::floor(x / length(axis));
        return inside < length(axis) ? inside : 0.0;
    }

    /// The number of box lengths to subtract from a separation along an axis to get that of the
    /// nearest images; 0 if the axis is not periodic.
    double turns(std::integral auto axis, double separation) const {
        return is_periodic(axis) ? std::round(separation / length(axis)) : 0.0;
    }

    /// Minimum-image convention: the shortest vector between two points that are `separation`
    /// apart, across periodic sides where there are any. Nearest images are computed only here and
    /// in turns(), except in the contact search, which handles several pairs at once
    /// (plane/contact_search.h).
    Eigen::Array2d nearest(const Eigen::Array2d& separation) const {
        return {separation[0] - size[0] * turns(0, separation[0]),
                separation[1] - size[1] * turns(1, separation[1])};
    }
};

struct UniformDistribution {
    double low, high;
};
struct NormalDistribution {
    double mean, deviation;
};
/// One number for all, one for each particle, or a distribution to draw from.
using Quantity = std::variant<double, std::vector<double>, UniformDistribution, NormalDistribution>;

struct Infinite {};
struct Density {
    Quantity value;  ///< mass = density * pi r^2 in 2-D, density * 2 r in 1-D
};
using MassRule = std::variant<Quantity, Density, Infinite>;

struct AtRest {};
struct Speed {
    Quantity value;  ///< in random directions
};
struct Velocity {
    std::vector<Eigen::Array2d> values;  ///< one for all, or one for each particle; y is 0 in 1-D
};
struct Temperature {
    double value;           ///< each component is normally distributed with variance T/m
    bool is_exact = false;  ///< rescaled so that thermal_motion() of the species gives exactly this
                            ///< value
};
using VelocityRule = std::variant<AtRest, Speed, Velocity, Temperature>;

struct Region {
    Eigen::Array2d low, high;
};
struct RandomPlaces {};
struct LatticePlaces {};
struct WithinRegion {
    Region region;  ///< random positions with the disks entirely inside the region
};
struct Places {
    std::vector<Eigen::Array2d> values;  ///< one for each particle
};
using PositionRule = std::variant<RandomPlaces, LatticePlaces, WithinRegion, Places>;

struct Species {
    std::string name;
    std::int64_t count = 0;
    Quantity radius = 0.5;
    MassRule mass = Quantity{1.0};
    VelocityRule velocity = AtRest{};
    PositionRule position = RandomPlaces{};
};

struct Gas {
    Box box;
    std::vector<Species> species;
    std::uint64_t seed = 1;
};

}  // namespace carom

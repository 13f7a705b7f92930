// The surfaces of a box, as plain values: the sides of the box, partitions across it and obstacles
// in it, and how each acts on a particle that hits it. The simulation numbers all surfaces
// consecutively: the sides left, right, bottom, top, then the partitions, then the obstacles.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "physics/surfaces/behaviours.h"
#include "physics/vec.h"

namespace carom {

/// An opening in a partition: an interval in the plane, a rectangle in space.
struct Gap {
    /// Its lower and upper ends along the axes that the partition is not perpendicular to, in the
    /// order x, y, z; the second is used in space only.
    std::array<double, 2> low{}, high{};

    Gap() = default;
    Gap(double from, double to) : low{from}, high{to} {}
    Gap(const std::array<double, 2>& from, const std::array<double, 2>& to) : low(from), high(to) {}

    double from() const { return low[0]; }
    double to() const { return high[0]; }
    /// The largest of its widths along these axes.
    double widest(int dimension) const {
        return dimension < 3 ? to() - from() : std::max(to() - from(), high[1] - low[1]);
    }
    /// How much of its partition it opens, if all its edges are moved inwards by a distance: a
    /// length in the plane, an area in space.
    double extent(int dimension, double inset = 0.0) const {
        const double first = to() - from() - 2.0 * inset, second = high[1] - low[1] - 2.0 * inset;
        if (!(first > 0.0)) return 0.0;
        return dimension < 3 ? first : second > 0.0 ? first * second : 0.0;
    }

    friend bool operator==(const Gap&, const Gap&) = default;

    template <class Archive>
    void archive(Archive& archive) {
        archive(low, high);
    }
};

/// A straight line across the box or, in space, a plane, perpendicular to an axis. It has two sides
/// and no thickness.
struct Partition {
    std::string name;
    int axis = 0;                ///< the axis it is perpendicular to: 0 for x, 1 for y, 2 for z
    double at = 0.0;             ///< position on that axis
    std::vector<Gap> gaps = {};  ///< in the plane in ascending order; they do not overlap
    Behaviour behaviour = Reflecting{};
    bool is_open = false;  ///< absent: everything passes
};

/// A fixed body. In the plane: a disk, or straight lines from corner to corner, each of which has
/// two sides. In space: a sphere, or a cuboid with edges along the axes.
struct Obstacle {
    struct Ball {
        Vec center;
        double radius;
    };
    struct Lines {
        std::vector<Vec> corners;
        bool is_closed = false;  ///< the last corner is joined to the first
    };
    struct Cuboid {
        Vec low, high;
    };
    std::string name;
    std::variant<Ball, Lines, Cuboid> shape;
};

/// All surfaces of a box, and the gravitational acceleration of everything mobile in it.
struct Surfaces {
    std::array<Behaviour, 6> sides{};  ///< left, right, bottom, top, back, front; unused beyond
                                       ///< side_count, and along periodic axes
    std::int32_t side_count = 4;       ///< that have numbers: 6 in space
    std::vector<Partition> partitions = {};
    std::vector<Obstacle> obstacles = {};
    Vec gravity = {};
    std::uint64_t seed = 1;  ///< for the velocities after a heat bath; in a gas, Gas::seed is used

    /// The sides that have numbers.
    std::span<const Behaviour> numbered_sides() const {
        return std::span(sides).first(static_cast<std::size_t>(side_count));
    }

    /// Numbers of the first partition and of the first obstacle among all surfaces, and the total
    /// number of surfaces.
    std::int32_t first_partition() const { return side_count; }
    std::int32_t first_obstacle() const {
        return first_partition() + static_cast<std::int32_t>(partitions.size());
    }
    std::int32_t count() const {
        return first_obstacle() + static_cast<std::int32_t>(obstacles.size());
    }

    bool is_side(std::integral auto surface) const { return std::cmp_less(surface, side_count); }
    /// The partition with this number; null for sides and obstacles.
    const Partition* partition(std::integral auto surface) const {
        if (is_side(surface) || std::cmp_greater_equal(surface, first_obstacle())) return nullptr;
        return &partitions[static_cast<std::size_t>(surface - side_count)];
    }

    /// The axis that a side or a partition is perpendicular to: 0 for x, 1 for y, 2 for z.
    int axis_of(std::integral auto surface) const {
        const Partition* line = partition(surface);
        return line != nullptr ? line->axis : static_cast<int>(surface / 2);
    }
    /// Whether the surface is the side at the upper end of its axis: right, top or front.
    bool is_far_side(std::integral auto surface) const {
        return is_side(surface) && surface % 2 == 1;
    }

    /// The names of all surfaces in the order of their numbers; the sides are called left, right,
    /// bottom, top, back and front.
    std::vector<std::string> names() const {
        std::vector<std::string> all{"left", "right", "bottom", "top", "back", "front"};
        all.resize(static_cast<std::size_t>(side_count));
        for (const Partition& partition : partitions) all.push_back(partition.name);
        for (const Obstacle& obstacle : obstacles) all.push_back(obstacle.name);
        return all;
    }

    /// Whether all sides only reflect.
    bool sides_reflect() const { return std::ranges::all_of(sides, only_reflects); }
    bool has_gravity() const { return gravity != Vec(); }
    /// Whether the box has only reflecting sides: no partitions, no obstacles and no gravity.
    bool are_plain() const {
        return sides_reflect() && partitions.empty() && obstacles.empty() && !has_gravity();
    }
};

/// What a surface has done since t = 0.
struct SurfaceTotals {
    std::int64_t hits = 0;
    Vec impulse = {};   ///< momentum transferred to the surface
    double work = 0.0;  ///< done on particles by the moving surface
    double heat = 0.0;  ///< given to particles by a heat bath
};

/// The totals of a surface together with its present state.
struct SurfaceState : SurfaceTotals {
    struct Motion {
        double place, velocity;  ///< along its normal
    };
    Behaviour behaviour = Reflecting{};  ///< may be changed by events of the run
    bool is_open = false;                ///< an open partition is absent
    bool is_held = false;                ///< a piston that stands still
    std::optional<Motion> motion = {};   ///< set if the surface moves or has ever moved
};

/// Energy balance of a gas in a box with surfaces: the energies at present, and the work and heat
/// received since t = 0. Without numerical error kinetic + potential + pistons grows by work +
/// heat.
struct EnergyAccount {
    double kinetic = 0.0;    ///< of the particles
    double potential = 0.0;  ///< of the particles in gravity, relative to the lowest position that
                             ///< each centre can reach; and of the constant forces on pistons,
                             ///< minus force times position
    double pistons = 0.0;    ///< kinetic energy of pistons
    double work = 0.0;       ///< of driven surfaces on the gas and on pistons
    double heat = 0.0;       ///< from baths, and by events that heat
    /// Numerical error of the energy balance relative to its largest term. Unset if an infinite
    /// mass moves or gravity acts on one: its energy, and the energy that it gives to others, are
    /// not included in any of the sums.
    std::optional<double> relative_error = 0.0;

    /// Total energy of the gas and the pistons.
    double in_all() const { return kinetic + potential + pistons; }
};

}  // namespace carom

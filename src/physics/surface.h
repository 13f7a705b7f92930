// What particles meet in a box besides one another, as plain values: the sides of the box,
// partitions across it and obstacles in it, and what each does to a particle that reaches it. The
// simulation numbers them in one list: the sides left, right, bottom, top, then partitions, then
// obstacles.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace carom {

/// Reverses the velocity along its normal.
struct Reflecting {};

/// A heat bath. A particle leaves it as from a gas of this temperature: the velocity along the
/// normal has the distribution of the flux, (v m / T) exp(-m v^2 / 2T), the other is normal.
struct Bath {
    double temperature = 1.0;
};

/// Moves along its normal at a given velocity, whatever hits it; after `until` it stands still.
struct Driven {
    double velocity = 0.0;
    double until = std::numeric_limits<double>::infinity();

    double velocity_at(double time) const { return time < until ? velocity : 0.0; }
};

/// Moves freely along its normal, pushed by a constant force besides what hits it.
struct Piston {
    double mass = 1.0;
    double force = 0.0;     ///< along x or y
    double velocity = 0.0;  ///< at the start

    /// With all that pushes it, where gravity has this component along its normal.
    double force_in(double gravity) const { return force + mass * gravity; }
    double kinetic_energy(double its_velocity) const {
        return 0.5 * mass * its_velocity * its_velocity;
    }
    /// In the constant forces on it.
    double potential_energy(double place, double gravity) const {
        return -force_in(gravity) * place;
    }
};

/// Lets particles through, or reflects them: those of some species always; the others to one side
/// where their speed lies between two bounds.
struct Membrane {
    struct Speeds {
        double faster_than = std::numeric_limits<double>::infinity();
        double slower_than = std::numeric_limits<double>::infinity();
        bool admits(double speed) const { return speed > faster_than && speed < slower_than; }
        bool admits_some() const { return faster_than < slower_than; }
    };
    std::vector<std::int32_t> species = {};  ///< indices into Gas::species
    Speeds upward = {};                      ///< of those that move to larger x, or y
    Speeds downward = {};

    /// Whether it lets some through by their speed, as Maxwell's demon does.
    bool is_demon() const { return upward.admits_some() || downward.admits_some(); }
};

using Behaviour = std::variant<Reflecting, Bath, Driven, Piston, Membrane>;

/// A straight line across the box, perpendicular to an axis. It has two sides and no thickness.
struct Partition {
    std::string name;
    int axis = 0;     ///< that it is perpendicular to: 0 for x, 1 for y
    double at = 0.0;  ///< its place on that axis
    std::vector<std::pair<double, double>> gaps = {};  ///< along the other axis, from and to
    Behaviour behaviour = Reflecting{};
    bool is_open = false;  ///< not there
};

/// A fixed body: a disk, or straight lines from corner to corner, each of which has two sides.
struct Obstacle {
    struct Disk {
        Eigen::Array2d center;
        double radius;
    };
    struct Lines {
        std::vector<Eigen::Array2d> corners;
        bool is_closed = false;  ///< the last is joined to the first
    };
    std::string name;
    std::variant<Disk, Lines> shape;
};

/// All surfaces of a box, and the acceleration of all that can move in it.
struct Surfaces {
    std::array<Behaviour, 4> sides{};  ///< left, right, bottom, top; where the box is not periodic
    std::vector<Partition> partitions = {};
    std::vector<Obstacle> obstacles = {};
    Eigen::Array2d gravity{0.0, 0.0};
    std::uint64_t seed = 1;  ///< of the velocities that baths give; in a gas, Gas::seed counts

    /// The number of the first partition, and of the first obstacle, among all surfaces; how many
    /// there are.
    static constexpr std::int32_t first_partition = 4;
    std::int32_t first_obstacle() const {
        return first_partition + static_cast<std::int32_t>(partitions.size());
    }
    std::int32_t count() const {
        return first_obstacle() + static_cast<std::int32_t>(obstacles.size());
    }

    static bool is_side(std::integral auto surface) {
        return std::cmp_less(surface, first_partition);
    }
    /// The partition with this number; null for sides and obstacles.
    const Partition* partition(std::integral auto surface) const {
        if (is_side(surface) || std::cmp_greater_equal(surface, first_obstacle())) return nullptr;
        return &partitions[static_cast<std::size_t>(surface) - first_partition];
    }

    /// The axis that a side or a partition is perpendicular to: 0 for x, 1 for y.
    int axis_of(std::integral auto surface) const {
        const Partition* line = partition(surface);
        return line != nullptr ? line->axis : static_cast<int>(surface / 2);
    }
    /// Whether it is a side at the end of its axis, not at the beginning: right or top.
    static bool is_far_side(std::integral auto surface) {
        return is_side(surface) && surface % 2 == 1;
    }

    /// The names of all surfaces, by their numbers; those of the sides are left, right, bottom and
    /// top.
    std::vector<std::string> names() const {
        std::vector<std::string> all{"left", "right", "bottom", "top"};
        for (const Partition& partition : partitions) all.push_back(partition.name);
        for (const Obstacle& obstacle : obstacles) all.push_back(obstacle.name);
        return all;
    }

    /// Whether all sides only reflect.
    bool sides_reflect() const {
        return std::ranges::all_of(
            sides, [](const Behaviour& side) { return std::holds_alternative<Reflecting>(side); });
    }
    /// Whether there is nothing but reflecting sides.
    bool are_plain() const {
        return sides_reflect() && partitions.empty() && obstacles.empty() && (gravity == 0.0).all();
    }
};

/// What a surface has done since t = 0.
struct SurfaceTotals {
    std::int64_t hits = 0;
    Eigen::Array2d impulse{0.0, 0.0};  ///< given to it
    double work = 0.0;                 ///< that it did on particles as it moved
    double heat = 0.0;                 ///< that it gave to particles
};

/// The same, and what a surface is like at present.
struct SurfaceState : SurfaceTotals {
    struct Motion {
        double place, velocity;  ///< along its normal
    };
    Behaviour behaviour = Reflecting{};  ///< which events of the run change
    bool is_open = false;                ///< a partition that is not there
    bool is_held = false;                ///< a piston that stands still
    std::optional<Motion> motion = {};   ///< of one that moves, or has moved
};

/// Where the energy of a gas in a box with surfaces is, and what has come in since t = 0. Without
/// error kinetic + potential + pistons grows by work + heat.
struct EnergyAccount {
    double kinetic = 0.0;    ///< of the particles
    double potential = 0.0;  ///< in gravity, of centres above the lowest that each can reach; and
                             ///< of the constant forces on pistons, minus force times place
    double pistons = 0.0;    ///< kinetic energy of pistons
    double work = 0.0;       ///< of driven surfaces on the gas and on pistons
    double heat = 0.0;       ///< from baths, and by events that heat
    /// Of the sum, in units of the largest of its terms; none where an infinite mass moves, or
    /// gravity pulls at one: its energy, and what it gives to others, are in no sum.
    std::optional<double> relative_error = 0.0;

    /// What is in the gas and in pistons.
    double in_all() const { return kinetic + potential + pistons; }
};

}  // namespace carom

#include "physics/theory/equation_of_state.h"

#include <array>
#include <cmath>
#include <numbers>

#include "physics/placement/members.h"

namespace carom {
namespace {

using std::numbers::pi;

// Z = sum of c x^power over these terms, where x = eta / (1 - eta).
double kolafa_rottner(double packing_fraction) {
    constexpr std::array<double, 13> coefficients{
        1.0,           2.0,          1.12801775,    0.00181895291,  -0.0526134737, 0.0504960168,
        -0.0325537792, 0.0134578632, 0.00140888182, -0.00834273601, 0.00694127367, -0.00262254723,
        0.000355746352};
    const double x = packing_fraction / (1.0 - packing_fraction);
    double sum = 0.0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * x + *c;
    return sum - 5.24672938e-9 * std::pow(x, 22) + 5.88054639e-23 * std::pow(x, 57);
}

// A fluid of disks; lengths are in units of the diameter and energies in units of the temperature.
struct Fluid {
    EquationOfState equation;
    double density;

    double packing_fraction() const { return 0.25 * pi * density; }
    double pressure() const {
        return density * compressibility_factor(equation, packing_fraction());
    }
    double tension() const {
        const double free = 1.0 - packing_fraction();
        return -0.5 * density * packing_fraction() / (free * free);
    }
    // Excess number of particles per length of wall, relative to the fluid density up to the line
    // that the centres can reach.
    double adsorbed() const {
        constexpr double step = 1e-5;  // relative: derivatives are good to its square
        const Fluid less{equation, density * (1.0 - step)}, more{equation, density * (1.0 + step)};
        return -density * (more.tension() - less.tension()) / (more.pressure() - less.pressure());
    }
};

// The area accessible to the centres, in units of the diameter, and its walls.
struct Room {
    Vec reach = {};
    std::array<bool, 2> has_walls{};  // at the ends of this axis

    double area() const { return reach[0] * reach[1]; }
    double perimeter() const {
        return (has_walls[0] ? 2.0 * reach[1] : 0.0) + (has_walls[1] ? 2.0 * reach[0] : 0.0);
    }
};

// The fluid of which `count` disks fill the accessible area and the walls; nothing if it would
// freeze.
std::optional<Fluid> fluid_of(EquationOfState equation, const Room& room, double count) {
    const auto held = [&](double density) {
        const Fluid fluid{equation, density};
        return density * room.area() + room.perimeter() * fluid.adsorbed();
    };
    double low = 0.0, high = largest_packing_of_fluid * 4.0 / pi;
    if (held(high) < count) return std::nullopt;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (held(middle) < count ? low : high) = middle;
    }
    return Fluid{equation, 0.5 * (low + high)};
}

// The fluid that disks of one radius form between their walls; nothing for other particles.
struct Filled {
    double diameter;
    Room room;
    Fluid fluid;

    /// On a wall across an axis, or through a line across a periodic one.
    double force(int axis) const {
        const int other = 1 - axis;
        const bool has_ends = room.has_walls[static_cast<std::size_t>(other)];
        return fluid.pressure() * room.reach[other] - (has_ends ? 2.0 * fluid.tension() : 0.0);
    }
};

std::optional<Filled> filled(EquationOfState equation, const Box& box, const Particles& particles) {
    const auto count = static_cast<double>(particles.count());
    if (box.dimension != 2 || count == 0.0 || !(particles.inverse_mass > 0.0).all())
        return std::nullopt;
    const double diameter = 2.0 * particles.radius[0];
    if (!(diameter > 0.0) || (particles.radius != particles.radius[0]).any()) return std::nullopt;
    Room room;
    for (int axis = 0; axis < 2; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        room.has_walls[a] = !box.is_periodic(axis);
        room.reach[axis] = (box.size[axis] - (room.has_walls[a] ? diameter : 0.0)) / diameter;
    }
    if (!(room.reach[0] > 0.0) || !(room.reach[1] > 0.0)) return std::nullopt;
    const std::optional<Fluid> fluid = fluid_of(equation, room, count);
    return fluid ? std::optional(Filled{diameter, room, *fluid}) : std::nullopt;
}

}  // namespace

double compressibility_factor(EquationOfState equation, double packing_fraction) {
    if (equation == EquationOfState::kolafa_rottner) return kolafa_rottner(packing_fraction);
    const double free = 1.0 - packing_fraction;
    return (1.0 + packing_fraction * packing_fraction / 8.0) / (free * free);
}

double relative_compressibility(EquationOfState equation, double packing_fraction) {
    if (packing_fraction == 0.0) return 1.0;
    constexpr double step = 1e-5;  // relative: the derivative is good to its square
    const auto pressure = [&](double packing) {
        return packing * compressibility_factor(equation, packing);
    };
    const double low = packing_fraction * (1.0 - step), high = packing_fraction * (1.0 + step);
    return (high - low) / (pressure(high) - pressure(low));
}

double pressure_of_points(const Box& box, double thermal_energy) {
    return 2.0 * thermal_energy / (box.dimension * box.content());
}

std::optional<double> pressure_of_disks(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal) {
    if (!(thermal.degrees_of_freedom > 0.0)) return std::nullopt;
    const std::optional<Filled> gas = filled(equation, box, particles);
    if (!gas) return std::nullopt;
    const auto count = static_cast<double>(particles.count());

    // The force on the two walls across each axis divided by their length; without walls the bulk
    // pressure.
    double force = 0.0, length = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        if (!gas->room.has_walls[static_cast<std::size_t>(axis)]) continue;
        force += gas->force(axis);
        length += box.size[1 - axis] / gas->diameter;
    }
    const double in_units = length > 0.0 ? force / length : gas->fluid.pressure();
    // Where momentum is conserved, the thermal energy is less than that of N particles at this
    // temperature.
    const double temperature = thermal.temperature();
    const double missing = count * temperature - thermal.energy;
    return temperature * in_units / (gas->diameter * gas->diameter) -
           missing / (box.size[0] * box.size[1]);
}

std::optional<double> force_of_disks(EquationOfState equation, const Box& box,
                                     const Particles& particles, int axis) {
    const std::optional<Filled> gas = filled(equation, box, particles);
    return gas ? std::optional(gas->force(axis) / gas->diameter) : std::nullopt;
}

std::optional<double> pressure_of_rods(const Box& box, const Particles& particles,
                                       const ThermalMotion& thermal) {
    if (box.dimension != 1 || !(particles.inverse_mass > 0.0).all()) return std::nullopt;
    const double free = box.size[0] - 2.0 * particles.radius.sum();
    if (!(free > 0.0) || particles.count() == 0) return std::nullopt;
    return 2.0 * thermal.energy / free;
}

}  // namespace carom

#include "physics/theory/equation_of_state.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "physics/placement/members.h"
#include "physics/theory/collision_rate.h"

namespace carom {
namespace {

using std::numbers::pi;

double polynomial(std::span<const double> coefficients, double x) {
    double sum = 0.0;
    for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * x + coefficients[k];
    return sum;
}

// Z = sum of c x^power over these terms, where x = eta / (1 - eta).
double kolafa_rottner(double packing_fraction) {
    constexpr std::array<double, 13> coefficients{
        1.0,           2.0,          1.12801775,    0.00181895291,  -0.0526134737, 0.0504960168,
        -0.0325537792, 0.0134578632, 0.00140888182, -0.00834273601, 0.00694127367, -0.00262254723,
        0.000355746352};
    const double x = packing_fraction / (1.0 - packing_fraction);
    return polynomial(coefficients, x) - 5.24672938e-9 * std::pow(x, 22) +
           5.88054639e-23 * std::pow(x, 57);
}

// The same in space.
double kolafa_labik_malijevsky(double packing_fraction) {
    constexpr std::array<double, 15> coefficients{
        1.0,         4.0, 6.0,         2.3647684, -0.8698551, 1.1062803, -1.1014221, 0.66605866,
        -0.03633431, 0.0, -0.20965164, 0.0,       0.0,        0.0,       0.10555569};
    const double x = packing_fraction / (1.0 - packing_fraction);
    return polynomial(coefficients, x) - 0.0087238 * std::pow(x, 22);
}

double henderson(double packing_fraction) {
    const double free = 1.0 - packing_fraction;
    return (1.0 + packing_fraction * packing_fraction / 8.0) / (free * free);
}

double carnahan_starling(double packing_fraction) {
    const double eta = packing_fraction, free = 1.0 - eta;
    return (1.0 + eta * (1.0 + eta * (1.0 - eta))) / (free * free * free);
}

// Of a crystal whose density is this part of that of close packing.
double speedy(double density) {
    return 3.0 / (1.0 - density) - 0.5921 * (density - 0.7072) / (density - 0.601);
}

// A fluid of disks or spheres; lengths are in units of the diameter and energies in units of the
// temperature.
struct Fluid {
    int dimension;
    EquationOfState equation;
    double density;

    double packing_fraction() const { return content_of_ball(0.5, dimension) * density; }
    static double largest_density(int dimension) {
        return largest_packing_of_fluid(dimension) / content_of_ball(0.5, dimension);
    }
    double pressure() const {
        return density * compressibility_factor(dimension, equation, packing_fraction());
    }
    double tension() const {
        const double eta = packing_fraction(), free = 1.0 - eta;
        if (dimension == 2) return -0.5 * density * eta / (free * free);
        return -4.5 / pi * eta * eta * (1.0 + eta) / (free * free * free);
    }
    // Excess number of particles per length or area of wall, relative to the fluid density up to
    // the line or surface that the centres can reach.
    double adsorbed() const {
        constexpr double step = 1e-5;  // relative: derivatives are good to its square
        const Fluid less{dimension, equation, density * (1.0 - step)},
            more{dimension, equation, density * (1.0 + step)};
        return -density * (more.tension() - less.tension()) / (more.pressure() - less.pressure());
    }
};

// The room accessible to the centres, in units of the diameter, and its walls.
struct Room {
    int dimension;
    Vec reach = {};
    std::array<bool, 3> has_walls{};  // at the ends of this axis

    double content() const { return content_of(reach, dimension); }
    // The perimeter of an area, the surface of a volume.
    double boundary() const {
        double sum = 0.0;
        for (int axis = 0; axis < dimension; ++axis)
            if (has_walls.at(static_cast<std::size_t>(axis)))
                sum += 2.0 * content_across(reach, dimension, axis);
        return sum;
    }
    // How fast the boundary grows if the room grows along an axis.
    double growth(int axis) const {
        double sum = 0.0;
        for (int other = 0; other < dimension; ++other)
            if (other != axis && has_walls.at(static_cast<std::size_t>(other)))
                sum += 2.0 * (dimension == 2 ? 1.0 : reach[3 - axis - other]);
        return sum;
    }
};

// The fluid of which `count` particles fill the accessible room and the walls; nothing if it would
// freeze.
std::optional<Fluid> fluid_of(EquationOfState equation, const Room& room, double count) {
    const auto held = [&](double density) {
        const Fluid fluid{room.dimension, equation, density};
        return density * room.content() + room.boundary() * fluid.adsorbed();
    };
    double low = 0.0, high = Fluid::largest_density(room.dimension);
    if (held(high) < count) return std::nullopt;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (held(middle) < count ? low : high) = middle;
    }
    return Fluid{room.dimension, equation, 0.5 * (low + high)};
}

// The fluid that particles of one radius form between their walls; nothing for other particles.
struct Filled {
    double diameter;
    Room room;
    Fluid fluid;

    /// On a wall across an axis, or through a line or plane across a periodic one.
    double force(int axis) const {
        return fluid.pressure() * content_across(room.reach, room.dimension, axis) -
               room.growth(axis) * fluid.tension();
    }
};

std::optional<Filled> filled(EquationOfState equation, const Box& box, const Particles& particles) {
    const auto count = static_cast<double>(particles.count());
    if (box.dimension == 1 || count == 0.0 || !(particles.inverse_mass > 0.0).all())
        return std::nullopt;
    const double diameter = 2.0 * particles.radius[0];
    if (!(diameter > 0.0) || (particles.radius != particles.radius[0]).any()) return std::nullopt;
    Room room{box.dimension};
    for (int axis = 0; axis < box.dimension; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        room.has_walls[a] = !box.is_periodic(axis);
        room.reach[axis] = (box.size[axis] - (room.has_walls[a] ? diameter : 0.0)) / diameter;
        if (!(room.reach[axis] > 0.0)) return std::nullopt;
    }
    const std::optional<Fluid> fluid = fluid_of(equation, room, count);
    return fluid ? std::optional(Filled{diameter, room, *fluid}) : std::nullopt;
}

// What the free energy of a mixture of spheres depends on: the sums, per volume, of 1 and of the
// radius, surface and content of each (Rosenfeld, Phys. Rev. Lett. 63, 980, 1989).
struct MixtureSums {
    explicit MixtureSums(const Eigen::Vector4d& sums)
        : count(sums[0]), radius(sums[1]), surface(sums[2]), packing(sums[3]) {
        // Of f: f(0) = 1 / (24 pi), (packing^2 f)' = packing (3 - packing) / (36 pi free^3).
        double power = 1.0;
        for (int k = 1; k <= 150; ++k) {
            const double c = k * (k + 2.0) / (k + 1.0) / (36.0 * pi) * power;
            f += c;
            slope += c * (k - 1.0);
            curvature += c * (k - 1.0) * (k - 2.0);
            power *= packing;
        }
        slope /= packing;
        curvature /= packing * packing;
    }

    // P / T less that of an ideal gas.
    double excess_pressure() const {
        const double u = 1.0 / (1.0 - packing);
        return count * (u - 1.0) + radius * surface * u * u +
               cube(surface) * (3.0 - packing) * cube(u) / (36.0 * pi);
    }
    // The tension, divided by T, where the centres of spheres of the diameter d end, less that of
    // an ideal gas, by scaled particle theory: at the wall itself it is the derivative of its free
    // energy by `surface`, and then a layer of d / 2 has its excess pressure.
    double tension(double d) const {
        const double u = 1.0 / (1.0 - packing), s = surface * u;
        const double pressure = count * (u - 1.0) + radius * s * u + cube(s) / (12.0 * pi);
        return radius * (u - 1.0) + s * s / (8.0 * pi) - 0.5 * d * pressure;
    }
    Eigen::Vector4d slopes_of_tension(double d) const {
        const double u = 1.0 / (1.0 - packing), s = surface * u;
        const Eigen::Vector4d at_wall{0.0, u - 1.0, s * u / (4.0 * pi),
                                      radius * u * u + s * s * u / (4.0 * pi)};
        const Eigen::Vector4d of_pressure{
            u - 1.0, s * u, radius * u * u + s * s * u / (4.0 * pi),
            count * u * u + 2.0 * radius * s * u * u + cube(s) * u / (4.0 * pi)};
        return at_wall - 0.5 * d * of_pressure;
    }
    // Second derivatives of the excess free energy -count ln(free) + radius surface / free +
    // surface^3 f(packing), in units of T.
    Eigen::Matrix4d stiffness() const {
        const double u = 1.0 / (1.0 - packing), s = surface;
        Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
        h(0, 3) = h(3, 0) = h(1, 2) = h(2, 1) = u;
        h(1, 3) = h(3, 1) = s * u * u;
        h(2, 2) = 6.0 * s * f;
        h(2, 3) = h(3, 2) = radius * u * u + 3.0 * s * s * slope;
        h(3, 3) = count * u * u + 2.0 * radius * s * cube(u) + cube(s) * curvature;
        return h;
    }

    static double cube(double x) { return x * x * x; }

    double count, radius, surface, packing;
    double f = 0.0, slope = 0.0, curvature = 0.0;
};

// Spheres of several radii in a box of this size, with and without walls.
class MixedFluid {
  public:
    MixedFluid(const Box& box, const Particles& particles) : box_(box), all_(particles.count(), 4) {
        const Eigen::ArrayXd radius = particles.radius;
        all_ << Eigen::ArrayXd::Ones(radius.size()), radius, 4.0 * pi * radius.square(),
            4.0 / 3.0 * pi * radius.cube();
        mean_ = 6.0 * all_.col(3).sum() / all_.col(2).sum();
    }

    // P / T, as the mean force on all walls over their extent; nothing if the spheres may freeze.
    std::optional<double> pressure() const {
        const Cavity room(box_.size, *this);
        if (!(room.content > 0.0)) return std::nullopt;
        Eigen::VectorXd density = Eigen::VectorXd::Constant(all_.rows(), 1.0 / room.content);
        for (int i = 0; i < 200; ++i) {
            const MixtureSums sums(all_.transpose() * density);
            if (!(sums.packing < 0.6)) return std::nullopt;
            const Eigen::Matrix4d squares = all_.transpose() * density.asDiagonal() * all_;
            const Eigen::Matrix4d response =
                Eigen::Matrix4d::Identity() + sums.stiffness() * squares;
            const Eigen::Vector4d shift = response.partialPivLu().solve(room.slopes(sums));
            const Eigen::VectorXd next = (room.content - (all_ * shift).array()).inverse().matrix();
            if (!(next.array() > 0.0).all()) return std::nullopt;
            const double change = (next - density).cwiseAbs().maxCoeff() / next.maxCoeff();
            density = next;
            if (change < 1e-14) break;
        }
        const MixtureSums sums(all_.transpose() * density);
        if (!(sums.packing <= largest_packing_of_fluid(3))) return std::nullopt;
        double force = 0.0, extent = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            if (box_.is_periodic(axis)) continue;
            Vec longer = box_.size;  // the potential is linear in each length
            longer[axis] += mean_;
            force += (room.potential(sums) - Cavity(longer, *this).potential(sums)) / mean_;
            extent += content_across(box_.size, 3, axis);
        }
        return extent > 0.0 ? force / extent : sums.count + sums.excess_pressure();
    }

  private:
    // The grand potential is that of ideal gases, each in the room that its centres reach, plus
    // that of the excess in the room of centres of spheres of the mean diameter, with its tension.
    struct Cavity {
        Cavity(const Vec& size, const MixedFluid& gas) : mean(gas.mean_) {
            Room room{3};
            Eigen::Vector4d reached{1.0, 0.0, 0.0, 0.0};  // by centres: by powers of the diameter
            for (int axis = 0; axis < 3; ++axis) {
                const bool has_walls = !gas.box_.is_periodic(axis);
                room.has_walls.at(static_cast<std::size_t>(axis)) = has_walls;
                room.reach[axis] = size[axis] - (has_walls ? mean : 0.0);
                Eigen::Vector4d next = size[axis] * reached;
                if (has_walls) next.tail<3>() -= reached.head<3>();
                reached = next;
            }
            content = room.content();
            surface = room.boundary();
            // Of each sphere d = 2 radius, d^2 = surface / pi, d^3 = 6 content / pi.
            ideal = {reached[0], 2.0 * reached[1], reached[2] / pi, 6.0 * reached[3] / pi};
        }
        // What is added to -P times the content, in units of T, and its derivatives.
        Eigen::Vector4d slopes(const MixtureSums& sums) const {
            Eigen::Vector4d all = surface * sums.slopes_of_tension(mean) - ideal;
            all[0] += content;
            return all;
        }
        double potential(const MixtureSums& sums) const {
            return surface * sums.tension(mean) - sums.excess_pressure() * content -
                   ideal.dot(Eigen::Vector4d{sums.count, sums.radius, sums.surface, sums.packing});
        }
        double mean, content = 0.0, surface = 0.0;
        Eigen::Vector4d ideal;
    };

    const Box& box_;
    Eigen::MatrixX4d all_;
    double mean_ = 0.0;  // diameter: the sum of cubes over that of squares
};

// P / T of spheres of several radii; nothing if they may freeze.
std::optional<double> pressure_of_mixture(const Box& box, const Particles& particles) {
    if (box.dimension != 3 || !(particles.inverse_mass > 0.0).all() ||
        !(particles.radius > 0.0).all())
        return std::nullopt;
    return MixedFluid(box, particles).pressure();
}

}  // namespace

std::string_view name_of(EquationOfState equation, int dimension) {
    const bool is_simple = equation == EquationOfState::simple;
    if (dimension == 3) return is_simple ? "Carnahan–Starling" : "Kolafa–Labík–Malijevský";
    return is_simple ? "Henderson" : "Kolafa–Rottner";
}

double largest_packing_of_fluid(int dimension) { return dimension == 3 ? 0.492 : 0.70; }

std::optional<double> compressibility_of_phase(PhaseOfSpheres phase, double packing_fraction) {
    constexpr double melting = 0.543, close_packing = pi / (3.0 * std::numbers::sqrt2);
    constexpr double pressure_of_coexistence = 11.5727;  // in units of T / d^3
    const double freezing = largest_packing_of_fluid(3), eta = packing_fraction;
    switch (phase) {
        case PhaseOfSpheres::fluid:
            if (eta > freezing) return std::nullopt;
            return compressibility_factor(3, EquationOfState::accurate, eta);
        case PhaseOfSpheres::coexistence:
            if (eta < freezing || eta > melting) return std::nullopt;
            return pressure_of_coexistence * content_of_ball(0.5, 3) / eta;
        case PhaseOfSpheres::crystal:
            if (eta < melting || !(eta < close_packing)) return std::nullopt;
            return speedy(eta / close_packing);
    }
    return std::nullopt;
}

double compressibility_factor(int dimension, EquationOfState equation, double packing_fraction) {
    const bool is_simple = equation == EquationOfState::simple;
    if (dimension == 3)
        return is_simple ? carnahan_starling(packing_fraction)
                         : kolafa_labik_malijevsky(packing_fraction);
    return is_simple ? henderson(packing_fraction) : kolafa_rottner(packing_fraction);
}

double relative_compressibility(int dimension, EquationOfState equation, double packing_fraction) {
    if (packing_fraction == 0.0) return 1.0;
    constexpr double step = 1e-5;  // relative: the derivative is good to its square
    const auto pressure = [&](double packing) {
        return packing * compressibility_factor(dimension, equation, packing);
    };
    const double low = packing_fraction * (1.0 - step), high = packing_fraction * (1.0 + step);
    return (high - low) / (pressure(high) - pressure(low));
}

double pressure_of_points(const Box& box, double thermal_energy) {
    return 2.0 * thermal_energy / (box.dimension * box.content());
}

std::optional<double> pressure_of_fluid(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal) {
    if (!(thermal.degrees_of_freedom > 0.0)) return std::nullopt;
    const auto count = static_cast<double>(particles.count());
    const double temperature = thermal.temperature();
    // Where momentum is conserved, the thermal energy is less than that of N particles at this
    // temperature.
    const double missing = count * temperature - 2.0 / box.dimension * thermal.energy;
    const auto measured = [&](double in_units, double unit) {
        return temperature * in_units / unit - missing / box.content();
    };
    const std::optional<Filled> gas = filled(equation, box, particles);
    if (!gas) {
        if (count == 0.0 || (particles.radius == particles.radius[0]).all()) return std::nullopt;
        const std::optional<double> mixed = pressure_of_mixture(box, particles);
        return mixed ? std::optional(measured(*mixed, 1.0)) : std::nullopt;
    }

    // The force on the two walls across each axis divided by their extent; without walls the bulk
    // pressure.
    double force = 0.0, extent = 0.0;
    const Vec size = box.size / gas->diameter;
    for (int axis = 0; axis < box.dimension; ++axis) {
        if (!gas->room.has_walls.at(static_cast<std::size_t>(axis))) continue;
        force += gas->force(axis);
        extent += content_across(size, box.dimension, axis);
    }
    const double in_units = extent > 0.0 ? force / extent : gas->fluid.pressure();
    const double d = gas->diameter;
    return measured(in_units, content_of({d, d, d}, box.dimension));
}

std::optional<double> pressure_of_phase(PhaseOfSpheres phase, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal) {
    if (box.dimension != 3 || !box.is_periodic() || particles.count() == 0 ||
        !(particles.inverse_mass > 0.0).all() || !(particles.radius[0] > 0.0) ||
        (particles.radius != particles.radius[0]).any())
        return std::nullopt;
    if (phase == PhaseOfSpheres::fluid)
        return pressure_of_fluid(EquationOfState::accurate, box, particles, thermal);
    const double eta = packing_fraction(box, particles);
    const std::optional<double> factor = compressibility_of_phase(phase, eta);
    if (!factor) return std::nullopt;
    return *factor * pressure_of_points(box, thermal.energy);
}

std::optional<double> scale_at_pressure(EquationOfState equation, const Box& box,
                                        const Particles& particles, const ThermalMotion& thermal,
                                        double pressure) {
    const auto at_scale = [&](double scale) {
        Box scaled = box;
        scaled.size = scale * box.size;
        return pressure_of_fluid(equation, scaled, particles, thermal);
    };
    // In a box that is too small for a fluid the pressure is unknown, and higher.
    const auto is_too_small = [&](double scale) {
        const std::optional<double> found = at_scale(scale);
        return !found || *found > pressure;
    };
    const double ideal = pressure_of_points(box, thermal.energy);
    double low = 0.0, high = std::pow(ideal / pressure, 1.0 / box.dimension);
    constexpr int most_doublings = 1000;  // of a gas without an equation of state
    for (int i = 0; is_too_small(high); ++i, low = high, high *= 2.0)
        if (i == most_doublings || !std::isfinite(high)) return std::nullopt;
    for (double middle = 0.5 * (low + high); low < middle && middle < high;
         middle = 0.5 * (low + high))
        (is_too_small(middle) ? low : high) = middle;
    constexpr double tolerance = 1e-9;
    return *at_scale(high) >= (1.0 - tolerance) * pressure ? std::optional(high) : std::nullopt;
}

std::optional<double> force_of_fluid(EquationOfState equation, const Box& box,
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

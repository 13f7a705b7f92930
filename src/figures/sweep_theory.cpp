#include "figures/sweep_theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "physics/mechanics.h"
#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/equation_of_state.h"
#include "physics/theory/theory.h"
#include "stats/pressure.h"

namespace carom {
namespace {

struct DrawnGas {
    const Scene& scene;
    const Particles& particles;
    const Sample& sample;

    const Box& box() const { return scene.gas.box; }
    ThermalMotion thermal() const { return thermal_motion(box(), particles, sample); }
};

bool is_pressure(const std::string& number) {
    return number == "wall pressure" || number == "virial pressure";
}

std::optional<double> pressure(const DrawnGas& gas) {
    if (gas.box().dimension == 1) return pressure_of_rods(gas.box(), gas.particles, gas.thermal());
    return pressure_of_disks(EquationOfState::kolafa_rottner, gas.box(), gas.particles,
                             gas.thermal());
}

// Collisions per particle and unit of time.
std::optional<double> collision_rate(const DrawnGas& gas) {
    const auto rate = expected_collision_rate(gas.box(), gas.particles, gas.sample);
    if (!rate) return std::nullopt;
    return 2.0 * *rate / static_cast<double>(gas.particles.count());
}

// The equilibrium of all particles, or of the species that the number names.
std::optional<EquilibriumGas> equilibrium_of(const std::string& number, const std::string& prefix,
                                             const DrawnGas& gas) {
    if (number == prefix) return equilibrium(gas.box(), gas.particles, gas.sample);
    const std::vector<Species>& all = gas.scene.gas.species;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (number == prefix + " of " + all[k].name)
            return equilibrium(gas.box(), gas.particles, gas.sample, {static_cast<int>(k)});
    return std::nullopt;
}

std::optional<double> value_of(const std::string& number, const DrawnGas& gas) {
    if (is_pressure(number)) return pressure(gas);
    if (number == "collision rate") return collision_rate(gas);
    if (number == "temperature") {
        const double temperature = gas.thermal().temperature();
        if (equilibrium(gas.box(), gas.particles, gas.sample)) return temperature;
        return std::nullopt;
    }
    if (number == "mean free path") {
        if ((gas.particles.inverse_mass == 0.0).any()) return std::nullopt;
        const auto all = equilibrium(gas.box(), gas.particles, gas.sample);
        const auto rate = collision_rate(gas);
        if (!all || !rate || !(*rate > 0.0)) return std::nullopt;
        return mean_speed(*all) / *rate;
    }
    if (const auto its = equilibrium_of(number, "mean energy", gas)) return mean_energy(*its);
    if (const auto its = equilibrium_of(number, "mean speed", gas)) return mean_speed(*its);
    return std::nullopt;
}

// The mean over the seeds, because velocities and radii may be random.
std::optional<double> mean_over_seeds(
    const Scene& scene, const SeedRange& seeds,
    const std::function<std::optional<double>(const DrawnGas&)>& value) {
    constexpr std::int64_t most = 16;
    if (!scene.gas.box.surfaces.are_plain() || !scene.run.events.empty()) return std::nullopt;
    const std::int64_t count = std::min(most, seeds.count());
    double sum = 0.0;
    for (std::int64_t k = 0; k < count; ++k) {
        Gas gas = scene.gas;
        gas.seed = seeds.first + static_cast<std::uint64_t>(k);
        const auto drawn = try_draw_gas(gas);
        if (!drawn) return std::nullopt;
        const auto its = value({scene, drawn->first, drawn->second});
        if (!its || !std::isfinite(*its)) return std::nullopt;
        sum += *its;
    }
    return sum / static_cast<double>(count);
}

}  // namespace

std::optional<double> theory_of_number(const std::string& number, const Scene& scene,
                                       const SeedRange& seeds) {
    return mean_over_seeds(scene, seeds,
                           [&](const DrawnGas& gas) { return value_of(number, gas); });
}

std::optional<double> ideal_gas_of_number(const std::string& number, const Scene& scene,
                                          const SeedRange& seeds) {
    if (!is_pressure(number)) return std::nullopt;
    return mean_over_seeds(scene, seeds, [](const DrawnGas& gas) {
        return std::optional(pressure_of_points(gas.box(), gas.thermal().energy));
    });
}

Phrase name_of_theory(const std::string& number, const Scene& scene) {
    const bool is_line = scene.gas.box.dimension == 1;
    if (is_pressure(number))
        return is_line ? Phrase{"hard rods (Tonks)"} : Phrase{"hard disks (Kolafa and Rottner)"};
    if (number == "collision rate" || number == "mean free path")
        return is_line ? Phrase{"kinetic theory"} : Phrase{"kinetic theory (Enskog)"};
    return Phrase{"equilibrium"};
}

Phrase name_of_ideal_gas() { return Phrase{"ideal gas"}; }

std::optional<double> packing_of(const Scene& scene) {
    const auto drawn = try_draw_gas(scene.gas);
    if (!drawn) return std::nullopt;
    return packing_fraction(scene.gas.box, drawn->first);
}

std::optional<double> density_of(const Scene& scene) {
    const Box& box = scene.gas.box;
    double count = 0.0;
    for (const Species& species : scene.gas.species) count += static_cast<double>(species.count);
    return count / (box.dimension == 1 ? box.size[0] : box.size.prod());
}

}  // namespace carom

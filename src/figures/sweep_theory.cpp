#include "figures/sweep_theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"
#include "physics/theory/law.h"
#include "scene/scene.h"

namespace carom {
namespace {

bool is_pressure(const std::string& number) {
    return number == "wall pressure" || number == "virial pressure";
}

// The particles of the species with this name; none if there is no such species.
std::optional<std::vector<Eigen::Index>> of_species(const std::string& name, const Gas& gas,
                                                    const Particles& particles) {
    const auto found = std::ranges::find(gas.species, name, &Species::name);
    if (found == gas.species.end()) return std::nullopt;
    std::vector<Eigen::Index> list;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (particles.species[i] == found - gas.species.begin()) list.push_back(i);
    return list;
}

// What theory knows of a number of runs: nothing of one that has no law.
std::optional<Law> law_of_number(const std::string& number, const Gas& gas, const BoxedGas& boxed,
                                 PhaseOfSpheres phase) {
    if (is_pressure(number)) return law(boxed, LawOf::pressure, {.phase = phase});
    if (phase != PhaseOfSpheres::fluid) return std::nullopt;
    if (number == "collision rate") return law(boxed, LawOf::collision_rate);
    if (number == "temperature") return law(boxed, LawOf::temperature);
    if (number == "mean free path") return law(boxed, LawOf::mean_free_path);
    for (const auto& [name, quantity] :
         {std::pair{"mean energy", LawOf::mean_energy}, {"mean speed", LawOf::mean_speed}}) {
        if (number == name) return law(boxed, quantity);
        const std::string of = std::string(name) + " of ";
        if (!number.starts_with(of)) continue;
        if (auto list = of_species(number.substr(of.size()), gas, *boxed.particles))
            return law(boxed, quantity, {.of = std::move(list)});
    }
    return std::nullopt;
}

// The mean over the seeds, because velocities and radii may be random.
std::optional<double> mean_over_seeds(
    const Scene& scene, const SeedRange& seeds,
    const std::function<std::optional<Law>(const BoxedGas&)>& law_of) {
    constexpr std::int64_t most = 16;
    const std::int64_t count = std::min(most, seeds.count());
    double sum = 0.0;
    for (std::int64_t k = 0; k < count; ++k) {
        Gas gas = scene.gas;
        gas.seed = seeds.first + static_cast<std::uint64_t>(k);
        const auto drawn = try_draw_gas(gas);
        if (!drawn) return std::nullopt;
        const auto found = law_of(BoxedGas(gas.box, scene.run.events, drawn->first, drawn->second));
        if (!found || !*found || !std::isfinite(found->value)) return std::nullopt;
        sum += found->value;
    }
    return sum / static_cast<double>(count);
}

}  // namespace

std::optional<double> theory_of_number(const std::string& number, const Scene& scene,
                                       const SeedRange& seeds, PhaseOfSpheres phase) {
    return mean_over_seeds(scene, seeds, [&](const BoxedGas& gas) {
        return law_of_number(number, scene.gas, gas, phase);
    });
}

std::optional<double> ideal_gas_of_number(const std::string& number, const Scene& scene,
                                          const SeedRange& seeds) {
    if (!is_pressure(number)) return std::nullopt;
    return mean_over_seeds(scene, seeds, [](const BoxedGas& gas) {
        return std::optional(law(gas, LawOf::ideal_pressure));
    });
}

Phrase name_of_theory(const std::string& number, const Scene& scene, PhaseOfSpheres phase) {
    if (phase == PhaseOfSpheres::coexistence) return Phrase{"fluid and crystal"};
    if (phase == PhaseOfSpheres::crystal) return Phrase{"crystal (Speedy)"};
    const int dimension = scene.gas.box.dimension;
    const bool is_line = dimension == 1;
    if (is_pressure(number))
        return is_line          ? Phrase{"hard rods (Tonks)"}
               : dimension == 2 ? Phrase{"hard disks (Kolafa and Rottner)"}
                                : Phrase{"hard spheres (Kolafa, Labík and Malijevský)"};
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
    return count / box.content();
}

}  // namespace carom

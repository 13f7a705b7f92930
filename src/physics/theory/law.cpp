#include "physics/theory/law.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "physics/gas.h"
#include "physics/placement/draws.h"
#include "physics/theory/laws/laws.h"

namespace carom {
namespace {

using LawFunction = Law (*)(const BoxedGas&, const Asked&);

// In the order of LawOf.
constexpr std::array<LawFunction, laws_count> functions{laws::mean_energy,
                                                        laws::mean_speed,
                                                        laws::bath,
                                                        laws::temperature,
                                                        laws::distribution,
                                                        laws::side_distribution,
                                                        laws::goodness_of_fit,
                                                        laws::velocity_entropy,
                                                        laws::position_entropy,
                                                        laws::collision_rate,
                                                        laws::mean_free_path,
                                                        laws::ideal_pressure,
                                                        laws::pressure,
                                                        laws::contact,
                                                        laws::displacement,
                                                        laws::autocorrelation,
                                                        laws::free_flight,
                                                        laws::memoryless,
                                                        laws::flux,
                                                        laws::gap_flux,
                                                        laws::side_count,
                                                        laws::side_energy,
                                                        laws::side_temperature,
                                                        laws::piston,
                                                        laws::isotherm,
                                                        laws::adiabat,
                                                        laws::binomial,
                                                        laws::heights,
                                                        laws::error_growth,
                                                        laws::diffusion};

}  // namespace

std::vector<Eigen::Index> laws::members(const BoxedGas& gas, const Asked& asked) {
    std::vector<Eigen::Index> all;
    if (asked.of) {
        all = *asked.of;
    } else {
        all.resize(static_cast<std::size_t>(gas.particles->count()));
        std::iota(all.begin(), all.end(), 0);
    }
    std::erase_if(all, [&](Eigen::Index i) { return gas.particles->inverse_mass[i] == 0.0; });
    return all;
}

Law law(const BoxedGas& gas, LawOf quantity, const Asked& asked) {
    if (gas.particles == nullptr) return laws::none(NoLaw::Why::unknown_gas);
    return functions.at(static_cast<std::size_t>(quantity))(gas, asked);
}

std::optional<NoLaw> why_no_law(const Gas& gas, const Run& run, LawOf quantity,
                                const Asked& asked) {
    const auto drawn = try_draw_gas(gas);
    if (!drawn) return std::nullopt;
    const auto& [particles, sample] = *drawn;
    const Law found = law(BoxedGas(gas.box, run.events, particles, sample), quantity, asked);
    const bool is_only_unplaced = found.none && found.none->why == NoLaw::Why::unknown_order;
    return is_only_unplaced ? std::nullopt : found.none;
}

}  // namespace carom

#include "panels/instruments/piston_over_gas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/surfaces/surface_words.h"
#include "physics/energy_account.h"
#include "physics/mechanics.h"
#include "physics/theory/collision_rate.h"

namespace carom {

namespace {

double force_to_gas(const Piston& piston, std::int32_t surface) {
    return Surfaces::is_far_side(surface) ? -piston.force : piston.force;
}

}  // namespace

bool is_over_gas_alone(const PanelContext& context, std::int32_t surface) {
    const Surfaces& surfaces = context.scene.gas.box.surfaces;
    if (!Surfaces::is_side(surface)) return false;
    const auto side = static_cast<std::size_t>(surface);
    const auto* piston = std::get_if<Piston>(&surfaces.sides.at(side));
    if (piston == nullptr || !(force_to_gas(*piston, surface) > 0.0) ||
        !context.scene.run.events.empty() || !surfaces.partitions.empty() ||
        !surfaces.obstacles.empty() || (surfaces.gravity != 0.0).any() ||
        (context.particles.inverse_mass == 0.0).any())
        return false;
    // All share the energy: one disk keeps that of its motion along the piston, and a gas that
    // periodic sides let through along it keeps its momentum.
    const Box& box = context.scene.gas.box;
    if (box.dimension == 2 &&
        (context.particles.count() < 2 ||
         conserves_momentum(box, context.particles, 1 - surfaces.axis_of(surface))))
        return false;
    for (std::size_t k = 0; k < surfaces.sides.size(); ++k)
        if (k != side && !std::holds_alternative<Reflecting>(surfaces.sides[k])) return false;
    return true;
}

std::optional<PistonOverGas> piston_over_gas(const PanelContext& context, std::int32_t surface,
                                             const FrameInput& start) {
    if (!is_over_gas_alone(context, surface)) return std::nullopt;
    const Box& box = context.scene.gas.box;
    const auto side = static_cast<std::size_t>(surface);
    const auto& piston = std::get<Piston>(box.surfaces.sides[side]);
    const double force = force_to_gas(piston, surface);
    const double direction = Surfaces::is_far_side(surface) ? 1.0 : -1.0;
    const double taken = box.dimension == 1 ? 2.0 * context.particles.radius.sum() : 0.0;
    const double zero = box.place_of(surface ^ 1) + direction * taken;
    const std::vector<SurfaceState>& states = start.advanced.surfaces;
    const EnergyAccount now = energies(box, context.particles, start.sample, states);
    const double height = std::abs(place_of_surface(box, states, side) - zero);
    const PistonLaw law{.count = static_cast<double>(context.particles.count()),
                        .energy = now.kinetic + now.pistons + force * height,
                        .force = force,
                        .dimension = box.dimension};
    const double area = law.mean() * box.length(1 - box.surfaces.axis_of(surface));
    const double free_path = box.dimension == 1
                                 ? std::numeric_limits<double>::infinity()
                                 : dilute_free_path(area, 2.0 * context.particles.radius.sum());
    return PistonOverGas{.law = law,
                         .mass = piston.mass,
                         .gas_mass = (1.0 / context.particles.inverse_mass).sum(),
                         .free_path = free_path,
                         .zero = zero,
                         .direction = direction};
}

}  // namespace carom

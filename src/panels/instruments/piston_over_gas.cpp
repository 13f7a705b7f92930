#include "panels/instruments/piston_over_gas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/surfaces/surface_words.h"
#include "physics/events/energy_account.h"
#include "physics/mechanics.h"
#include "physics/theory/collision_rate.h"

namespace carom {

namespace {

double force_to_gas(const Piston& piston, bool is_far_side) {
    return is_far_side ? -piston.force : piston.force;
}

}  // namespace

std::optional<PistonOverGas> piston_over_gas(const PanelContext& context, std::int32_t surface,
                                             const FrameInput& start) {
    if (!law(context.gas, LawOf::piston, {.surface = surface})) return std::nullopt;
    const Box& box = context.box();
    const auto side = static_cast<std::size_t>(surface);
    const Piston& piston = *piston_of(box.surfaces.sides[side]);
    const bool is_far_side = box.surfaces.is_far_side(surface);
    const double force = force_to_gas(piston, is_far_side);
    const double direction = is_far_side ? 1.0 : -1.0;
    const double taken = box.dimension == 1 ? 2.0 * context.particles.radius.sum() : 0.0;
    const double zero = box.place_of(surface ^ 1) + direction * taken;
    const std::vector<SurfaceState>& states = start.advanced.surfaces;
    const EnergyAccount now = energies(box, context.particles, start.sample, states);
    const double height = std::abs(place_of_surface(box, states, side) - zero);
    const PistonLaw law{.count = static_cast<double>(context.particles.count()),
                        .energy = now.kinetic + now.pistons + force * height,
                        .force = force,
                        .dimension = box.dimension};
    const double room = law.mean() * box.content_across(box.surfaces.axis_of(surface));
    const double free_path =
        box.dimension == 1
            ? std::numeric_limits<double>::infinity()
            : dilute_free_path(room, cross_sections(context.particles.radius, box.dimension));
    return PistonOverGas{.law = law,
                         .mass = piston.mass,
                         .gas_mass = (1.0 / context.particles.inverse_mass).sum(),
                         .free_path = free_path,
                         .zero = zero,
                         .direction = direction};
}

}  // namespace carom

#include "physics/events/energy_account.h"

#include <variant>

namespace carom {

EnergyAccount energies(const Box& box, const Particles& particles, const Sample& sample,
                       std::span<const SurfaceState> states) {
    EnergyAccount account;
    const Vec& gravity = box.surfaces.gravity;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        if (particles.inverse_mass[i] == 0.0) {
            if (box.surfaces.has_gravity() || (sample.velocity.row(i) != 0.0).any())
                account.relative_error.reset();
            continue;
        }
        const double square = sample.velocity.row(i).square().sum();
        account.kinetic += 0.5 * square / particles.inverse_mass[i];
        for (Eigen::Index axis = 0; axis < box.dimension; ++axis) {
            const double g = gravity[axis], r = particles.radius[i];
            if (g == 0.0) continue;
            const double lowest = g < 0.0 ? r : box.size[axis] - r;
            account.potential +=
                -g * (sample.position(i, axis) - lowest) / particles.inverse_mass[i];
        }
    }
    for (std::size_t k = 0; k < states.size(); ++k) {
        const SurfaceState& state = states[k];
        account.heat += state.heat;
        const auto* piston = piston_of(state.behaviour);
        if (piston == nullptr) continue;
        const double pull = gravity[box.surfaces.axis_of(k)];
        account.pistons += piston->kinetic_energy(state.motion->velocity);
        account.potential += piston->potential_energy(state.motion->place, pull);
    }
    return account;
}

}  // namespace carom

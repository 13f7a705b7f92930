#include "physics/theory/error_growth.h"

#include <cmath>

#include "physics/theory/collision_rate.h"

namespace carom {

double bits_lost_per_collision(double packing) {
    return packing > 0.0 ? 3.85 * std::log2(1.0 + 0.115 / packing) : 0.0;
}

std::optional<double> bits_lost_per_collision(const Box& box, const Particles& particles) {
    if (box.dimension != 2 || particles.count() < 2) return std::nullopt;
    const double radius = particles.radius[0], inverse_mass = particles.inverse_mass[0];
    const bool equal =
        (particles.radius == radius).all() && (particles.inverse_mass == inverse_mass).all();
    if (!equal || !(radius > 0.0) || !(inverse_mass > 0.0)) return std::nullopt;
    return bits_lost_per_collision(packing_fraction(box, particles));
}

}  // namespace carom

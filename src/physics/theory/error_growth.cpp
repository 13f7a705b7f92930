#include "physics/theory/error_growth.h"

#include <cmath>

#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"

namespace carom {

double bits_lost_per_collision(double packing) {
    return packing > 0.0 ? 3.85 * std::log2(1.0 + 0.115 / packing) : 0.0;
}

std::optional<double> bits_lost_per_collision(const Box& box, const Particles& particles) {
    if (box.dimension != 2 || particles.count() < 2 || !box.surfaces.are_plain())
        return std::nullopt;
    if (!particles.are_equal() || !(particles.radius[0] > 0.0) ||
        !(particles.inverse_mass[0] > 0.0))
        return std::nullopt;
    return bits_lost_per_collision(packing_fraction(box, particles));
}

std::optional<std::string> why_no_growth_law(const Gas& gas) {
    if (gas.box.dimension == 1)
        return "no estimate of the growth of errors is known for beads on a wire, where they grow "
               "far more slowly";
    const auto drawn = try_draw_gas(gas);
    if (!drawn || bits_lost_per_collision(gas.box, drawn->first)) return std::nullopt;
    return "no estimate of the growth of errors is known for this gas, only for disks of one "
           "radius and one finite mass";
}

}  // namespace carom

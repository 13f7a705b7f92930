#include "physics/theory/barometric_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr int steps = 512;            // intervals of the tabulated heights
constexpr double scale_heights = 20;  // above which the density is taken as 0

// For the density exp(-x) cut off at x = `a`: its mean, its variance, and the logarithm of its
// integral over [0, a] divided by `a`.
double mean_of(double a) { return a < 1e-4 ? 0.5 * a : 1.0 - a / std::expm1(a); }
double variance_of(double a) {
    if (a < 1e-2) return a * a / 12.0;
    const double s = 2.0 * std::sinh(0.5 * std::min(a, 200.0));
    return 1.0 - a * a / (s * s);
}
double log_integral_of(double a) { return a < 1e-9 ? 0.0 : std::log(-std::expm1(-a) / a); }

// All degrees of freedom of the gas except the height of one particle.
struct OtherFreedoms {
    double freedoms, gravity;
    std::vector<FallingKind> kinds;

    // The sum of `function` over all these particles, evaluated at m g height / T with T = 1 / b.
    double sum(double b, double (*function)(double)) const {
        double all = 0.0;
        for (const FallingKind& kind : kinds)
            all += kind.count * function(b * kind.mass * gravity * kind.height);
        return all;
    }

    // The logarithm of their phase-space volume at an energy, up to a constant: evaluated at the
    // saddle point b, at which their mean energy equals the given one.
    double log_volume(double energy) const {
        if (!(energy > 0.0)) return -std::numeric_limits<double>::infinity();
        const auto excess = [&](double b) {
            return energy - (0.5 * freedoms + sum(b, mean_of)) / b;
        };
        double low = 1e-3 / energy, high = 1.0 / energy;
        while (excess(low) > 0.0) low *= 0.5;
        while (excess(high) < 0.0) high *= 2.0;
        for (int step = 0; step < 100; ++step) {
            const double middle = std::sqrt(low * high);
            (excess(middle) < 0.0 ? low : high) = middle;
        }
        const double b = high, capacity = 0.5 * freedoms + sum(b, variance_of);
        return b * energy - 0.5 * freedoms * std::log(b) + sum(b, log_integral_of) -
               0.5 * std::log(capacity / (b * b));
    }
};

}  // namespace

BarometricLaw::BarometricLaw(double freedoms, double energy, double gravity,
                             const std::vector<FallingKind>& kinds, std::size_t kind) {
    OtherFreedoms others{freedoms, gravity, kinds};
    others.kinds[kind].count -= 1.0;
    const double weight = kinds[kind].mass * gravity;
    // A column may be much higher than any particle comes; T is not above this.
    const double temperature = 2.0 * energy / freedoms;
    const double height =
        std::min({kinds[kind].height, energy / weight, scale_heights * temperature / weight});
    step_ = height / steps;
    const double most = others.log_volume(energy);
    const auto density = [&](double h) {
        return std::exp(others.log_volume(energy - weight * h) - most);
    };
    below_.push_back(0.0);
    double last = density(0.0);
    for (int k = 0; k < steps; ++k) {  // by Simpson's rule
        const double middle = density((k + 0.5) * step_), next = density((k + 1.0) * step_);
        below_.push_back(below_.back() + (last + 4.0 * middle + next) / 6.0);
        last = next;
    }
    for (double& share : below_) share /= below_.back();
}

double BarometricLaw::share_below(double height) const {
    const double at = std::clamp(height / step_, 0.0, double(steps));
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(at), steps - 1);
    return std::lerp(below_[k], below_[k + 1], at - double(k));
}

namespace {

// The particles grouped into kinds that share one law: by mass, and by how far they can fall.
struct Falling {
    std::vector<FallingKind> kinds = {};
    std::vector<std::size_t> kind_of = {};  // of each particle
};

Falling falling(const Box& box, const Particles& particles, int axis) {
    Falling all;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const double mass = 1.0 / particles.inverse_mass[i];
        const double height = box.size[axis] - 2.0 * particles.radius[i];
        auto kind = std::ranges::find_if(all.kinds, [&](const FallingKind& one) {
            return one.mass == mass && one.height == height;
        });
        if (kind == all.kinds.end()) kind = all.kinds.insert(kind, {mass, 0.0, height});
        kind->count += 1.0;
        all.kind_of.push_back(static_cast<std::size_t>(kind - all.kinds.begin()));
        if (all.kinds.size() > most_falling_kinds) break;
    }
    return all;
}

// The share of particles of this radius in a slab.
double share_in(const BarometricLaw& law, const Box& box, int axis, double radius, double low,
                double high) {
    const double size = box.size[axis];
    return box.surfaces.gravity[axis] < 0.0
               ? law.share_below(high - radius) - law.share_below(low - radius)
               : law.share_below(size - low - radius) - law.share_below(size - high - radius);
}

}  // namespace

std::size_t falling_kinds(const BoxedGas& gas, int axis) {
    return falling(gas.box, *gas.particles, axis).kinds.size();
}

std::vector<double> barometric_densities(const BoxedGas& gas, int axis, int slabs,
                                         const std::vector<Eigen::Index>& members) {
    const Box& box = gas.box;
    const Falling all = falling(box, *gas.particles, axis);
    const double gravity = std::abs(box.surfaces.gravity[axis]), width = box.size[axis] / slabs;
    const double energy = gas.thermal.energy + gas.falling_energy;
    std::vector<double> counts(all.kinds.size(), 0.0);
    for (const Eigen::Index i : members) counts[all.kind_of[static_cast<std::size_t>(i)]] += 1.0;
    std::vector<double> densities(static_cast<std::size_t>(slabs), 0.0);
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        if (counts[kind] == 0.0) continue;
        const BarometricLaw law(gas.freedoms(), energy, gravity, all.kinds, kind);
        const double radius = 0.5 * (box.size[axis] - all.kinds[kind].height);
        for (std::size_t slab = 0; slab < densities.size(); ++slab) {
            const double low = static_cast<double>(slab) * width;
            densities[slab] += counts[kind] * share_in(law, box, axis, radius, low, low + width) /
                               (box.content() / slabs);
        }
    }
    return densities;
}

}  // namespace carom

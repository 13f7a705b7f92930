#include "stats/barometric_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/mechanics.h"

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
struct Others {
    double freedoms, gravity;
    std::vector<FallingKind> kinds;

    // The sum of `function` over all these particles, evaluated at m g height / T with T = 1 / b.
    double sum(double b, double (*function)(double)) const {
        double all = 0.0;
        for (const FallingKind& one : kinds)
            all += one.count * function(b * one.mass * gravity * one.height);
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
    Others others{freedoms, gravity, kinds};
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

constexpr std::size_t most_kinds = 20;

// The particles grouped into kinds that share one law: by mass, and by how far they can fall.
struct Falling {
    double energy = 0.0;
    std::vector<FallingKind> kinds = {};
    std::vector<std::size_t> kind_of = {};  // of each particle
};

// `drift`: the conserved velocity of the centre of mass.
Falling falling(const Box& box, const Particles& particles, const Sample& start, int axis,
                const Eigen::ArrayXd& drift) {
    const double gravity = box.surfaces.gravity[axis], size = box.size[axis];
    Falling all;
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const double mass = 1.0 / particles.inverse_mass[i], radius = particles.radius[i];
        const double lowest = gravity < 0.0 ? radius : size - radius;
        const double height = size - 2.0 * radius;
        const double square = (start.velocity.row(i).transpose() - drift).square().sum();
        all.energy += mass * (0.5 * square - gravity * (start.position(i, axis) - lowest));
        auto kind = std::ranges::find_if(all.kinds, [&](const FallingKind& one) {
            return one.mass == mass && one.height == height;
        });
        if (kind == all.kinds.end()) kind = all.kinds.insert(kind, {mass, 0.0, height});
        kind->count += 1.0;
        all.kind_of.push_back(static_cast<std::size_t>(kind - all.kinds.begin()));
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

std::vector<std::vector<double>> barometric_densities(
    const Box& box, const Particles& particles, const Sample& start, int axis, const Cells& slabs,
    const std::vector<std::vector<Eigen::Index>>& groups) {
    if ((particles.inverse_mass == 0.0).any()) return {};
    // The motion of the centre of mass along the other axis is conserved: it takes no part in the
    // energy and the degrees of freedom that the particles share.
    const bool is_joined = box.dimension == 2 && conserves_momentum(box, particles, 1 - axis);
    Eigen::ArrayXd drift = Eigen::ArrayXd::Zero(box.dimension);
    if (is_joined) drift[1 - axis] = momentum(particles, start)[1 - axis] / masses(particles).sum();
    const Falling all = falling(box, particles, start, axis, drift);
    const double freedoms = double(box.dimension) * double(particles.count()) - (is_joined ? 1 : 0);
    if (!(all.energy > 0.0) || freedoms < 3.0 || all.kinds.size() > most_kinds) return {};
    const double gravity = std::abs(box.surfaces.gravity[axis]), width = slabs.size[axis];
    std::vector<std::vector<double>> densities;
    for (const std::vector<Eigen::Index>& group : groups) {
        std::vector<double>& its = densities.emplace_back(slabs.all(), 0.0);
        for (std::size_t kind = 0; kind < all.kinds.size(); ++kind) {
            double count = 0.0;
            for (const Eigen::Index i : group)
                count += all.kind_of[static_cast<std::size_t>(i)] == kind ? 1.0 : 0.0;
            if (count == 0.0) continue;
            const BarometricLaw law(freedoms, all.energy, gravity, all.kinds, kind);
            const double radius = 0.5 * (box.size[axis] - all.kinds[kind].height);
            for (std::size_t slab = 0; slab < its.size(); ++slab) {
                const double low = static_cast<double>(slab) * width;
                its[slab] +=
                    count * share_in(law, box, axis, radius, low, low + width) / slabs.area();
            }
        }
    }
    return densities;
}

}  // namespace carom

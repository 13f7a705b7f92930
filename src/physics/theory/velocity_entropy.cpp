#include "physics/theory/velocity_entropy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "util/bin_number.h"
#include "util/random.h"

namespace carom {

VelocityEntropy::VelocityEntropy(const Particles& particles, const ThermalMotion& start)
    : kinds_(kinds_of(particles)) {
    const Eigen::ArrayXd& inverse = particles.inverse_mass;
    scale_ = (inverse > 0.0).select(1.0 / (inverse * start.temperature()), 0.0).sqrt();
    for (Eigen::Index i = 0; i < inverse.size(); ++i)
        if (inverse[i] > 0.0)
            most_ = std::max<double>(most_, kinds_.members[static_cast<std::size_t>(kinds_.of[i])]);
}

// In space about as many cells in all as there are in a plane.
int VelocityEntropy::cells_along_axis(Eigen::Index dimension) const {
    const double in_plane = std::clamp(std::round(2.0 * std::cbrt(most_)), 6.0, 24.0);
    return static_cast<int>(dimension < 3 ? in_plane : std::round(std::cbrt(in_plane * in_plane)));
}

namespace {

int cell_of(double u, int cells) {
    constexpr double reach = 4.0;
    const double place = (u + reach) / (2.0 * reach) * cells;
    return static_cast<int>(std::clamp(bin_number(place), 0.0, cells - 1.0));
}

}  // namespace

double VelocityEntropy::of(const Eigen::ArrayXXd& velocity) const {
    const int along = cells_along_axis(velocity.cols());
    std::size_t cells = 1;
    for (Eigen::Index axis = 0; axis < velocity.cols(); ++axis)
        cells *= static_cast<std::size_t>(along);
    std::vector<int> found(cells * kinds_.members.size(), 0);  // by kind and cell
    double all = 0.0;
    for (Eigen::Index i = 0; i < velocity.rows(); ++i) {
        if (scale_[i] == 0.0) continue;
        int cell = 0;
        for (Eigen::Index a = 0; a < velocity.cols(); ++a)
            cell = along * cell + cell_of(velocity(i, a) * scale_[i], along);
        ++found[static_cast<std::size_t>(kinds_.of[i]) * cells + static_cast<std::size_t>(cell)];
        all += 1.0;
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < found.size(); ++k)
        if (found[k] > 0)
            sum -= found[k] * std::log(double(found[k]) / double(kinds_.members[k / cells]));
    return all > 0.0 ? sum / all : 0.0;
}

namespace {

// Velocities of the particles, at rest for infinite masses, at the energy of the gas.
Eigen::ArrayXXd random_velocities(const BoxedGas& gas, Random& random) {
    const Eigen::ArrayXd& inverse = gas.particles->inverse_mass;
    const Eigen::ArrayXd masses = (inverse > 0.0).select(inverse.inverse(), 0.0);
    Eigen::ArrayXXd velocity(inverse.size(), gas.box.dimension);
    for (double& component : velocity.reshaped()) component = random.normal();
    velocity.colwise() *= inverse.sqrt();
    double energy = 0.0;
    for (Eigen::Index axis = 0; axis < velocity.cols(); ++axis) {
        auto along = velocity.col(axis);
        if (gas.conserves.at(static_cast<std::size_t>(axis)))
            along -= (masses * along).sum() / gas.mass;
        energy += 0.5 * (masses * along.square()).sum();
    }
    return velocity * std::sqrt(gas.thermal.energy / energy);
}

}  // namespace

SampledMean equilibrium_entropy(const BoxedGas& gas) {
    constexpr double wanted_error = 4e-4, most_velocities = 2e6;
    const VelocityEntropy entropy(*gas.particles, gas.thermal);
    const auto count = static_cast<double>(gas.particles->count());
    const double most = std::max(4.0, most_velocities / count);
    Random random(1, "entropy in equilibrium");
    double samples = 0.0, mean = 0.0, squares = 0.0, error = 0.0;
    constexpr double fewest = 4.0;
    do {  // by Welford's recurrence
        samples += 1.0;
        const double now = entropy.of(random_velocities(gas, random)), off = now - mean;
        mean += off / samples;
        squares += off * (now - mean);
        error = std::sqrt(squares / samples / std::max(1.0, samples - 1.0));
    } while (samples < most &&
             (samples < fewest || error > wanted_error || samples * count < 0.1 * most_velocities));
    return {mean, error};
}

}  // namespace carom

#include "stats/entropy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "stats/paths/bin_number.h"
#include "util/random.h"

namespace carom {

VelocityEntropy::VelocityEntropy(const Particles& particles, const ThermalMotion& start)
    : kinds_(kinds_of(particles)), degrees_of_freedom_(start.degrees_of_freedom) {
    const Eigen::ArrayXd& inverse = particles.inverse_mass;
    scale_ = (inverse > 0.0).select(1.0 / (inverse * start.temperature()), 0.0).sqrt();
    int most = 0;
    for (Eigen::Index i = 0; i < inverse.size(); ++i)
        if (inverse[i] > 0.0)
            most = std::max(most, kinds_.members[static_cast<std::size_t>(kinds_.of[i])]);
    cells_per_axis_ = static_cast<int>(std::clamp(std::round(2.0 * std::cbrt(most)), 6.0, 24.0));
}

double VelocityEntropy::of(const Eigen::ArrayXXd& velocity) const {
    std::map<std::pair<int, int>, double> found;  // by kind and cell
    double all = 0.0;
    for (Eigen::Index i = 0; i < velocity.rows(); ++i) {
        if (scale_[i] == 0.0) continue;
        int cell = 0;
        for (Eigen::Index a = 0; a < velocity.cols(); ++a)
            cell = cells_per_axis_ * cell + cell_of(velocity(i, a) * scale_[i]);
        found[{kinds_.of[i], cell}] += 1.0;
        all += 1.0;
    }
    double sum = 0.0;
    for (const auto& [place, count] : found)
        sum -=
            count * std::log(count / double(kinds_.members[static_cast<std::size_t>(place.first)]));
    return all > 0.0 ? sum / all : 0.0;
}

double VelocityEntropy::in_equilibrium(int dimension) const {
    Random random(1, "entropy in equilibrium");
    const Eigen::Index count = scale_.size();
    const int samples = static_cast<int>(std::clamp<Eigen::Index>(200'000 / count, 4, 100));
    const auto moves = (scale_ > 0.0).cast<double>();
    double sum = 0.0;
    for (int s = 0; s < samples; ++s) {
        Eigen::ArrayXXd velocity(count, dimension);
        for (double& one : velocity.reshaped()) one = random.normal();
        const double square = (velocity.square().rowwise().sum() * moves).sum();
        velocity *= std::sqrt(degrees_of_freedom_ / square);
        velocity.colwise() *= (scale_ > 0.0).select(1.0 / scale_, 0.0);
        sum += of(velocity);
    }
    return sum / samples;
}

PositionEntropy::PositionEntropy(const Box& box, const Particles& particles,
                                 std::optional<int> along_longer)
    : counted_((particles.inverse_mass > 0.0).cast<double>()) {
    constexpr double wanted_in_cell = 5.0;
    const double cells = std::max(1.0, counted_.sum() / wanted_in_cell);
    const double stretch =
        box.dimension == 1 ? cells : std::sqrt(cells * box.size.maxCoeff() / box.size.minCoeff());
    cells_ = square_cells(
        box, along_longer.value_or(std::max(2, 2 * static_cast<int>(std::floor(0.5 * stretch)))));
}

double PositionEntropy::of(const Eigen::ArrayXXd& position) const {
    Eigen::ArrayXd found = Eigen::ArrayXd::Zero(cells_.all());
    for (Eigen::Index i = 0; i < position.rows(); ++i) {
        Eigen::Index cell = 0, stride = 1;
        for (Eigen::Index axis = 0; axis < position.cols(); ++axis) {
            const double place = bin_number(position(i, axis) / cells_.size[axis]);
            cell += stride *
                    static_cast<Eigen::Index>(std::clamp(place, 0.0, cells_.count[axis] - 1.0));
            stride *= cells_.count[axis];
        }
        found[cell] += counted_[i];
    }
    const double all = counted_.sum();
    double sum = 0.0;
    for (const double count : found)
        if (count > 0.0) sum -= count / all * std::log(count / all);
    return sum;
}

double PositionEntropy::of_even_spread() const {
    const double all = counted_.sum(), share = 1.0 / static_cast<double>(cells_.all());
    if (share == 1.0) return 0.0;
    double sum = 0.0;
    for (double n = 1.0; n <= all; n += 1.0) {
        const double chance =
            std::exp(std::lgamma(all + 1.0) - std::lgamma(n + 1.0) - std::lgamma(all - n + 1.0) +
                     n * std::log(share) + (all - n) * std::log1p(-share));
        sum -= chance * n / all * std::log(n / all);
    }
    return sum / share;
}

int VelocityEntropy::cell_of(double u) const {
    constexpr double reach = 4.0;
    const double place = (u + reach) / (2.0 * reach) * cells_per_axis_;
    return static_cast<int>(std::clamp(bin_number(place), 0.0, cells_per_axis_ - 1.0));
}

}  // namespace carom

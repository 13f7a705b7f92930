#include "stats/pairs/bond_order.h"

#include <array>
#include <cmath>
#include <complex>

#include "stats/pairs/near_pairs.h"

namespace carom {
namespace {

using Complex = std::complex<double>;

Complex sixth_power(const Complex& direction) {
    const Complex third = direction * direction * direction;
    return third * third;
}

// The seven components of a unit vector. The associated Legendre functions without sin^m theta,
// with z = cos theta, are written out; sin^m theta e^(i m phi) is the m-th power of x + i y.
std::array<Complex, 7> harmonics(const Vec& direction) {
    const Complex around(direction[0], direction[1]);
    const double z = direction[2], z2 = z * z;
    const std::array<double, 7> along{
        (z2 * (z2 * (231.0 * z2 - 315.0) + 105.0) - 5.0) / 16.0,
        std::sqrt(21.0) / 8.0 * z * (z2 * (33.0 * z2 - 30.0) + 5.0),
        std::sqrt(105.0 / 2.0) / 16.0 * (z2 * (33.0 * z2 - 18.0) + 1.0),
        std::sqrt(105.0 / 2.0) / 8.0 * z * (11.0 * z2 - 3.0),
        3.0 * std::sqrt(7.0) / 16.0 * (11.0 * z2 - 1.0),
        3.0 * std::sqrt(77.0 / 2.0) / 8.0 * z,
        std::sqrt(231.0 / 2.0) / 16.0};
    std::array<Complex, 7> all;
    Complex power = 1.0;
    for (std::size_t m = 0; m < all.size(); ++m) {
        all.at(m) = along.at(m) * power;
        power *= around;
    }
    return all;
}

}  // namespace

Eigen::ArrayXXcd bond_order(const Box& box, const Particles& particles,
                            const Eigen::ArrayXXd& positions) {
    const Eigen::Index count = particles.count(), components = box.dimension == 3 ? 7 : 1;
    Eigen::ArrayXXcd sums = Eigen::ArrayXXcd::Zero(count, components);
    Eigen::ArrayXd neighbours = Eigen::ArrayXd::Zero(count);
    const double farthest =
        count > 0 ? 2.0 * neighbour_distance * particles.radius.maxCoeff() : 0.0;
    NearPairs(box, positions, farthest).for_each([&](Eigen::Index i, Eigen::Index j) {
        const Vec apart = box.nearest(vec_in(positions, j) - vec_in(positions, i));
        const double contact = particles.radius[i] + particles.radius[j];
        const double distance = length(apart);
        if (!(distance < neighbour_distance * contact)) return;
        // They are the same for the opposite direction, seen from the other particle.
        Eigen::RowVectorXcd own(components);
        if (box.dimension == 3) {
            const std::array<Complex, 7> all = harmonics(apart / distance);
            own = Eigen::Map<const Eigen::RowVectorXcd>(all.data(), components);
        } else {
            own[0] = sixth_power({apart[0] / distance, apart[1] / distance});
        }
        for (const Eigen::Index k : {i, j}) {
            sums.row(k) += own.array();
            neighbours[k] += 1.0;
        }
    });
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index k = 0; k < components && neighbours[i] > 0.0; ++k)
            sums(i, k) /= neighbours[i];
    return sums;
}

double global_order(const Eigen::ArrayXXcd& order) {
    return order.cols() == 1 ? std::abs(order.mean()) : order.colwise().mean().matrix().norm();
}

double local_order(const Eigen::ArrayXXcd& order) {
    return order.cols() == 1 ? order.abs().mean() : order.matrix().rowwise().norm().mean();
}

}  // namespace carom

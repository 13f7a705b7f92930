#include "stats/entropy.h"

#include <algorithm>
#include <cmath>

#include "util/bin_number.h"

namespace carom {

PositionEntropy::PositionEntropy(const Box& box, const Particles& particles,
                                 std::optional<int> along_longest)
    : counted_((particles.inverse_mass > 0.0).cast<double>()) {
    constexpr double wanted_in_cell = 5.0;
    const double cells = std::max(1.0, counted_.sum() / wanted_in_cell);
    const double stretch = box.dimension == 1 ? cells
                           : box.dimension == 2
                               ? std::sqrt(cells * box.longest_side() / box.shortest_side())
                               : box.longest_side() * std::cbrt(cells / box.content());
    cells_ = square_cells(
        box, along_longest.value_or(std::max(2, 2 * static_cast<int>(std::floor(0.5 * stretch)))));
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

}  // namespace carom

#include "stats/pairs/near_pairs.h"

#include <algorithm>
#include <cmath>

namespace carom {

// Cells are at least as wide as the distance. Positions outside the box, which are possible with
// moving sides, are in the cells at its ends.
NearPairs::NearPairs(const Box& box, const Eigen::ArrayXXd& positions, double distance) {
    const Eigen::Index particles = positions.rows();
    Vec low, size{1.0, 1.0, 1.0};
    const auto all = static_cast<double>(particles);
    // No more cells than particles.
    const double most = std::max(1.0, positions.cols() == 3 ? std::cbrt(all) : std::sqrt(all));
    for (Eigen::Index axis = 0; axis < positions.cols(); ++axis) {
        is_periodic_[static_cast<std::size_t>(axis)] = box.is_periodic(axis);
        size[axis] = box.length(axis);
        if (!box.is_periodic(axis) && particles > 0) {
            low[axis] = positions.col(axis).minCoeff();
            size[axis] = positions.col(axis).maxCoeff() - low[axis];
        }
        const double room = distance > 0.0 ? size[axis] / distance : most;
        count_[axis] = static_cast<int>(std::clamp(std::floor(room), 1.0, std::ceil(most)));
    }
    begin_.assign(static_cast<std::size_t>(count_.prod()) + 1, 0);
    std::vector<int> cells;
    for (Eigen::Index i = 0; i < particles; ++i) {
        Eigen::Array3i at{0, 0, 0};
        for (Eigen::Index axis = 0; axis < positions.cols(); ++axis)
            if (size[axis] > 0.0)
                at[axis] = std::clamp(
                    static_cast<int>((positions(i, axis) - low[axis]) / size[axis] * count_[axis]),
                    0, count_[axis] - 1);
        cells.push_back(at[0] + count_[0] * (at[1] + count_[1] * at[2]));
        ++begin_[static_cast<std::size_t>(cells.back()) + 1];
    }
    for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
    std::vector<std::size_t> next = begin_;
    order_.resize(static_cast<std::size_t>(particles));
    for (Eigen::Index i = 0; i < particles; ++i)
        order_[next[static_cast<std::size_t>(cells[static_cast<std::size_t>(i)])]++] = i;
}

// The neighbours of a cell and the cell itself, each once.
std::vector<int> NearPairs::around(int cell) const {
    std::vector<int> all;
    const Eigen::Array3i at{cell % count_[0], cell / count_[0] % count_[1],
                            cell / (count_[0] * count_[1])};
    const int depth = count_[2] > 1 ? 1 : 0;
    const auto add = [&](Eigen::Array3i there) {
        for (int axis = 0; axis < 3; ++axis) {
            if (is_periodic_[static_cast<std::size_t>(axis)])
                there[axis] = (there[axis] + count_[axis]) % count_[axis];
            if (there[axis] < 0 || there[axis] >= count_[axis]) return;
        }
        const int number = there[0] + count_[0] * (there[1] + count_[1] * there[2]);
        if (std::ranges::find(all, number) == all.end()) all.push_back(number);
    };
    for (int dz = -depth; dz <= depth; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) add(at + Eigen::Array3i(dx, dy, dz));
    return all;
}

}  // namespace carom

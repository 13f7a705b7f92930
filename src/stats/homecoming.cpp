#include "stats/homecoming.h"

#include <cmath>
#include <cstddef>

namespace carom {

ReturnDistance return_distance(const Box& box, const Sample& start, const Sample& end) {
    Eigen::ArrayXXd apart = end.position - start.position;
    if (apart.rows() == 0) return {};
    for (Eigen::Index a = 0; a < apart.cols(); ++a)
        if (box.walls[static_cast<std::size_t>(a)] == Wall::periodic)
            apart.col(a) -= box.size[a] * (apart.col(a) / box.size[a]).round();
    const Eigen::ArrayXd square = apart.square().rowwise().sum();
    const double largest = std::sqrt(square.maxCoeff()), mean = std::sqrt(square.mean());
    return {largest, mean, std::log10(largest), std::log10(mean)};
}

}  // namespace carom

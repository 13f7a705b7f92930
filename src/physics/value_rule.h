// How the numbers of a species' particles are given, such as their radii.
#pragma once

#include <variant>
#include <vector>

namespace carom {

struct UniformDistribution {
    double low, high;
};
struct NormalDistribution {
    double mean, deviation;
};
/// One number for all, one for each particle, or a distribution to draw from.
using ValueRule =
    std::variant<double, std::vector<double>, UniformDistribution, NormalDistribution>;

}  // namespace carom

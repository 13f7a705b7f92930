#include "physics/exact_positions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "physics/archived.h"
#include "physics/multiprecision/multiprecision.h"

namespace carom {
namespace {

ReturnDistance distance_of(const Box& box, const Eigen::ArrayXXd& from, const Eigen::ArrayXXd& to) {
    Eigen::ArrayXXd apart = to - from;
    if (apart.rows() == 0) return {};
    for (Eigen::Index axis = 0; axis < apart.cols(); ++axis)
        for (double& one : apart.col(axis))
            one -= box.size[axis] * box.turns(static_cast<std::size_t>(axis), one);
    const Eigen::ArrayXd square = apart.square().rowwise().sum();
    const double largest = std::sqrt(square.maxCoeff()), mean = std::sqrt(square.mean());
    return {largest, mean, std::log10(largest), std::log10(mean)};
}

ReturnDistance distance_of(const Box& box, const std::vector<Real>& from,
                           const std::vector<Real>& to) {
    if (from.empty()) return {};
    const auto dimension = static_cast<std::size_t>(box.dimension);
    Real largest = 0.0, sum = 0.0;
    for (std::size_t k = 0; k < from.size(); k += dimension) {
        Real square = 0.0;
        for (std::size_t axis = 0; axis < dimension; ++axis) {
            Real apart = to[k + axis] - from[k + axis];
            const double times = box.turns(axis, static_cast<double>(apart));
            apart -= as_precise_as(apart, box.length(axis)) * times;
            square += apart * apart;
        }
        largest = std::max(largest, square);
        sum += square;
    }
    largest = sqrt(largest);
    const Real mean = sqrt(sum / static_cast<double>(from.size() / dimension));
    return {static_cast<double>(largest), static_cast<double>(mean), log10(largest), log10(mean)};
}

}  // namespace

ExactPositions::ExactPositions(const Box& box, Eigen::ArrayXXd doubles)
    : box_(box), doubles_(std::move(doubles)) {}

ExactPositions::ExactPositions(const Box& box, std::vector<Real> coordinates)
    : box_(box), coordinates_(std::make_shared<const std::vector<Real>>(std::move(coordinates))) {}

void ExactPositions::archive(Archive& archive) {
    std::optional<std::vector<Real>> in_full;
    if (coordinates_ != nullptr) in_full = *coordinates_;
    archive(box_, doubles_, in_full);
    if (!archive.is_reading()) return;
    coordinates_.reset();
    if (in_full) coordinates_ = std::make_shared<const std::vector<Real>>(*std::move(in_full));
}

ReturnDistance return_distance(const ExactPositions& a, const ExactPositions& b) {
    const bool in_full = a.coordinates_ != nullptr;
    const bool alike = in_full == (b.coordinates_ != nullptr) &&
                       a.doubles_.rows() == b.doubles_.rows() &&
                       (!in_full || a.coordinates_->size() == b.coordinates_->size());
    if (!alike)
        throw std::invalid_argument(
            "positions of different gases, or in different kinds of number");
    return in_full ? distance_of(a.box_, *a.coordinates_, *b.coordinates_)
                   : distance_of(a.box_, a.doubles_, b.doubles_);
}

ReturnDistance return_distance(const Box& box, const Sample& a, const Sample& b) {
    if (a.position.rows() != b.position.rows())
        throw std::invalid_argument("positions of different gases");
    return distance_of(box, a.position, b.position);
}

}  // namespace carom

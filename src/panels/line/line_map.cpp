#include "panels/line/line_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace carom {
namespace {

constexpr double share_of_spacing = 0.4;  // the radius that points are drawn with

double drawn_radius(const PanelContext& context, Eigen::Index i) {
    const auto species = static_cast<std::size_t>(context.particles.species[i]);
    if (const auto& wanted = context.looks()[species].drawn_radius) return *wanted;
    if (context.particles.radius[i] > 0.0) return context.particles.radius[i];
    return share_of_spacing * context.box().size[0] /
           static_cast<double>(context.particles.count());
}

}  // namespace

LineMap::LineMap(const PanelContext& context, const Sample& start)
    : true_length_(context.box().size[0]),
      ring_(context.box().is_periodic(0)),
      order_(static_cast<std::size_t>(context.particles.count())),
      radius_(context.particles.count()),
      true_(context.particles.count()),
      push_(context.particles.count()),
      length_(true_length_) {
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](Eigen::Index a, Eigen::Index b) {
        return start.position(a, 0) < start.position(b, 0);
    });
    for (const Eigen::Index i : order_) {
        radius_[i] = drawn_radius(context, i);
        true_[i] = radius_[i] == context.particles.radius[i];
        const double growth = 2.0 * (radius_[i] - context.particles.radius[i]);
        push_[i] = length_ - true_length_ + 0.5 * growth;
        length_ += growth;
    }
}

double LineMap::place(Eigen::Index i, double x, double last) const {
    if (!ring_) return x + push_[i];
    const double turns = std::round((last - push_[i] - x) / true_length_);
    return x + turns * true_length_ + push_[i];
}

// On a ring, the first bead is placed near its last place; each further bead is the next one to the
// right, or at the same place up to round-off.
Eigen::ArrayXd LineMap::places(const Sample& sample, const Eigen::ArrayXd& last) const {
    Eigen::ArrayXd places(static_cast<Eigen::Index>(order_.size()));
    double before = 0.0;
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const Eigen::Index i = order_[k];
        const double x = sample.position(i, 0);
        if (!ring_ || k == 0) {
            places[i] = place(i, x, last.size() > 0 ? last[i] : x + push_[i]);
        } else {
            const double behind = before - 1e-9 * true_length_;
            places[i] = x + std::ceil((behind - x) / true_length_) * true_length_ + push_[i];
        }
        before = places[i] - push_[i];
    }
    return places;
}

}  // namespace carom

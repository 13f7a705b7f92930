#include "stats/displacements.h"

#include <cmath>
#include <limits>

namespace carom {

void Displacements::fly(Eigen::Index particle, double time, const Vec& after) {
    if (time < time_[particle]) return;  // a collision before the first sample
    moved_.row(particle) += (time - time_[particle]) * velocity_.row(particle);
    time_[particle] = time;
    put(after, velocity_, particle);
}

Eigen::ArrayXXd Displacements::operator()(const Sample& sample,
                                          std::span<const Collision> collisions) {
    const Eigen::ArrayXXd& position = sample.position;
    if (sample.time < from_)
        return Eigen::ArrayXXd::Constant(position.rows(), position.cols(),
                                         std::numeric_limits<double>::quiet_NaN());
    if (start_.size() == 0) {
        start_ = position;
        moved_ = 0.0 * position;
        time_ = Eigen::ArrayXd::Constant(position.rows(), sample.time);
        velocity_ = sample.velocity;
    }
    for (const Collision& one : collisions) {
        fly(one.first, one.time, one.first_after);
        if (one.second.is_particle()) fly(one.second.particle(), one.time, one.second_after);
    }
    moved_ += velocity_.colwise() * (sample.time - time_);
    time_ = sample.time;
    velocity_ = sample.velocity;
    // The straight flights determine only how often a particle has gone around the periodic box;
    // the positions supply the displacement to full precision.
    for (Eigen::Index axis = 0; axis < moved_.cols(); ++axis) {
        const Eigen::ArrayXd inside = position.col(axis) - start_.col(axis);
        const double period = box_.is_periodic(axis) ? box_.size[axis] : 0.0;
        moved_.col(axis) = period > 0.0
                               ? inside + period * ((moved_.col(axis) - inside) / period).round()
                               : inside;
    }
    return moved_;
}

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
    LineFit fit;
    for (std::size_t i = 0; i < x.size(); ++i) {
        fit.mean_x += x[i] / static_cast<double>(x.size());
        fit.mean_y += y[i] / static_cast<double>(x.size());
    }
    double products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        products += (x[i] - fit.mean_x) * (y[i] - fit.mean_y);
        squares += (x[i] - fit.mean_x) * (x[i] - fit.mean_x);
    }
    fit.slope = products / squares;
    return fit;
}

}  // namespace carom

#include "stats/paths/paths.h"

#include <algorithm>
#include <cmath>

namespace carom {

std::vector<double> velocity_changes(const Run& run) {
    std::vector<double> times;
    for (const RunEvent& event : run.events)
        if (std::holds_alternative<ReverseVelocities>(event.action) ||
            std::holds_alternative<Heat>(event.action))
            times.push_back(event.at);
    return times;
}

double length_of_way(const Eigen::Array2d& middle, const Eigen::Array2d& gravity, double span) {
    const double speed = middle.matrix().norm(), pull = gravity.matrix().norm();
    const double change = pull * span;
    if (change < 1e-3 * speed || change == 0.0) return span * speed;  // to the sixth digit
    const double along = (middle * gravity).sum() / pull;
    const double across = std::sqrt(std::max(0.0, speed * speed - along * along));
    const auto primitive = [&](double w) {
        const double bent = across > 0.0 ? across * across * std::asinh(w / across) : 0.0;
        return 0.5 * (w * std::hypot(across, w) + bent) / pull;
    };
    return primitive(along + 0.5 * change) - primitive(along - 0.5 * change);
}

Paths::Paths(const Box& box, std::vector<double> changes) : changes_(std::move(changes)) {
    for (int axis = 0; axis < box.dimension; ++axis) gravity_[axis] = box.surfaces.gravity[axis];
}

Paths::Point Paths::at(const Sample& sample, Eigen::Index particle) {
    Point point{.time = sample.time};
    for (Eigen::Index axis = 0; axis < sample.position.cols(); ++axis) {
        point.place[axis] = sample.position(particle, axis);
        point.velocity[axis] = sample.velocity(particle, axis);
    }
    return point;
}

Paths::Point Paths::moved(const Point& from, double time) const {
    const double span = time - from.time;
    return {time, from.place + span * (from.velocity + 0.5 * span * gravity_),
            from.velocity + span * gravity_};
}

// The end where there is none.
double Paths::change_between(double from, double to) const {
    const auto change = std::ranges::lower_bound(changes_, from);
    return change != changes_.end() && *change < to ? *change : to;
}

}  // namespace carom

#include "panels/gas/flights.h"

#include <algorithm>
#include <cmath>

namespace carom {

Flights::Flights(const Box& box, Eigen::Index axis, std::vector<Eigen::Index> particles)
    : axis_(axis),
      period_(box.is_periodic(axis) ? box.size[axis] : 0.0),
      acceleration_(box.surfaces.gravity[axis]),
      particles_(std::move(particles)) {}

double Flights::within(double place) const {
    return period_ > 0.0 ? place - period_ * std::floor(place / period_) : place;
}

void Flights::meet(Corner& corner, std::int32_t particle, double place, double after) const {
    for (std::size_t k = 0; k < particles_.size(); ++k) {
        if (particles_[k] != particle) continue;
        corner.place[k] = within(place);
        corner.after[k] = after;
    }
}

std::vector<Flights::Corner> Flights::see(const FrameInput& input) {
    std::vector<Corner> corners;
    const auto is_followed = [&](std::int32_t particle) {
        return std::ranges::find(particles_, particle) != particles_.end();
    };
    for (const Collision& collision : input.advanced.collisions) {
        if (last_.place.empty()) break;  // there is no frame before
        const bool with_particle = collision.second.is_particle();
        if (!is_followed(collision.first) &&
            !(with_particle && is_followed(collision.second.particle())))
            continue;
        Corner corner{collision.time, last_.place, last_.after, last_.after};
        const double elapsed = collision.time - last_.time, gain = elapsed * acceleration_;
        for (std::size_t k = 0; k < particles_.size(); ++k) {
            corner.place[k] = within(last_.place[k] + elapsed * (last_.after[k] + 0.5 * gain));
            corner.before[k] = corner.after[k] = last_.after[k] + gain;
        }
        meet(corner, collision.first, collision.first_position[axis_],
             collision.first_after[axis_]);
        if (with_particle)
            meet(corner, collision.second.particle(), collision.second_position[axis_],
                 collision.second_after[axis_]);
        last_ = corner;
        corners.push_back(std::move(corner));
    }
    Corner now{input.tick.time, {}, {}, {}};
    for (const Eigen::Index i : particles_) {
        now.place.push_back(input.sample.position(i, axis_));
        now.after.push_back(input.sample.velocity(i, axis_));
    }
    now.before = now.after;
    if (input.advanced.reversals != reversals_) {
        if (!last_.place.empty()) now.before = last_.after;
        corners.push_back(now);
    }
    reversals_ = input.advanced.reversals;
    last_ = std::move(now);
    return corners;
}

}  // namespace carom

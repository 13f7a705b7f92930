#include "physics/surfaces/mover.h"

#include <algorithm>

#include "physics/surfaces/barrier.h"

namespace carom {

double Mover::place_at(double now) const {
    const double t = now - time;
    return place + t * (velocity + 0.5 * t * acceleration);
}

void Mover::advance(double now) {
    place = place_at(now);
    velocity = velocity_at(now);
    time = now;
}

double Mover::registered_until() const {
    return time + std::min(fall_time(place - low, velocity, acceleration),
                           fall_time(high - place, -velocity, -acceleration));
}

void Mover::change() {
    before = velocity;
    changed_at = change_at;
    velocity = then;
    change_at = never<double>;
    ++changes;
}

void Mover::move_epoch(double shift) {
    time -= shift;
    change_at -= shift;
    changed_at -= shift;
}

void Mover::reverse() {
    velocity = -velocity;
    change_at = changed_at > -never<double> ? time + (time - changed_at) : never<double>;
    then = -before;
    changed_at = -never<double>;
    ++changes;
}

std::vector<Mover> movers_of(const Box& box) {
    std::vector<Mover> movers;
    const auto add = [&](const Behaviour& behaviour, int axis, double place, std::size_t surface) {
        Mover mover{.surface = static_cast<std::int32_t>(surface),
                    .axis = static_cast<std::size_t>(axis),
                    .place = place};
        if (const auto* driven = std::get_if<Driven>(&behaviour)) {
            mover.velocity = driven->velocity;
            mover.change_at = driven->until;
        } else if (const auto* piston = std::get_if<Piston>(&behaviour)) {
            mover.velocity = piston->velocity;
            mover.inverse_mass = 1.0 / piston->mass;
            mover.acceleration = piston->force * mover.inverse_mass + box.surfaces.gravity[axis];
        } else {
            return;
        }
        movers.push_back(mover);
    };
    for (int side = 0; side < 4; ++side)
        if (!box.is_periodic(side / 2))
            add(box.surfaces.sides[static_cast<std::size_t>(side)], side / 2,
                side % 2 == 0 ? 0.0 : box.length(side / 2), static_cast<std::size_t>(side));
    for (std::size_t k = 0; k < box.surfaces.partitions.size(); ++k) {
        const Partition& partition = box.surfaces.partitions[k];
        add(partition.behaviour, partition.axis, partition.at, 4 + k);
    }
    return movers;
}

}  // namespace carom

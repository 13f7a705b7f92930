#include "physics/events/fixed_step_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "physics/collision/contact_rule.h"
#include "physics/collision_error.h"
#include "util/interrupt.h"

namespace carom {

FixedStepLoop::FixedStepLoop(const Box& box, const Particles& particles, double step,
                             std::int64_t most)
    : box_(box),
      particles_(particles),
      step_(step),
      order_(static_cast<std::size_t>(particles.count())),
      most_(most) {
    std::iota(order_.begin(), order_.end(), 0);
}

void FixedStepLoop::start(Sample state) {
    now_ = std::move(state);
    first_ = now_.time;
    steps_ = 0;
}

void FixedStepLoop::forget() {
    counts_ = {};
    impulses_ = {};
}

void FixedStepLoop::move_to(double time) {
    now_.position += (time - now_.time) * now_.velocity;
    now_.time = time;
}

void FixedStepLoop::advance(double time, std::vector<Collision>* record,
                            const TimeCallback& on_progress, VelocityLog* velocities) {
    constexpr std::int64_t steps_between_calls = 1024;
    if (velocities) velocities->give_up();
    while (true) {
        const double next = first_ + step_ * static_cast<double>(steps_ + 1);
        if (next > time) break;
        throw_if_interrupted();
        move_to(next);
        ++steps_;
        const std::int64_t before = counts_.particle + counts_.wall;
        reflect(record);
        collide_overlapping(record);
        count_collisions(counts_.particle + counts_.wall - before);
        if (on_progress && steps_ % steps_between_calls == 0) on_progress(next);
    }
}

void FixedStepLoop::count_collisions(std::int64_t in_step) {
    collisions_ += in_step;
    if (collisions_ <= most_) return;
    throw TooManyCollisions(
        {.most = most_, .begin = now_.time - step_, .end = now_.time, .count = in_step});
}

// Reflects the particles that are beyond a wall and move outward.
void FixedStepLoop::reflect(std::vector<Collision>* record) {
    for (std::int32_t i = 0; i < particles_.count(); ++i)
        for (int axis = 0; axis < box_.dimension; ++axis) {
            if (box_.is_periodic(axis)) continue;
            const double x = now_.position(i, axis), radius = particles_.radius[i];
            double& v = now_.velocity(i, axis);
            const bool is_low = x < radius && v < 0.0;
            if (!is_low && !(x > box_.size[axis] - radius && v > 0.0)) continue;
            const Vec before = velocity(i);
            ContactRule::reflect(v);
            ++counts_.wall;
            const int side = 2 * axis + (is_low ? 0 : 1);
            impulses_.wall[static_cast<std::size_t>(side)] +=
                ContactRule::change(std::abs(v)) / particles_.inverse_mass[i];
            if (record == nullptr) continue;
            Vec contact = place(i);
            contact[axis] = is_low ? 0.0 : box_.size[axis];
            record->push_back({now_.time, i, static_cast<Side>(side), place(i), contact, before,
                               Vec(), velocity(i), Vec()});
        }
}

// Sweep along x: only particles that are near each other in x are compared, across a periodic side
// too.
void FixedStepLoop::collide_overlapping(std::vector<Collision>* record) {
    const auto along = [&](std::int32_t i) { return box_.wrapped(0, now_.position(i, 0)); };
    std::ranges::sort(order_, {}, [&](std::int32_t i) { return std::pair(along(i), i); });
    const double reach = 2.0 * particles_.radius.maxCoeff();
    const std::size_t count = order_.size();
    const std::size_t turns = box_.is_periodic(0) ? 2 : 1;
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < turns * count && b - a < count; ++b) {
            const std::int32_t first = order_[a], second = order_[b % count];
            const double across = b < count ? 0.0 : box_.size[0];
            if (along(second) + across - along(first) > reach) break;
            collide(first, second, record);
        }
}

void FixedStepLoop::collide(std::int32_t first, std::int32_t second,
                            std::vector<Collision>* record) {
    const Vec apart = box_.nearest(place(second) - place(first));
    const double sigma = particles_.radius[first] + particles_.radius[second];
    const double distance = length(apart);
    if (distance >= sigma || distance == 0.0) return;
    const Vec first_before = velocity(first), second_before = velocity(second);
    const Vec relative = second_before - first_before;
    const RelativeMotion<double, 3> motion{{apart[0], apart[1], apart[2]},
                                           {relative[0], relative[1], relative[2]}};
    const double first_w = particles_.inverse_mass[first],
                 second_w = particles_.inverse_mass[second];
    if (dot(apart, relative) >= 0.0 || first_w + second_w == 0.0) return;
    static_assert(ContactRule::keeps_species);
    const Unrounded<double> factor = ContactRule::impulse(motion, first_w, second_w);
    put(first_before + product_of(first_w, factor) * apart, now_.velocity, first);
    put(second_before - product_of(second_w, factor) * apart, now_.velocity, second);
    ++counts_.particle;
    impulses_.virial -= factor.value * distance * distance;
    impulses_.largest_overlap = std::max(impulses_.largest_overlap, 1.0 - distance / sigma);
    if (record == nullptr) return;
    record->push_back({now_.time, first, second, place(first), place(first) + apart, first_before,
                       second_before, velocity(first), velocity(second)});
}

void FixedStepLoop::reverse(double time) {
    move_to(time);
    now_.velocity = -now_.velocity;
    first_ = time;
    steps_ = 0;
}

// Particles may overlap afterwards, as they may at the end of a step.
std::optional<Partner> FixedStepLoop::displace(std::int64_t particle, const Displacement& by,
                                               double time) {
    move_to(time);
    first_ = time;
    steps_ = 0;
    for (int axis = 0; axis < box_.dimension; ++axis)
        now_.position(particle, axis) +=
            std::strtod(by[static_cast<std::size_t>(axis)].c_str(), nullptr);
    return std::nullopt;
}

void FixedStepLoop::sample(double time, Sample& state) const {
    state = now_;
    state.time = time;
    state.position += (time - now_.time) * now_.velocity;
    for (Eigen::Index axis = 0; axis < box_.dimension; ++axis)
        for (double& x : state.position.col(axis)) x = box_.wrapped(axis, x);
}

Sample FixedStepLoop::sample_of_positions(double time) const {
    Sample state;
    sample(time, state);
    state.velocity = {};
    return state;
}

std::vector<double> FixedStepLoop::positions(double time) const {
    std::vector<double> all;
    for (Eigen::Index i = 0; i < particles_.count(); ++i)
        for (int axis = 0; axis < box_.dimension; ++axis)
            all.push_back(now_.position(i, axis) + (time - now_.time) * now_.velocity(i, axis));
    return all;
}

}  // namespace carom

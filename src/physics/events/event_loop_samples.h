// The part of the event loop that returns the state of all particles at a time between two events.
// Included only by event_loop_steps.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/events/event_loop.h"

namespace carom {

// Calls see(number, body) for each body. If there are many, they are visited in the order of their
// numbers: the results are then written sequentially, and the bodies, which are scattered in
// memory, can be prefetched.
template <int Dimension, typename Scalar, bool has_surfaces>
template <typename See>
void EventLoop<Dimension, Scalar, has_surfaces>::for_each_body(const See& see) const {
    constexpr std::size_t many = 1 << 14, ahead = 16;
    const std::size_t count = bodies_.size();
    if (count < many) {
        for (std::size_t k = 0; k < count; ++k) see(number_[k], bodies_[k]);
        return;
    }
    std::vector<std::int32_t> places(count);
    for (std::size_t k = 0; k < count; ++k)
        places[static_cast<std::size_t>(number_[k])] = static_cast<std::int32_t>(k);
    const auto body_of = [&](std::size_t number) -> const Body& {
        return bodies_[static_cast<std::size_t>(places[number])];
    };
    for (std::size_t number = 0; number < count; ++number) {
        if (number + ahead < count) __builtin_prefetch(&body_of(number + ahead));
        see(static_cast<std::int32_t>(number), body_of(number));
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::sample(double time, Sample& state) const {
    const auto count = static_cast<Eigen::Index>(bodies_.size());
    state.time = time;
    state.position.resize(count, Dimension);
    state.velocity.resize(count, Dimension);
    const Scalar local = clock_.local(time);
    for_each_body([&](std::int32_t number, const Body& b) {
        for (std::size_t a = 0; a < Dimension; ++a) {
            const auto axis = static_cast<Eigen::Index>(a);
            const auto x = static_cast<double>(position_at(b, a, local));
            state.position(number, axis) = box_.wrapped(a, x);
            state.velocity(number, axis) = static_cast<double>(velocity_at(b, a, local));
        }
    });
}

template <int Dimension, typename Scalar, bool has_surfaces>
Sample EventLoop<Dimension, Scalar, has_surfaces>::sample_of_positions(double time) const {
    Sample state{time, Eigen::ArrayXXd(static_cast<Eigen::Index>(bodies_.size()), Dimension), {}};
    const Scalar local = clock_.local(time);
    for_each_body([&](std::int32_t number, const Body& b) {
        for (std::size_t a = 0; a < Dimension; ++a)
            state.position(number, static_cast<Eigen::Index>(a)) =
                box_.wrapped(a, static_cast<double>(position_at(b, a, local)));
    });
    return state;
}

template <int Dimension, typename Scalar, bool has_surfaces>
Sample EventLoop<Dimension, Scalar, has_surfaces>::sample_of_velocities(double time) const {
    Sample state{time, {}, Eigen::ArrayXXd(static_cast<Eigen::Index>(bodies_.size()), Dimension)};
    const Scalar local = clock_.local(time);
    for_each_body([&](std::int32_t number, const Body& b) {
        for (std::size_t a = 0; a < Dimension; ++a)
            state.velocity(number, static_cast<Eigen::Index>(a)) =
                static_cast<double>(velocity_at(b, a, local));
    });
    return state;
}

template <int Dimension, typename Scalar, bool has_surfaces>
std::vector<Scalar> EventLoop<Dimension, Scalar, has_surfaces>::positions(double time) const {
    std::vector<Scalar> all(bodies_.size() * Dimension);
    const Scalar local = clock_.local(time);
    for_each_body([&](std::int32_t number, const Body& b) {
        for (std::size_t a = 0; a < Dimension; ++a)
            all[static_cast<std::size_t>(number) * Dimension + a] = position_at(b, a, local);
    });
    return all;
}

}  // namespace carom

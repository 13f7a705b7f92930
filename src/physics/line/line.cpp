#include "physics/line/line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "physics/collision/contact_rule.h"
#include "physics/collision/flight.h"
#include "physics/collision_error.h"

namespace carom {
template <typename Scalar, typename BodyType>
Line<Scalar, BodyType>::Line(const Box& box, const Particles& particles, const Arithmetic&)
    : length_(box.size[0]),
      periodic_(box.is_periodic(0)),
      count_(static_cast<std::int32_t>(particles.count())) {}

template <typename Scalar, typename BodyType>
std::vector<std::int32_t> Line<Scalar, BodyType>::order(const Bodies& bodies) {
    std::vector<std::int32_t> numbers = PlainBodies<Body>::order(bodies);
    std::stable_sort(numbers.begin(), numbers.end(), [&](std::int32_t a, std::int32_t b) {
        return bodies[static_cast<std::size_t>(a)].x[0] < bodies[static_cast<std::size_t>(b)].x[0];
    });
    return numbers;
}

template <typename Scalar, typename BodyType>
void Line<Scalar, BodyType>::enter(Bodies& bodies) {
    for (Body& body : bodies) body.turns = 0;
}

// From the right end of one body to the left end of the next; `around`: across the end of a
// periodic line.
template <typename Scalar, typename BodyType>
Scalar Line<Scalar, BodyType>::gap(const Body& left, const Body& right, const Scalar& now,
                                   bool around) const {
    const Scalar apart = position_at(right, 0, now) - position_at(left, 0, now);
    const double turns = right.turns - left.turns + (around ? 1 : 0);
    return (apart + turns * length_) - (left.radius + right.radius);
}

template <typename Scalar, typename BodyType>
[[gnu::always_inline]] inline void Line<Scalar, BodyType>::predict_pair(const Bodies& bodies,
                                                                        std::int32_t i,
                                                                        bool to_the_right,
                                                                        const Scalar& now,
                                                                        Event<Scalar>& first) {
    const bool at_end = i == (to_the_right ? last() : 0);
    if (at_end && (!periodic_ || count_ == 1)) return;
    const std::int32_t j = at_end ? last() - i : to_the_right ? i + 1 : i - 1;
    const Body& left = bodies[static_cast<std::size_t>(to_the_right ? i : j)];
    const Body& right = bodies[static_cast<std::size_t>(to_the_right ? j : i)];
    const Scalar approach = velocity_at(left, 0, now) - velocity_at(right, 0, now);
    Scalar time = now;
    if constexpr (Falls<Body>) {
        const Scalar apart = std::max(Scalar(0.0), gap(left, right, now, at_end));
        time += fall_time<Scalar>(apart, -approach, right.a[0] - left.a[0]);
    } else {
        if (!(approach > 0.0)) return;
        time += std::max(Scalar(0.0), gap(left, right, now, at_end)) / approach;
    }
    if (j != first.partner) first.notice(time);
    if (time > first.time || (time == first.time && j >= first.partner)) return;
    first.time = time;
    first.contact_time = rounded_down(time);
    first.partner = j;
    first.partner_collisions = bodies[static_cast<std::size_t>(j)].collisions & most_collisions;
}

template <typename Scalar, typename BodyType>
void Line<Scalar, BodyType>::predict_neighbours(const Bodies& bodies, std::int32_t i,
                                                const Scalar& now, Event<Scalar>& first) {
    predict_pair(bodies, i, true, now, first);
    predict_pair(bodies, i, false, now, first);
}

// Predicts when the first or the last bead reaches the wall next to it, or the end of a periodic
// line.
template <typename Scalar, typename BodyType>
[[gnu::always_inline]] inline void Line<Scalar, BodyType>::predict_end(const Bodies& bodies,
                                                                       std::int32_t i,
                                                                       const Scalar& now,
                                                                       Event<Scalar>& first) {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    const bool up = body.v[0] > 0.0;
    if (!periodic_ && i != (up ? last() : 0)) return;
    const double margin = periodic_ ? 0.0 : body.radius;
    const Scalar time = now + wall_time(position_at(body, 0, now), body.v[0], Scalar(margin),
                                        Scalar(length_ - margin));
    first.notice(time);
    if (time >= first.time) return;
    first.time = time;
    first.contact_time = never<double>;
    first.border = ((periodic_ ? first_cell_side : 0U) + (up ? 1U : 0U)) & most_border;
}

template <typename Scalar, typename BodyType>
Scalar Line<Scalar, BodyType>::predict(Bodies& bodies, std::int32_t i, const Scalar& now) {
    Event<Scalar> first;
    predict_neighbours(bodies, i, now, first);
    predict_end(bodies, i, now, first);
    return take(first, bodies[static_cast<std::size_t>(i)]);
}

template <typename Scalar, typename BodyType>
void Line<Scalar, BodyType>::cross(Bodies& bodies, std::int32_t i, int side, const Scalar& now) {
    Body& body = bodies[static_cast<std::size_t>(i)];
    advance_body(body, now);
    body.x[0] += side == 1 ? -length_ : length_;
    body.turns += side == 1 ? 1 : -1;
}

// Of two alone on a ring either may be the left one.
template <typename Scalar, typename BodyType>
bool Line<Scalar, BodyType>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                     Contact<1>& contact) const {
    Body& a = bodies[static_cast<std::size_t>(i)];
    Body& b = bodies[static_cast<std::size_t>(j)];
    const bool ring_of_two = periodic_ && count_ == 2;
    const bool across_the_end = periodic_ && i == last() && j == 0;
    const bool a_is_left = ring_of_two ? a.v[0] > b.v[0] : j == i + 1 || across_the_end;
    const Body& left = a_is_left ? a : b;
    const Body& right = a_is_left ? b : a;
    if (!(left.v[0] > right.v[0])) return false;
    const Scalar a_w = as_precise_as(a.v[0], a.inverse_mass),
                 b_w = as_precise_as(a.v[0], b.inverse_mass);
    if (!(a_w + b_w > 0.0))
        throw CollisionError(
            "two beads of infinite mass meet: on a line they can neither pass nor yield; give one "
            "of them a finite mass, or let them move apart");
    const double sigma = a.radius + b.radius;
    const bool around = &left > &right;
    const auto depth = static_cast<double>(-gap(left, right, a.time, around));
    contact.separation = {a_is_left ? sigma : -sigma};
    contact.virial =
        sigma * ContactRule::change(static_cast<double>((left.v[0] - right.v[0]) / (a_w + b_w)));
    contact.overlap = sigma > 0.0 ? std::max(0.0, depth / sigma) : 0.0;
    const auto [a_share, b_share] = ContactRule::shares_on_line(a.inverse_mass, b.inverse_mass);
    static_assert(ContactRule::keeps_species);
    ContactRule::push_on_line(a.v[0], b.v[0], as_precise_as(a.v[0], a_share),
                              as_precise_as(a.v[0], b_share));
    return true;
}

template <typename Scalar, typename BodyType>
std::optional<std::int32_t> Line<Scalar, BodyType>::overlapped(const Bodies& bodies, std::int32_t i,
                                                               const Scalar& now,
                                                               double slack) const {
    const auto at = [&](std::int32_t k) -> const Body& {
        return bodies[static_cast<std::size_t>(k)];
    };
    const bool has_right = i < last() || (periodic_ && count_ > 1);
    const bool has_left = i > 0 || (periodic_ && count_ > 1);
    const std::int32_t right = i < last() ? i + 1 : 0, left = i > 0 ? i - 1 : last();
    if (has_right && gap(at(i), at(right), now, i == last()) < -slack * length_) return right;
    if (has_left && gap(at(left), at(i), now, i == 0) < -slack * length_) return left;
    return std::nullopt;
}

template class Line<double>;
template class Line<Real>;
template class Line<double, FallingBody<double>>;
template class Line<Real, FallingBody<Real>>;

}  // namespace carom

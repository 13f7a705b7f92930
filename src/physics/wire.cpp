#include "physics/wire.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "physics/pair_collision.h"

namespace carom {

Wire::Wire(const Box& box, const Eigen::ArrayXd& radii)
    : length_(box.size[0]),
      periodic_(box.walls[0] == Wall::periodic),
      count_(static_cast<std::int32_t>(radii.size())) {}

std::vector<std::int32_t> Wire::order(const Bodies& bodies) {
    std::vector<std::int32_t> numbers(bodies.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::stable_sort(numbers.begin(), numbers.end(), [&](std::int32_t a, std::int32_t b) {
        return bodies[static_cast<std::size_t>(a)].x < bodies[static_cast<std::size_t>(b)].x;
    });
    return numbers;
}

void Wire::enter(Bodies& bodies) {
    for (Body& body : bodies) body.turns = 0;
}

// From the right end of one body to the left end of the next; `around`: across the end of a
// periodic wire.
double Wire::gap(const Body& left, const Body& right, double now, bool around) const {
    const double there = right.x[0] + right.v[0] * (now - right.time);
    const double here = left.x[0] + left.v[0] * (now - left.time);
    const double turns = right.turns - left.turns + (around ? 1 : 0);
    return ((there - here) + turns * length_) - (left.radius + right.radius);
}

void Wire::foresee_pair(const Bodies& bodies, std::int32_t i, bool to_the_right, double now,
                        Event& first) const {
    const bool at_end = i == (to_the_right ? last() : 0);
    if (at_end && (!periodic_ || count_ == 1)) return;
    const std::int32_t j = at_end ? last() - i : to_the_right ? i + 1 : i - 1;
    const Body& left = bodies[static_cast<std::size_t>(to_the_right ? i : j)];
    const Body& right = bodies[static_cast<std::size_t>(to_the_right ? j : i)];
    const double approach = left.v[0] - right.v[0];
    if (!(approach > 0.0)) return;
    const double time = now + std::max(0.0, gap(left, right, now, at_end)) / approach;
    if (time > first.contact_time || (time == first.contact_time && j >= first.partner)) return;
    first.contact_time = time;
    first.partner = j;
    first.partner_collisions = bodies[static_cast<std::size_t>(j)].collisions & most_collisions;
}

// The wall beside the first or the last bead, or the end of a periodic wire.
void Wire::foresee_end(const Bodies& bodies, std::int32_t i, double now, Event& first) const {
    const Body& body = bodies[static_cast<std::size_t>(i)];
    first.time = first.contact_time;
    const bool up = body.v[0] > 0.0;
    if (!periodic_ && i != (up ? last() : 0)) return;
    const double margin = periodic_ ? 0.0 : body.radius;
    const double x = body.x[0] + body.v[0] * (now - body.time);
    const double time = now + wall_time(x, body.v[0], margin, length_ - margin);
    if (time >= first.contact_time) return;
    first.time = time;
    first.border = ((periodic_ ? first_cell_side : 0U) + (up ? 1U : 0U)) & 7U;
}

Event Wire::foresee(const Bodies& bodies, std::int32_t i, double now, const EventQueue&) {
    Event first;
    foresee_pair(bodies, i, true, now, first);
    foresee_pair(bodies, i, false, now, first);
    foresee_end(bodies, i, now, first);
    return first;
}

Event Wire::foresee_after_crossing(const Bodies& bodies, std::int32_t i, int, const Event&,
                                   double now, const EventQueue& queue) {
    return foresee(bodies, i, now, queue);
}

void Wire::cross(Bodies& bodies, std::int32_t i, int side, double now) {
    Body& body = bodies[static_cast<std::size_t>(i)];
    body.x[0] += body.v[0] * (now - body.time);
    body.time = now;
    body.x[0] += side == 1 ? -length_ : length_;
    body.turns += side == 1 ? 1 : -1;
}

// Beads of equal mass exchange their velocities to the last bit. Of two alone on a ring either may
// be the left one.
bool Wire::collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<1>& contact) const {
    Body& a = bodies[static_cast<std::size_t>(i)];
    Body& b = bodies[static_cast<std::size_t>(j)];
    const bool ring_of_two = periodic_ && count_ == 2;
    const bool across_the_end = periodic_ && i == last() && j == 0;
    const bool a_is_left = ring_of_two ? a.v[0] > b.v[0] : j == i + 1 || across_the_end;
    const Body& left = a_is_left ? a : b;
    const Body& right = a_is_left ? b : a;
    if (!(left.v[0] > right.v[0])) return false;
    const double w = a.inverse_mass + b.inverse_mass;
    if (!(w > 0.0))
        throw std::runtime_error(
            "two beads of infinite mass meet: on a wire they can neither pass nor yield; give one "
            "of them a finite mass, or let them move apart");
    const double sigma = a.radius + b.radius;
    const bool around = &left > &right;
    const double depth = -gap(left, right, a.time, around);
    const double impulse = 2.0 * (left.v[0] - right.v[0]) / w;  // 2 v / (w1 + w2)
    contact.separation = {a_is_left ? sigma : -sigma};
    contact.virial = sigma * impulse;
    contact.overlap = sigma > 0.0 ? std::max(0.0, depth / sigma) : 0.0;
    if (a.inverse_mass == b.inverse_mass) {
        std::swap(a.v[0], b.v[0]);
        return true;
    }
    a.v[0] += (a_is_left ? -impulse : impulse) * a.inverse_mass;
    b.v[0] += (a_is_left ? impulse : -impulse) * b.inverse_mass;
    return true;
}

}  // namespace carom

#include "support/slow_simulator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::test {

SlowSimulator::SlowSimulator(const Box& box, const Particles& particles, const Sample& start)
    : box_(box), images_(images_of(box, 2)) {
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        bodies_.push_back({{}, {}, particles.radius[i], particles.inverse_mass[i]});
    adopt(start);
}

SlowSimulator::Pair SlowSimulator::pair(const Body& a, const Body& b,
                                        const SlowVector& image) const {
    return {b.x + image - a.x, b.v - a.v, a.radius + b.radius};
}

void SlowSimulator::look_at_pairs(Candidate& best) const {
    // No two particles come closer to each other than this along an axis in one step.
    const long double closer = 0.5L * static_cast<long double>(box_.shortest_side());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
            const Body &a = bodies_[i], &b = bodies_[j];
            if (a.inverse_mass + b.inverse_mass == 0.0L) continue;
            for (const SlowVector& image : images_) {
                const Pair p = pair(a, b, image);
                if (largest(p.x) > p.contact + closer) continue;
                const long double approach = dot(p.x, p.v), v2 = dot(p.v, p.v);
                // An approach within the rounding errors of doubles is none.
                constexpr long double epsilon = std::numeric_limits<double>::epsilon();
                long double rounding = 0.0L;
                for (int axis = 0; axis < box_.dimension; ++axis)
                    rounding += std::abs(p.x[axis]) * (std::abs(a.v[axis]) + std::abs(b.v[axis]));
                if (approach >= -4.0L * epsilon * rounding) continue;
                const long double gap = dot(p.x, p.x) - p.contact * p.contact;
                const long double discriminant = approach * approach - v2 * gap;
                if (discriminant <= 0.0L) continue;
                const long double wait =
                    gap <= 0.0L ? 0.0L : (-approach - std::sqrt(discriminant)) / v2;
                if (wait < best.wait)
                    best = {wait, static_cast<int>(i), static_cast<int>(j), image};
            }
        }
    }
}

void SlowSimulator::look_at_walls(Candidate& best) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = bodies_[i];
        for (int axis = 0; axis < box_.dimension; ++axis) {
            if (box_.is_periodic(axis)) continue;
            const long double v = body.v[axis];
            if (v == 0.0L) continue;
            const long double wall = v > 0.0L ? box_.size[axis] - body.radius : body.radius;
            const long double wait = std::max(0.0L, (wall - body.x[axis]) / v);
            const int side = 2 * axis + (v > 0.0L ? 1 : 0);
            if (wait < best.wait) best = {wait, static_cast<int>(i), -1 - side, {}};
        }
    }
}

void SlowSimulator::collide(const Candidate& event) {
    Body& a = bodies_[static_cast<std::size_t>(event.first)];
    if (event.second < 0) {
        a.v[(-1 - event.second) / 2] *= -1.0L;
        return;
    }
    Body& b = bodies_[static_cast<std::size_t>(event.second)];
    const Pair p = pair(a, b, event.image);
    const SlowVector normal = (1.0L / size(p.x)) * p.x;
    const long double impulse = 2.0L * dot(normal, p.v) / (a.inverse_mass + b.inverse_mass);
    a.v = a.v + a.inverse_mass * impulse * normal;
    b.v = b.v - b.inverse_mass * impulse * normal;
}

void SlowSimulator::append_touches_of_pair(std::size_t i, std::size_t j,
                                           std::vector<SlowTouch>& all) const {
    const Body &a = bodies_[i], &b = bodies_[j];
    if (a.inverse_mass + b.inverse_mass == 0.0L) return;
    const long double far = 0.01L * static_cast<long double>(box_.shortest_side());
    for (const SlowVector& image : images_) {
        const Pair p = pair(a, b, image);
        if (largest(p.x) > p.contact + far) continue;  // much more than any tolerance
        const SlowVector normal = (1.0L / size(p.x)) * p.x;
        const long double furthest = std::max({largest(a.x), largest(b.x), p.contact});
        all.push_back({i, j, normal, size(p.x) - p.contact,
                       distance_of_round_off(time_, dot(normal, p.v), furthest + p.contact)});
    }
}

// The walls are the participant after the particles.
void SlowSimulator::append_touches_of_walls(std::size_t i, std::vector<SlowTouch>& all) const {
    const Body& body = bodies_[i];
    if (body.inverse_mass == 0.0L) return;
    for (int axis = 0; axis < box_.dimension; ++axis) {
        if (box_.is_periodic(axis)) continue;
        const long double x = body.x[axis], length = box_.size[axis];
        for (const bool up : {false, true})
            all.push_back({i, bodies_.size(), (up ? 1.0L : -1.0L) * along_axis(axis),
                           (up ? length - x : x) - body.radius,
                           distance_of_round_off(time_, body.v[axis], length)});
    }
}

// Whether round-off decides if two particles touch at all.
bool SlowSimulator::grazes(const Candidate& event) const {
    if (event.second < 0) return false;
    const Pair p = pair(its(event.first), its(event.second), event.image);
    return std::abs(dot(p.x, p.v)) < 1e-6L * size(p.x) * size(p.v);
}

// Carries out all contacts that coincide with the first one found and are connected with it.
void SlowSimulator::settle(const Candidate& first, SlowEvent& event) {
    std::vector<SlowTouch> touches;
    std::vector<SlowParticipant> participants;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const long double w = bodies_[i].inverse_mass;
        participants.push_back({bodies_[i].v, {w, w, w}});
        append_touches_of_walls(i, touches);
        for (std::size_t j = i + 1; j < bodies_.size(); ++j) append_touches_of_pair(i, j, touches);
    }
    participants.push_back({});
    for (const SlowTouch& touch : touches)
        event.is_doubtful = event.is_doubtful || touch.is_doubtful();
    if (grazes(first)) {  // in the worst case through a slit that it just fills: without end
        event.is_doubtful = true;
        return collide(first);
    }
    const std::int32_t pushed = its(first.first).inverse_mass > 0.0L ? first.first : first.second;
    if (pushed < 0) return collide(first);
    const auto connected = connected_with(static_cast<std::size_t>(pushed), touches, participants);
    if (connected.size() < 2) return collide(first);
    event.contacts = carry_out_rounds(participants, connected);
    if (event.contacts == 0) {
        event.contacts = 1;
        return collide(first);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].v = participants[i].v;
}

void SlowSimulator::adopt(const Sample& state) {
    time_ = state.time;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        bodies_[i].x = slow(vec_in(state.position, row));
        bodies_[i].v = slow(vec_in(state.velocity, row));
    }
}

// The longest time step in which nothing flies further than a quarter of the box, so that the
// images examined suffice.
long double SlowSimulator::longest_step() const {
    long double fastest = 1e-300L;
    for (const Body& body : bodies_) fastest = std::max(fastest, size(body.v));
    return 0.25L * static_cast<long double>(box_.shortest_side()) / fastest;
}

void SlowSimulator::move(long double wait) {
    time_ += wait;
    for (Body& body : bodies_) body.x = body.x + wait * body.v;
}

void SlowSimulator::wrap() {
    for (Body& body : bodies_)
        for (int axis = 0; axis < box_.dimension; ++axis) {
            if (!box_.is_periodic(axis)) continue;
            const long double length = box_.size[axis];
            body.x[axis] -= length * std::floor(body.x[axis] / length);
        }
}

std::optional<SlowEvent> SlowSimulator::next(long double end) {
    while (true) {
        const long double step = longest_step();
        Candidate best{step, -1, -1, {}};
        look_at_pairs(best);
        look_at_walls(best);
        if (!(time_ + best.wait <= end)) return std::nullopt;
        move(best.wait);
        if (best.first < 0) {
            wrap();
            continue;
        }
        // Carry out the collision before wrapping positions into the box: wrapping may change which
        // image is in contact.
        SlowEvent event{time_, best.first, best.second};
        settle(best, event);
        wrap();
        return event;
    }
}

}  // namespace carom::test

#include "support/slow_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace carom::test {

using Vector = SlowVector;

// Sets the motion that follows from the behaviour; a piston keeps its own velocity.
void SlowSurfaces::set_motion(Mover& mover) {
    mover.inverse_mass = mover.acceleration = 0.0L;
    mover.stops = infinite;
    if (const auto* driven = std::get_if<Driven>(&mover.behaviour)) {
        mover.is_mobile = true;
        mover.velocity = driven->until > time_ ? driven->velocity : 0.0;
        mover.stops = driven->until > time_ ? driven->until : infinite;
    } else if (const auto* piston = std::get_if<Piston>(&mover.behaviour)) {
        mover.is_mobile = true;
        if (mover.is_held) {
            mover.velocity = 0.0L;
        } else {
            mover.inverse_mass = 1.0L / piston->mass;
            mover.acceleration = piston->force / static_cast<long double>(piston->mass) +
                                 box_.surfaces.gravity[mover.axis];
        }
    } else {
        mover.velocity = 0.0L;
    }
}

// Particles fall, except those that rest on a wall that does not move.
void SlowSurfaces::settle() {
    const Vector gravity = slow(box_.surfaces.gravity);
    for (Body& body : bodies_) {
        body.a = gravity;
        for (const Part& part : parts_) {
            if (!part.is_endless() || !is_there(part)) continue;
            if (movers_[static_cast<std::size_t>(part.surface)].is_mobile) continue;
            const Vector& normal = *part.normal;
            const long double side = side_of(part, dot(normal, body.x - part.place));
            if (dot(normal, body.v) == 0.0L && side * dot(normal, body.a) < 0.0L &&
                side * dot(normal, body.x - part.place) < body.radius + slack_)
                body.a = body.a - dot(normal, body.a) * normal;
        }
    }
}

// On which side of a part a body is. For walls, whose normals point along an axis, it is always the
// inside of the box.
long double SlowSurfaces::side_of(const Part& part, long double distance) const {
    if (box_.surfaces.is_side(part.surface)) return part.surface % 2 == 0 ? 1.0L : -1.0L;
    return distance < 0.0L ? -1.0L : 1.0L;
}

bool SlowSurfaces::is_there(const Part& part) const {
    const auto k = static_cast<std::size_t>(part.surface);
    return k >= movers_.size() || !movers_[k].is_open;
}

bool SlowSurfaces::lets_pass(const Part& part, const Body& body) const {
    const auto k = static_cast<std::size_t>(part.surface);
    if (k >= movers_.size()) return false;
    const auto* membrane = std::get_if<Membrane>(&movers_[k].behaviour);
    return membrane != nullptr && std::find(membrane->species.begin(), membrane->species.end(),
                                            body.species) != membrane->species.end();
}

bool SlowSurfaces::admits(const Mover& mover, const Body& body) const {
    const auto* membrane = std::get_if<Membrane>(&mover.behaviour);
    if (membrane == nullptr) return false;
    const auto& speeds = body.v[mover.axis] > 0.0L ? membrane->upward : membrane->downward;
    return size(body.v) > speeds.faster_than && size(body.v) < speeds.slower_than;
}

// ------------------------------------------------------------------------------ what comes next

SlowSurfaces::Motion SlowSurfaces::motion_of(const Body& body, const Part& part,
                                             const Vector& image) const {
    Motion m{body.x + image - part.place, body.v, body.a};
    const auto k = static_cast<std::size_t>(part.surface);
    if (k >= movers_.size()) return m;
    const Mover& mover = movers_[k];
    // The place of a part is that at the start; the mover has the present one.
    m.r[mover.axis] = body.x[mover.axis] + image[mover.axis] - mover.place;
    m.v[mover.axis] -= mover.velocity;
    m.a[mover.axis] -= mover.acceleration;
    return m;
}

SlowSurfaces::Motion SlowSurfaces::between(const Body& a, const Body& b,
                                           const Vector& image) const {
    return {b.x + image - a.x, b.v - a.v, b.a - a.a};
}

// How far a body may move along an axis in this time, or less.
static long double way_along(int axis, const SlowVector& v, const SlowVector& a, long double time) {
    return time * (std::abs(v[axis]) + 0.5L * time * std::abs(a[axis]));
}

// Whether a body is further from a part along an axis than it moves in this time. A part may move
// along its normal.
bool SlowSurfaces::is_out_of_reach(const Body& body, const Part& part, const Vector& image,
                                   long double before) const {
    const auto k = static_cast<std::size_t>(part.surface);
    for (int axis = 0; axis < box_.dimension; ++axis) {
        if (k < movers_.size() && movers_[k].axis == axis) continue;
        const long double x = body.x[axis] + image[axis];
        const long double reach =
            body.radius + part.radius + slack_ + way_along(axis, body.v, body.a, before);
        if (part.low[axis] - x > reach || x - part.high[axis] > reach) return true;
    }
    return false;
}

// The times before `before` at which a body comes closer than this.
std::vector<long double> SlowSurfaces::times_at(const Motion& m, long double distance,
                                                long double before) const {
    for (int axis = 0; axis < box_.dimension; ++axis)
        if (std::abs(m.r[axis]) > distance + way_along(axis, m.v, m.a, before)) return {};
    const Polynomial gap{{dot(m.r, m.r) - distance * distance, 2.0L * dot(m.r, m.v),
                          dot(m.v, m.v) + dot(m.r, m.a), dot(m.v, m.a), 0.25L * dot(m.a, m.a)}};
    return falls_of(gap, before);
}

long double SlowSurfaces::time_to_part(const Body& body, const Part& part, const Motion& m,
                                       long double before) const {
    // A body that is let through and overlaps the surface must leave it before it can meet it
    // again.
    const bool is_passing = body.passing.contains(part.surface) && gap_of(m, part, body) < slack_;
    const long double reach = body.radius + part.radius - slack_;
    const long double soonest = is_passing ? 1e-9L : 0.0L;
    const auto is_over = [&](long double t) { return part.has(m.r + t * (m.v + 0.5L * t * m.a)); };
    if (!part.normal) {
        if (reach <= 0.0L) return infinite;
        const Motion across{part.across(m.r), part.across(m.v), part.across(m.a)};
        for (const long double t : times_at(across, reach, before))
            if (t >= soonest && is_over(t)) return t;
        return infinite;
    }
    const Vector& normal = *part.normal;
    const long double way =
        before * (std::abs(dot(normal, m.v)) + 0.5L * before * std::abs(dot(normal, m.a)));
    if (std::abs(dot(normal, m.r)) > std::abs(reach) + way) return infinite;
    // A point on a face goes to the side that its velocity shows.
    const bool is_on_it = body.radius == 0.0L && std::abs(dot(normal, m.r)) < slack_;
    const long double side = side_of(part, is_on_it ? dot(normal, m.v) : dot(normal, m.r));
    long double first = infinite;
    for (const long double from : {side, -side}) {
        if (box_.surfaces.is_side(part.surface) && from != side) continue;
        Polynomial gap = along(from * normal, m.r, m.v, m.a);
        gap.c[0] -= reach;
        if (from != side && gap.c[0] > 0.0L) continue;  // a body in contact stays on its own side
        for (const long double t : falls_of(gap, before)) {
            if (t < soonest || (t == 0.0L && from != side) || !is_over(t)) continue;
            first = std::min(first, t);
            break;
        }
    }
    return first;
}

void SlowSurfaces::look_at_pairs(Next& next) const {
    const auto consider = [&](std::size_t i, std::size_t j, long double t) {
        if (t < next.wait) next = {t, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
    };
    if (box_.dimension == 1) {
        for (std::size_t k = 0; k + 1 < order_.size(); ++k) {
            const Body &a = bodies_[order_[k]], &b = bodies_[order_[k + 1]];
            const Motion m = between(a, b, {});
            Polynomial gap = along({1.0L, 0.0L}, m.r, m.v, m.a);
            gap.c[0] -= a.radius + b.radius - slack_;
            const auto falls = falls_of(gap, next.wait);
            if (!falls.empty()) consider(order_[k], order_[k + 1], falls.front());
        }
        return;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
            const Body &a = bodies_[i], &b = bodies_[j];
            const long double distance = a.radius + b.radius - slack_;
            if (distance <= 0.0L || a.inverse_mass + b.inverse_mass == 0.0L) continue;
            for (const Vector& image : images_)
                for (const long double t : times_at(between(a, b, image), distance, next.wait))
                    consider(i, j, t);
        }
}

void SlowSurfaces::look_at_parts(Next& next) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        for (const Part& part : parts_) {
            if (!is_there(part) || lets_pass(part, bodies_[i])) continue;
            for (const Vector& image : part.images) {
                if (is_out_of_reach(bodies_[i], part, image, next.wait)) continue;
                const Motion m = motion_of(bodies_[i], part, image);
                const long double t = time_to_part(bodies_[i], part, m, next.wait);
                if (t < next.wait) next = {t, static_cast<std::int32_t>(i), -1 - part.surface};
            }
        }
}

// The end of the part that the mover would hit; none if the mover is already alongside the part.
std::optional<long double> SlowSurfaces::end_towards(const Part& part, const Mover& mover) const {
    const long double low = part.low[mover.axis] - part.radius;
    const long double high = part.high[mover.axis] + part.radius;
    if (mover.place > low && mover.place < high) return std::nullopt;
    return mover.place - low < high - mover.place ? low : high;
}

// Calls consider(distance, velocity, acceleration, what, place) for everything that mover k can
// hit: another mover (what = -2 - its number) or a part at rest (what = its number).
template <class Consider>
void SlowSurfaces::for_each_that_reaches(std::size_t k, const Consider& consider) const {
    const Mover& mover = movers_[k];
    for (std::size_t j = 0; j < movers_.size(); ++j)
        if (j != k && movers_[j].axis == mover.axis && movers_[j].is_mobile && !movers_[j].is_open)
            consider(mover.place - movers_[j].place, mover.velocity - movers_[j].velocity,
                     mover.acceleration - movers_[j].acceleration, -2 - static_cast<int>(j));
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        const Part& part = parts_[j];
        const auto its = static_cast<std::size_t>(part.surface);
        if (!is_there(part)) continue;
        if (its < movers_.size() && (movers_[its].is_mobile || movers_[its].axis != mover.axis))
            continue;
        if (const auto end = end_towards(part, mover))
            consider(mover.place - *end, mover.velocity, mover.acceleration, static_cast<int>(j),
                     *end);
    }
}

// Movers on one axis meet each other and whatever extends across their path. A mover that already
// overlaps the extent of such an obstacle passes by it.
void SlowSurfaces::look_at_movers(Next& next) const {
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        const Mover& mover = movers_[k];
        if (!mover.is_mobile) continue;
        if (mover.stops - time_ < next.wait)
            next = {std::max(0.0L, mover.stops - time_), -1 - static_cast<int>(k), -1};
        if (mover.is_open) continue;
        const auto consider = [&](long double apart, long double v, long double a, int second,
                                  long double place = 0.0L) {
            const long double side = apart < 0.0L || (apart == 0.0L && v < 0.0L) ? -1.0L : 1.0L;
            const Polynomial gap{{side * apart, side * v, side * 0.5L * a, 0.0L, 0.0L}};
            const auto falls = falls_of(gap, next.wait);
            if (!falls.empty()) next = {falls.front(), -1 - static_cast<int>(k), second, place};
        };
        for_each_that_reaches(k, consider);
    }
}

long double SlowSurfaces::least_room() const {
    long double least = infinite;
    const auto consider = [&](long double apart, long double, long double, int,
                              long double = 0.0L) { least = std::min(least, std::abs(apart)); };
    for (std::size_t k = 0; k < movers_.size(); ++k)
        if (movers_[k].is_mobile && !movers_[k].is_open) for_each_that_reaches(k, consider);
    return least;
}

// The longest time step in which nothing moves further than a quarter of the box, so that the
// images examined suffice.
long double SlowSurfaces::longest_step() const {
    long double fastest = 1e-300L, acceleration = 0.0L;
    for (const Body& body : bodies_) {
        fastest = std::max(fastest, size(body.v));
        acceleration = std::max(acceleration, size(body.a));
    }
    long double quarter = infinite;
    for (int axis = 0; axis < box_.dimension; ++axis)
        quarter = std::min(quarter, 0.25L * box_.size[axis]);
    return 2.0L * quarter /
           (fastest + std::sqrt(fastest * fastest + 2.0L * acceleration * quarter));
}

void SlowSurfaces::fly(long double wait) {
    time_ += wait;
    for (Body& body : bodies_) {
        body.x = body.x + wait * (body.v + 0.5L * wait * body.a);
        body.v = body.v + wait * body.a;
        for (int axis = 0; axis < box_.dimension; ++axis)
            if (box_.is_periodic(axis))
                body.x[axis] -= box_.size[axis] * std::floor(body.x[axis] / box_.size[axis]);
    }
    for (Mover& mover : movers_) {
        if (!mover.is_mobile) continue;
        mover.place += wait * (mover.velocity + 0.5L * wait * mover.acceleration);
        mover.velocity += wait * mover.acceleration;
    }
}

// A mover stops (second = -1), or bounces off another mover (-2 - its number) or off a part at
// rest.
void SlowSurfaces::bounce(const Next& next) {
    Mover& mover = movers_[static_cast<std::size_t>(-1 - next.first)];
    if (next.second == -1) {
        mover.velocity = 0.0L;
        mover.stops = infinite;
        return;
    }
    ++bounces_;
    if (next.second < -1) {
        Mover& other = movers_[static_cast<std::size_t>(-2 - next.second)];
        const long double impulse =
            2.0L * (other.velocity - mover.velocity) / (mover.inverse_mass + other.inverse_mass);
        mover.velocity += impulse * mover.inverse_mass;
        other.velocity -= impulse * other.inverse_mass;
        mover.place = other.place;
    } else {
        mover.place = next.place;  // exactly: from beyond the obstacle it would not meet it again
        mover.velocity = -mover.velocity;
    }
}

std::optional<SlowContact> SlowSurfaces::advance(long double time) {
    while (time_ < time) {
        Next next{std::min(time - time_, longest_step())};
        const long double step = next.wait;
        look_at_movers(next);
        look_at_pairs(next);
        look_at_parts(next);
        const bool is_last = next.wait == step && step == time - time_;
        fly(next.wait);
        if (is_last) time_ = time;
        if (next.wait == step) continue;
        if (next.first < 0) {
            bounce(next);
            continue;
        }
        if (next.second < 0) {
            const auto k = static_cast<std::size_t>(-1 - next.second);
            Body& body = bodies_[static_cast<std::size_t>(next.first)];
            if (k < movers_.size() && admits(movers_[k], body)) {
                body.passing.insert(static_cast<std::int32_t>(k));
                continue;
            }
        }
        return SlowContact{next.first, next.second};
    }
    find_slack();
    return std::nullopt;
}

}  // namespace carom::test

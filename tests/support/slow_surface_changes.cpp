// Contacts and run events: how they change the state.
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "physics/mechanics.h"
#include "support/slow_surfaces.h"

namespace carom::test {

using Vector = SlowVector;

SlowSurfaces::Touch SlowSurfaces::collide(const SlowContact& contact, const Vector& like) {
    Body& a = bodies_[static_cast<std::size_t>(contact.first)];
    if (contact.second < 0) a.passing.erase(-1 - contact.second);
    if (contact.second < 0) return collide_with_surface(a, -1 - contact.second, like);
    Body& b = bodies_[static_cast<std::size_t>(contact.second)];
    Touch touch{infinite, 0.0L};
    Vector normal;
    if (box_.dimension == 1) {
        const Motion m = between(a, b, {});
        const auto rank = [&](std::int32_t i) {
            return std::find(order_.begin(), order_.end(), static_cast<std::size_t>(i));
        };
        normal = {rank(contact.first) < rank(contact.second) ? 1.0L : -1.0L, 0.0L};
        touch = {dot(normal, m.r) - a.radius - b.radius, dot(normal, m.v)};
    } else {
        for (const Vector& image : images_) {
            const Motion m = between(a, b, image);
            const long double gap = size(m.r) - a.radius - b.radius;
            if (!(std::abs(gap) < std::abs(touch.gap))) continue;
            normal = (1.0L / size(m.r)) * m.r;
            touch = {gap, dot(normal, m.v)};
        }
    }
    const long double impulse = 2.0L * touch.approach / (a.inverse_mass + b.inverse_mass);
    a.v = a.v + a.inverse_mass * impulse * normal;
    b.v = b.v - b.inverse_mass * impulse * normal;
    return touch;
}

long double SlowSurfaces::gap_of(const Motion& m, const Part& part, const Body& body) const {
    if (!part.has(m.r, slack_)) return infinite;
    const long double distance =
        part.normal ? std::abs(dot(*part.normal, m.r)) : size(part.across(m.r));
    return distance - part.radius - body.radius;
}

SlowSurfaces::Touch SlowSurfaces::collide_with_surface(Body& body, std::int32_t surface,
                                                       const Vector& like) {
    const bool moves = static_cast<std::size_t>(surface) < movers_.size();
    Mover* mover = moves ? &movers_[static_cast<std::size_t>(surface)] : nullptr;
    const bool is_membrane = moves && std::holds_alternative<Membrane>(mover->behaviour);
    Touch best{
        .gap = infinite, .approach = 0.0L, .is_random = moves && is_random(mover->behaviour)};
    long double nearest = infinite;
    Vector after = body.v;
    for (const Part& part : parts_) {
        if (part.surface != surface) continue;
        for (const Vector& image : part.images) {
            const Motion m = motion_of(body, part, image);
            const long double gap = gap_of(m, part, body);
            // advance() finds a contact where the two overlap by the slack. A body that a membrane
            // has let in may be reflected while it overlaps the membrane.
            if (gap > slack_ || (gap < -2.0L * slack_ && !is_membrane)) continue;
            const Vector away = part.across(m.r);
            if (!part.normal && size(away) == 0.0L) continue;
            const Vector n = part.normal ? *part.normal : (1.0L / size(away)) * away;
            // A point comes from the side that its velocity shows; its place is lost in round-off.
            const long double place =
                body.radius == 0.0L && !box_.surfaces.is_side(surface) ? -dot(n, m.v) : dot(n, m.r);
            const long double side = part.normal ? side_of(part, place) : 1.0L;
            const long double approach = side * dot(n, m.v);
            const long double other = moves ? mover->inverse_mass : 0.0L;
            const long double share =
                other > 0.0L ? body.inverse_mass / (body.inverse_mass + other) : 1.0L;
            const Vector v = body.v - 2.0L * share * dot(n, m.v) * n;
            if (!(size(v - like) < nearest) && !(nearest == infinite)) continue;
            nearest = size(v - like);
            best.is_within = gap < -2.0L * slack_;
            best.gap = best.is_within ? 0.0L : gap;
            best.approach = approach;
            after = v;
        }
    }
    if (moves && mover->inverse_mass > 0.0L)
        mover->velocity -=
            mover->inverse_mass *
            (body.inverse_mass > 0.0L
                 ? (after - body.v)[mover->axis] / body.inverse_mass
                 : 2.0L * (mover->velocity - body.v[mover->axis]) / mover->inverse_mass);
    body.v = after;
    return best;
}

long double SlowSurfaces::least_gap() const {
    long double least = infinite;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        for (const Part& part : parts_) {
            if (!is_there(part) || lets_pass(part, bodies_[i])) continue;
            for (const Vector& image : part.images)
                least =
                    std::min(least, gap_of(motion_of(bodies_[i], part, image), part, bodies_[i]));
        }
        for (std::size_t j = i + 1; j < bodies_.size(); ++j)
            for (const Vector& image : images_)
                least = std::min(least, size(between(bodies_[i], bodies_[j], image).r) -
                                            bodies_[i].radius - bodies_[j].radius);
    }
    return least;
}

// ------------------------------------------------------------------------------ what events change

bool SlowSurfaces::apply(const RunEvent& event, std::vector<std::int32_t>& in_the_way) {
    const auto mover = [&](const auto& its) -> Mover& {
        return movers_[static_cast<std::size_t>(its.surface)];
    };
    // Finds particles that were let through the surface and would now overlap it.
    const auto close_on = [&](std::int32_t surface) {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            for (const Part& part : parts_)
                for (const Vector& image : part.images)
                    if (part.surface == surface && is_there(part) && !lets_pass(part, bodies_[i]) &&
                        gap_of(motion_of(bodies_[i], part, image), part, bodies_[i]) < -slack_)
                        in_the_way.push_back(static_cast<std::int32_t>(i));
    };
    if (const auto* set = std::get_if<SetOpen>(&event.action)) {
        const bool closes = mover(*set).is_open && !set->is_open;
        mover(*set).is_open = set->is_open;
        if (closes) close_on(set->surface);
    } else if (const auto* move = std::get_if<MoveSurface>(&event.action)) {
        const bool let_through = std::holds_alternative<Membrane>(mover(*move).behaviour);
        mover(*move).behaviour = Driven{.velocity = move->velocity};
        set_motion(mover(*move));
        if (let_through) close_on(move->surface);
    } else if (const auto* held = std::get_if<HoldPiston>(&event.action)) {
        mover(*held).is_held = true;
        set_motion(mover(*held));
    } else if (const auto* released = std::get_if<ReleasePiston>(&event.action)) {
        mover(*released).is_held = false;
        set_motion(mover(*released));
    } else if (const auto* change = std::get_if<ChangeSurface>(&event.action)) {
        Mover& its = mover(*change);
        const bool let_through = std::holds_alternative<Membrane>(its.behaviour);
        its.behaviour = change->behaviour;
        its.is_held = false;
        if (const auto* piston = std::get_if<Piston>(&its.behaviour))
            its.velocity = piston->velocity;
        set_motion(its);
        if (let_through) close_on(change->surface);
    } else if (const auto* heat = std::get_if<Heat>(&event.action)) {
        long double mass = 0.0L, mass_of_all = 0.0L, energy = 0.0L;
        Vector momentum, momentum_of_all;
        std::vector<Body*> all;
        bool are_finite = true;
        for (Body& body : bodies_) {
            are_finite = are_finite && body.inverse_mass > 0.0L;
            if (!(body.inverse_mass > 0.0L)) continue;
            const long double its = 1.0L / body.inverse_mass;
            mass_of_all += its;
            momentum_of_all = momentum_of_all + its * body.v;
            if (heat->species && body.species != *heat->species) continue;
            all.push_back(&body);
            mass += its;
            momentum = momentum + its * body.v;
        }
        if (all.empty()) return false;
        // Equal energy for each degree of freedom, without those of the centre-of-mass motion of
        // the gas.
        const auto count = static_cast<long double>(all.size());
        Vector mean;
        long double freedom = box_.dimension * count, of_mean = 0.0L;
        int drifting = 0;
        for (int axis = 0; axis < box_.dimension; ++axis) {
            if (!are_finite || !conserves_momentum(box_, axis)) continue;
            mean[axis] = momentum[axis] / mass;
            const long double apart = mean[axis] - momentum_of_all[axis] / mass_of_all;
            of_mean += 0.5L * mass * apart * apart;
            freedom -= mass / mass_of_all;
            ++drifting;
        }
        if (count < 2.0L && drifting == box_.dimension) return false;
        for (const Body* body : all)
            energy += 0.5L * dot(body->v - mean, body->v - mean) / body->inverse_mass;
        const auto* to = std::get_if<Temperature>(&heat->amount);
        const long double wanted = to != nullptr ? 0.5L * freedom * to->value - of_mean
                                                 : energy + std::get<double>(heat->amount);
        if (!(energy > 0.0L && wanted > 0.0L)) return false;
        for (Body* body : all) body->v = mean + std::sqrt(wanted / energy) * (body->v - mean);
    }
    settle();
    return in_the_way.empty();
}

void SlowSurfaces::adopt(const Sample& state, const std::vector<SurfaceState>& surfaces) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        bodies_[i].x = slow(vec_in(state.position, row));
        bodies_[i].v = slow(vec_in(state.velocity, row));
    }
    for (std::size_t k = 0; k < surfaces.size() && k < movers_.size(); ++k) {
        if (!surfaces[k].motion) continue;
        movers_[k].place = surfaces[k].motion->place;
        movers_[k].velocity = surfaces[k].motion->velocity;
    }
    bounces_ = 0;
    find_slack();
    settle();
}

// Round-off of positions and, because of the round-off of time, of the distances travelled.
void SlowSurfaces::find_slack() {
    long double furthest = box_.longest_side(), fastest = 0.0L;
    for (const Body& body : bodies_) {
        furthest = std::max(furthest, size(body.x));
        fastest = std::max(fastest, size(body.v));
    }
    for (const Mover& mover : movers_) {
        furthest = std::max(furthest, std::abs(mover.place));
        fastest = std::max(fastest, std::abs(mover.velocity));
    }
    slack_ = 1e-13L * (furthest + fastest * (1.0L + time_));
}

}  // namespace carom::test

// Contacts that coincide, in boxes with surfaces.
#include <algorithm>
#include <cmath>
#include <variant>

#include "support/slow_surfaces.h"

namespace carom::test {

using Vector = SlowVector;

void SlowSurfaces::append_touches_of_pairs(std::vector<SlowTouch>& all) const {
    const auto add = [&](std::size_t i, std::size_t j, const Motion& m, const Vector& normal) {
        const Body &a = bodies_[i], &b = bodies_[j];
        const long double sigma = a.radius + b.radius;
        if (a.inverse_mass + b.inverse_mass == 0.0L || (box_.dimension > 1 && sigma == 0.0L))
            return;
        const long double furthest = std::max({largest(a.x), largest(b.x), sigma});
        all.push_back({i, j, normal, dot(normal, m.r) - sigma,
                       distance_of_round_off(time_, dot(normal, m.v), furthest + sigma)});
    };
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        for (std::size_t j = i + 1; j < bodies_.size() && box_.dimension > 1; ++j)
            for (const Vector& image : images_) {
                const Motion m = between(bodies_[i], bodies_[j], image);
                add(i, j, m, (1.0L / size(m.r)) * m.r);
            }
    for (std::size_t k = 0; k + 1 < order_.size() && box_.dimension == 1; ++k)
        add(order_[k], order_[k + 1], between(bodies_[order_[k]], bodies_[order_[k + 1]], {}),
            {1.0L, 0.0L});
}

// The normal points from the body to the part, and the surfaces follow the bodies: first those that
// can move, then one that stands for all others.
std::optional<SlowTouch> SlowSurfaces::touch_of(std::size_t i, const Part& part,
                                                const Motion& m) const {
    const Body& body = bodies_[i];
    const auto k = std::min(static_cast<std::size_t>(part.surface), movers_.size());
    Vector n;
    long double gap = 0.0L;
    if (!part.has(m.r)) return std::nullopt;
    if (part.normal) {
        const bool is_point = body.radius == 0.0L && !box_.surfaces.is_side(part.surface);
        const long double side = side_of(part, dot(*part.normal, is_point ? -1.0L * m.v : m.r));
        n = side * *part.normal;
        gap = dot(n, m.r) - body.radius;
    } else {
        const Vector away = part.across(m.r);
        if (size(away) == 0.0L) return std::nullopt;
        n = (1.0L / size(away)) * away;
        gap = size(away) - part.radius - body.radius;
    }
    const long double length =
        2.0L * (body.radius + std::abs(body.x.x) + std::abs(body.x.y) + std::abs(body.x.z));
    return SlowTouch{i, bodies_.size() + k, -1.0L * n, gap,
                     distance_of_round_off(time_, dot(n, m.v), length)};
}

void SlowSurfaces::append_touches_of_parts(std::size_t i, std::vector<SlowTouch>& all) const {
    const Body& body = bodies_[i];
    for (const Part& part : parts_) {
        const auto k = static_cast<std::size_t>(part.surface);
        // On a line only the bead next to a wall can reach it.
        if (box_.dimension == 1 && i != (part.surface == 0 ? order_.front() : order_.back()))
            continue;
        if (!is_there(part) || lets_pass(part, body) || body.passing.contains(part.surface))
            continue;
        if (k < movers_.size() && (admits(movers_[k], body) || is_random(movers_[k].behaviour)))
            continue;
        const long double pushed = k < movers_.size() ? movers_[k].inverse_mass : 0.0L;
        if (body.inverse_mass + pushed == 0.0L) continue;
        for (const Vector& image : part.images)
            if (const auto touch = touch_of(i, part, motion_of(body, part, image)))
                all.push_back(*touch);
    }
}

std::vector<SlowParticipant> SlowSurfaces::participants() const {
    std::vector<SlowParticipant> all;
    for (const Body& body : bodies_)
        all.push_back({body.v, {body.inverse_mass, body.inverse_mass, body.inverse_mass}});
    for (const Mover& mover : movers_) {
        SlowParticipant& its = all.emplace_back();
        its.v[mover.axis] = mover.velocity;
        its.inverse_mass[mover.axis] = mover.inverse_mass;
    }
    all.push_back({});
    return all;
}

SlowSurfaces::Tie SlowSurfaces::settle_tie(const SlowContact& contact) {
    std::vector<SlowTouch> touches;
    append_touches_of_pairs(touches);
    for (std::size_t i = 0; i < bodies_.size(); ++i) append_touches_of_parts(i, touches);
    Tie tie{1, std::ranges::any_of(touches, &SlowTouch::is_doubtful)};
    const auto pushed = [&](std::int32_t i) {
        return i >= 0 && bodies_[static_cast<std::size_t>(i)].inverse_mass > 0.0L;
    };
    const std::int32_t begin = pushed(contact.first) ? contact.first : contact.second;
    if (!pushed(begin)) return tie;
    std::vector<SlowParticipant> all = participants();
    const auto connected = connected_with(static_cast<std::size_t>(begin), touches, all);
    if (connected.size() < 2) return tie;
    tie.contacts = carry_out_rounds(all, connected);
    if (tie.contacts < 2) return tie;
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].v = all[i].v;
    for (std::size_t k = 0; k < movers_.size(); ++k)
        movers_[k].velocity = all[bodies_.size() + k].v[movers_[k].axis];
    return tie;
}

}  // namespace carom::test

// The part of the event loop that finds which particles and surfaces touch each other at the
// present. Included only by event_loop_steps.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "physics/events/event_loop.h"

namespace carom {

// What the rounding errors of doubles allow for every contact, however slow it is: the prediction
// of one in a million times the typical speed is compared with others too.
template <int Dimension, typename Scalar, bool has_surfaces>
double EventLoop<Dimension, Scalar, has_surfaces>::margin_of_instants() const {
    constexpr double share = 0x1p-28;  // of the time in which the fastest crosses the box
    double fastest = 0.0;
    for (const Body& b : bodies_)
        for (const Scalar& v : b.v) fastest = std::max(fastest, std::abs(static_cast<double>(v)));
    const double size = box_.longest_side();
    for (int axis = 0; axis < Dimension; ++axis)
        fastest = std::max(fastest, std::sqrt(std::abs(box_.surfaces.gravity[axis]) * size));
    const double round_off =
        std::ldexp(std::abs(static_cast<double>(now_)), 6 - std::numeric_limits<double>::digits);
    return fastest > 0.0 ? share * size / fastest + round_off : 0.0;
}

// Whether two bodies touch at the present: whether their contact is at most 4 epsilon (|t| + length
// / |speed|) away, with the local time t. `length`: of contact and places, whose rounding errors
// matter.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::is_closed(const Scalar& gap, const Scalar& speed,
                                                           double length) const {
    const double way = std::abs(static_cast<double>(now_) * static_cast<double>(speed));
    return std::abs(static_cast<double>(gap)) <= std::ldexp(way + length, 3 - bits_);
}

// Whether two bodies are certainly too far apart to touch, by the square of their distance.
template <int Dimension, typename Scalar, bool has_surfaces>
inline bool EventLoop<Dimension, Scalar, has_surfaces>::is_beyond_contact(double square,
                                                                          double sigma) const {
    const double size = box_.longest_side();
    return square > 1.001 * (sigma * sigma) + 1e-12 * (size * size);
}

// Whether what particle k of the queue does may have to do with body i at the present: it is no
// body, or they may touch, or both may touch a piston.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::may_touch(std::int32_t i, std::int32_t k) {
    if constexpr (has_surfaces) {
        if (static_cast<std::size_t>(k) >= bodies_.size()) return true;
        if (geometry_.surfaces().has_pistons()) return true;
    }
    double square = 0.0;
    for (std::size_t a = 0; a < Dimension; ++a) {
        const double apart = static_cast<double>(position_at(body(k), a, now_)) -
                             static_cast<double>(position_at(body(i), a, now_));
        const double nearest = apart - box_.length(a) * box_.turns(a, apart);
        square += nearest * nearest;
    }
    const auto radius = [&](std::int32_t of) {
        return geometry_.properties(bodies_, static_cast<std::size_t>(of)).radius;
    };
    return !is_beyond_contact(square, radius(i) + radius(k));
}

template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::between(std::int32_t i, std::int32_t j,
                                                         const Shift& shift) -> Between {
    Between all{no_vector(), no_vector(), 0.0};
    const Body &a = body(i), &b = body(j);
    for (std::size_t k = 0; k < Dimension; ++k) {
        const Scalar from = position_at(a, k, now_), to = position_at(b, k, now_);
        all.r[k] = to + shift[k] - from;
        all.v[k] = velocity_at(b, k, now_) - velocity_at(a, k, now_);
        all.furthest = std::max({all.furthest, std::abs(static_cast<double>(from)),
                                 std::abs(static_cast<double>(to)), std::abs(shift[k])});
    }
    return all;
}

// Empty if the two do not touch. `side` as in Line::for_each_neighbour().
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::closed_pair(std::int32_t i, std::int32_t j,
                                                             const Shift& shift, int side)
    -> std::optional<ClosedContact> {
    using std::sqrt;
    const auto first = geometry_.properties(bodies_, static_cast<std::size_t>(i)),
               second = geometry_.properties(bodies_, static_cast<std::size_t>(j));
    const double sigma = first.radius + second.radius;
    double square = 0.0;
    for (std::size_t k = 0; k < Dimension; ++k) {
        const auto apart = static_cast<double>(position_at(body(j), k, now_)) + shift[k] -
                           static_cast<double>(position_at(body(i), k, now_));
        square += apart * apart;
    }
    if (is_beyond_contact(square, sigma)) [[likely]]
        return {};
    if (!(first.inverse_mass + second.inverse_mass > 0.0)) return {};
    if (Dimension > 1 && !(sigma > 0.0)) return {};
    const auto [r, v, furthest] = between(i, j, shift);
    const Scalar distance =
        Dimension == 1 ? Scalar(double(side) * r[0]) : Scalar(sqrt(scalar_product(r, r)));
    Vector normal = no_vector();
    normal[0] = with_bits(side);
    if constexpr (Dimension > 1)
        for (std::size_t k = 0; k < Dimension; ++k) normal[k] = r[k] / distance;
    const Scalar speed = scalar_product(normal, v);
    if (!is_closed(distance - sigma, speed, std::max(sigma, furthest) + sigma)) return {};
    return ClosedContact{i, j, true, normal, static_cast<double>(distance), sigma};
}

// Empty if the body does not touch this side of a plain box.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::closed_side(std::int32_t i, std::size_t axis,
                                                             bool up)
    -> std::optional<ClosedContact> {
    if (Dimension == 1 && i != (up ? static_cast<std::int32_t>(bodies_.size()) - 1 : 0)) return {};
    const Body& b = body(i);
    const double radius = geometry_.properties(bodies_, static_cast<std::size_t>(i)).radius;
    const double size = box_.length(axis);
    const Scalar x = position_at(b, axis, now_);
    const Scalar gap = (up ? Scalar(size - x) : x) - radius;
    if (!is_closed(gap, b.v[axis], size)) return {};
    Vector normal = no_vector();
    normal[axis] = with_bits(up ? 1.0 : -1.0);
    return ClosedContact{
        i, static_cast<std::int32_t>(2 * axis) + (up ? 1 : 0), false, normal, radius, radius};
}

// Empty if the body does not touch barrier k, or if no contact can push either of them.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::closed_barrier(std::int32_t i, std::int32_t k)
    -> std::optional<ClosedContact> {
    if constexpr (has_surfaces) {
        const Body& b = body(i);
        const auto& surfaces = geometry_.surfaces();
        const auto touch = surfaces.touch(b, k, now_);
        const auto& barrier = surfaces.barrier(k);
        if (!touch || (b.inverse_mass == 0.0 && !surfaces.can_be_pushed(barrier))) return {};
        const auto velocity = surfaces.velocity_of(barrier, now_);
        Scalar speed = with_bits(0.0);
        double length = b.radius;
        for (std::size_t a = 0; a < Dimension; ++a) {
            speed += touch->normal[a] * (velocity[a] - velocity_at(b, a, now_));
            length += std::abs(static_cast<double>(b.x[a]));
        }
        if (!is_closed(touch->gap, speed, 2.0 * length)) return {};
        return ClosedContact{i, k, false, touch->normal, b.radius, b.radius};
    }
    return {};
}

// What body i touches.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::closed_contacts_of(std::int32_t i)
    -> std::vector<ClosedContact> {
    std::vector<ClosedContact> all;
    geometry_.for_each_neighbour(bodies_, i, [&](std::int32_t j, const auto& shift, int side) {
        if (auto found = closed_pair(i, j, shift, side)) all.push_back(std::move(*found));
    });
    append_closed_walls(i, all);
    return all;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::append_closed_walls(
    std::int32_t i, std::vector<ClosedContact>& all) {
    if constexpr (has_surfaces) {
        geometry_.for_each_barrier(bodies_, i, [&](std::int32_t k) {
            if (auto found = closed_barrier(i, k)) all.push_back(std::move(*found));
        });
    } else {
        if (geometry_.properties(bodies_, static_cast<std::size_t>(i)).inverse_mass == 0.0) return;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            for (const bool up : {false, true}) {
                if (box_.is_periodic(axis)) continue;
                if (auto found = closed_side(i, axis, up)) all.push_back(std::move(*found));
            }
    }
}

// All contacts of bodies that are connected with body i or j by such contacts, not through bodies
// that cannot be pushed. In the order of the numbers that the user gives, so that the order in
// memory does not matter.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::closed_contacts_around(std::int32_t i,
                                                                        std::int32_t j)
    -> std::vector<ClosedContact> {
    std::vector<ClosedContact> all;
    std::set<std::int32_t> seen, done, pistons;
    std::vector<std::int32_t> open;
    const auto visit = [&](std::int32_t k) {
        const auto properties = geometry_.properties(bodies_, static_cast<std::size_t>(k));
        if (properties.inverse_mass > 0.0 && seen.insert(k).second) open.push_back(k);
    };
    visit(i);
    visit(j);
    for (std::size_t next = 0; next < open.size(); ++next) {
        const std::int32_t k = open[next];
        for (ClosedContact& contact : closed_contacts_of(k)) {
            if (contact.is_pair && done.contains(contact.second)) continue;
            if (contact.is_pair)
                visit(contact.second);
            else if (pushes_piston(contact) && pistons.insert(surface_touched(contact)).second)
                std::ranges::for_each(bodies_at_surface(surface_touched(contact)), visit);
            all.push_back(std::move(contact));
        }
        done.insert(k);
    }
    put_in_users_order(all);
    return all;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::put_in_users_order(
    std::vector<ClosedContact>& contacts) const {
    for (ClosedContact& contact : contacts)
        if (contact.is_pair && number_of(contact.first) > number_of(contact.second)) {
            std::swap(contact.first, contact.second);
            for (Scalar& n : contact.normal) n = -n;
        }
    std::ranges::stable_sort(contacts, {}, [&](const ClosedContact& c) {
        return std::tuple(number_of(c.first), !c.is_pair,
                          c.is_pair ? number_of(c.second) : c.second);
    });
}

template <int Dimension, typename Scalar, bool has_surfaces>
std::int32_t EventLoop<Dimension, Scalar, has_surfaces>::surface_touched(
    const ClosedContact& contact) const {
    if constexpr (has_surfaces)
        return geometry_.surfaces().barrier(contact.second).surface;
    else
        return contact.second;
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::pushes_piston(const ClosedContact& contact) const {
    if constexpr (has_surfaces)
        return !contact.is_pair &&
               geometry_.surfaces().can_be_pushed(geometry_.surfaces().barrier(contact.second));
    else
        return false;
}

// The bodies that touch a surface.
template <int Dimension, typename Scalar, bool has_surfaces>
std::vector<std::int32_t> EventLoop<Dimension, Scalar, has_surfaces>::bodies_at_surface(
    std::int32_t surface) {
    std::vector<std::int32_t> found;
    std::vector<ClosedContact> walls;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        walls.clear();
        append_closed_walls(static_cast<std::int32_t>(k), walls);
        if (std::ranges::any_of(walls,
                                [&](const auto& c) { return surface_touched(c) == surface; }))
            found.push_back(static_cast<std::int32_t>(k));
    }
    return found;
}

// Bodies that touch one another, or a surface, without approaching, whose contacts no prediction
// knows.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::find_touching() {
    touching_.clear();
    for (std::size_t k = 0; k < bodies_.size(); ++k)
        for (const ClosedContact& contact : closed_contacts_of(static_cast<std::int32_t>(k)))
            if (!rounds_of({contact}).rounds.recedes(0)) add_touching(contact);
    geometry_.coincidences().watch_always(!touching_.empty());
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::add_touching(const ClosedContact& contact) {
    const std::int32_t first = number_of(contact.first);
    const std::int32_t second = contact.is_pair ? number_of(contact.second) : a_surface;
    touching_.insert({first, second});
    if (contact.is_pair) touching_.insert({second, first});
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::touches_another(std::int32_t i) const {
    const auto found = touching_.lower_bound({number_of(i), a_surface});
    return found != touching_.end() && found->first == number_of(i);
}

}  // namespace carom

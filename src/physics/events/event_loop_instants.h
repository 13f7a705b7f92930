// The part of the event loop for contacts that coincide: finds all contacts of connected particles
// at one instant and carries them out in rounds (contact_rounds.h). Included only by
// event_loop.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "physics/events/contact_rounds.h"
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
    const double size = box_.size.maxCoeff();
    for (int axis = 0; axis < Dimension; ++axis)
        fastest = std::max(fastest, std::sqrt(std::abs(box_.surfaces.gravity[axis]) * size));
    const double round_off =
        std::ldexp(std::abs(clock_.absolute(now_)), 6 - std::numeric_limits<double>::digits);
    return fastest > 0.0 ? share * size / fastest + round_off : 0.0;
}

// Whether two bodies touch at the present: whether their contact is at most 4 epsilon (|t| + length
// / |speed|) away. `length`: of contact and places, whose rounding errors matter.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::is_closed(const Scalar& gap, const Scalar& speed,
                                                           double length) const {
    const double way = std::abs(clock_.absolute(now_) * static_cast<double>(speed));
    return std::abs(static_cast<double>(gap)) <= std::ldexp(way + length, 3 - bits_);
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::append_closed_pairs(
    std::int32_t i, std::vector<ClosedContact>& all) {
    using std::sqrt;
    const auto index = [](std::int32_t k) { return static_cast<std::size_t>(k); };
    geometry_.for_each_neighbour(bodies_, i, [&](std::int32_t j, const auto& shift, int side) {
        const Body &a = body(i), &b = body(j);
        const Properties first = geometry_.properties(bodies_, index(i)),
                         second = geometry_.properties(bodies_, index(j));
        const double sigma = first.radius + second.radius;
        if (!(first.inverse_mass + second.inverse_mass > 0.0)) return;
        if (Dimension == 2 && !(sigma > 0.0)) return;
        std::array<Scalar, 2> r{with_bits(0.0), with_bits(0.0)}, v = r;
        double length = sigma;
        for (std::size_t k = 0; k < Dimension; ++k) {
            const Scalar place = position_at(a, k, now_);
            r[k] = position_at(b, k, now_) + shift[k] - place;
            v[k] = velocity_at(b, k, now_) - velocity_at(a, k, now_);
            length = std::max({length, std::abs(static_cast<double>(place)), std::abs(shift[k])});
        }
        const auto x = static_cast<double>(r[0]), y = static_cast<double>(r[1]);
        if (x * x + y * y > 1.001 * (sigma * sigma) + 1e-12 * (length * length)) return;
        const Scalar distance =
            Dimension == 1 ? Scalar(double(side) * r[0]) : Scalar(sqrt(r[0] * r[0] + r[1] * r[1]));
        std::array<Scalar, 2> normal{with_bits(side), with_bits(0.0)};
        if constexpr (Dimension == 2) normal = {r[0] / distance, r[1] / distance};
        const Scalar speed = normal[0] * v[0] + normal[1] * v[1];
        const Scalar gap = distance - sigma;
        if (is_closed(gap, speed, length + sigma))
            all.push_back({i, j, true, normal, static_cast<double>(distance), sigma});
    });
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::append_closed_walls(
    std::int32_t i, std::vector<ClosedContact>& all) {
    const Body& b = body(i);
    const auto [radius, inverse_mass] = geometry_.properties(bodies_, static_cast<std::size_t>(i));
    if constexpr (has_surfaces) {
        const auto& surfaces = geometry_.surfaces();
        geometry_.for_each_barrier(bodies_, i, [&](std::int32_t k) {
            const auto touch = surfaces.touch(b, k, now_);
            const Barrier& barrier = surfaces.barrier(k);
            if (!touch || (inverse_mass == 0.0 && !surfaces.can_be_pushed(barrier))) return;
            const auto velocity = surfaces.velocity_of(barrier, now_);
            Scalar speed = with_bits(0.0);
            double length = radius;
            for (std::size_t a = 0; a < Dimension; ++a) {
                speed += touch->normal[a] * (velocity[a] - velocity_at(b, a, now_));
                length += std::abs(static_cast<double>(b.x[a]));
            }
            if (is_closed(touch->gap, speed, 2.0 * length))
                all.push_back({i, k, false, touch->normal, radius, radius});
        });
    } else {
        if (inverse_mass == 0.0) return;
        for (std::size_t axis = 0; axis < Dimension; ++axis) {
            if (box_.is_periodic(axis)) continue;
            for (const int up : {0, 1}) {
                if (Dimension == 1 &&
                    i != (up == 1 ? static_cast<std::int32_t>(bodies_.size()) - 1 : 0))
                    continue;
                const double size = box_.length(axis);
                const Scalar x = position_at(b, axis, now_);
                const Scalar gap = (up == 1 ? Scalar(size - x) : x) - radius;
                if (!is_closed(gap, b.v[axis], size)) continue;
                std::array<Scalar, 2> normal{with_bits(0.0), with_bits(0.0)};
                normal[axis] = with_bits(up == 1 ? 1.0 : -1.0);
                all.push_back(
                    {i, static_cast<std::int32_t>(2 * axis) + up, false, normal, radius, radius});
            }
        }
    }
}

// All contacts of bodies that are connected with body i by such contacts. In the order of the
// numbers that the user gives, so that the order in memory does not matter.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::closed_contacts_around(std::int32_t i)
    -> std::vector<ClosedContact> {
    std::vector<ClosedContact> all;
    std::set<std::int32_t> seen{i}, pistons;
    std::vector<std::int32_t> open{i};
    const auto visit = [&](std::int32_t k) {
        if (seen.insert(k).second) open.push_back(k);
    };
    for (std::size_t next = 0; next < open.size(); ++next) {
        const std::int32_t k = open[next];
        std::vector<ClosedContact> its;
        append_closed_pairs(k, its);
        append_closed_walls(k, its);
        for (ClosedContact& contact : its) {
            if (contact.is_pair) {
                const auto before = open.begin() + static_cast<std::ptrdiff_t>(next);
                if (std::find(open.begin(), before, contact.second) != before) continue;
                visit(contact.second);
            } else if (pushes_piston(contact) && pistons.insert(surface_touched(contact)).second) {
                for (const std::int32_t other : bodies_at_surface(surface_touched(contact)))
                    visit(other);
            }
            if (contact.is_pair && number_of(contact.first) > number_of(contact.second)) {
                std::swap(contact.first, contact.second);
                for (Scalar& n : contact.normal) n = -n;
            }
            all.push_back(std::move(contact));
        }
    }
    std::ranges::stable_sort(all, {}, [&](const ClosedContact& c) {
        return std::tuple(number_of(c.first), !c.is_pair,
                          c.is_pair ? number_of(c.second) : c.second);
    });
    return all;
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
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        std::vector<ClosedContact> its;
        append_closed_walls(static_cast<std::int32_t>(k), its);
        if (std::ranges::any_of(its, [&](auto& one) { return surface_touched(one) == surface; }))
            found.push_back(static_cast<std::int32_t>(k));
    }
    return found;
}

// Bodies that touch without approaching, whose contacts no prediction knows.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::find_touching() {
    touching_.clear();
    std::vector<ClosedContact> all;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        all.clear();
        append_closed_pairs(static_cast<std::int32_t>(k), all);
        for (const ClosedContact& contact : all)
            if (!rounds_of({contact}).rounds.recedes(0))
                touching_.insert({number_of(contact.first), number_of(contact.second)});
    }
    geometry_.coincidences().watch_always(!touching_.empty());
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::touches_another(std::int32_t i) const {
    const auto found = touching_.lower_bound({number_of(i), -1});
    return found != touching_.end() && found->first == number_of(i);
}

// The bodies, and the surfaces, that take part in these contacts.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::rounds_of(
    const std::vector<ClosedContact>& contacts) -> Rounds {
    using Participant = typename ContactRounds<Scalar>::Participant;
    std::vector<Participant> participants;
    std::vector<typename ContactRounds<Scalar>::Contact> among;
    std::map<std::int32_t, std::size_t> bodies, surfaces;
    const auto of_body = [&](std::int32_t i) {
        const auto [place, is_new] = bodies.try_emplace(i, participants.size());
        if (is_new) {
            const double w =
                geometry_.properties(bodies_, static_cast<std::size_t>(i)).inverse_mass;
            Participant its{{with_bits(0.0), with_bits(0.0)}, {w, w}};
            for (std::size_t a = 0; a < Dimension; ++a) its.v[a] = velocity_at(body(i), a, now_);
            participants.push_back(std::move(its));
        }
        return place->second;
    };
    const auto of_wall = [&](const ClosedContact& contact) {
        const std::int32_t surface = surface_touched(contact);
        const auto [place, is_new] = surfaces.try_emplace(surface, participants.size());
        if (is_new) {
            Participant its{{with_bits(0.0), with_bits(0.0)}, {0.0, 0.0}};
            if constexpr (has_surfaces) {
                const Barrier& barrier = geometry_.surfaces().barrier(contact.second);
                its.v = geometry_.surfaces().velocity_of(barrier, now_);
                if (pushes_piston(contact)) {
                    const auto& mover =
                        geometry_.surfaces().mover(static_cast<std::size_t>(surface));
                    its.inverse_mass[mover.axis] = mover.inverse_mass;
                }
            }
            participants.push_back(std::move(its));
        }
        return place->second;
    };
    for (const ClosedContact& contact : contacts) {
        const std::size_t first = of_body(contact.first);
        const std::size_t second = contact.is_pair ? of_body(contact.second) : of_wall(contact);
        among.push_back({first, second, contact.normal});
    }
    return {ContactRounds<Scalar>(std::move(participants), std::move(among), bits_),
            {bodies.begin(), bodies.end()},
            {surfaces.begin(), surfaces.end()}};
}

// Carries out all contacts of this instant that are connected with the event of body i. Returns
// false, and changes nothing, if there is only one: the event is then an ordinary collision.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::settle_instant(std::int32_t i, bool is_bath,
                                                                Collision* collision) {
    const std::vector<ClosedContact> contacts = closed_contacts_around(i);
    if (contacts.size() < (is_bath ? 1 : 2)) return false;
    Rounds its = rounds_of(contacts);
    const auto start = its.rounds.participants();
    std::size_t approaching = 0, receding = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        approaching += its.rounds.approaches(c) ? 1 : 0;
        receding += its.rounds.recedes(c) ? 1 : 0;
    }
    if (approaching == 0 || (approaching == 1 && receding + 1 == contacts.size() && !is_bath))
        return false;
    if (!its.rounds.run()) refuse_endless(i);
    if (its.rounds.hits().size() > 1 && !its.rounds.lead_back_to(start) && !one_way_)
        one_way_ = clock_.absolute(now_);
    for (const auto& [k, unused] : its.bodies) advance_body(body(k), now_);
    count_tie(its.rounds.hits().size());
    for (const auto& hit : its.rounds.hits()) carry_out(contacts[hit.contact], hit);
    if (collision && !at_once_.empty()) {
        *collision = at_once_.front();
        at_once_.erase(at_once_.begin());
    }
    note_touching(contacts, its);
    follow_up(i, its, start);
    return true;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::count_tie(std::size_t contacts) {
    if (contacts < 2) return;
    const double time = clock_.absolute(now_);
    if (!(time == last_tie_)) ++ties_.instants;
    if (ties_.contacts == 0) ties_.first = time;
    ties_.contacts += static_cast<std::int64_t>(contacts);
    counts_.ties = ties_.contacts;
    last_tie_ = time;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::carry_out(
    const ClosedContact& contact, const typename ContactRounds<Scalar>::Hit& hit) {
    const auto impulse = static_cast<double>(hit.impulse);
    const auto set_velocity = [&](std::int32_t k, std::size_t side) {
        Body& b = body(k);
        for (std::size_t a = 0; a < Dimension; ++a) b.v[a] = hit.after[side][a];
        if (velocities_) note_velocity(k, in_doubles(hit.before[side]));
    };
    set_velocity(contact.first, 0);
    const Eigen::Array2d place = in_plane(body(contact.first).x);
    Collision record{clock_.absolute(now_),
                     number_of(contact.first),
                     {},
                     place,
                     place + contact.distance * in_plane(contact.normal),
                     in_plane(hit.before[0]),
                     in_plane(hit.before[1]),
                     in_plane(hit.after[0]),
                     in_plane(hit.after[1])};
    if (contact.is_pair) {
        set_velocity(contact.second, 1);
        ++counts_.particle;
        impulses_.virial += contact.distance * impulse;
        const double sigma = contact.sigma;
        if (sigma > 0.0)
            impulses_.largest_overlap =
                std::max(impulses_.largest_overlap, 1.0 - contact.distance / sigma);
        record.second = number_of(contact.second);
    } else {
        ++counts_.wall;
        const auto surface = static_cast<std::size_t>(surface_touched(contact));
        if (Surfaces::is_side(surface)) impulses_.wall[surface] += impulse;
        record.second = Partner::of_surface(surface_touched(contact));
        if constexpr (has_surfaces) {
            auto& surfaces = geometry_.surfaces();
            Body& b = body(contact.first);
            surfaces.count_hit(b, contact.second, hit.before[0]);
            record.second_position =
                in_plane(surfaces.contact_point(b, surfaces.barrier(contact.second), now_));
        }
    }
    at_once_.push_back(record);
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::note_touching(
    const std::vector<ClosedContact>& contacts, const Rounds& its) {
    for (const auto& [k, unused] : its.bodies) {
        const std::int32_t number = number_of(k);
        std::erase_if(touching_,
                      [&](auto& pair) { return pair.first == number || pair.second == number; });
    }
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (!contacts[c].is_pair || its.rounds.recedes(c)) continue;
        const std::int32_t first = number_of(contacts[c].first),
                           second = number_of(contacts[c].second);
        touching_.insert({first, second});
        touching_.insert({second, first});
    }
    geometry_.coincidences().watch_always(!touching_.empty());
}

// Predicts what those whose velocity has changed do next, and the particle of the event.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::follow_up(
    std::int32_t i, const Rounds& its,
    const std::vector<typename ContactRounds<Scalar>::Participant>& start) {
    std::vector<std::int32_t> changed;
    const auto has_changed = [&](std::size_t participant) {
        return its.rounds.participants()[participant].v != start[participant].v;
    };
    for (const auto& [k, participant] : its.bodies) {
        Body& b = body(k);
        body_has_changed(b);
        if (!has_changed(participant) && k != i) continue;
        ++b.collisions;
        b.prediction = {};
        if constexpr (has_surfaces) geometry_.surfaces().path_has_changed(b);
        changed.push_back(k);
    }
    if constexpr (has_surfaces)
        for (const auto& [surface, participant] : its.surfaces) {
            const auto& after = its.rounds.participants()[participant];
            if (!has_changed(participant)) continue;
            const auto k = static_cast<std::size_t>(surface);
            geometry_.surfaces().push(k, after.v[geometry_.surfaces().mover(k).axis], now_);
        }
    for (const std::int32_t k : changed) predict_next(k);
    if constexpr (has_surfaces)
        for (const auto& [surface, participant] : its.surfaces)
            if (has_changed(participant)) look_for_hits(static_cast<std::size_t>(surface));
}

}  // namespace carom

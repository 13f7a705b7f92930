// The part of the event loop that carries out contacts that coincide, in rounds (contact_rounds.h).
// Included only by event_loop_steps.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "physics/events/event_loop_contacts.h"
#include "physics/events/event_loop_vectors.h"

namespace carom {

// Whether body j, which body i meets, expects something else until then.
template <int Dimension, typename Scalar, bool has_surfaces>
inline bool EventLoop<Dimension, Scalar, has_surfaces>::expects_another(std::int32_t j,
                                                                        std::int32_t i,
                                                                        double until) {
    const Prediction& expected = body(j).prediction;
    if (expected.contact_time < never<double> && expected.partner == i &&
        expected.partner_collisions == (body(i).collisions & most_collisions))
        return false;
    return i != j && static_cast<double>(queue_.time(j)) <= until;
}

// Whether other contacts may coincide with the event of body i, with or without a partner. Asked
// for each contact: two comparisons answer nearly always.
template <int Dimension, typename Scalar, bool has_surfaces>
inline bool EventLoop<Dimension, Scalar, has_surfaces>::may_coincide(std::int32_t i, std::int32_t j,
                                                                     double time) {
    const double until = time + geometry_.coincidences().margin();
    if (!queue_.may_have_another_until(until) && !geometry_.coincidences().are_near(time))
        [[likely]]
        return false;
    return may_coincide_until(until, i, j, time);
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::may_coincide_until(double until, std::int32_t i,
                                                                    std::int32_t j, double time) {
    Coincidences& noted = geometry_.coincidences();
    noted.forget_before(time);
    // In a large gas something always happens elsewhere within the margin.
    const auto concerns = [&](std::int32_t k) {
        return k != i && k != j && (may_touch(i, k) || may_touch(j, k));
    };
    return expects_another(j, i, until) || queue_.has_another_until(until, concerns) ||
           noted.are_noted_near(time) || touches_another(i) || touches_another(j);
}

template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::participant_of(std::int32_t i) -> Participant {
    const double w = geometry_.properties(bodies_, static_cast<std::size_t>(i)).inverse_mass;
    Participant body_itself{no_vector(), {}};
    body_itself.inverse_mass.fill(w);
    for (std::size_t a = 0; a < Dimension; ++a) body_itself.v[a] = velocity_at(body(i), a, now_);
    return body_itself;
}

template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::surface_participant(const ClosedContact& contact)
    -> Participant {
    Participant surface{no_vector(), {}};
    if constexpr (has_surfaces) {
        const auto& surfaces = geometry_.surfaces();
        surface.v = surfaces.velocity_of(surfaces.barrier(contact.second), now_);
        if (pushes_piston(contact)) {
            const auto& mover = surfaces.mover(static_cast<std::size_t>(surface_touched(contact)));
            surface.inverse_mass[mover.axis] = mover.inverse_mass;
        }
    }
    return surface;
}

// The bodies, and the surfaces, that take part in these contacts.
template <int Dimension, typename Scalar, bool has_surfaces>
auto EventLoop<Dimension, Scalar, has_surfaces>::rounds_of(
    const std::vector<ClosedContact>& contacts) -> Rounds {
    std::vector<Participant> participants;
    std::vector<typename AllContacts::Contact> among;
    std::map<std::int32_t, std::size_t> bodies, surfaces;
    const auto place_in = [&](auto& places, std::int32_t key, const auto& make) {
        const auto [place, is_new] = places.try_emplace(key, participants.size());
        if (is_new) participants.push_back(make());
        return place->second;
    };
    const auto place_of_body = [&](std::int32_t i) {
        return place_in(bodies, i, [&] { return participant_of(i); });
    };
    for (const ClosedContact& contact : contacts) {
        const std::size_t first = place_of_body(contact.first);
        const std::size_t second = contact.is_pair
                                       ? place_of_body(contact.second)
                                       : place_in(surfaces, surface_touched(contact),
                                                  [&] { return surface_participant(contact); });
        among.push_back({first, second, contact.normal});
    }
    return {AllContacts(std::move(participants), std::move(among), bits_),
            {bodies.begin(), bodies.end()},
            {surfaces.begin(), surfaces.end()}};
}

// Whether there are several contacts to carry out at once: not if one approaches and all others
// have just been carried out.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::is_tie(const AllContacts& rounds,
                                                        bool is_random) const {
    const std::size_t count = rounds.contacts().size();
    std::size_t approaching = 0, receding = 0;
    for (std::size_t c = 0; c < count; ++c) {
        approaching += rounds.approaches(c) ? 1 : 0;
        receding += rounds.recedes(c) ? 1 : 0;
    }
    return approaching > 1 || (approaching == 1 && (receding + 1 < count || is_random));
}

// Carries out all contacts of this instant that are connected with the event of body i, with or
// without a partner j, except those with surfaces that particles leave in random directions.
// Returns false, and changes nothing, if there is only one: the event is then an ordinary
// collision. `is_random`: the event is a contact with such a surface.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::settle_instant(std::int32_t i, std::int32_t j,
                                                                bool is_random,
                                                                Collision* collision) {
    const std::vector<ClosedContact> contacts = closed_contacts_around(i, j);
    if (contacts.size() < (is_random ? 1 : 2)) {
        // Those of the two that can be moved touch nothing else.
        for (const std::int32_t k : {i, j})
            if (geometry_.properties(bodies_, static_cast<std::size_t>(k)).inverse_mass > 0.0)
                forget_touching(k);
        geometry_.coincidences().watch_always(!touching_.empty());
        return false;
    }
    Rounds found = rounds_of(contacts);
    if (!is_tie(found.rounds, is_random)) return false;
    const std::vector<Participant> start = found.rounds.participants();
    if (!found.rounds.run()) refuse_endless(i);
    if (found.rounds.hits().size() > 1 && !one_way_ && !found.rounds.lead_back_to(start))
        one_way_ = clock_.absolute(now_);
    for (const auto& [k, unused] : found.bodies) advance_body(body(k), now_);
    count_tie(found.rounds.hits().size());
    for (const auto& hit : found.rounds.hits()) carry_out(contacts[hit.contact], hit);
    if (collision && !at_once_.empty()) {
        *collision = at_once_.front();
        at_once_.erase(at_once_.begin());
    }
    note_touching(contacts, found);
    follow_up({i, j}, found, start);
    return true;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::count_tie(std::size_t contacts) {
    if (contacts < 2) return;
    const double time = clock_.absolute(now_);
    Ties& ties = counts_.ties;
    if (!(time == last_tie_)) ++ties.instants;
    if (ties.contacts == 0) ties.first = time;
    ties.contacts += static_cast<std::int64_t>(contacts);
    last_tie_ = time;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::set_velocity(std::int32_t i, const Vector& before,
                                                              const Vector& after) {
    for (std::size_t a = 0; a < Dimension; ++a) body(i).v[a] = after[a];
    if (velocities_) note_velocity(i, as_vec(before));
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::carry_out(const ClosedContact& contact,
                                                           const typename AllContacts::Hit& hit) {
    set_velocity(contact.first, hit.before[0], hit.after[0]);
    if (contact.is_pair) set_velocity(contact.second, hit.before[1], hit.after[1]);
    const Vec place = as_vec(body(contact.first).x);
    at_once_.push_back({clock_.absolute(now_),
                        number_of(contact.first),
                        {},
                        place,
                        place + contact.distance * as_vec(contact.normal),
                        as_vec(hit.before[0]),
                        as_vec(hit.before[1]),
                        as_vec(hit.after[0]),
                        as_vec(hit.after[1])});
    if (contact.is_pair)
        count_pair(contact, static_cast<double>(hit.impulse));
    else
        count_hit(contact, hit);
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::count_pair(const ClosedContact& contact,
                                                            double impulse) {
    at_once_.back().second = number_of(contact.second);
    ++counts_.particle;
    impulses_.virial += contact.distance * impulse;
    if (contact.sigma > 0.0)
        impulses_.largest_overlap =
            std::max(impulses_.largest_overlap, 1.0 - contact.distance / contact.sigma);
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::count_hit(const ClosedContact& contact,
                                                           const typename AllContacts::Hit& hit) {
    const std::int32_t surface = surface_touched(contact);
    at_once_.back().second = Partner::of_surface(surface);
    ++counts_.wall;
    if (const auto side = static_cast<std::size_t>(surface); box_.surfaces.is_side(side))
        impulses_.wall[side] += static_cast<double>(hit.impulse);
    if constexpr (has_surfaces) {
        auto& surfaces = geometry_.surfaces();
        Body& b = body(contact.first);
        surfaces.count_hit(b, contact.second, contact.normal, hit.before[0], now_);
        at_once_.back().second_position =
            as_vec(surfaces.contact_point(b, surfaces.barrier(contact.second), now_));
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::note_touching(
    const std::vector<ClosedContact>& contacts, const Rounds& found) {
    for (const auto& [k, unused] : found.bodies) forget_touching(k);
    for (std::size_t c = 0; c < contacts.size(); ++c)
        if (!found.rounds.recedes(c)) add_touching(contacts[c]);
    geometry_.coincidences().watch_always(!touching_.empty());
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::forget_touching(std::int32_t i) {
    const std::int32_t number = number_of(i);
    while (true) {
        const auto pair = touching_.lower_bound({number, a_surface});
        if (pair == touching_.end() || pair->first != number) return;
        const auto [first, second] = *pair;
        touching_.erase({second, first});
        touching_.erase({first, second});
    }
}

// Predicts what those whose velocity has changed do next, and the particles of the event.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::follow_up(
    const std::array<std::int32_t, 2>& of_event, const Rounds& found,
    const std::vector<Participant>& start) {
    const auto has_changed = [&](std::size_t participant) {
        return found.rounds.participants()[participant].v != start[participant].v;
    };
    std::vector<std::int32_t> changed;
    for (const auto& [k, participant] : found.bodies) {
        Body& b = body(k);
        body_has_changed(b);
        if (!has_changed(participant) && k != of_event[0] && k != of_event[1]) continue;
        ++b.collisions;
        b.prediction = {};
        if constexpr (has_surfaces) geometry_.surfaces().path_has_changed(b);
        changed.push_back(k);
    }
    for (const auto& [surface, participant] : found.surfaces)
        if (has_changed(participant))
            push_surface(static_cast<std::size_t>(surface),
                         found.rounds.participants()[participant].v);
    for (const std::int32_t k : changed) predict_next(k);
    for (const auto& [surface, participant] : found.surfaces)
        if (has_changed(participant)) look_for_hits(static_cast<std::size_t>(surface));
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::push_surface(std::size_t k, const Vector& v) {
    if constexpr (has_surfaces) {
        auto& surfaces = geometry_.surfaces();
        surfaces.push(k, v[surfaces.mover(k).axis], now_);
    }
}

}  // namespace carom

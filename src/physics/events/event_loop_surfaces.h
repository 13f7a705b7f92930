// The part of the event loop needed only in boxes with active surfaces: hits of surfaces, events of
// the surfaces themselves, and changes by events of the run. Included only by event_loop_steps.h.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/events/event_loop.h"
#include "physics/events/event_loop_vectors.h"
#include "physics/mechanics.h"

namespace carom {

// The number of events that belong to surfaces: one for each mover, and one for the next change in
// the history.
template <int Dimension, typename Scalar, bool has_surfaces>
std::int32_t EventLoop<Dimension, Scalar, has_surfaces>::events_of_surfaces() const {
    if constexpr (has_surfaces)
        return static_cast<std::int32_t>(geometry_.surfaces().mover_count()) + 1;
    else
        return 0;
}

template <int Dimension, typename Scalar, bool has_surfaces>
Scalar EventLoop<Dimension, Scalar, has_surfaces>::surface_event(std::size_t k) const {
    if constexpr (has_surfaces) {
        const auto& surfaces = geometry_.surfaces();
        return k < surfaces.mover_count() ? surfaces.mover_event(k) : changes_.next_time();
    } else {
        return never<double>;
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::process_surface_event(std::size_t k) {
    if constexpr (has_surfaces) {
        const Scalar time = queue_.time(static_cast<std::int32_t>(bodies_.size() + k));
        move_on_to(time, std::nullopt);
        if (k == geometry_.surfaces().mover_count()) {
            move_epoch_to(now_);
            Change<Scalar, axes> change = changes_.take_next();
            carry_out(change);
            if (auto* its = std::get_if<SurfaceChange<Scalar>>(&change.what))
                its->is_pending = false;
            changes_.add_behind(std::move(change));
            geometry_.resettle(bodies_);
            predict_all();
            return;
        }
        const auto other = geometry_.surfaces().process_mover(k, now_);
        if (!geometry_.fits_grid(now_)) {
            move_epoch_to(now_);
            geometry_.enter(bodies_);
            predict_all();
            return;
        }
        look_for_hits(k);
        if (other) look_for_hits(*other);
    }
}

// To be called when the motion of a mover has changed: predicts which particles it reaches, and
// when its motion changes next.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::look_for_hits(std::size_t k) {
    if constexpr (has_surfaces) {
        const auto time_left = [&](std::int32_t i) {
            return rounded_up(Scalar(queue_.time(i) - now_));
        };
        const auto move_forward = [&](std::int32_t i, const Scalar& time) {
            if (!(time < queue_.time(i))) return false;
            queue_.schedule(i, time);
            return true;
        };
        geometry_.look_for_hits(bodies_, k, now_, {time_left, move_forward});
        // It may meet the other movers at other times now.
        for (std::size_t mover = 0; mover < geometry_.surfaces().mover_count(); ++mover)
            queue_.schedule(static_cast<std::int32_t>(bodies_.size() + mover),
                            surface_event(mover));
    }
}

// Returns true if the particle was reflected. It is not if the motion of the mover has changed
// since the prediction, or if the surface lets the particle through.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::hit(std::int32_t i, const Prediction& event,
                                                     Collision* collision) {
    bool reflected = false;
    if constexpr (has_surfaces) {
        auto& surfaces = geometry_.surfaces();
        const std::int32_t which = -1 - event.partner;
        const auto& barrier = surfaces.barrier(which);
        Body& b = body(i);
        if (surfaces.changes_of(barrier) == event.partner_collisions) {
            const auto time = static_cast<double>(now_);
            if (may_coincide(i, i, time)) [[unlikely]]
                if (settle_instant(i, i, surfaces.is_random(barrier), collision)) return true;
            advance_body(b, now_);
            const auto before = b.v;
            const auto surface_before = surfaces.velocity_of(barrier, now_);
            reflected = surfaces.hit(b, which, now_);
            if (reflected) {
                ++b.collisions;
                ++counts_.wall;
                const auto side = static_cast<std::size_t>(barrier.surface);
                if (box_.surfaces.is_side(side))
                    impulses_.wall[side] +=
                        std::abs(static_cast<double>(b.v[side / 2] - before[side / 2])) /
                        b.inverse_mass;
            }
            if (reflected && collision)
                *collision = {clock_.absolute(now_),
                              number_of(i),
                              Partner::of_surface(barrier.surface),
                              as_vec(b.x),
                              as_vec(surfaces.contact_point(b, barrier, now_)),
                              as_vec(before),
                              as_vec(surface_before),
                              as_vec(b.v),
                              as_vec(surfaces.velocity_of(barrier, now_))};
        }
        predict_next(i);
        if (reflected && surfaces.is_mobile(barrier))
            look_for_hits(static_cast<std::size_t>(barrier.surface));
    }
    return reflected;
}

// With the name of the surface, the time and where it is.
template <int Dimension, typename Scalar, bool has_surfaces>
SurfaceError EventLoop<Dimension, Scalar, has_surfaces>::at_present(
    const SurfaceError& error) const {
    if constexpr (has_surfaces) {
        const auto k = static_cast<std::size_t>(error.surface());
        const auto& mover = geometry_.surfaces().mover(k);
        return {error.surface(),
                fmt::format("`{}` {} at time {:.6g}, where it is at {} = {:.6g}{}",
                            box_.surfaces.names()[k], error.what(), clock_.absolute(now_),
                            name_of_axis(mover.axis), static_cast<double>(mover.place_at(now_)),
                            error.reason()),
                "", error.hint()};
    }
    return error;
}

// -------------------------------------------------------------------------- what events change

// A driven surface whose motion has an end stops there, unless it is changed before.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::stop_later(std::int32_t surface) {
    if constexpr (has_surfaces) {
        changes_.erase_if([&](const ChangeAction<Scalar, axes>& action) {
            const auto* change = std::get_if<SurfaceChange<Scalar>>(&action);
            return change != nullptr && change->is_pending && change->surface == surface;
        });
        const auto moving = geometry_.surfaces().control(surface, now_);
        const auto* driven = driven_of(moving.behaviour);
        if (driven == nullptr || !std::isfinite(driven->until)) return;
        auto still = moving;
        still.velocity = 0.0;
        const Scalar end = clock_.local(driven->until);
        if (end > now_)
            changes_.add_ahead(
                {end, SurfaceChange<Scalar>{surface, SurfaceChange<Scalar>::Part::end, moving,
                                            still, true}});
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
std::optional<std::int32_t> EventLoop<Dimension, Scalar, has_surfaces>::change(
    const SurfaceAction& action, bool is_mirrored, double time) requires has_surfaces {
    if constexpr (has_surfaces) {  // Clang before 16 instantiates it without, too
        move_epoch_to(clock_.local(time));
        auto& surfaces = geometry_.surfaces();
        const std::int32_t surface = surface_of(action);
        const auto before = surfaces.control(surface, now_);
        const auto after = control_after(before, action, time);
        surfaces.set_control(surface, after, now_);
        // Bodies that the surface has let through may still overlap it.
        const bool opens = sets_opening(action);
        const bool let_through = before.is_open || (!opens && membrane_of(before.behaviour));
        if (const auto one = let_through && !after.is_open ? first_in(surface) : std::nullopt) {
            surfaces.set_control(surface, before, now_);
            return one;
        }
        using Part = typename SurfaceChange<Scalar>::Part;
        const Part part = opens ? Part::opening : Part::motion;
        if (is_mirrored)
            changes_.add_behind({now_, SurfaceChange<Scalar>{surface, part, before, after}});
        if (!opens) stop_later(surface);
        geometry_.resettle(bodies_);
        predict_all();
        return std::nullopt;
    } else {
        return {};
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::carry_out(const Change<Scalar, axes>& change) {
    if constexpr (has_surfaces) {
        if (const auto* scaling = std::get_if<Scaling<Scalar, axes>>(&change.what)) {
            scale(*scaling);
            return;
        }
        const auto& its = std::get<SurfaceChange<Scalar>>(change.what);
        auto& surfaces = geometry_.surfaces();
        const auto before = surfaces.control(its.surface, now_);
        const auto after = its.applied_to(before);
        if (before.is_open && !after.is_open)
            if (const auto one = first_in(its.surface))
                throw SurfaceError(
                    its.surface, "cannot close again as the run goes back",
                    fmt::format(": particle {} is in its way, with {} bits", *one, bits_),
                    "use `precision: auto`, and let all events be undone that were before");
        surfaces.set_control(its.surface, after, now_);
    }
}

// The first particle that overlaps a surface, if any.
template <int Dimension, typename Scalar, bool has_surfaces>
std::optional<std::int32_t> EventLoop<Dimension, Scalar, has_surfaces>::first_in(
    std::int32_t surface) const {
    if constexpr (has_surfaces)
        for (std::size_t k = 0; k < bodies_.size(); ++k)
            if (geometry_.surfaces().overlapped(bodies_[k], now_, surface)) return number_[k];
    return std::nullopt;
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::counts_for(
    const Body& body, const std::optional<std::int32_t>& species) const {
    if constexpr (has_surfaces)
        return body.inverse_mass > 0.0 && (!species || body.species == *species);
    else
        return false;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::scale(const Scaling<Scalar, axes>& scaling) {
    if constexpr (has_surfaces)
        for (Body& b : bodies_) {
            if (!counts_for(b, scaling.species)) continue;
            for (std::size_t a = 0; a < Dimension; ++a) {
                const auto before = static_cast<double>(b.v[a]);
                b.v[a] = scaling.mean[a] + scaling.factor * (b.v[a] - scaling.mean[a]);
                const auto after = static_cast<double>(b.v[a]);
                heat_of_events_ += 0.5 * (after * after - before * before) / b.inverse_mass;
            }
        }
}

// Scales velocities: along axes where momentum is conserved relative to the velocity of the centre
// of mass, which stays the same, as does its energy; along other axes relative to 0. A target
// temperature is that of thermal_motion(), which takes velocities along conserved axes relative to
// those of the whole gas.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::heat(const Heat& heat, bool is_mirrored,
                                                      double time) requires has_surfaces {
    if constexpr (has_surfaces) {  // Clang before 16 instantiates it without, too
        using std::sqrt;
        move_epoch_to(clock_.local(time));
        const bool are_finite =
            std::ranges::none_of(bodies_, [](const Body& b) { return b.inverse_mass == 0.0; });
        Scalar mass = with_bits(0.0), mass_of_all = with_bits(0.0), energy = with_bits(0.0);
        Vector mean = no_vector(), mean_of_all = mean;
        double count = 0.0;
        for (const Body& b : bodies_) {
            if (b.inverse_mass == 0.0) continue;
            const Scalar its = with_bits(1.0) / b.inverse_mass;
            mass_of_all += its;
            for (std::size_t a = 0; a < Dimension; ++a) mean_of_all[a] += its * b.v[a];
            if (!counts_for(b, heat.species)) continue;
            count += 1.0;
            mass += its;
            for (std::size_t a = 0; a < Dimension; ++a) mean[a] += its * b.v[a];
        }
        if (count == 0.0) return false;
        // For a target temperature: the degrees of freedom, and the energy that scaling does not
        // change.
        Scalar freedom = with_bits(Dimension * count), energy_of_mean = with_bits(0.0);
        bool shares_energy = count > 1.0;
        for (std::size_t a = 0; a < Dimension; ++a) {
            if (!are_finite || !conserves_momentum(box_, static_cast<Eigen::Index>(a))) {
                mean[a] = with_bits(0.0);
                shares_energy = true;
                continue;
            }
            mean[a] = mean[a] / mass;
            const Scalar apart = mean[a] - mean_of_all[a] / mass_of_all;
            energy_of_mean += 0.5 * mass * apart * apart;
            freedom -= mass / mass_of_all;
        }
        if (!shares_energy) return false;
        for (const Body& b : bodies_) {
            if (!counts_for(b, heat.species)) continue;
            for (std::size_t a = 0; a < Dimension; ++a) {
                const Scalar v = b.v[a] - mean[a];
                energy += 0.5 * v * v / b.inverse_mass;
            }
        }
        const auto* to = std::get_if<Temperature>(&heat.amount);
        const Scalar wanted = to != nullptr ? Scalar(0.5 * freedom * to->value - energy_of_mean)
                                            : Scalar(energy + std::get<double>(heat.amount));
        if (!(energy > 0.0) || !(wanted > 0.0)) return false;
        const Change<Scalar, axes> change{
            now_, Scaling<Scalar, axes>{heat.species, sqrt(wanted / energy), mean}};
        carry_out(change);
        if (is_mirrored) changes_.add_behind(change);
        geometry_.resettle(bodies_);
        predict_all();
        return true;
    } else {
        return {};
    }
}

}  // namespace carom

// The steps of the event loop: from one event to the next, and what each event does.
// Included only by event_loop.cpp and mp_event_loop.cpp, which are compiled with different
// optimisation.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "physics/collision/contact_rule.h"
#include "physics/collision_error.h"
#include "physics/events/event_loop.h"
#include "physics/events/event_loop_instants.h"
#include "physics/events/event_loop_limits.h"
#include "physics/events/event_loop_samples.h"
#include "physics/events/event_loop_surfaces.h"
#include "physics/events/event_loop_vectors.h"
#include "physics/multiprecision/body_overlap.h"
#include "util/interrupt.h"

namespace carom {

// A cycle covers about eight events of each body; neighbours need a few cycles to separate.
inline constexpr int cycles_between_sorts = 2;

// Sets a pointer for the lifetime of this object.
template <typename T>
class PointedAt {
  public:
    PointedAt(T*& pointer, T* target) : pointer_(pointer) { pointer = target; }
    ~PointedAt() { pointer_ = nullptr; }
    PointedAt(const PointedAt&) = delete;
    PointedAt& operator=(const PointedAt&) = delete;

  private:
    T*& pointer_;
};

template <int Dimension, typename Scalar, bool has_surfaces>
EventLoop<Dimension, Scalar, has_surfaces>::EventLoop(const Box& box, const Particles& particles,
                                                      const Arithmetic& arithmetic,
                                                      std::int64_t most)
    : box_(box),
      bodies_(Geometry::bodies_of(particles)),
      geometry_(box, particles, arithmetic),
      queue_(static_cast<std::int32_t>(particles.count()) + events_of_surfaces()),
      bits_(arithmetic.bits),
      most_(most) {
    if constexpr (!of_doubles) clock_ = MpClock(arithmetic.bits);
    number_.reserve(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        number_.push_back(static_cast<std::int32_t>(i));
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::forget() {
    counts_ = {};
    impulses_ = {};
    heat_of_events_ = 0.0;
    one_way_ = {};
    last_tie_ = -never<double>;
    if constexpr (has_surfaces) geometry_.surfaces().forget();
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::start(Sample state) {
    now_ = clock_.start(state.time);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        Body& b = bodies_[k];
        b.time = now_;
        for (std::size_t a = 0; a < Dimension; ++a) {
            const auto axis = static_cast<Eigen::Index>(a);
            b.x[a] = with_bits(box_.wrapped(a, state.position(number_[k], axis)));
            b.v[a] = with_bits(state.velocity(number_[k], axis));
        }
        body_has_changed(b);
    }
    state = {};  // frees it before the predictions, which take the most memory
    put_in_order();
    if constexpr (has_surfaces) {
        geometry_.surfaces().shift_epoch(-now_);
        for (std::int32_t k = 0; k < box_.surfaces.first_obstacle(); ++k) stop_later(k);
    }
    geometry_.enter(bodies_);
    predict_all();
}

// Sorts the bodies and returns where each was before.
template <int Dimension, typename Scalar, bool has_surfaces>
std::vector<std::int32_t> EventLoop<Dimension, Scalar, has_surfaces>::put_in_order() {
    cycles_since_sorted_ = 0;
    std::vector<std::int32_t> order = geometry_.order(bodies_);
    // In place, along the cycles of the permutation: a second array would increase the peak memory
    // of a run.
    std::vector<bool> is_done(order.size());
    for (std::size_t first = 0; first < order.size(); ++first) {
        if (is_done[first] || static_cast<std::size_t>(order[first]) == first) continue;
        Body begin = std::move(bodies_[first]);
        const std::int32_t its_number = number_[first];
        std::size_t k = first;
        for (auto next = static_cast<std::size_t>(order[k]); next != first;
             next = static_cast<std::size_t>(order[k])) {
            bodies_[k] = std::move(bodies_[next]);
            number_[k] = number_[next];
            is_done[k] = true;
            k = next;
        }
        bodies_[k] = std::move(begin);
        number_[k] = its_number;
        is_done[k] = true;
    }
    return order;
}

// Sorts the bodies at any time and keeps the events already predicted.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::resort() {
    if constexpr (is_large) {
        std::vector<std::int32_t> before = put_in_order();
        geometry_.renumber(bodies_, before);
        for (std::int32_t k = 0; k < events_of_surfaces(); ++k)
            before.push_back(static_cast<std::int32_t>(before.size()));
        queue_.renumber(before);
    }
}

// All bodies must have been advanced to the present.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::predict_all() {
    at_one_instant_ = 0;
    geometry_.set_margin(margin_of_instants());
    for (Body& b : bodies_) b.collisions = 0;
    // Stored only after all predictions have been made, so that none depends on another one made
    // just before it.
    for (Body& b : bodies_) b.prediction = {};
    std::vector<Prediction> predictions;
    std::vector<Scalar> times;
    predictions.reserve(bodies_.size());
    times.reserve(bodies_.size() + static_cast<std::size_t>(events_of_surfaces()));
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        times.push_back(geometry_.predict(bodies_, static_cast<std::int32_t>(k), now_));
        predictions.push_back(std::exchange(bodies_[k].prediction, {}));
    }
    for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k].prediction = predictions[k];
    predictions = {};
    for (std::int32_t k = 0; k < events_of_surfaces(); ++k)
        times.push_back(surface_event(static_cast<std::size_t>(k)));
    queue_.reset(std::move(times));
    find_touching();
}

// Advances all bodies to a local time, which becomes the epoch.
template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::move_epoch_to(const Scalar& local_time) {
    now_ = local_time;
    for (Body& b : bodies_) advance_body(b, now_);
    const Scalar before = now_;
    now_ = clock_.move_epoch_to(now_);
    if constexpr (has_surfaces) {
        geometry_.surfaces().advance(before);
        geometry_.surfaces().shift_epoch(before - now_);
        changes_.shift_epoch(before - now_);
    }
    for (Body& b : bodies_) {
        b.time = now_;
        body_has_changed(b);
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::reverse(double time) {
    move_epoch_to(clock_.local(time));
    for (Body& b : bodies_) {
        for (Scalar& v : b.v) v = -v;
        body_has_changed(b);
    }
    if constexpr (has_surfaces) {
        geometry_.surfaces().reverse();
        changes_.reverse(now_);
    }
    predict_all();
}

template <int Dimension, typename Scalar, bool has_surfaces>
std::optional<Partner> EventLoop<Dimension, Scalar, has_surfaces>::displace(std::int64_t particle,
                                                                            const Displacement& by,
                                                                            double time) {
    move_epoch_to(clock_.local(time));
    const auto moved = static_cast<std::size_t>(
        std::find(number_.begin(), number_.end(), static_cast<std::int32_t>(particle)) -
        number_.begin());
    Body& b = bodies_.at(moved);
    for (std::size_t a = 0; a < Dimension; ++a) {
        if constexpr (of_doubles)
            b.x[a] += std::strtod(by[a].c_str(), nullptr);
        else
            b.x[a] += Real::from_text(by[a], bits_);
    }
    const auto obstacle = overlapped(moved);
    if constexpr (Dimension > 1) {
        for (std::size_t a = 0; a < Dimension; ++a) {
            const double size = box_.length(a);
            if (!box_.is_periodic(a)) continue;
            if (b.x[a] < 0.0) b.x[a] += size;
            if (b.x[a] >= size) b.x[a] -= size;
        }
        for (Body& one : bodies_) body_has_changed(one);
        geometry_.enter(bodies_);
    }
    predict_all();
    return obstacle;
}

// A contact is not an overlap; with doubles neither is a slightly deeper position, which is due to
// round-off.
template <int Dimension, typename Scalar, bool has_surfaces>
std::optional<Partner> EventLoop<Dimension, Scalar, has_surfaces>::overlapped(
    std::size_t moved) const {
    const double slack = of_doubles ? 1e-12 : 0.0;
    const Body& b = bodies_[moved];
    if constexpr (has_surfaces) {  // at present: sides may have moved
        if (const auto surface = geometry_.surfaces().overlapped(b, now_))
            return Partner::of_surface(*surface);
    } else {
        const double radius = geometry_.properties(bodies_, moved).radius;
        for (std::size_t a = 0; a < Dimension; ++a) {
            if (box_.is_periodic(a)) continue;
            const double size = box_.length(a);
            if (b.x[a] < radius - slack * size) return static_cast<Side>(2 * a);
            if (b.x[a] > size - radius + slack * size) return static_cast<Side>(2 * a + 1);
        }
    }
    if constexpr (Dimension == 1) {
        const auto k = geometry_.overlapped(bodies_, static_cast<std::int32_t>(moved), now_, slack);
        return k ? std::optional<Partner>(number_of(*k)) : std::nullopt;
    } else {
        const auto k = body_overlapped(geometry_, bodies_, moved, box_, slack);
        return k ? std::optional<Partner>(number_[*k]) : std::nullopt;
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::advance(double time,
                                                         std::vector<Collision>* record,
                                                         const TimeCallback& on_progress,
                                                         VelocityLog* velocities) {
    // With surfaces, velocities may also change between collisions, by gravity.
    if (has_surfaces && velocities) std::exchange(velocities, nullptr)->give_up();
    const PointedAt log(velocities_, velocities);
    constexpr int events_between_looks = 4096;
    int until_look = events_between_looks;
    Collision collision;
    while (true) {
        const std::int32_t i = next_particle();
        if (i < 0 || !(queue_.time(i) <= clock_.local(time))) break;
        if constexpr (is_large) fetch_ahead_.step(bodies_, geometry_, queue_);
        const bool is_surface_event = has_surfaces && static_cast<std::size_t>(i) >= bodies_.size();
        const bool is_collision = process(i, record ? &collision : nullptr);
        if (is_collision && record) record->push_back(collision);
        if (is_collision || is_surface_event) {
            ++collisions_;
            if (!at_once_.empty()) [[unlikely]] {
                collisions_ += std::ssize(at_once_);
                if (record) record->insert(record->end(), at_once_.begin(), at_once_.end());
                at_once_.clear();
            }
            if (collisions_ > most_) [[unlikely]]
                refuse_more_collisions();
        }
        if (--until_look == 0) {
            throw_if_interrupted();
            if (on_progress) on_progress(clock_.absolute(now_));
            until_look = events_between_looks;
        }
    }
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::advance_one(double time, Collision& collision) {
    if (!at_once_.empty()) {
        collision = at_once_.front();
        at_once_.erase(at_once_.begin());
        return true;
    }
    while (true) {
        const std::int32_t i = next_particle();
        if (i < 0 || !(queue_.time(i) <= clock_.local(time))) return false;
        if (process(i, &collision)) return true;
    }
}

// The particle with the earliest event, or -1 if there are no more events.
template <int Dimension, typename Scalar, bool has_surfaces>
inline std::int32_t EventLoop<Dimension, Scalar, has_surfaces>::next_particle() {
    if constexpr (of_doubles) {
        while (true) {
            const std::int32_t i = queue_.earliest();
            if (i >= 0 || !begin_cycle()) return i;
        }
    } else {
        return queue_.earliest();
    }
}

// To be called at the end of a cycle of the queue: moves the epoch so that all times stay small;
// the shift is a whole number of cycles and therefore exact. Returns false if there are no more
// events.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::begin_cycle() {
    if constexpr (of_doubles) {
        const double shift = queue_.next_cycle();
        if (!std::isfinite(shift)) return false;
        queue_.begin_cycle(shift);
        clock_.advance(shift);
        now_ -= shift;
        geometry_.coincidences().shift_epoch(shift);
        for (Body& b : bodies_) {
            b.time -= shift;
            b.prediction.contact_time -= shift;
        }
        if constexpr (has_surfaces) {
            geometry_.surfaces().shift_epoch(shift);
            changes_.shift_epoch(shift);
        }
        if (Geometry::is_resorted(bodies_.size()) && ++cycles_since_sorted_ >= cycles_between_sorts)
            resort();
    }
    return of_doubles;
}

// Returns true if the event was a collision, which is then written to `collision` unless that is
// null.
template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::process(std::int32_t i, Collision* collision) {
    if constexpr (has_surfaces) {
        if (static_cast<std::size_t>(i) >= bodies_.size()) {
            process_surface_event(static_cast<std::size_t>(i) - bodies_.size());
            return false;
        }
    }
    const Prediction event = body(i).prediction;
    const auto& exact_time = queue_.time(i);
    const auto time = static_cast<double>(exact_time);
    move_on_to(exact_time, i);
    if (event.contact_time <= time) {
        if constexpr (has_surfaces)
            if (event.partner < 0) return hit(i, event, collision);
        const std::int32_t j = event.partner;
        const bool is_valid = (body(j).collisions & most_collisions) == event.partner_collisions;
        if (is_valid && may_coincide(i, j, time)) [[unlikely]]
            if (settle_instant(i, j, false, collision)) return true;
        const bool met = is_valid && collide(i, j, collision);
        if constexpr (is_large) {
            std::array<double, 2> when;
            if (met && geometry_.predict_both(bodies_, i, j, now_, when)) {
                queue_.schedule(i, when[0]);
                queue_.schedule(j, when[1]);
                return true;
            }
        }
        predict_next(i);
        if (met) predict_next(j);
        return met;
    }
    if (event.border < first_cell_side) {
        if (may_coincide(i, i, time)) [[unlikely]]
            if (settle_instant(i, i, false, collision)) return true;
        bounce(i, static_cast<int>(event.border), collision);
        predict_next(i);
        return true;
    }
    const int side = static_cast<int>(event.border - first_cell_side);
    geometry_.cross(bodies_, i, side, now_);
    queue_.schedule(i, geometry_.predict_after_crossing(bodies_, i, side, now_));
    return false;
}

template <int Dimension, typename Scalar, bool has_surfaces>
bool EventLoop<Dimension, Scalar, has_surfaces>::collide(std::int32_t first, std::int32_t second,
                                                         Collision* collision) {
    Body& a = body(first);
    Body& b = body(second);
    if constexpr (has_surfaces && is_large) {
        geometry_.advance(a, now_);
        geometry_.advance(b, now_);
    } else {
        advance_body(a, now_);
        advance_body(b, now_);
    }
    Contact<Dimension> contact;
    const auto first_before = in_doubles(a.v), second_before = in_doubles(b.v);
    if (!geometry_.collide(bodies_, first, second, contact)) return false;
    ++a.collisions;
    ++b.collisions;
    ++counts_.particle;
    impulses_.virial += contact.virial;
    impulses_.largest_overlap = std::max(impulses_.largest_overlap, contact.overlap);
    if (velocities_) {
        note_velocity(first, as_vec(first_before));
        note_velocity(second, as_vec(second_before));
    }
    if (collision) {
        const Vec position = as_vec(a.x);
        *collision = {clock_.absolute(now_),
                      number_of(first),
                      number_of(second),
                      position,
                      position + as_vec(contact.separation),
                      as_vec(first_before),
                      as_vec(second_before),
                      as_vec(a.v),
                      as_vec(b.v)};
    }
    return true;
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::note_velocity(std::int32_t i, const Vec& before) {
    if (velocities_->is_open()) velocities_->note(number_of(i), before, as_vec(body(i).v));
}

template <int Dimension, typename Scalar, bool has_surfaces>
void EventLoop<Dimension, Scalar, has_surfaces>::bounce(std::int32_t i, int side,
                                                        Collision* collision) {
    Body& b = body(i);
    advance_body(b, now_);
    Scalar& v = b.v[static_cast<std::size_t>(side / 2)];
    impulses_.wall[static_cast<std::size_t>(side)] +=
        ContactRule::change(std::abs(static_cast<double>(v))) /
        geometry_.properties(bodies_, static_cast<std::size_t>(i)).inverse_mass;
    const auto before = in_doubles(b.v);
    ContactRule::reflect(v);
    body_has_changed(b);
    ++b.collisions;
    ++counts_.wall;
    if (velocities_) note_velocity(i, as_vec(before));
    if (!collision) return;
    const Vec position = as_vec(b.x);
    Vec contact = position;
    contact[side / 2] = side % 2 == 0 ? 0.0 : box_.size[side / 2];
    *collision = {clock_.absolute(now_),
                  number_of(i),
                  static_cast<Side>(side),
                  position,
                  contact,
                  as_vec(before),
                  Vec(),
                  as_vec(b.v),
                  Vec()};
}

}  // namespace carom

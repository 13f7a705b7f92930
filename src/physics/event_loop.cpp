#include "physics/event_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "util/interrupt.h"

namespace carom {
namespace {

// A lap is one or two events of each disk; it takes some tens for neighbours to part.
constexpr int laps_between_sorts = 20;

// Fewer lie near the processor anyhow.
constexpr std::size_t least_fetched_ahead = 16384;

// How many buckets ahead, each of half an event, particles are asked for; and how many particles
// later their cells, and the particles in these: each farther apart than memory takes to answer.
constexpr std::int32_t buckets_ahead = 16;
constexpr std::uint32_t cells_after = 2;
constexpr std::uint32_t bodies_near_after = 4;

template <std::size_t Dimension>
Eigen::Array2d in_plane(const std::array<double, Dimension>& x) {
    if constexpr (Dimension == 1)
        return {x[0], 0.0};
    else
        return {x[0], x[1]};
}

}  // namespace

template <int Dimension>
EventLoop<Dimension>::EventLoop(const Box& box, const Particles& particles)
    : box_(box),
      bodies_(static_cast<std::size_t>(particles.count())),
      space_(box, particles.radius),
      queue_(static_cast<std::int32_t>(particles.count())) {
    many_ = bodies_.size() >= least_fetched_ahead;
    number_.reserve(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        number_.push_back(static_cast<std::int32_t>(i));
        bodies_[i].radius = particles.radius[static_cast<Eigen::Index>(i)];
        bodies_[i].inverse_mass = particles.inverse_mass[static_cast<Eigen::Index>(i)];
    }
}

template <int Dimension>
void EventLoop<Dimension>::forget() {
    counts_ = {};
    transfers_ = {};
}

template <int Dimension>
void EventLoop<Dimension>::start(const Sample& state) {
    clock_ = LocalClock(state.time);
    now_ = 0.0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        Body& b = bodies_[k];
        b.time = 0.0;
        for (std::size_t a = 0; a < Dimension; ++a) {
            const auto axis = static_cast<Eigen::Index>(a);
            const double x = state.position(number_[k], axis);
            b.x[a] = box_.walls[a] == Wall::periodic ? wrapped(x, box_.size[axis]) : x;
            b.v[a] = state.velocity(number_[k], axis);
        }
    }
    put_in_order();
    space_.enter(bodies_);
    foresee_all();
}

template <int Dimension>
void EventLoop<Dimension>::put_in_order() {
    laps_since_sorted_ = 0;
    const std::vector<std::int32_t> order = space_.order(bodies_);
    typename Space::Bodies bodies(bodies_.size());
    std::vector<std::int32_t> number(number_.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        bodies[k] = body(order[k]);
        number[k] = number_of(order[k]);
    }
    bodies_.swap(bodies);
    number_.swap(number);
}

// All bodies are at local time 0.
template <int Dimension>
void EventLoop<Dimension>::foresee_all() {
    last_collision_ = -1.0;
    at_one_instant_ = 0;
    for (Body& b : bodies_) b.collisions = 0;
    queue_.reset(std::vector<Event>(bodies_.size()));
    std::vector<Event> events(bodies_.size());
    for (std::size_t i = 0; i < events.size(); ++i)
        events[i] = space_.foresee(bodies_, static_cast<std::int32_t>(i), now_, queue_);
    queue_.reset(events);
}

// All bodies fly to a local time, which becomes the epoch.
template <int Dimension>
void EventLoop<Dimension>::move_epoch_to(double local_time) {
    now_ = local_time;
    for (Body& b : bodies_) {
        fly_to_now(b);
        b.time = 0.0;
    }
    clock_.advance(now_);
    now_ = 0.0;
}

template <int Dimension>
void EventLoop<Dimension>::reverse(double time) {
    move_epoch_to(clock_.local(time));
    for (Body& b : bodies_)
        for (double& v : b.v) v = -v;
    foresee_all();
}

template <int Dimension>
void EventLoop<Dimension>::advance(double time, std::vector<Collision>* record) {
    constexpr int events_between_looks = 4096;
    int until_look = events_between_looks;
    Collision collision;
    while (true) {
        const std::int32_t i = next_particle();
        if (i < 0 || !(queue_.event(i).time <= clock_.local(time))) break;
        if (many_) fetch_ahead();
        if (process(i, record ? &collision : nullptr) && record) record->push_back(collision);
        if (--until_look == 0) {
            throw_if_interrupted();
            until_look = events_between_looks;
        }
    }
}

template <int Dimension>
bool EventLoop<Dimension>::advance_one(double time, Collision& collision) {
    while (true) {
        const std::int32_t i = next_particle();
        if (i < 0 || !(queue_.event(i).time <= clock_.local(time))) return false;
        if (process(i, &collision)) return true;
    }
}

template <int Dimension>
void EventLoop<Dimension>::sample(double time, Sample& state) const {
    const auto count = static_cast<Eigen::Index>(bodies_.size());
    state.time = time;
    state.position.resize(count, Dimension);
    state.velocity.resize(count, Dimension);
    const double local = clock_.local(time);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const Body& b = bodies_[k];
        for (std::size_t a = 0; a < Dimension; ++a) {
            const auto axis = static_cast<Eigen::Index>(a);
            const double x = b.x[a] + b.v[a] * (local - b.time);
            state.position(number_[k], axis) =
                box_.walls[a] == Wall::periodic ? wrapped(x, box_.size[axis]) : x;
            state.velocity(number_[k], axis) = b.v[a];
        }
    }
}

// Of many particles most lie far from the processor. The calendar tells whose events are near, so
// what these will need is asked for in time: the body, its cells, those in them, each when the one
// before has come.
template <int Dimension>
void EventLoop<Dimension>::fetch_ahead() {
    if constexpr (Dimension == 2) {
        const std::int32_t bucket = queue_.bucket();
        if (ahead_ < bucket || ahead_ > bucket + 2 * buckets_ahead) ahead_ = bucket;  // a new lap
        const std::int32_t end = std::min(bucket + buckets_ahead, queue_.buckets() - 1);
        while (ahead_ < end) {
            ahead_ = queue_.next_occupied(ahead_ + 1);
            if (ahead_ >= queue_.buckets()) break;
            const auto before = [this](std::uint32_t steps) -> std::int32_t& {
                return coming_[(coming_count_ - steps) % coming_.size()];
            };
            before(0) = queue_.first_in(ahead_);
            __builtin_prefetch(&body(before(0)));
            space_.fetch_cells_ahead(body(before(cells_after)));
            space_.fetch_bodies_ahead(bodies_, before(bodies_near_after), queue_);
            ++coming_count_;
        }
    }
}

// The particle with the earliest event, -1 when nothing will ever happen. Between laps all times
// are counted from a new epoch, so that they stay small (a whole number of laps: exact).
template <int Dimension>
std::int32_t EventLoop<Dimension>::next_particle() {
    while (true) {
        const std::int32_t i = queue_.earliest();
        if (i >= 0) return i;
        const double shift = queue_.next_lap();
        if (!std::isfinite(shift)) return -1;
        queue_.begin_lap(shift);
        clock_.advance(shift);
        now_ -= shift;
        last_collision_ -= shift;
        for (Body& b : bodies_) b.time -= shift;
        if (!Space::sorts_again(bodies_.size()) || ++laps_since_sorted_ < laps_between_sorts)
            continue;
        move_epoch_to(now_);  // the time of the last event
        put_in_order();
        space_.enter(bodies_);
        foresee_all();
    }
}

// True if it was a collision, which is then told unless `collision` is null.
template <int Dimension>
bool EventLoop<Dimension>::process(std::int32_t i, Collision* collision) {
    const Event event = queue_.event(i);
    if (event.time > now_)
        at_one_instant_ = 0;
    else
        refuse_to_stall();
    now_ = event.time;
    if (event.contact_time <= event.time) {
        const std::int32_t j = event.partner;
        const bool met = (body(j).collisions & most_collisions) == event.partner_collisions &&
                         collide(i, j, collision);
        queue_.schedule(i, space_.foresee(bodies_, i, now_, queue_));
        if (met) queue_.schedule(j, space_.foresee(bodies_, j, now_, queue_));
        return met;
    }
    if (event.border < first_cell_side) {
        bounce(i, static_cast<int>(event.border), collision);
        queue_.schedule(i, space_.foresee(bodies_, i, now_, queue_));
        return true;
    }
    const int side = static_cast<int>(event.border - first_cell_side);
    space_.cross(bodies_, i, side, now_);
    queue_.schedule(i, space_.foresee_after_crossing(bodies_, i, side, event, now_, queue_));
    return false;
}

// Touching starts take some events at time 0, but far fewer than this.
template <int Dimension>
void EventLoop<Dimension>::refuse_to_stall() {
    const auto bound = 1'000'000 + 100 * static_cast<std::int64_t>(bodies_.size());
    if (++at_one_instant_ <= bound) return;
    throw std::runtime_error(
        fmt::format("{} collide without end at t = {:g}: they fill the box along a line, or are "
                    "crushed between infinite masses",
                    Dimension == 1 ? "beads" : "disks", clock_.absolute(now_)));
}

template <int Dimension>
void EventLoop<Dimension>::fly_to_now(Body& b) const {
    for (std::size_t a = 0; a < Dimension; ++a) b.x[a] += b.v[a] * (now_ - b.time);
    b.time = now_;
}

template <int Dimension>
bool EventLoop<Dimension>::collide(std::int32_t first, std::int32_t second, Collision* collision) {
    Body& a = body(first);
    Body& b = body(second);
    fly_to_now(a);
    fly_to_now(b);
    Contact<Dimension> contact;
    const auto first_before = a.v, second_before = b.v;
    if (!space_.collide(bodies_, first, second, contact)) return false;
    ++a.collisions;
    ++b.collisions;
    ++counts_.particle;
    transfers_.virial += contact.virial;
    transfers_.largest_overlap = std::max(transfers_.largest_overlap, contact.overlap);
    count_tie(first, second);
    if (collision) {
        const Eigen::Array2d position = in_plane(a.x);
        *collision = {clock_.absolute(now_),
                      number_of(first),
                      number_of(second),
                      position,
                      position + in_plane(contact.separation),
                      in_plane(first_before),
                      in_plane(second_before),
                      in_plane(a.v),
                      in_plane(b.v)};
    }
    return true;
}

template <int Dimension>
void EventLoop<Dimension>::count_tie(std::int32_t first, std::int32_t second) {
    const auto was_in_last = [this](std::int32_t i) {
        return i == last_pair_[0] || i == last_pair_[1];
    };
    if (now_ == last_collision_ && (was_in_last(first) || was_in_last(second))) ++counts_.ties;
    last_collision_ = now_;
    last_pair_[0] = first;
    last_pair_[1] = second;
}

template <int Dimension>
void EventLoop<Dimension>::bounce(std::int32_t i, int side, Collision* collision) {
    Body& b = body(i);
    fly_to_now(b);
    double& v = b.v[static_cast<std::size_t>(side / 2)];
    transfers_.wall[static_cast<std::size_t>(side)] += 2.0 * std::abs(v) / b.inverse_mass;
    const auto before = b.v;
    v = -v;
    ++b.collisions;
    ++counts_.wall;
    if (!collision) return;
    const Eigen::Array2d position = in_plane(b.x);
    Eigen::Array2d contact = position;
    contact[side / 2] = side % 2 == 0 ? 0.0 : box_.size[side / 2];
    *collision = {clock_.absolute(now_),
                  number_of(i),
                  -1 - side,
                  position,
                  contact,
                  in_plane(before),
                  Eigen::Array2d::Zero(),
                  in_plane(b.v),
                  Eigen::Array2d::Zero()};
}

template class EventLoop<1>;
template class EventLoop<2>;

}  // namespace carom

#include "physics/surfaces/surface_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <ranges>
#include <utility>
#include <variant>

#include "physics/surfaces/surface_error.h"
#include "util/random.h"

namespace carom {
namespace {

auto& at(auto& things, std::integral auto i) { return things[static_cast<std::size_t>(i)]; }

// More work than this, in units of the energy that a box has without it, only a driven wall does
// that crushes the gas: in a plane the volume falls as the energy rises. It would hit ever faster,
// without end.
constexpr double most_times_energy = 1e8;

// The radius that surfaces see of a point, in units of the box, so that it has a side of a line.
constexpr double side_of_points = 1e-13;

template <typename Scalar>
Scalar dot(const std::array<Scalar, 2>& a,
           const std::array<Scalar, 2>& b) requires(!std::same_as<Scalar, double>) {
    return a[0] * b[0] + a[1] * b[1];
}

template <typename Scalar>
double square_of(const std::array<Scalar, 2>& v) {
    const auto x = static_cast<double>(v[0]), y = static_cast<double>(v[1]);
    return x * x + y * y;
}

// As a disk knows what it passes.
std::uint64_t bit_of(std::int32_t surface) { return std::uint64_t{1} << (surface % 64); }

// The end of a barrier along an axis that is met from a place; infinite from within.
double end_towards(const Barrier& barrier, std::size_t axis, double place) {
    const double low = barrier.low(axis), high = barrier.high(axis);
    return place <= low ? low : place >= high ? high : never<double>;
}

}  // namespace

template <typename Scalar>
SurfaceSet<Scalar>::SurfaceSet(const Box& box, double reach,
                               const std::array<double, 2>& registered, int bits)
    : box_(box),
      registered_(registered),
      bits_(bits),
      size_of_box_(box.size.maxCoeff()),
      least_radius_(side_of_points * size_of_box_),
      behaviours_(behaviours_of(box)),
      is_open_(behaviours_.size()),
      is_held_(behaviours_.size()),
      barriers_(barriers_of(box, reach, true)),
      totals_(behaviours_.size()),
      has_gravity_((box.surfaces.gravity != 0.0).any()) {
    const Surfaces& surfaces = box.surfaces;
    for (std::size_t k = 0; k < barriers_.size(); ++k)
        if (barriers_[k].is_endless()) floors_.push_back(static_cast<std::int32_t>(k));
    movers_.resize(static_cast<std::size_t>(surfaces.first_obstacle()));
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        Mover<Scalar>& mover = movers_[k];
        const Partition* line = surfaces.partition(k);
        mover.axis = static_cast<std::size_t>(surfaces.axis_of(k));
        mover.place = box.place_of(k);
        is_open_[k] = line != nullptr && line->is_open;
        double velocity = 0.0;
        if (const auto* driven = std::get_if<Driven>(&behaviours_[k])) velocity = driven->velocity;
        if (const auto* piston = std::get_if<Piston>(&behaviours_[k])) velocity = piston->velocity;
        set_motion(k, velocity);
        mover.changes = 0;
    }
}

// ------------------------------------------------------------------------------- where they are

template <typename Scalar>
const Mover<Scalar>* SurfaceSet<Scalar>::mover_of(const Barrier& barrier) const {
    if (static_cast<std::size_t>(barrier.surface) >= movers_.size()) return nullptr;
    const Mover<Scalar>& mover = at(movers_, barrier.surface);
    return mover.is_mobile ? &mover : nullptr;
}

template <typename Scalar>
bool SurfaceSet<Scalar>::is_there(const Barrier& barrier) const {
    return !is_open_[static_cast<std::size_t>(barrier.surface)];
}

template <typename Scalar>
bool SurfaceSet<Scalar>::lets_pass(const Barrier& barrier, std::int32_t species) const {
    const auto* membrane = std::get_if<Membrane>(&at(behaviours_, barrier.surface));
    return membrane != nullptr &&
           std::ranges::find(membrane->species, species) != membrane->species.end();
}

template <typename Scalar>
std::uint32_t SurfaceSet<Scalar>::changes_of(const Barrier& barrier) const {
    const auto* mover = mover_of(barrier);
    return mover != nullptr ? mover->changes & most_collisions : 0;
}

template <typename Scalar>
auto SurfaceSet<Scalar>::place_of(const Barrier& barrier, const Scalar& now) const -> Vector {
    Vector place{barrier.place[0], barrier.place[1]};
    if (const auto* mover = mover_of(barrier)) place[mover->axis] = mover->place_at(now);
    return place;
}

template <typename Scalar>
auto SurfaceSet<Scalar>::velocity_of(const Barrier& barrier, const Scalar& now) const -> Vector {
    Vector velocity{};
    if (const auto* mover = mover_of(barrier)) velocity[mover->axis] = mover->velocity_at(now);
    return velocity;
}

// As the barrier sees it.
template <typename Scalar>
BarrierMotion<Scalar> SurfaceSet<Scalar>::motion_of(const Body& body, const Barrier& barrier,
                                                    const Scalar& now) const {
    BarrierMotion<Scalar> m{
        .x = {}, .v = {}, .a = body.a, .radius = std::max(body.radius, least_radius_)};
    const Vector place = place_of(barrier, now);
    for (std::size_t k = 0; k < 2; ++k) {
        m.x[k] = position_at(body, k, now) - place[k];
        m.v[k] = velocity_at(body, k, now);
    }
    if (const auto* mover = mover_of(barrier)) {
        m.v[mover->axis] -= mover->velocity_at(now);
        m.a[mover->axis] -= mover->acceleration;
    }
    return m;
}

template <typename Scalar>
bool SurfaceSet<Scalar>::may_touch(const DiskView& disk, double radius, std::int32_t k,
                                   const Scalar& now, double within) const {
    const Barrier& its = barrier(k);
    BarrierMotion<double> m{.x = disk.x, .v = disk.v, .a = disk.a, .radius = radius};
    std::array<double, 2> place = its.place;
    if (const auto* mover = mover_of(its)) {
        place[mover->axis] = static_cast<double>(mover->place_at(now));
        m.v[mover->axis] -= static_cast<double>(mover->velocity_at(now));
        m.a[mover->axis] -= static_cast<double>(mover->acceleration);
    }
    for (std::size_t a = 0; a < 2; ++a) m.x[a] -= place[a];
    return may_touch_within(its, m, within, size_of_box_);
}

template <typename Scalar>
Scalar SurfaceSet<Scalar>::time_to(const Body& body, std::int32_t k, const Scalar& now) const {
    const Barrier& its = barrier(k);
    const BarrierMotion<Scalar> m = motion_of(body, its, now);
    const bool is_let_in = (body.passing & bit_of(its.surface)) != 0;
    const double let_in = is_let_in ? m.radius + least_radius_ : 0.0;
    if (its.kind == Barrier::Kind::circle) return circle_time(its, m, let_in, bits_);
    return line_time(its, m, let_in);
}

template <typename Scalar>
auto SurfaceSet<Scalar>::contact_point(const Body& body, const Barrier& barrier,
                                       const Scalar& now) const -> Vector {
    const BarrierMotion<Scalar> m = motion_of(body, barrier, now);
    Vector point = body.x;
    if (barrier.kind == Barrier::Kind::line) {
        const Scalar share = dot(barrier.normal, m.x);
        for (std::size_t k = 0; k < 2; ++k) point[k] -= share * barrier.normal[k];
    } else {
        const double share = 1.0 - barrier.radius / std::sqrt(square_of(m.x));
        for (std::size_t k = 0; k < 2; ++k) point[k] -= share * m.x[k];
    }
    return point;
}

template <typename Scalar>
std::optional<std::int32_t> SurfaceSet<Scalar>::overlapped(const Body& body, const Scalar& now,
                                                           std::optional<std::int32_t> only) const {
    std::vector<Barrier> present;
    for (const Barrier& barrier : barriers_) {
        if (only ? barrier.surface != *only : !is_there(barrier)) continue;
        if (lets_pass(barrier, body.species)) continue;
        present.push_back(barrier);
        const Vector place = place_of(barrier, now);
        present.back().place = {static_cast<double>(place[0]), static_cast<double>(place[1])};
    }
    return surface_in_the_way(box_, present,
                              {static_cast<double>(position_at(body, 0, now)),
                               static_cast<double>(position_at(body, 1, now))},
                              body.radius);
}

template <typename Scalar>
void SurfaceSet<Scalar>::settle_at_rest(Body& body) {
    if (!has_gravity_) return;
    const Eigen::Array2d& gravity = box_.surfaces.gravity;
    if (std::exchange(body.is_at_rest, false)) --at_rest_;
    body.a = {as_precise_as(body.x[0], gravity[0]), as_precise_as(body.x[0], gravity[1])};
    if ((body.v[0] != 0.0) & (body.v[1] != 0.0)) return;  // floors lie along an axis
    const double slack = 1e-12 * box_.size.maxCoeff();
    for (const std::int32_t k : floors_) {
        const Barrier& wall = barrier(k);
        if (is_mobile(wall) || !is_there(wall) || dot(wall.normal, body.v) != 0.0) continue;
        double distance = 0.0, pull = 0.0;
        for (std::size_t a = 0; a < 2; ++a) {
            distance += wall.normal[a] * static_cast<double>(body.x[a] - wall.place[a]);
            pull += wall.normal[a] * static_cast<double>(body.a[a]);
        }
        const double side = wall.side_of(distance);
        if (side * distance > body.radius + slack || !(side * pull < 0.0)) continue;
        for (std::size_t a = 0; a < 2; ++a) body.a[a] -= Scalar(pull * wall.normal[a]);
        if (!std::exchange(body.is_at_rest, true)) ++at_rest_;
    }
}

// --------------------------------------------------------------------------------- what they do

// The velocity of the flux along the normal, away from the wall, and a normal one along the wall.
template <typename Scalar>
void SurfaceSet<Scalar>::leave_bath(Body& body, const Barrier& barrier, double temperature,
                                    std::int64_t hit, const Scalar& now) {
    Random random(box_.surfaces.seed, fmt::format("hit {} of surface {}", hit, barrier.surface));
    const double thermal = std::sqrt(temperature * body.inverse_mass);
    const double away = thermal * std::sqrt(-2.0 * std::log1p(-random.uniform()));
    const double across = box_.dimension == 2 ? thermal * random.normal() : 0.0;
    const Vector from = motion_of(body, barrier, now).x;
    std::array<double, 2> normal = barrier.normal;
    double side = barrier.side_of(dot(normal, from));
    if (barrier.kind == Barrier::Kind::circle) {  // a corner: away from it
        const double distance = std::sqrt(square_of(from));
        for (std::size_t k = 0; k < 2; ++k) normal[k] = static_cast<double>(from[k]) / distance;
        side = 1.0;
    }
    body.v = {as_precise_as(body.x[0], side * away * normal[0] + across * normal[1]),
              as_precise_as(body.x[0], side * away * normal[1] - across * normal[0])};
}

template <typename Scalar>
void SurfaceSet<Scalar>::reflect(Body& body, const Barrier& barrier, const Scalar& now) {
    const BarrierMotion<Scalar> m = motion_of(body, barrier, now);
    const Vector normal = barrier.kind == Barrier::Kind::line
                              ? Vector{as_precise_as(m.x[0], barrier.normal[0]),
                                       as_precise_as(m.x[0], barrier.normal[1])}
                              : m.x;
    const auto* mover = mover_of(barrier);
    const double other = mover != nullptr ? mover->inverse_mass : 0.0;
    Scalar factor = -2.0 * dot(m.v, normal) / dot(normal, normal);
    if (!(other > 0.0)) {
        for (std::size_t k = 0; k < 2; ++k) body.v[k] += factor * normal[k];
        return;
    }
    // One impulse for both: two with rounding errors of their own would make the energy drift.
    factor = divided_by_sum(factor, as_precise_as(factor, body.inverse_mass),
                            as_precise_as(factor, other));
    for (std::size_t k = 0; k < 2; ++k) body.v[k] += body.inverse_mass * factor * normal[k];
    Mover<Scalar>& hit = at(movers_, barrier.surface);
    hit.advance(now);
    hit.velocity -= other * factor * normal[hit.axis];
    ++hit.changes;
}

// A point that is fast has flown through the line within the rounding error of a time. It came from
// the side that it flies away from; of a wall, from the inside.
template <typename Scalar>
void SurfaceSet<Scalar>::keep_on_its_side(Body& body, const Barrier& line,
                                          const Scalar& now) const {
    const BarrierMotion<Scalar> m = motion_of(body, line, now);
    const double side = line.is_wall() || dot(line.normal, m.v) < 0.0 ? 1.0 : -1.0;
    const double distance = side * static_cast<double>(dot(line.normal, m.x));
    if (distance >= 0.5 * least_radius_) return;
    for (std::size_t k = 0; k < 2; ++k)
        body.x[k] += Scalar(side * (least_radius_ - distance) * line.normal[k]);
}

template <typename Scalar>
bool SurfaceSet<Scalar>::hit(Body& body, std::int32_t k, const Scalar& now) {
    const Barrier& its = barrier(k);
    const Behaviour& behaviour = at(behaviours_, its.surface);
    if (its.kind == Barrier::Kind::line && body.radius < least_radius_)
        keep_on_its_side(body, its, now);
    const BarrierMotion<Scalar> m = motion_of(body, its, now);
    const Scalar approach = its.kind == Barrier::Kind::line
                                ? Scalar(its.side_of(dot(its.normal, m.x)) * dot(its.normal, m.v))
                                : dot(m.x, m.v);
    if (!(approach < 0.0)) return false;
    if (const auto* membrane = std::get_if<Membrane>(&behaviour)) {
        const auto& speeds =
            body.v[at(movers_, its.surface).axis] > 0.0 ? membrane->upward : membrane->downward;
        if (speeds.admits(std::sqrt(square_of(body.v)))) {
            body.passing |= bit_of(its.surface);
            some_passed_ = true;
            return false;
        }
    }
    const Vector before = body.v;
    const std::int64_t number = ++at(totals_, its.surface).hits;
    const auto* bath = std::get_if<Bath>(&behaviour);
    if (bath != nullptr && body.inverse_mass > 0.0)
        leave_bath(body, its, bath->temperature, number, now);
    else
        reflect(body, its, now);
    path_has_changed(body);
    if (body.inverse_mass > 0.0) account_for_hit(body, before, its);
    return true;
}

template <typename Scalar>
void SurfaceSet<Scalar>::account_for_hit(const Body& body, const Vector& before,
                                         const Barrier& barrier) {
    SurfaceTotals& totals = at(totals_, barrier.surface);
    const double mass = 1.0 / body.inverse_mass;
    for (std::size_t a = 0; a < 2; ++a)
        totals.impulse[static_cast<Eigen::Index>(a)] +=
            mass * static_cast<double>(before[a] - body.v[a]);
    const double gain = 0.5 * mass * (square_of(body.v) - square_of(before));
    if (std::holds_alternative<Bath>(at(behaviours_, barrier.surface))) {
        totals.heat += gain;
        most_work_ += most_times_energy * std::abs(gain);
    } else if (const auto* mover = mover_of(barrier)) {
        totals.work += gain;
        if (mover->inverse_mass == 0.0) driven_work_ += gain;
    }
    if (totals.work > most_work_) throw crushes(barrier.surface);
}

template <typename Scalar>
std::optional<std::int32_t> SurfaceSet<Scalar>::hardest_worker() const {
    const auto movers =
        std::ranges::subrange(totals_.begin(), totals_.begin() + std::ssize(movers_));
    const auto most = std::ranges::max_element(movers, {}, &SurfaceTotals::work);
    if (most == movers.end() || !(most->work > 0.0)) return std::nullopt;
    return static_cast<std::int32_t>(most - movers.begin());
}

// --------------------------------------------------------------------------------------- movers

template <typename Scalar>
void SurfaceSet<Scalar>::register_mover(Mover<Scalar>& mover) const {
    mover.low = mover.place - registered_[mover.axis];
    mover.high = mover.place + registered_[mover.axis];
}

// When a mover reaches a barrier at rest, -1 - its number, or another mover.
template <typename Scalar>
Scalar SurfaceSet<Scalar>::next_obstacle(const Mover<Scalar>& mover, std::int32_t& other) const {
    Scalar first = never<double>;
    const auto consider = [&](const Scalar& from, const Scalar& apart, const Scalar& v,
                              const Scalar& a, std::int32_t which) {
        const double side = apart < 0.0 || (apart == 0.0 && v < 0.0) ? -1.0 : 1.0;
        const Scalar t = from + fall_time<Scalar>(side * apart, side * v, side * a);
        if (t < first) first = t, other = which;
    };
    const double place = static_cast<double>(mover.place);
    for (std::size_t k = 0; k < barriers_.size(); ++k) {
        const Barrier& barrier = barriers_[k];
        if (is_mobile(barrier) || !is_there(barrier)) continue;
        // It slides along a partition that stands across its way.
        const auto its = static_cast<std::size_t>(barrier.surface);
        if (its < movers_.size() && movers_[its].axis != mover.axis) continue;
        const double end = end_towards(barrier, mover.axis, place);
        if (!std::isfinite(end)) continue;
        consider(mover.time, mover.place - end, mover.velocity, mover.acceleration,
                 -1 - static_cast<std::int32_t>(k));
    }
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        const Mover<Scalar>& one = movers_[k];
        if (&one == &mover || !one.is_mobile || one.axis != mover.axis || is_open_[k]) continue;
        const Scalar& both = std::max(mover.time, one.time);  // their motions are known from then
        consider(both, mover.place_at(both) - one.place_at(both),
                 mover.velocity_at(both) - one.velocity_at(both),
                 mover.acceleration - one.acceleration, static_cast<std::int32_t>(k));
    }
    return first;
}

template <typename Scalar>
Scalar SurfaceSet<Scalar>::mover_event(std::size_t k) const {
    const Mover<Scalar>& mover = movers_[k];
    if (!mover.is_mobile || is_open_[k]) return never<double>;
    std::int32_t other = 0;
    return std::min(mover.registered_until(), next_obstacle(mover, other));
}

// By no more than round-off, without a change of its energy: that would grow with each bounce.
template <typename Scalar>
void SurfaceSet<Scalar>::move_exactly_to(Mover<Scalar>& mover, const Scalar& place) {
    using std::sqrt;
    if (mover.acceleration != 0.0) {
        const Scalar square =
            mover.velocity * mover.velocity + 2.0 * mover.acceleration * (place - mover.place);
        if (square > 0.0)
            mover.velocity = mover.velocity < 0.0 ? Scalar(-sqrt(square)) : sqrt(square);
    }
    mover.place = place;
}

// Elastically.
template <typename Scalar>
void SurfaceSet<Scalar>::bounce_off(Mover<Scalar>& mover, std::int32_t other, const Scalar& now) {
    ++mover.changes;
    if (other < 0) {  // exactly there: a little beyond, it would not be met again
        const auto place = static_cast<double>(mover.place);
        const Barrier& met = barrier(-1 - other);
        const double low = met.low(mover.axis), high = met.high(mover.axis);
        move_exactly_to(mover, as_precise_as(mover.place, place - low < high - place ? low : high));
        mover.velocity = -mover.velocity;
        return;
    }
    Mover<Scalar>& partner = at(movers_, other);
    partner.advance(now);
    move_exactly_to(mover, partner.place);
    const auto energy = [](const Mover<Scalar>& its) {
        const auto v = static_cast<double>(its.velocity);
        return its.inverse_mass > 0.0 ? 0.5 * v * v / its.inverse_mass : 0.0;
    };
    const double before = energy(mover) + energy(partner);
    const Scalar impulse =
        2.0 * (partner.velocity - mover.velocity) /
        (as_precise_as(mover.velocity, mover.inverse_mass) + partner.inverse_mass);
    mover.velocity += impulse * mover.inverse_mass;
    partner.velocity -= impulse * partner.inverse_mass;
    if (mover.inverse_mass == 0.0 || partner.inverse_mass == 0.0)
        driven_work_ += energy(mover) + energy(partner) - before;
    ++partner.changes;
}

template <typename Scalar>
std::optional<std::size_t> SurfaceSet<Scalar>::process_mover(std::size_t k, const Scalar& now) {
    Mover<Scalar>& mover = movers_[k];
    std::int32_t other = 0;
    // The time has been rounded again since this was predicted. A little beyond what it reaches, it
    // would not meet that any more.
    const Scalar wait = next_obstacle(mover, other) - now;
    mover.advance(now);
    double speed = std::abs(static_cast<double>(mover.velocity));
    if (other >= 0) speed += std::abs(static_cast<double>(at(movers_, other).velocity_at(now)));
    const bool has_reached = !(static_cast<double>(wait) * speed > least_radius_);
    register_mover(mover);
    if (!has_reached) return std::nullopt;
    const bool is_driven = mover.inverse_mass == 0.0;
    if (is_driven && (other < 0 || at(movers_, other).inverse_mass == 0.0))
        throw SurfaceError(static_cast<std::int32_t>(k), "reaches another surface", "",
                           "stop it before (`until`, or an event), or end the run");
    bounce_off(mover, other, now);
    if (other < 0) return std::nullopt;
    return static_cast<std::size_t>(other);
}

template <typename Scalar>
SurfaceControl<Scalar> SurfaceSet<Scalar>::control(std::int32_t surface, const Scalar& now) const {
    const auto k = static_cast<std::size_t>(surface);
    SurfaceControl<Scalar> control{behaviours_[k], is_open_[k], is_held_[k], Scalar(0.0)};
    if (k < movers_.size()) control.velocity = movers_[k].velocity_at(now);
    return control;
}

template <typename Scalar>
void SurfaceSet<Scalar>::set_control(std::int32_t surface, const SurfaceControl<Scalar>& control,
                                     const Scalar& now) {
    const auto k = static_cast<std::size_t>(surface);
    movers_[k].advance(now);
    const double before = energy_of_piston(k);
    behaviours_[k] = control.behaviour;
    is_open_[k] = control.is_open;
    is_held_[k] = control.is_held;
    set_motion(k, control.velocity);
    register_mover(movers_[k]);
    driven_work_ += energy_of_piston(k) - before;
}

// Kinetic, and in the constant forces on it.
template <typename Scalar>
double SurfaceSet<Scalar>::energy_of_piston(std::size_t k) const {
    const auto* piston = std::get_if<Piston>(&behaviours_[k]);
    if (piston == nullptr) return 0.0;
    const Mover<Scalar>& mover = movers_[k];
    const double pull = box_.surfaces.gravity[static_cast<Eigen::Index>(mover.axis)];
    return piston->kinetic_energy(static_cast<double>(mover.velocity)) +
           piston->potential_energy(static_cast<double>(mover.place), pull);
}

// As its behaviour has it.
template <typename Scalar>
void SurfaceSet<Scalar>::set_motion(std::size_t k, const Scalar& velocity) {
    Mover<Scalar>& mover = movers_[k];
    const auto* piston = std::get_if<Piston>(&behaviours_[k]);
    const bool is_free = piston != nullptr && !is_held_[k];
    const auto axis = static_cast<Eigen::Index>(mover.axis);
    mover.inverse_mass = is_free ? 1.0 / piston->mass : 0.0;
    mover.acceleration =
        is_free ? piston->force * mover.inverse_mass + box_.surfaces.gravity[axis] : 0.0;
    const bool is_driven = std::holds_alternative<Driven>(behaviours_[k]);
    mover.velocity = is_free || is_driven ? velocity : Scalar(0.0);
    mover.is_mobile = mover.is_mobile || piston != nullptr || is_driven;
    ++mover.changes;
}

// ------------------------------------------------------------------------------------ the whole

template <typename Scalar>
void SurfaceSet<Scalar>::enter(const LargeVector<Body>& bodies, const Scalar& now) {
    for (Mover<Scalar>& mover : movers_) {
        mover.advance(now);
        register_mover(mover);
    }
    most_work_ = most_times_energy * energy_of(bodies);
    for (const SurfaceTotals& totals : totals_) most_work_ += std::max(0.0, totals.work);
}

// All that the gas could have without driven walls and baths, but for them: kinetic energies, those
// of disks as fast as the fastest mover, and what a fall through the box gives.
template <typename Scalar>
double SurfaceSet<Scalar>::energy_of(const LargeVector<Body>& bodies) const {
    const Eigen::Array2d fall = box_.surfaces.gravity.abs() * box_.size;
    double energy = 0.0, fastest = 0.0;
    for (const Mover<Scalar>& mover : movers_) {
        const auto v = static_cast<double>(mover.velocity);
        fastest = std::max(fastest, std::abs(v));
        if (!(mover.inverse_mass > 0.0)) continue;
        const double way =
            std::abs(static_cast<double>(mover.acceleration)) * box_.length(mover.axis);
        energy += (0.5 * v * v + way) / mover.inverse_mass;
    }
    for (const Body& body : bodies)
        if (body.inverse_mass > 0.0)
            energy += (square_of(body.v) + fastest * fastest + fall.sum()) / body.inverse_mass;
    return energy;
}

template <typename Scalar>
void SurfaceSet<Scalar>::advance(const Scalar& now) {
    for (Mover<Scalar>& mover : movers_) mover.advance(now);
}

template <typename Scalar>
void SurfaceSet<Scalar>::shift_epoch(const Scalar& shift) {
    for (Mover<Scalar>& mover : movers_) mover.time -= shift;
}

template <typename Scalar>
void SurfaceSet<Scalar>::reverse() {
    for (Mover<Scalar>& mover : movers_) {
        mover.velocity = -mover.velocity;
        ++mover.changes;
    }
}

template <typename Scalar>
std::vector<SurfaceState> SurfaceSet<Scalar>::states(const Scalar& now) const {
    std::vector<SurfaceState> states;
    for (std::size_t k = 0; k < totals_.size(); ++k) {
        states.push_back({totals_[k], behaviours_[k], is_open_[k], is_held_[k], {}});
        if (k < movers_.size() && movers_[k].is_mobile)
            states[k].motion =
                SurfaceState::Motion{static_cast<double>(movers_[k].place_at(now)),
                                     static_cast<double>(movers_[k].velocity_at(now))};
    }
    return states;
}

template <typename Scalar>
void SurfaceSet<Scalar>::forget() {
    totals_.assign(totals_.size(), {});
    driven_work_ = 0.0;
}

template class SurfaceSet<double>;
template class SurfaceSet<Real>;

}  // namespace carom

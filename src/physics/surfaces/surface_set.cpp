#include "physics/surfaces/surface_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>
#include <variant>

#include "physics/collision/contact_rule.h"
#include "physics/surfaces/surface_error.h"
#include "util/overloaded.h"
#include "util/random.h"

namespace carom {
namespace {

// Work above this multiple of the energy that the box has without it is done only by a driven wall
// that crushes the gas (in a plane the volume falls as the energy rises), which would hit disks
// ever faster without end.
constexpr double most_times_energy = 1e5;

// Where numbers with very many bits have units in the last place that no double can hold.
constexpr double least_clearance = 1e-290;

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

// The bit of a surface in FallingDisk::passing.
std::uint64_t bit_of(std::int32_t surface) { return std::uint64_t{1} << (surface % 64); }

}  // namespace

template <typename Scalar>
SurfaceSet<Scalar>::SurfaceSet(const Box& box, double reach,
                               const std::array<double, 2>& registered, int bits)
    : Base(box, reach, registered),
      bits_(bits),
      clearance_(std::max(std::ldexp(8.0 * box.longest_side(), -bits), least_clearance)),
      size_of_box_(box.longest_side()),
      totals_(behaviours_.size()),
      has_gravity_(box.surfaces.has_gravity()) {
    for (std::size_t k = 0; k < barriers_.size(); ++k)
        if (barriers_[k].is_endless()) floors_.push_back(static_cast<std::int32_t>(k));
}

// The motion of a disk relative to a barrier.
template <typename Scalar>
BarrierMotion<Scalar> SurfaceSet<Scalar>::motion_of(const Body& body, const Barrier& barrier,
                                                    const Scalar& now) const {
    BarrierMotion<Scalar> m{.x = {}, .v = {}, .a = body.a, .radius = body.radius};
    const Vector place = this->place_of(barrier, now);
    for (std::size_t k = 0; k < 2; ++k) {
        m.x[k] = position_at(body, k, now) - place[k];
        m.v[k] = velocity_at(body, k, now);
    }
    if (const auto* mover = this->mover_of(barrier)) {
        m.v[mover->axis] -= mover->velocity_at(now);
        m.a[mover->axis] -= mover->acceleration;
    }
    return m;
}

template <typename Scalar>
bool SurfaceSet<Scalar>::may_touch(const BodyView<2>& disk, double radius, std::int32_t k,
                                   const Scalar& now, double within) const {
    const Barrier& barrier = this->barrier(k);
    BarrierMotion<double> m{.x = disk.x, .v = disk.v, .a = disk.a, .radius = radius};
    std::array<double, 2> place = barrier.place;
    if (const auto* mover = this->mover_of(barrier)) {
        place[mover->axis] = static_cast<double>(mover->place_at(now));
        m.v[mover->axis] -= static_cast<double>(mover->velocity_at(now));
        m.a[mover->axis] -= static_cast<double>(mover->acceleration);
    }
    for (std::size_t a = 0; a < 2; ++a) m.x[a] -= place[a];
    return may_touch_within(barrier, m, within, size_of_box_);
}

template <typename Scalar>
Scalar SurfaceSet<Scalar>::time_to(const Body& body, std::int32_t k, const Scalar& now) const {
    const Barrier& barrier = this->barrier(k);
    BarrierMotion<Scalar> m = motion_of(body, barrier, now);
    const bool is_let_in = (body.passing & bit_of(barrier.surface)) != 0;
    if (barrier.kind == Barrier::Kind::line)  // a point that it has let in is beyond it at once
        return line_time(barrier, m, is_let_in && !is_point(body) ? m.radius + slack_ : 0.0);
    // At a corner, where two lines meet, round-off might let a point through.
    if (barrier.radius == 0.0) m.radius = std::max(m.radius, clearance_);
    return circle_time(barrier, m, is_let_in ? m.radius + slack_ : 0.0, bits_);
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
        if (only ? barrier.surface != *only : !this->is_there(barrier)) continue;
        if (this->lets_pass(barrier, body.species)) continue;
        present.push_back(barrier);
        const Vector place = this->place_of(barrier, now);
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
    const Vec& gravity = box_.surfaces.gravity;
    if (std::exchange(body.is_at_rest, false)) --at_rest_;
    body.a = {as_precise_as(body.x[0], gravity[0]), as_precise_as(body.x[0], gravity[1])};
    if ((body.v[0] != 0.0) & (body.v[1] != 0.0)) return;  // floors lie along an axis
    const double slack = slack_of_places(box_);
    for (const std::int32_t k : floors_) {
        const Barrier& wall = this->barrier(k);
        if (this->is_mobile(wall) || !this->is_there(wall) || dot(wall.normal, body.v) != 0.0)
            continue;
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

// Numbers that depend on the seed and on this hit only, so that a run is the same everywhere.
template <typename Scalar>
Random SurfaceSet<Scalar>::random_of_hit(std::int32_t surface, std::int64_t hit) const {
    return {box_.surfaces.seed, fmt::format("hit {} of surface {}", hit, surface)};
}

// The normal velocity has the distribution of the flux, directed away from the wall; the tangential
// velocity is normally distributed.
template <typename Scalar>
void SurfaceSet<Scalar>::leave_bath(Body& body, const Barrier& barrier, double temperature,
                                    std::int64_t hit, const Vector& from) {
    Random random = random_of_hit(barrier.surface, hit);
    const double thermal = std::sqrt(temperature * body.inverse_mass);
    const double away = thermal * std::sqrt(-2.0 * std::log1p(-random.uniform()));
    const double across = box_.dimension == 2 ? thermal * random.normal() : 0.0;
    std::array<double, 2> normal = barrier.normal;
    double side = barrier.side_of(dot(normal, from));
    if (barrier.kind == Barrier::Kind::circle) {  // a corner: the normal points away from it
        const double distance = std::sqrt(square_of(from));
        for (std::size_t k = 0; k < 2; ++k) normal[k] = static_cast<double>(from[k]) / distance;
        side = 1.0;
    }
    body.v = {as_precise_as(body.x[0], side * away * normal[0] + across * normal[1]),
              as_precise_as(body.x[0], side * away * normal[1] - across * normal[0])};
}

// The sine of the angle to the normal is uniform. The speed is not rounded before it is multiplied:
// that of a particle alone would be rounded in the same direction again and again.
template <typename Scalar>
void SurfaceSet<Scalar>::scatter(Body& body, const Barrier& barrier, std::int64_t hit,
                                 const Vector& from) {
    using std::fma;
    using std::sqrt;
    Random random = random_of_hit(barrier.surface, hit);
    Vector normal;
    if (barrier.kind == Barrier::Kind::circle) {  // a corner: the normal points away from it
        const Scalar distance = sqrt(Scalar(dot(from, from)));
        normal = {from[0] / distance, from[1] / distance};
    } else {
        const double side = barrier.side_of(dot(barrier.normal, from));
        for (std::size_t k = 0; k < 2; ++k)
            normal[k] = as_precise_as(from[k], side * barrier.normal[k]);
    }
    const Unrounded<Scalar> square = unrounded_product(body.v, body.v);
    const Scalar root = sqrt(square.value);
    const Unrounded<Scalar> speed{root,
                                  (fma(-root, root, square.value) + square.error) / (2.0 * root)};
    const Scalar sine = as_precise_as(root, 2.0 * random.uniform() - 1.0);
    const Scalar cosine = sqrt(Scalar((1.0 - sine) * (1.0 + sine)));
    body.v = {product_of<Scalar>(cosine * normal[0] - sine * normal[1], speed),
              product_of<Scalar>(cosine * normal[1] + sine * normal[0], speed)};
}

template <typename Scalar>
void SurfaceSet<Scalar>::reflect(Body& body, const Barrier& barrier, const BarrierMotion<Scalar>& m,
                                 const Scalar& now) {
    const Vector normal = barrier.kind == Barrier::Kind::line
                              ? Vector{as_precise_as(m.x[0], barrier.normal[0]),
                                       as_precise_as(m.x[0], barrier.normal[1])}
                              : m.x;
    const auto* mover = this->mover_of(barrier);
    const double other = mover != nullptr ? mover->inverse_mass : 0.0;
    const auto change = ContactRule::reflection<Scalar>(dot(m.v, normal), dot(normal, normal),
                                                        as_precise_as(m.x[0], body.inverse_mass),
                                                        as_precise_as(m.x[0], other));
    for (std::size_t k = 0; k < 2; ++k) body.v[k] += change.of_particle * normal[k];
    if (!(other > 0.0)) return;
    Mover<Scalar>& hit = at(movers_, barrier.surface);
    hit.advance(now);
    hit.velocity += change.of_surface * normal[hit.axis];
    ++hit.changes;
}

// The side of a line that a body which reaches it comes from, 1 or -1. That of a point follows from
// its velocity, because its distance from the line is lost in round-off.
template <typename Scalar>
double SurfaceSet<Scalar>::side_of_origin(const Body& body, const Barrier& line,
                                          const BarrierMotion<Scalar>& m) const {
    if (line.is_wall || !is_point(body)) return line.side_of(dot(line.normal, m.x));
    return dot(line.normal, m.v) < 0.0 ? 1.0 : -1.0;
}

// Puts a point that touches a line clear of it on one side. Walls act from one side only: a point
// may lie exactly on them, but not beyond. Returns whether it was moved.
template <typename Scalar>
bool SurfaceSet<Scalar>::put_on_side(Body& body, const Barrier& line, double side,
                                     const BarrierMotion<Scalar>& m) const {
    if (!is_point(body)) return false;
    const double least = line.is_wall ? 0.0 : std::max(body.radius, clearance_);
    const double distance = side * static_cast<double>(dot(line.normal, m.x));
    if (distance >= 0.5 * least) return false;
    for (std::size_t k = 0; k < 2; ++k)
        body.x[k] += Scalar(side * (least - distance) * line.normal[k]);
    return true;
}

template <typename Scalar>
bool SurfaceSet<Scalar>::hit(Body& body, std::int32_t k, const Scalar& now) {
    const Barrier& barrier = this->barrier(k);
    const Behaviour& behaviour = at(behaviours_, barrier.surface);
    const bool is_line = barrier.kind == Barrier::Kind::line;
    BarrierMotion<Scalar> m = motion_of(body, barrier, now);
    const double side = is_line ? side_of_origin(body, barrier, m) : 1.0;
    if (is_line && put_on_side(body, barrier, side, m)) m = motion_of(body, barrier, now);
    const Scalar approach = is_line ? Scalar(side * dot(barrier.normal, m.v)) : dot(m.x, m.v);
    if (!(approach < 0.0)) return false;
    if (const auto* membrane = membrane_of(behaviour)) {
        const auto& speeds =
            body.v[at(movers_, barrier.surface).axis] > 0.0 ? membrane->upward : membrane->downward;
        if (speeds.admits(std::sqrt(square_of(body.v)))) {
            body.passing |= bit_of(barrier.surface);
            if (is_line) put_on_side(body, barrier, -side, m);
            return false;
        }
    }
    const Vector before = body.v;
    const std::int64_t number = ++at(totals_, barrier.surface).hits;
    const auto reflect_it = [&] { reflect(body, barrier, m, now); };
    std::visit(
        Overloaded{[&](const Reflecting&) { reflect_it(); },
                   [&](const Bath& bath) {
                       body.inverse_mass > 0.0
                           ? leave_bath(body, barrier, bath.temperature, number, m.x)
                           : reflect_it();
                   },
                   [&](const Driven&) { reflect_it(); }, [&](const Piston&) { reflect_it(); },
                   [&](const Membrane&) { reflect_it(); },
                   [&](const Diffuse&) { scatter(body, barrier, number, m.x); }},
        behaviour);
    body.passing &= ~bit_of(barrier.surface);
    path_has_changed(body);
    if (body.inverse_mass > 0.0) account_for_hit(body, before, barrier);
    return true;
}

template <typename Scalar>
auto SurfaceSet<Scalar>::touch(const Body& body, std::int32_t k, const Scalar& now) const
    -> std::optional<Touch> {
    using std::sqrt;
    const Barrier& barrier = this->barrier(k);
    const Behaviour& behaviour = at(behaviours_, barrier.surface);
    if (!this->is_there(barrier) || this->lets_pass(barrier, body.species) ||
        is_random(behaviour) || (body.passing & bit_of(barrier.surface)) != 0)
        return std::nullopt;
    const BarrierMotion<Scalar> m = motion_of(body, barrier, now);
    if (const auto* membrane = membrane_of(behaviour)) {
        const auto& speeds = velocity_at(body, at(movers_, barrier.surface).axis, now) > 0.0
                                 ? membrane->upward
                                 : membrane->downward;
        const Vector v{velocity_at(body, 0, now), velocity_at(body, 1, now)};
        if (speeds.admits(std::sqrt(square_of(v)))) return std::nullopt;
    }
    if (barrier.kind == Barrier::Kind::line) {
        const Scalar share = m.x[0] * barrier.normal[1] - m.x[1] * barrier.normal[0];
        if (!barrier.is_endless() && !(share >= 0.0 && share <= barrier.length))
            return std::nullopt;
        const double side = side_of_origin(body, barrier, m);
        return Touch{side * dot(barrier.normal, m.x) - m.radius,
                     {as_precise_as(m.x[0], -side * barrier.normal[0]),
                      as_precise_as(m.x[0], -side * barrier.normal[1])}};
    }
    const Scalar distance = sqrt(Scalar(m.x[0] * m.x[0] + m.x[1] * m.x[1]));
    if (!(distance > 0.0)) return std::nullopt;
    const Scalar gap = distance - (as_precise_as(m.x[0], barrier.radius) + m.radius);
    return Touch{gap, {-(m.x[0] / distance), -(m.x[1] / distance)}};
}

template <typename Scalar>
void SurfaceSet<Scalar>::count_hit(Body& body, std::int32_t k, const Vector& normal,
                                   const Vector& before, const Scalar& now) {
    const Barrier& barrier = this->barrier(k);
    if (barrier.kind == Barrier::Kind::line)
        put_on_side(body, barrier, dot(barrier.normal, normal) < 0.0 ? 1.0 : -1.0,
                    motion_of(body, barrier, now));
    ++at(totals_, barrier.surface).hits;
    body.passing &= ~bit_of(barrier.surface);
    if (body.inverse_mass > 0.0) account_for_hit(body, before, barrier);
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
    const auto count_heat = [&] {
        totals.heat += gain;
        most_work_ += most_times_energy * std::abs(gain);
    };
    const auto count_work = [&] {  // of one that moves or has moved
        const auto* mover = this->mover_of(barrier);
        if (mover == nullptr) return;
        totals.work += gain;
        if (mover->inverse_mass == 0.0) driven_work_ += gain;
    };
    std::visit(
        Overloaded{[&](const Reflecting&) { count_work(); }, [&](const Bath&) { count_heat(); },
                   [&](const Driven&) { count_work(); }, [&](const Piston&) { count_work(); },
                   [&](const Membrane&) { count_work(); }, [&](const Diffuse&) { count_work(); }},
        at(behaviours_, barrier.surface));
    if (totals.work > most_work_) throw crushes(barrier.surface);
}

template <typename Scalar>
std::optional<std::int32_t> SurfaceSet<Scalar>::hardest_worker() const {
    const auto begin = totals_.begin(), end = begin + std::ssize(movers_);
    const auto most = std::ranges::max_element(begin, end, {}, &SurfaceTotals::work);
    if (most == end || !(most->work > 0.0)) return std::nullopt;
    return static_cast<std::int32_t>(most - begin);
}

template <typename Scalar>
void SurfaceSet<Scalar>::enter(const LargeVector<Body>& bodies, const Scalar& now) {
    this->register_all(now);
    most_work_ = most_times_energy * energy_of(bodies);
    for (const SurfaceTotals& totals : totals_) most_work_ += std::max(0.0, totals.work);
}

// An upper limit of the energy that the gas could have apart from the effects of driven walls and
// baths: the kinetic energies, those of disks as fast as the fastest mover, and what a fall through
// the box adds.
template <typename Scalar>
double SurfaceSet<Scalar>::energy_of(const LargeVector<Body>& bodies) const {
    double fall = 0.0, energy = 0.0, fastest = 0.0;
    for (int axis = 0; axis < box_.dimension; ++axis)
        fall += std::abs(box_.surfaces.gravity[axis]) * box_.size[axis];
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
            energy += (square_of(body.v) + fastest * fastest + fall) / body.inverse_mass;
    return energy;
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

#include "physics/surfaces/surface_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "physics/collision/contact_rule.h"
#include "physics/surfaces/leaving.h"
#include "physics/surfaces/surface_error.h"
#include "util/overloaded.h"
#include "util/random.h"

namespace carom {
namespace {

// Work above this multiple of the energy that the box has without it is done only by a driven wall
// that crushes the gas (in a plane the volume falls as the energy rises), which would hit particles
// ever faster without end.
constexpr double most_times_energy = 1e5;

// Where numbers with very many bits have units in the last place that no double can hold.
constexpr double least_clearance = 1e-290;

template <typename Scalar, std::size_t Count>
double square_of(const std::array<Scalar, Count>& v) {
    double square = 0.0;
    for (const Scalar& along : v) square += static_cast<double>(along) * static_cast<double>(along);
    return square;
}

// The bit of a surface in FallingBody::passing.
std::uint64_t bit_of(std::int32_t surface) { return std::uint64_t{1} << (surface % 64); }

}  // namespace

template <typename Scalar, int Dimension>
SurfaceSet<Scalar, Dimension>::SurfaceSet(const Box& box, double reach, const Lengths& registered,
                                          int bits)
    : Base(box, reach, registered),
      bits_(bits),
      clearance_(std::max(std::ldexp(8.0 * box.longest_side(), -bits), least_clearance)),
      size_of_box_(box.longest_side()),
      totals_(behaviours_.size()),
      has_gravity_(box.surfaces.has_gravity()) {
    for (std::size_t k = 0; k < barriers_.size(); ++k)
        if (barriers_[k].is_endless()) floors_.push_back(static_cast<std::int32_t>(k));
}

// The motion of a body relative to a barrier.
template <typename Scalar, int Dimension>
auto SurfaceSet<Scalar, Dimension>::motion_of(const Body& body, const Barrier& barrier,
                                              const Scalar& now) const -> Motion {
    Motion m{.x = {}, .v = {}, .a = body.a, .radius = body.radius};
    const Vector place = this->place_of(barrier, now);
    for (std::size_t k = 0; k < axes; ++k) {
        m.x[k] = position_at(body, k, now) - place[k];
        m.v[k] = velocity_at(body, k, now);
    }
    if (const auto* mover = this->mover_of(barrier)) {
        m.v[mover->axis] -= mover->velocity_at(now);
        m.a[mover->axis] -= mover->acceleration;
    }
    return m;
}

template <typename Scalar, int Dimension>
bool SurfaceSet<Scalar, Dimension>::may_touch(const BodyView<Dimension>& view, double radius,
                                              std::int32_t k, const Scalar& now,
                                              double within) const {
    const Barrier& barrier = this->barrier(k);
    BarrierMotion<double, Dimension> m{.x = view.x, .v = view.v, .a = view.a, .radius = radius};
    Lengths place = barrier.place;
    if (const auto* mover = this->mover_of(barrier)) {
        place[mover->axis] = static_cast<double>(mover->place_at(now));
        m.v[mover->axis] -= static_cast<double>(mover->velocity_at(now));
        m.a[mover->axis] -= static_cast<double>(mover->acceleration);
    }
    for (std::size_t a = 0; a < axes; ++a) m.x[a] -= place[a];
    return may_touch_within(barrier, m, within, size_of_box_);
}

template <typename Scalar, int Dimension>
Scalar SurfaceSet<Scalar, Dimension>::time_to(const Body& body, std::int32_t k,
                                              const Scalar& now) const {
    const Barrier& barrier = this->barrier(k);
    Motion m = motion_of(body, barrier, now);
    const bool is_flat = barrier.kind == Kind::flat;
    // A point that a line or a face has let in is beyond it at once.
    const bool is_let_in =
        (body.passing & bit_of(barrier.surface)) != 0 && !(is_flat && is_point(body));
    // At a corner or an edge, where two lines or faces meet, round-off might let a point through.
    if (!is_flat && barrier.radius == 0.0) m.radius = std::max(m.radius, clearance_);
    return time_to_barrier(barrier, m, is_let_in ? m.radius + slack_ : 0.0, bits_);
}

// The shortest vector to a place from an edge, or from the center of a circle or a sphere.
template <typename Scalar, int Dimension>
auto SurfaceSet<Scalar, Dimension>::separation_from(const Barrier& barrier, const Vector& x)
    -> Vector {
    Vector separation = x;
    if (barrier.kind == Kind::edge) separation[barrier.axis] = as_precise_as(x[0], 0.0);
    return separation;
}

template <typename Scalar, int Dimension>
auto SurfaceSet<Scalar, Dimension>::contact_point(const Body& body, const Barrier& barrier,
                                                  const Scalar& now) const -> Vector {
    const Motion m = motion_of(body, barrier, now);
    Vector point = body.x;
    if (barrier.kind == Kind::flat) {
        const Scalar share = barrier.across(m.x);
        for (std::size_t k = 0; k < axes; ++k) point[k] -= share * barrier.normal[k];
    } else {
        const Vector from = separation_from(barrier, m.x);
        const double share = 1.0 - barrier.radius / std::sqrt(square_of(from));
        for (std::size_t k = 0; k < axes; ++k) point[k] -= share * from[k];
    }
    return point;
}

template <typename Scalar, int Dimension>
std::optional<std::int32_t> SurfaceSet<Scalar, Dimension>::overlapped(
    const Body& body, const Scalar& now, std::optional<std::int32_t> only) const {
    std::vector<Barrier> present;
    for (const Barrier& barrier : barriers_) {
        if (only ? barrier.surface != *only : !this->is_there(barrier)) continue;
        if (this->lets_pass(barrier, body.species)) continue;
        present.push_back(barrier);
        const Vector place = this->place_of(barrier, now);
        for (std::size_t a = 0; a < axes; ++a)
            present.back().place[a] = static_cast<double>(place[a]);
    }
    Vec center;
    for (std::size_t a = 0; a < axes; ++a)
        center[a] = static_cast<double>(position_at(body, a, now));
    return surface_in_the_way(box_, present, center, body.radius);
}

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::settle_at_rest(Body& body) {
    if (!has_gravity_) return;
    const Vec& gravity = box_.surfaces.gravity;
    if (std::exchange(body.is_at_rest, false)) --at_rest_;
    for (std::size_t a = 0; a < axes; ++a) body.a[a] = as_precise_as(body.x[0], gravity[a]);
    if (!stands_along_an_axis(body)) return;  // floors are perpendicular to an axis
    const double slack = slack_of_places(box_);
    for (const std::int32_t k : floors_) {
        const Barrier& wall = this->barrier(k);
        if (this->is_mobile(wall) || !this->is_there(wall) || wall.across(body.v) != 0.0) continue;
        double distance = 0.0, pull = 0.0;
        for (std::size_t a = 0; a < axes; ++a) {
            distance += wall.normal[a] * static_cast<double>(body.x[a] - wall.place[a]);
            pull += wall.normal[a] * static_cast<double>(body.a[a]);
        }
        const double side = wall.side_of(distance);
        if (side * distance > body.radius + slack || !(side * pull < 0.0)) continue;
        for (std::size_t a = 0; a < axes; ++a) body.a[a] -= Scalar(pull * wall.normal[a]);
        if (!std::exchange(body.is_at_rest, true)) ++at_rest_;
    }
}

// Numbers that depend on the seed and on this hit only, so that a run is the same everywhere.
template <typename Scalar, int Dimension>
Random SurfaceSet<Scalar, Dimension>::random_of_hit(std::int32_t surface, std::int64_t hit) const {
    return {box_.surfaces.seed, fmt::format("hit {} of surface {}", hit, surface)};
}

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::leave_bath(Body& body, const Barrier& barrier,
                                               double temperature, std::int64_t hit,
                                               const Vector& from) {
    Random random = random_of_hit(barrier.surface, hit);
    const double thermal = std::sqrt(temperature * body.inverse_mass);
    Lengths normal = barrier.normal;
    double side = barrier.side_of(barrier.across(from));
    if (barrier.kind != Kind::flat) {  // a corner or an edge: the normal points away from it
        const Vector separation = separation_from(barrier, from);
        const double distance = std::sqrt(square_of(separation));
        for (std::size_t k = 0; k < axes; ++k)
            normal[k] = static_cast<double>(separation[k]) / distance;
        side = 1.0;
    }
    const Lengths v = velocity_from_bath(random, thermal, side, normal, box_.dimension > 1);
    for (std::size_t k = 0; k < axes; ++k) body.v[k] = as_precise_as(body.x[0], v[k]);
}

// The speed is not rounded before it is multiplied: that of a particle alone would be rounded in
// the same direction again and again.
template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::scatter(Body& body, const Barrier& barrier, std::int64_t hit,
                                            const Vector& from) {
    using std::fma;
    using std::sqrt;
    Random random = random_of_hit(barrier.surface, hit);
    Vector normal = separation_from(barrier, from);
    if (barrier.kind == Kind::flat) {
        const double side = barrier.side_of(barrier.across(from));
        for (std::size_t k = 0; k < axes; ++k)
            normal[k] = as_precise_as(from[k], side * barrier.normal[k]);
    } else {  // a corner or an edge: the normal points away from it
        const Scalar distance = sqrt(scalar_product(normal, normal));
        for (std::size_t k = 0; k < axes; ++k) normal[k] = normal[k] / distance;
    }
    const Unrounded<Scalar> square = unrounded_product(body.v, body.v);
    const Scalar root = sqrt(square.value);
    const Unrounded<Scalar> speed{root,
                                  (fma(-root, root, square.value) + square.error) / (2.0 * root)};
    const Vector direction = direction_by_cosine_law(random, normal);
    for (std::size_t k = 0; k < axes; ++k) body.v[k] = product_of(direction[k], speed);
}

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::reflect(Body& body, const Barrier& barrier, const Motion& m,
                                            const Scalar& now) {
    Vector normal = separation_from(barrier, m.x);
    if (barrier.kind == Kind::flat)
        for (std::size_t k = 0; k < axes; ++k) normal[k] = as_precise_as(m.x[0], barrier.normal[k]);
    const auto* mover = this->mover_of(barrier);
    const double other = mover != nullptr ? mover->inverse_mass : 0.0;
    const auto change = ContactRule::reflection<Scalar>(
        scalar_product(m.v, normal), scalar_product(normal, normal),
        as_precise_as(m.x[0], body.inverse_mass), as_precise_as(m.x[0], other));
    for (std::size_t k = 0; k < axes; ++k) body.v[k] += change.of_particle * normal[k];
    if (!(other > 0.0)) return;
    Mover<Scalar>& hit = at(movers_, barrier.surface);
    hit.advance(now);
    hit.velocity += change.of_surface * normal[hit.axis];
    ++hit.changes;
}

// The side of a line or a face that a body which reaches it comes from, 1 or -1. That of a point
// follows from its velocity, because its distance from the line is lost in round-off.
template <typename Scalar, int Dimension>
double SurfaceSet<Scalar, Dimension>::side_of_origin(const Body& body, const Barrier& flat,
                                                     const Motion& m) const {
    if (flat.is_wall || !is_point(body)) return flat.side_of(flat.across(m.x));
    return flat.across(m.v) < 0.0 ? 1.0 : -1.0;
}

// Puts a point that touches a line or a face clear of it on one side. Walls act from one side only:
// a point may lie exactly on them, but not beyond. Returns whether it was moved.
template <typename Scalar, int Dimension>
bool SurfaceSet<Scalar, Dimension>::put_on_side(Body& body, const Barrier& flat, double side,
                                                const Motion& m) const {
    if (!is_point(body)) return false;
    const double least = flat.is_wall ? 0.0 : std::max(body.radius, clearance_);
    const double distance = side * static_cast<double>(flat.across(m.x));
    if (distance >= 0.5 * least) return false;
    for (std::size_t k = 0; k < axes; ++k)
        body.x[k] += Scalar(side * (least - distance) * flat.normal[k]);
    return true;
}

template <typename Scalar, int Dimension>
bool SurfaceSet<Scalar, Dimension>::hit(Body& body, std::int32_t k, const Scalar& now) {
    const Barrier& barrier = this->barrier(k);
    const Behaviour& behaviour = at(behaviours_, barrier.surface);
    const bool is_flat = barrier.kind == Kind::flat;
    Motion m = motion_of(body, barrier, now);
    const double side = is_flat ? side_of_origin(body, barrier, m) : 1.0;
    if (is_flat && put_on_side(body, barrier, side, m)) m = motion_of(body, barrier, now);
    const Scalar approach = is_flat ? Scalar(side * barrier.across(m.v))
                                    : scalar_product(separation_from(barrier, m.x), m.v);
    if (!(approach < 0.0)) return false;
    if (const auto* membrane = membrane_of(behaviour)) {
        const auto& speeds =
            body.v[at(movers_, barrier.surface).axis] > 0.0 ? membrane->upward : membrane->downward;
        if (speeds.admits(std::sqrt(square_of(body.v)))) {
            body.passing |= bit_of(barrier.surface);
            if (is_flat) put_on_side(body, barrier, -side, m);
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

template <typename Scalar, int Dimension>
auto SurfaceSet<Scalar, Dimension>::touch(const Body& body, std::int32_t k, const Scalar& now) const
    -> std::optional<Touch> {
    using std::sqrt;
    const Barrier& barrier = this->barrier(k);
    const Behaviour& behaviour = at(behaviours_, barrier.surface);
    if (!this->is_there(barrier) || this->lets_pass(barrier, body.species) ||
        is_random(behaviour) || (body.passing & bit_of(barrier.surface)) != 0)
        return std::nullopt;
    const Motion m = motion_of(body, barrier, now);
    if (const auto* membrane = membrane_of(behaviour)) {
        const auto& speeds = velocity_at(body, at(movers_, barrier.surface).axis, now) > 0.0
                                 ? membrane->upward
                                 : membrane->downward;
        Vector v;
        for (std::size_t a = 0; a < axes; ++a) v[a] = velocity_at(body, a, now);
        if (speeds.admits(std::sqrt(square_of(v)))) return std::nullopt;
    }
    if (!barrier.extends_to(m.x)) return std::nullopt;
    Touch touch;
    if (barrier.kind == Kind::flat) {
        const double side = side_of_origin(body, barrier, m);
        touch.gap = side * barrier.across(m.x) - m.radius;
        for (std::size_t a = 0; a < axes; ++a)
            touch.normal[a] = as_precise_as(m.x[0], -side * barrier.normal[a]);
        return touch;
    }
    const Vector from = separation_from(barrier, m.x);
    const Scalar distance = sqrt(scalar_product(from, from));
    if (!(distance > 0.0)) return std::nullopt;
    touch.gap = distance - (as_precise_as(m.x[0], barrier.radius) + m.radius);
    for (std::size_t a = 0; a < axes; ++a) touch.normal[a] = -(from[a] / distance);
    return touch;
}

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::count_hit(Body& body, std::int32_t k, const Vector& normal,
                                              const Vector& before, const Scalar& now) {
    const Barrier& barrier = this->barrier(k);
    if (barrier.kind == Kind::flat)
        put_on_side(body, barrier, barrier.across(normal) < 0.0 ? 1.0 : -1.0,
                    motion_of(body, barrier, now));
    ++at(totals_, barrier.surface).hits;
    body.passing &= ~bit_of(barrier.surface);
    if (body.inverse_mass > 0.0) account_for_hit(body, before, barrier);
}

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::account_for_hit(const Body& body, const Vector& before,
                                                    const Barrier& barrier) {
    SurfaceTotals& totals = at(totals_, barrier.surface);
    const double mass = 1.0 / body.inverse_mass;
    for (std::size_t a = 0; a < axes; ++a)
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

template <typename Scalar, int Dimension>
std::optional<std::int32_t> SurfaceSet<Scalar, Dimension>::hardest_worker() const {
    const auto begin = totals_.begin(), end = begin + std::ssize(movers_);
    const auto most = std::ranges::max_element(begin, end, {}, &SurfaceTotals::work);
    if (most == end || !(most->work > 0.0)) return std::nullopt;
    return static_cast<std::int32_t>(most - begin);
}

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::enter(const LargeVector<Body>& bodies, const Scalar& now) {
    this->register_all(now);
    most_work_ = most_times_energy * energy_of(bodies);
    for (const SurfaceTotals& totals : totals_) most_work_ += std::max(0.0, totals.work);
}

// An upper limit of the energy that the gas could have apart from the effects of driven walls and
// baths: the kinetic energies, those of particles as fast as the fastest mover, and what a fall
// through the box adds.
template <typename Scalar, int Dimension>
double SurfaceSet<Scalar, Dimension>::energy_of(const LargeVector<Body>& bodies) const {
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

template <typename Scalar, int Dimension>
std::vector<SurfaceState> SurfaceSet<Scalar, Dimension>::states(const Scalar& now) const {
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

template <typename Scalar, int Dimension>
void SurfaceSet<Scalar, Dimension>::forget() {
    totals_.assign(totals_.size(), {});
    driven_work_ = 0.0;
}

template class SurfaceSet<double, 2>;
template class SurfaceSet<double, 3>;
template class SurfaceSet<Real, 2>;
template class SurfaceSet<Real, 3>;

}  // namespace carom

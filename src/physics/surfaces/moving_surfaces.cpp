#include "physics/surfaces/moving_surfaces.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "physics/collision/loop_types.h"
#include "physics/surfaces/surface_error.h"

namespace carom {
namespace {

// The largest distance, in units of the box, that counts as round-off.
constexpr double round_off_of_places = 1e-13;

// The end of a barrier along an axis that a mover coming from `place` meets; infinite if `place`
// lies within the barrier.
template <int Dimension>
double end_towards(const Barrier<Dimension>& barrier, std::size_t axis, double place) {
    const double low = barrier.low(axis), high = barrier.high(axis);
    return place <= low ? low : place >= high ? high : never<double>;
}

}  // namespace

template <typename Scalar, int Dimension>
MovingSurfaces<Scalar, Dimension>::MovingSurfaces(const Box& box, double reach,
                                                  const Lengths& registered)
    : box_(box),
      slack_(round_off_of_places * box.longest_side()),
      behaviours_(behaviours_of(box)),
      is_open_(behaviours_.size()),
      is_held_(behaviours_.size()),
      barriers_(barriers_of<Dimension>(box, reach, true)),
      movers_(static_cast<std::size_t>(box.surfaces.first_obstacle())),
      registered_(registered) {
    const Surfaces& surfaces = box.surfaces;
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        Mover<Scalar>& mover = movers_[k];
        const Partition* line = surfaces.partition(k);
        mover.axis = static_cast<std::size_t>(surfaces.axis_of(k));
        mover.place = box.place_of(k);
        is_open_[k] = line != nullptr && line->is_open;
        set_motion(k, velocity_from(behaviours_[k], 0.0));
        mover.changes = 0;
    }
}

template <typename Scalar, int Dimension>
const Mover<Scalar>* MovingSurfaces<Scalar, Dimension>::mover_of(const Barrier& barrier) const {
    if (static_cast<std::size_t>(barrier.surface) >= movers_.size()) return nullptr;
    const Mover<Scalar>& mover = at(movers_, barrier.surface);
    return mover.is_mobile ? &mover : nullptr;
}

template <typename Scalar, int Dimension>
bool MovingSurfaces<Scalar, Dimension>::is_there(const Barrier& barrier) const {
    return !is_open_[static_cast<std::size_t>(barrier.surface)];
}

template <typename Scalar, int Dimension>
bool MovingSurfaces<Scalar, Dimension>::lets_pass(const Barrier& barrier,
                                                  std::int32_t species) const {
    const auto* membrane = membrane_of(at(behaviours_, barrier.surface));
    return membrane != nullptr &&
           std::ranges::find(membrane->species, species) != membrane->species.end();
}

template <typename Scalar, int Dimension>
std::uint32_t MovingSurfaces<Scalar, Dimension>::changes_of(const Barrier& barrier) const {
    const auto* mover = mover_of(barrier);
    return mover != nullptr ? mover->changes & most_collisions : 0;
}

template <typename Scalar, int Dimension>
auto MovingSurfaces<Scalar, Dimension>::place_of(const Barrier& barrier, const Scalar& now) const
    -> Vector {
    Vector place{};
    for (std::size_t a = 0; a < axes; ++a) place[a] = barrier.place[a];
    if (const auto* mover = mover_of(barrier)) place[mover->axis] = mover->place_at(now);
    return place;
}

template <typename Scalar, int Dimension>
auto MovingSurfaces<Scalar, Dimension>::velocity_of(const Barrier& barrier, const Scalar& now) const
    -> Vector {
    Vector velocity{};
    if (const auto* mover = mover_of(barrier)) velocity[mover->axis] = mover->velocity_at(now);
    return velocity;
}

template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::register_mover(Mover<Scalar>& mover) const {
    mover.low = mover.place - registered_[mover.axis];
    mover.high = mover.place + registered_[mover.axis];
}

// The time at which a mover reaches the next barrier at rest or another mover. `other` becomes -1 -
// the number of the barrier, or the number of the other mover.
template <typename Scalar, int Dimension>
Scalar MovingSurfaces<Scalar, Dimension>::next_obstacle(const Mover<Scalar>& mover,
                                                        std::int32_t& other) const {
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
        // It slides along partitions perpendicular to itself.
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
        const Scalar& both = std::max(mover.time, one.time);  // both are known from then on
        consider(both, mover.place_at(both) - one.place_at(both),
                 mover.velocity_at(both) - one.velocity_at(both),
                 mover.acceleration - one.acceleration, static_cast<std::int32_t>(k));
    }
    return first;
}

template <typename Scalar, int Dimension>
Scalar MovingSurfaces<Scalar, Dimension>::mover_event(std::size_t k) const {
    const Mover<Scalar>& mover = movers_[k];
    if (!mover.is_mobile || is_open_[k]) return never<double>;
    std::int32_t other = 0;
    return std::min(mover.registered_until(), next_obstacle(mover, other));
}

// Moves it by no more than round-off without changing its energy; otherwise the error would grow
// with each bounce.
template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::move_exactly_to(Mover<Scalar>& mover, const Scalar& place) {
    using std::sqrt;
    if (mover.acceleration != 0.0) {
        const Scalar square =
            mover.velocity * mover.velocity + 2.0 * mover.acceleration * (place - mover.place);
        if (square > 0.0)
            mover.velocity = mover.velocity < 0.0 ? Scalar(-sqrt(square)) : sqrt(square);
    }
    mover.place = place;
}

// Elastic collision with a barrier or with another mover.
template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::bounce_off(Mover<Scalar>& mover, std::int32_t other,
                                                   const Scalar& now) {
    ++mover.changes;
    if (other < 0) {  // placed exactly there: slightly beyond, it would not be met again
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
    ++partner.changes;
    const bool mover_is_driven = mover.inverse_mass == 0.0;
    if (!mover_is_driven && partner.inverse_mass > 0.0) return;
    const double after = energy(mover) + energy(partner);
    driven_work_ += after - before;
    // Between a driven surface and an obstacle at rest a piston would be hit ever faster without
    // end.
    if (after > most_work_)
        throw crushes(mover_is_driven ? static_cast<std::int32_t>(&mover - movers_.data()) : other,
                      "a piston");
}

template <typename Scalar, int Dimension>
std::optional<std::size_t> MovingSurfaces<Scalar, Dimension>::process_mover(std::size_t k,
                                                                            const Scalar& now) {
    Mover<Scalar>& mover = movers_[k];
    std::int32_t other = 0;
    // The time has been rounded again since the prediction. Slightly beyond the surface that it
    // reaches, the mover would no longer meet it, so a small tolerance is needed.
    const Scalar wait = next_obstacle(mover, other) - now;
    mover.advance(now);
    double speed = std::abs(static_cast<double>(mover.velocity));
    double pull = std::abs(static_cast<double>(mover.acceleration));  // it may just be turning back
    if (other >= 0) {
        speed += std::abs(static_cast<double>(at(movers_, other).velocity_at(now)));
        pull += std::abs(static_cast<double>(at(movers_, other).acceleration));
    }
    const auto left = static_cast<double>(wait);
    const bool has_reached = left < never<double> && !(left * (speed + 0.5 * left * pull) > slack_);
    register_mover(mover);
    if (!has_reached) return std::nullopt;
    const bool is_driven = mover.inverse_mass == 0.0;
    if (is_driven && (other < 0 || at(movers_, other).inverse_mass == 0.0))
        throw SurfaceError(static_cast<std::int32_t>(k), "reaches another surface", "",
                           how_to_stop);
    bounce_off(mover, other, now);
    if (other < 0) return std::nullopt;
    return static_cast<std::size_t>(other);
}

template <typename Scalar, int Dimension>
SurfaceControl<Scalar> MovingSurfaces<Scalar, Dimension>::control(std::int32_t surface,
                                                                  const Scalar& now) const {
    const auto k = static_cast<std::size_t>(surface);
    SurfaceControl<Scalar> control{behaviours_[k], is_open_[k], is_held_[k], Scalar(0.0)};
    if (k < movers_.size()) control.velocity = movers_[k].velocity_at(now);
    return control;
}

template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::set_control(std::int32_t surface,
                                                    const SurfaceControl<Scalar>& control,
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

// Kinetic energy, and potential energy in the constant forces on the piston.
template <typename Scalar, int Dimension>
double MovingSurfaces<Scalar, Dimension>::energy_of_piston(std::size_t k) const {
    const auto* piston = piston_of(behaviours_[k]);
    if (piston == nullptr) return 0.0;
    const Mover<Scalar>& mover = movers_[k];
    const double pull = box_.surfaces.gravity[static_cast<Eigen::Index>(mover.axis)];
    return piston->kinetic_energy(static_cast<double>(mover.velocity)) +
           piston->potential_energy(static_cast<double>(mover.place), pull);
}

// Sets mass, acceleration and velocity according to the behaviour of the surface.
template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::set_motion(std::size_t k, const Scalar& velocity) {
    Mover<Scalar>& mover = movers_[k];
    const auto* piston = piston_of(behaviours_[k]);
    const bool is_free = piston != nullptr && !is_held_[k];
    const auto axis = static_cast<Eigen::Index>(mover.axis);
    mover.inverse_mass = is_free ? 1.0 / piston->mass : 0.0;
    mover.acceleration =
        is_free ? piston->force * mover.inverse_mass + box_.surfaces.gravity[axis] : 0.0;
    const bool stands_still = is_held_[k] || !moves(behaviours_[k]);
    mover.velocity = stands_still ? Scalar(0.0) : velocity;
    mover.is_mobile = mover.is_mobile || moves(behaviours_[k]);
    ++mover.changes;
}

template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::advance(const Scalar& now) {
    for (Mover<Scalar>& mover : movers_) mover.advance(now);
}

template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::shift_epoch(const Scalar& shift) {
    for (Mover<Scalar>& mover : movers_) mover.time -= shift;
}

template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::reverse() {
    for (Mover<Scalar>& mover : movers_) {
        mover.velocity = -mover.velocity;
        ++mover.changes;
    }
}

template <typename Scalar, int Dimension>
void MovingSurfaces<Scalar, Dimension>::register_all(const Scalar& now) {
    for (Mover<Scalar>& mover : movers_) {
        mover.advance(now);
        register_mover(mover);
    }
}

template class MovingSurfaces<double, 2>;
template class MovingSurfaces<double, 3>;
template class MovingSurfaces<Real, 2>;
template class MovingSurfaces<Real, 3>;

}  // namespace carom

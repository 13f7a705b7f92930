#include "physics/surfaces/open_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/collision/contact_rule.h"
#include "physics/collision/lanes.h"

namespace carom {
namespace {

double radius_of_largest(const Particles& particles) {
    return particles.count() > 0 ? particles.radius.maxCoeff() : 0.0;
}

template <typename Scalar>
double size_of(const Scalar& number) {
    return std::abs(static_cast<double>(number));
}

// A new grid is made if a wall is this many cells beyond the grid, or if the walls enclose less
// than this share of it, unless the cells would then grow by more than this factor, because
// barriers have no images that far away. The new grid leaves a share of its length free for walls
// that move.
constexpr double most_cells_beyond_grid = 2.0, least_share_of_grid = 0.6, free_share_of_grid = 0.1,
                 most_growth_of_cells = 2.0;

// When and through which side a disk leaves its cell. This has no physical meaning, and a cell is
// slightly wider than necessary, so doubles with their round-off are sufficient.
struct Leaving {
    double time;
    std::uint32_t side;
};

// The cell of a disk along both axes, and the disk in it. All in lanes and branchless, because the
// processor cannot predict where the disk goes.
struct InCell {
    TwoLanes low, high;        ///< the borders
    TwoMasks no_low, no_high;  ///< where there is no border
    TwoLanes x, v;
};

[[gnu::always_inline]] inline Leaving first_of(const TwoLanes& time, const TwoMasks& upwards) {
    const TwoMasks side = TwoMasks{0, 2} - upwards;
    const TwoMasks other_first = swapped(time) < time;
    return {select_bits(other_first, swapped(time), time)[0],
            static_cast<std::uint32_t>(select_bits(other_first, swapped(side), side)[0])};
}

[[gnu::always_inline]] inline Leaving leaving_straight(const InCell& in) {
    const TwoLanes zero{}, none = both(never<double>);
    const TwoMasks upwards = in.v > zero;
    const TwoLanes ahead = (select_bits(upwards, in.high, in.low) - in.x) / in.v;
    const TwoMasks stays = select_bits(upwards, in.no_high, in.no_low) | (in.v == zero);
    return first_of(select_bits(stays, none, select_bits(ahead > zero, ahead, zero)), upwards);
}

// Coordinates are mirrored if necessary so that the disk falls downwards; it may rise first, to the
// border above or to a turning point below it.
[[gnu::always_inline]] inline Leaving leaving_in_fall(const InCell& in, const TwoLanes& a) {
    const TwoLanes zero{}, none = both(never<double>);
    const TwoMasks mirrored = a > zero;
    const TwoLanes v = select_bits(mirrored, -in.v, in.v), g = abs(a);
    TwoLanes below = in.x - in.low, above = in.high - in.x;
    const TwoLanes kept = below;
    below = select_bits(mirrored, above, below);
    above = select_bits(mirrored, kept, above);
    below = select_bits(below > zero, below, zero);
    above = select_bits(above > zero, above, zero);
    const TwoMasks no_below = select_bits(mirrored, in.no_high, in.no_low);
    const TwoMasks no_above = select_bits(mirrored, in.no_low, in.no_high);
    const TwoLanes over = v * v - 2.0 * g * above;
    const TwoMasks rises = v > zero, arrives = rises & (over > zero) & ~no_above;
    const TwoLanes root = sqrt(select_bits(arrives, over, v * v + 2.0 * g * below));
    const TwoMasks returns = rises & ~arrives;
    const TwoLanes way = select_bits(returns, v + root, 2.0 * select_bits(arrives, above, below));
    const TwoLanes speed = select_bits(returns, g, select_bits(arrives, v + root, root - v));
    const TwoMasks stays = (~arrives & no_below) | ((v == zero) & (g == zero));
    const TwoLanes time = select_bits(way > zero, way / speed, zero);
    return first_of(select_bits(stays, none, time), arrives ^ mirrored);
}

// Whether two disks with the same acceleration certainly do not touch within `time`: they separate,
// miss each other or are too far apart, by margins far above the rounding errors of doubles.
bool surely_miss(const BodyView<2>& a, const BodyView<2>& b, const std::array<double, 2>& shift,
                 double sigma, double time) {
    if (a.a != b.a) return false;
    constexpr double slack = 1e-9;
    const double x = b.x[0] + shift[0] - a.x[0], y = b.x[1] + shift[1] - a.x[1];
    const double vx = b.v[0] - a.v[0], vy = b.v[1] - a.v[1];
    const double way = std::abs(vx) + std::abs(vy), far = std::abs(x) + std::abs(y);
    if (x * vx + y * vy > slack * way * far) return true;
    const double touching = sigma + slack * (sigma + std::abs(b.x[0]) + std::abs(b.x[1]) +
                                             std::abs(shift[0]) + std::abs(shift[1]));
    const double miss = x * vy - y * vx;
    if (std::abs(miss) > (touching + slack * far) * way) return true;
    const double reach = touching + way * time;
    return x * x + y * y > reach * reach;
}

}  // namespace

template class PairSearch<FallingBody<double>>;

template <typename Scalar>
OpenPlane<Scalar>::OpenPlane(const Box& box, const Particles& particles,
                             const Arithmetic& arithmetic)
    : Base(box, particles, {box.surfaces.gravity[0], box.surfaces.gravity[1]}),
      bits_(arithmetic.bits),
      screened_(arithmetic.screened),
      largest_(radius_of_largest(particles)),
      image_reach_(largest_ +
                   most_growth_of_cells * std::max(grid_.cell_size()[0], grid_.cell_size()[1])),
      gravity_{box.surfaces.gravity[0], box.surfaces.gravity[1]},
      surfaces_(box, image_reach_, {0.25 * grid_.cell_size()[0], 0.25 * grid_.cell_size()[1]},
                arithmetic.bits) {
    for (std::size_t axis = 0; axis < 2; ++axis) gridded_[axis] = {0.0, box.length(axis)};
    note_ends_of_grid();
}

// A cell next to a wall has no border there.
template <typename Scalar>
void OpenPlane<Scalar>::note_ends_of_grid() {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const bool ends = !box_.is_periodic(axis);
        first_with_end_[axis] = ends ? 0.0 : -1.0;
        last_with_end_[axis] = ends ? grid_.last_cell()[axis] : -1.0;
    }
}

// The interval between the walls, which may have moved, along each axis.
template <typename Scalar>
auto OpenPlane<Scalar>::enclosed(const Scalar& now) const -> std::array<Interval, 2> {
    std::array<Interval, 2> between;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto place = [&](std::size_t side) {
            return static_cast<double>(surfaces_.mover(2 * axis + side).place_at(now));
        };
        between[axis] = {place(0), place(1)};
    }
    return between;
}

// Disks beyond the grid are assigned to its outermost cells, which would become crowded; and so
// would all cells if they were too wide for a gas that has become denser.
template <typename Scalar>
bool OpenPlane<Scalar>::fits_grid(const Scalar& now) const {
    const std::array<Interval, 2> between = enclosed(now);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Interval &grid = gridded_[axis], &is = between[axis];
        const double beyond = most_cells_beyond_grid * grid_.cell_size()[axis];
        if (is.low < grid.low - beyond || is.high > grid.high + beyond) return false;
        if (is.length() < least_share_of_grid * grid.length()) return false;
    }
    return true;
}

template <typename Scalar>
void OpenPlane<Scalar>::fit_grid(const Scalar& now, std::size_t count) {
    gridded_ = enclosed(now);
    Box part = box_;
    std::array<double, 2> origin{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        Interval& range = gridded_[axis];
        const double free = free_share_of_grid * range.length();
        if (surfaces_.mover(2 * axis).is_mobile) range.low -= free;
        if (surfaces_.mover(2 * axis + 1).is_mobile) range.high += free;
        origin[axis] = range.low;
        part.size[static_cast<Eigen::Index>(axis)] = range.length();
    }
    const CellGrid before = grid_;
    const std::array<double, 2> origin_before = origin_;
    this->set_grid(origin, part, count);
    if (largest_ + std::max(grid_.cell_size()[0], grid_.cell_size()[1]) > image_reach_) {
        grid_ = before;
        origin_ = origin_before;
    }
    note_ends_of_grid();
}

// How far a disk in a cell may reach beyond it along an axis.
template <typename Scalar>
double OpenPlane<Scalar>::reach_of(std::size_t axis) const {
    return (largest_ + grid_.overhang()[axis]) * (1.0 + 1e-9) + 1e-9 * box_.longest_side();
}

// The column or row of cells that contains a coordinate.
template <typename Scalar>
int OpenPlane<Scalar>::cell_along(std::size_t axis, double place) const {
    return static_cast<int>(
        std::clamp(std::floor((place - origin_[axis]) / grid_.cell_size()[axis]), 0.0,
                   static_cast<double>(grid_.last_cell()[axis])));
}

// Stores the lists of barriers that a disk in each cell may touch, one cell after the other.
template <typename Scalar>
void OpenPlane<Scalar>::list_barriers() {
    const std::array cells{grid_.last_cell()[0] + 1, grid_.last_cell()[1] + 1};
    std::vector<std::vector<std::int32_t>> lists(static_cast<std::size_t>(cells[0] * cells[1]));
    moving_.clear();
    for (std::size_t k = 0; k < surfaces_.barriers().size(); ++k) {
        const Barrier& barrier = surfaces_.barriers()[k];
        if (!surfaces_.is_there(barrier)) continue;
        if (surfaces_.is_mobile(barrier)) {
            moving_.push_back(
                {.barrier = static_cast<std::int32_t>(k), .axis = surfaces_.axis_of(barrier)});
            continue;
        }
        std::array<int, 2> from{}, to{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double reach = reach_of(axis);
            from[axis] = cell_along(axis, barrier.low(axis) - reach);
            to[axis] = cell_along(axis, barrier.high(axis) + reach);
        }
        for (int row = from[1]; row <= to[1]; ++row)
            for (int column = from[0]; column <= to[0]; ++column)
                at(lists, row * cells[0] + column).push_back(static_cast<std::int32_t>(k));
    }
    listed_.clear();
    first_listed_.assign(1, 0);
    for (const auto& list : lists) {
        listed_.insert(listed_.end(), list.begin(), list.end());
        first_listed_.push_back(static_cast<std::int32_t>(listed_.size()));
    }
}

template <typename Scalar>
void OpenPlane<Scalar>::list_reach(std::size_t k) {
    const Mover<Scalar>& mover = surfaces_.mover(k);
    const double reach = reach_of(mover.axis);
    for (Moving& moving : moving_) {
        if (surfaces_.barrier(moving.barrier).surface != static_cast<std::int32_t>(k)) continue;
        moving.first = cell_along(mover.axis, static_cast<double>(mover.low) - reach);
        moving.last = cell_along(mover.axis, static_cast<double>(mover.high) + reach);
    }
}

template <typename Scalar>
void OpenPlane<Scalar>::enter(Bodies& bodies) {
    if (!bodies.empty() && !fits_grid(bodies[0].time)) fit_grid(bodies[0].time, bodies.size());
    Base::enter(bodies);
    resettle(bodies);
}

template <typename Scalar>
void OpenPlane<Scalar>::resettle(Bodies& bodies) {
    list_barriers();
    for (Body& body : bodies) surfaces_.settle_at_rest(body);
    if (!bodies.empty()) surfaces_.enter(bodies, bodies[0].time);
    for (std::size_t k = 0; k < surfaces_.mover_count(); ++k) list_reach(k);
}

template <typename Scalar>
Scalar OpenPlane<Scalar>::pair_time(const Body& a, const Body& b,
                                    const std::array<double, 2>& shift, const Scalar& now) const {
    const double sigma = a.radius + b.radius;
    if (a.inverse_mass + b.inverse_mass == 0.0 || sigma == 0.0) return never<double>;
    std::array<Scalar, 2> r, v, acceleration;
    std::array<double, 2> fast;
    for (std::size_t k = 0; k < 2; ++k) {
        const Scalar first = velocity_at(a, k, now), second = velocity_at(b, k, now);
        r[k] = position_at(b, k, now) + shift[k] - position_at(a, k, now);
        v[k] = second - first;
        fast[k] = size_of(first) + size_of(second);
        acceleration[k] = b.a[k] - a.a[k];
    }
    const double round_off = approach_error(size_of(r[0]), size_of(r[1]), fast[0], fast[1], bits_);
    return falling_contact_time<Scalar>({r[0], r[1], v[0], v[1]}, acceleration,
                                        as_precise_as(r[0], a.radius) + b.radius, round_off, bits_);
}

// Considers the barriers that a disk may touch within a time.
template <typename Scalar>
inline void OpenPlane<Scalar>::look_at_barriers(const Body& body, double radius,
                                                const BodyView<2>& view, const Scalar& now,
                                                double within, First& first) {
    const auto look = [&](std::int32_t k) {
        if (screened_ && !surfaces_.may_touch(view, radius, k, now, within)) return;
        const Barrier& barrier = surfaces_.barrier(k);
        if (surfaces_.lets_pass(barrier, body.species)) return;
        const Scalar time = now + surfaces_.time_to(body, k, now);
        notice(time, first);
        if (time < first.time) first = {time, -1 - k, surfaces_.changes_of(barrier)};
    };
    const int cell = body.cell[1] * (grid_.last_cell()[0] + 1) + body.cell[0];
    for (std::int32_t k = at(first_listed_, cell); k < at(first_listed_, cell + 1); ++k)
        look(at(listed_, k));
    for (const Moving& moving : moving_) {
        const int along = body.cell[moving.axis];
        if (moving.first <= along && along <= moving.last) look(moving.barrier);
    }
}

// Time until a body leaves its cell, and through which side. A cell next to a wall has no border
// there.
template <typename Scalar>
inline double OpenPlane<Scalar>::border_time(const Body& body, const BodyView<2>& view,
                                             std::uint32_t& side) const {
    const TwoLanes cell{static_cast<double>(body.cell[0]), static_cast<double>(body.cell[1])};
    const TwoLanes size = load_two(grid_.cell_size().data());
    const TwoLanes hang = load_two(grid_.overhang().data());
    const TwoLanes origin = load_two(origin_.data());
    const InCell in{.low = origin + size * cell - hang,
                    .high = origin + size * (cell + 1.0) + hang,
                    .no_low = cell == first_with_end_,
                    .no_high = cell == last_with_end_,
                    .x = load_two(view.x.data()),
                    .v = load_two(view.v.data())};
    const Leaving leaving = surfaces_.has_gravity() ? leaving_in_fall(in, load_two(view.a.data()))
                                                    : leaving_straight(in);
    side = first_cell_side + leaving.side;
    return leaving.time;
}

// Searches the disks of given cells; for all scalars, falling disks and disks at rest.
template <typename Scalar>
auto OpenPlane<Scalar>::search_slots(const Bodies& bodies, std::int32_t i, const Scalar& now,
                                     First& first) {
    return [this, &bodies, &now, &first, i, view = BodyView<2>(at(bodies, i), now)](
               const CellGrid<2>::Slots& slots, const std::array<double, 2>& shift) {
        const Body& body = at(bodies, i);
        std::size_t count = 0;
        grid_.append(slots, near_, count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t j = near_[k];
            if (j == i) continue;
            const Body& other = at(bodies, j);
            if (screened_ &&
                surely_miss(view, BodyView<2>(other, now), shift, body.radius + other.radius,
                            rounded_up(Scalar(first.time - now))))
                continue;
            const Scalar time = now + pair_time(body, other, shift, now);
            notice(time, first);
            if (time < first.time || (time == first.time && j < first.partner))
                first = {time, j, other.collisions & most_collisions};
        }
    };
}

// The next event: a contact, a hit of a surface, or the cell border. With doubles the body keeps a
// contact even if it may come after the border; with multiprecision it does not, because two
// different times may round to the same double.
template <typename Scalar>
inline Scalar OpenPlane<Scalar>::next_event(Body& body, double radius, const Scalar& now,
                                            First first) {
    const BodyView<2> view = view_of(body, now);
    std::uint32_t side = 0;
    Scalar border = now + border_time(body, view, side);
    const double within = rounded_up(Scalar(std::min(first.time, border) - now));
    look_at_barriers(body, radius, view, now, within, first);
    const bool is_contact = first.time <= border;
    body.prediction = {
        .contact_time = of_doubles || is_contact ? rounded_down(first.time) : never<double>,
        .partner = first.partner,
        .partner_collisions = first.partner_collisions & most_collisions,
        .border = side & most_border};
    return is_contact ? std::move(first.time) : std::move(border);
}

template <typename Scalar>
Scalar OpenPlane<Scalar>::predict(Bodies& bodies, std::int32_t i, const Scalar& now) {
    Body& body = at(bodies, i);
    const double radius = this->radius_of(i);
    if constexpr (of_doubles)
        if (all_fall())
            return next_event(body, radius, now, First(this->first_contact(bodies, i, now)));
    First first;
    grid_.for_each_near(radius, body.cell, search_slots(bodies, i, now, first));
    return next_event(body, radius, now, std::move(first));
}

template <typename Scalar>
bool OpenPlane<Scalar>::predict_both(Bodies& bodies, std::int32_t i, std::int32_t j,
                                     const Scalar& now, std::array<Scalar, 2>& when) {
    if constexpr (of_doubles) {
        std::array<FirstContact, 2> contacts;
        if (!all_fall() || !this->first_contacts(bodies, i, j, now, contacts)) return false;
        when = {next_event(at(bodies, i), this->radius_of(i), now, First(contacts[0])),
                next_event(at(bodies, j), this->radius_of(j), now, First(contacts[1]))};
        return true;
    }
    return false;
}

template <typename Scalar>
Scalar OpenPlane<Scalar>::predict_after_crossing(Bodies& bodies, std::int32_t i, int side,
                                                 const Scalar& now) {
    Body& body = at(bodies, i);
    // After crossing a periodic side a disk faces other images of the same barriers.
    if constexpr (of_doubles)
        if (all_fall() && !grid_.is_last(body.cell, side ^ 1))
            return next_event(body, this->radius_of(i), now,
                              First(this->first_contact_after_crossing(bodies, i, side, now)));
    return predict(bodies, i, now);
}

template <typename Scalar>
bool OpenPlane<Scalar>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                Contact<2>& contact) {
    Body &a = at(bodies, i), &b = at(bodies, j);
    const Properties &first = properties_[i], &second = properties_[j];
    const double sigma = first.radius + second.radius;
    RelativeMotion<Scalar> m{{0.0, 0.0}, {b.v[0] - a.v[0], b.v[1] - a.v[1]}};
    if (!this->separation_at_contact(a, b, sigma, m.r)) return false;
    const Scalar first_w = as_precise_as(m.r[0], first.inverse_mass),
                 second_w = as_precise_as(m.r[0], second.inverse_mass);
    static_assert(ContactRule::keeps_species);
    const Unrounded<Scalar> factor = ContactRule::impulse(m, first_w, second_w);
    accelerate(a, product_of(first_w, factor), m.r);
    accelerate(b, Scalar(-product_of(second_w, factor)), m.r);
    surfaces_.path_has_changed(a);
    surfaces_.path_has_changed(b);
    contact = contact_of(m, factor.value, sigma);
    return true;
}

template <typename Scalar>
void OpenPlane<Scalar>::look_for_hits(Bodies& bodies, std::size_t k, const Scalar& now,
                                      const Agenda<Scalar>& agenda) {
    list_reach(k);
    const Mover<Scalar>& mover = surfaces_.mover(k);
    for (const Moving& moving : moving_) {
        const Barrier& barrier = surfaces_.barrier(moving.barrier);
        if (barrier.surface != static_cast<std::int32_t>(k)) continue;
        const auto look_at = [&](std::int32_t i) {
            Body& body = at(bodies, i);
            if (screened_ && !surfaces_.may_touch(view_of(body, now), this->radius_of(i),
                                                  moving.barrier, now, agenda.time_left(i)))
                return;
            if (surfaces_.lets_pass(barrier, body.species)) return;
            const Scalar time = now + surfaces_.time_to(body, moving.barrier, now);
            if (!agenda.move_forward(i, time)) return;
            body.prediction.contact_time = rounded_down(time);
            body.prediction.partner = -1 - moving.barrier;
            body.prediction.partner_collisions = mover.changes & most_collisions;
        };
        grid_.for_each_in_band(mover.axis, moving.first, moving.last,
                               [&](const CellGrid<2>::Slots& slots) {
                                   std::size_t count = 0;
                                   grid_.append(slots, near_, count);
                                   for (std::size_t n = 0; n < count; ++n) look_at(near_[n]);
                               });
    }
}

template class OpenPlane<double>;
template class OpenPlane<Real>;

}  // namespace carom

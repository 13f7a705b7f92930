#include "physics/surfaces/open_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/cells/leaving_cell.h"

namespace carom {
namespace {

double radius_of_largest(const Particles& particles) {
    return particles.count() > 0 ? particles.radius.maxCoeff() : 0.0;
}

template <std::size_t Count>
std::array<double, Count> first_components(const Vec& vec) {
    std::array<double, Count> components;
    for (std::size_t a = 0; a < Count; ++a) components[a] = vec[a];
    return components;
}

template <int Dimension>
double widest_cell(const CellGrid<Dimension>& grid) {
    return *std::ranges::max_element(grid.cell_size());
}

template <int Dimension>
auto quarter_of_cell(const CellGrid<Dimension>& grid) {
    auto quarter = grid.cell_size();
    for (double& length : quarter) length *= 0.25;
    return quarter;
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

// Calls see(cell) for the cells of a block, those at two of its corners included.
template <std::size_t Count, typename See>
void for_each_cell(const std::array<std::uint16_t, Count>& from,
                   const std::array<std::uint16_t, Count>& to, const See& see) {
    auto cell = from;
    while (true) {
        see(cell);
        std::size_t axis = 0;
        for (; axis < Count && cell[axis] == to[axis]; ++axis) cell[axis] = from[axis];
        if (axis == Count) return;
        ++cell[axis];
    }
}

// Whether two bodies with the same acceleration certainly do not touch within `time`: they
// separate, miss each other or are too far apart, by margins far above the rounding errors of
// doubles.
template <int Dimension>
bool surely_miss(const BodyView<Dimension>& a, const BodyView<Dimension>& b,
                 const typename BodyView<Dimension>::Point& shift, double sigma, double time) {
    if (a.a != b.a) return false;
    constexpr double slack = 1e-9;
    RelativeMotion<double, Dimension> m;
    double way = 0.0, far = 0.0, places = sigma;
    for (std::size_t k = 0; k < Dimension; ++k) {
        m.r[k] = b.x[k] + shift[k] - a.x[k];
        m.v[k] = b.v[k] - a.v[k];
        way += std::abs(m.v[k]);
        far += std::abs(m.r[k]);
        places += std::abs(b.x[k]) + std::abs(shift[k]);
    }
    if (scalar_product(m.r, m.v) > slack * way * far) return true;
    const double touching = sigma + slack * places;
    const double miss = (touching + slack * far) * way;
    if (sum_of_squares(cross_product(m)) > miss * miss) return true;
    const double reach = touching + way * time;
    return scalar_product(m.r, m.r) > reach * reach;
}

}  // namespace

template class PairSearch<FallingBody<double, 2>>;
template class PairSearch<FallingBody<double, 3>>;

template <typename Scalar, int Dimension>
OpenSpace<Scalar, Dimension>::OpenSpace(const Box& box, const Particles& particles,
                                        const Arithmetic& arithmetic)
    : Base(box, particles, first_components<axes>(box.surfaces.gravity)),
      bits_(arithmetic.bits),
      screened_(arithmetic.screened),
      largest_(radius_of_largest(particles)),
      image_reach_(largest_ + most_growth_of_cells * widest_cell(grid_)),
      gravity_(first_components<axes>(box.surfaces.gravity)),
      surfaces_(box, image_reach_, quarter_of_cell(grid_), arithmetic.bits) {
    for (std::size_t axis = 0; axis < axes; ++axis) gridded_[axis] = {0.0, box.length(axis)};
    note_ends_of_grid();
}

// A cell next to a wall has no border there.
template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::note_ends_of_grid() {
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const bool ends = !box_.is_periodic(axis);
        first_with_end_[axis] = ends ? 0.0 : -1.0;
        last_with_end_[axis] = ends ? grid_.last_cell()[axis] : -1.0;
    }
}

// The interval between the walls, which may have moved, along each axis.
template <typename Scalar, int Dimension>
auto OpenSpace<Scalar, Dimension>::enclosed(const Scalar& now) const -> Enclosed {
    Enclosed between;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const auto place = [&](std::size_t side) {
            return static_cast<double>(surfaces_.mover(2 * axis + side).place_at(now));
        };
        between[axis] = {place(0), place(1)};
    }
    return between;
}

// Bodies beyond the grid are assigned to its outermost cells, which would become crowded; and so
// would all cells if they were too wide for a gas that has become denser.
template <typename Scalar, int Dimension>
bool OpenSpace<Scalar, Dimension>::fits_grid(const Scalar& now) const {
    const Enclosed between = enclosed(now);
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const Interval &grid = gridded_[axis], &is = between[axis];
        const double beyond = most_cells_beyond_grid * grid_.cell_size()[axis];
        if (is.low < grid.low - beyond || is.high > grid.high + beyond) return false;
        if (is.length() < least_share_of_grid * grid.length()) return false;
    }
    return true;
}

template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::fit_grid(const Scalar& now, std::size_t count) {
    gridded_ = enclosed(now);
    Box part = box_;
    Point origin{};
    for (std::size_t axis = 0; axis < axes; ++axis) {
        Interval& range = gridded_[axis];
        const double free = free_share_of_grid * range.length();
        if (surfaces_.mover(2 * axis).is_mobile) range.low -= free;
        if (surfaces_.mover(2 * axis + 1).is_mobile) range.high += free;
        origin[axis] = range.low;
        part.size[axis] = range.length();
    }
    const Grid before = grid_;
    const Point origin_before = origin_;
    this->set_grid(origin, part, count);
    if (largest_ + widest_cell(grid_) > image_reach_) {
        grid_ = before;
        origin_ = origin_before;
    }
    note_ends_of_grid();
}

// How far a body in a cell may reach beyond it along an axis.
template <typename Scalar, int Dimension>
double OpenSpace<Scalar, Dimension>::reach_of(std::size_t axis) const {
    return (largest_ + grid_.overhang()[axis]) * (1.0 + 1e-9) + 1e-9 * box_.longest_side();
}

// Stores the lists of barriers that a body in each cell may touch, one cell after the other.
template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::list_barriers() {
    std::size_t cells = 1;
    for (const int last : grid_.last_cell()) cells *= static_cast<std::size_t>(last) + 1;
    std::vector<std::vector<std::int32_t>> lists(cells);
    moving_.clear();
    for (std::size_t k = 0; k < surfaces_.barriers().size(); ++k) {
        const auto& barrier = surfaces_.barriers()[k];
        if (!surfaces_.is_there(barrier)) continue;
        if (surfaces_.is_mobile(barrier)) {
            moving_.push_back(
                {.barrier = static_cast<std::int32_t>(k), .axis = surfaces_.axis_of(barrier)});
            continue;
        }
        Cell from{}, to{};
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const double reach = reach_of(axis);
            from[axis] = cell_number(axis, barrier.low(axis) - reach);
            to[axis] = cell_number(axis, barrier.high(axis) + reach);
        }
        for_each_cell(from, to, [&](const Cell& cell) {
            at(lists, list_of(cell)).push_back(static_cast<std::int32_t>(k));
        });
    }
    listed_.clear();
    first_listed_.assign(1, 0);
    for (const auto& list : lists) {
        listed_.insert(listed_.end(), list.begin(), list.end());
        first_listed_.push_back(static_cast<std::int32_t>(listed_.size()));
    }
}

template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::list_reach(std::size_t k) {
    const Mover<Scalar>& mover = surfaces_.mover(k);
    const double reach = reach_of(mover.axis);
    for (Moving& moving : moving_) {
        if (surfaces_.barrier(moving.barrier).surface != static_cast<std::int32_t>(k)) continue;
        moving.first = cell_number(mover.axis, static_cast<double>(mover.low) - reach);
        moving.last = cell_number(mover.axis, static_cast<double>(mover.high) + reach);
    }
}

template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::enter(Bodies& bodies) {
    if (!bodies.empty() && !fits_grid(bodies[0].time)) fit_grid(bodies[0].time, bodies.size());
    Base::enter(bodies);
    resettle(bodies);
}

template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::resettle(Bodies& bodies) {
    list_barriers();
    for (Body& body : bodies) surfaces_.settle_at_rest(body);
    if (!bodies.empty()) surfaces_.enter(bodies, bodies[0].time);
    for (std::size_t k = 0; k < surfaces_.mover_count(); ++k) list_reach(k);
}

template <typename Scalar, int Dimension>
Scalar OpenSpace<Scalar, Dimension>::pair_time(const Body& a, const Body& b, const Point& shift,
                                               const Scalar& now) const {
    const double sigma = a.radius + b.radius;
    if (a.inverse_mass + b.inverse_mass == 0.0 || sigma == 0.0) return never<double>;
    RelativeMotion<Scalar, axes> m;
    std::array<Scalar, axes> acceleration;
    Point far, fast;
    for (std::size_t k = 0; k < axes; ++k) {
        const Scalar first = velocity_at(a, k, now), second = velocity_at(b, k, now);
        m.r[k] = position_at(b, k, now) + shift[k] - position_at(a, k, now);
        m.v[k] = second - first;
        far[k] = size_of(m.r[k]);
        fast[k] = size_of(first) + size_of(second);
        acceleration[k] = b.a[k] - a.a[k];
    }
    return falling_contact_time(m, acceleration, Scalar(as_precise_as(m.r[0], a.radius) + b.radius),
                                approach_error(far, fast, bits_), bits_);
}

// Considers the barriers that a body may touch within a time.
template <typename Scalar, int Dimension>
inline void OpenSpace<Scalar, Dimension>::look_at_barriers(const Body& body, double radius,
                                                           const View& view, const Scalar& now,
                                                           double within, First& first) {
    const auto look = [&](std::int32_t k) {
        if (screened_ && !surfaces_.may_touch(view, radius, k, now, within)) return;
        const auto& barrier = surfaces_.barrier(k);
        if (surfaces_.lets_pass(barrier, body.species)) return;
        const Scalar time = now + surfaces_.time_to(body, k, now);
        notice(time, first);
        if (time < first.time) first = {time, -1 - k, surfaces_.changes_of(barrier)};
    };
    const int cell = list_of(body.cell);
    for (std::int32_t k = at(first_listed_, cell); k < at(first_listed_, cell + 1); ++k)
        look(at(listed_, k));
    for (const Moving& moving : moving_) {
        const int along = body.cell[moving.axis];
        if (moving.first <= along && along <= moving.last) look(moving.barrier);
    }
}

// Time until a body leaves its cell, and through which side. A cell next to a wall has no border
// there.
template <typename Scalar, int Dimension>
inline double OpenSpace<Scalar, Dimension>::border_time(const Body& body, const View& view,
                                                        std::uint32_t& side) const {
    using Lanes = AxisLanes<Dimension>;
    const Lanes cell = lanes_of(body.cell), size = lanes_of(grid_.cell_size());
    const Lanes hang = lanes_of(grid_.overhang()), origin = lanes_of(origin_);
    const InCell<Dimension> in{.low = origin + size * cell - hang,
                               .high = origin + size * (cell + 1.0) + hang,
                               .no_low = cell == first_with_end_,
                               .no_high = cell == last_with_end_,
                               .x = lanes_of(view.x),
                               .v = lanes_of(view.v)};
    const Leaving leaving = surfaces_.has_gravity()
                                ? leaving_in_fall<Dimension>(in, lanes_of(view.a))
                                : leaving_straight<Dimension>(in);
    side = first_cell_side + leaving.side;
    return leaving.time;
}

// Searches the bodies of given cells; for all scalars, falling bodies and bodies at rest.
template <typename Scalar, int Dimension>
auto OpenSpace<Scalar, Dimension>::search_slots(const Bodies& bodies, std::int32_t i,
                                                const Scalar& now, First& first) {
    return [this, &bodies, &now, &first, i, view = View(at(bodies, i), now)](
               const typename Grid::Slots& slots, const Point& shift) {
        const Body& body = at(bodies, i);
        std::size_t count = 0;
        grid_.append(slots, near_, count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t j = near_[k];
            if (j == i) continue;
            const Body& other = at(bodies, j);
            if (screened_ && surely_miss(view, View(other, now), shift, body.radius + other.radius,
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
template <typename Scalar, int Dimension>
inline Scalar OpenSpace<Scalar, Dimension>::next_event(Body& body, double radius, const Scalar& now,
                                                       First first) {
    const View view = view_of(body, now);
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

template <typename Scalar, int Dimension>
Scalar OpenSpace<Scalar, Dimension>::predict(Bodies& bodies, std::int32_t i, const Scalar& now) {
    Body& body = at(bodies, i);
    const double radius = this->radius_of(i);
    if constexpr (of_doubles)
        if (all_fall())
            return next_event(body, radius, now, First(this->first_contact(bodies, i, now)));
    First first;
    grid_.for_each_near(radius, body.cell, search_slots(bodies, i, now, first));
    return next_event(body, radius, now, std::move(first));
}

template <typename Scalar, int Dimension>
bool OpenSpace<Scalar, Dimension>::predict_both(Bodies& bodies, std::int32_t i, std::int32_t j,
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

template <typename Scalar, int Dimension>
Scalar OpenSpace<Scalar, Dimension>::predict_after_crossing(Bodies& bodies, std::int32_t i,
                                                            int side, const Scalar& now) {
    Body& body = at(bodies, i);
    // After crossing a periodic side a body faces other images of the same barriers.
    if constexpr (of_doubles)
        if (all_fall() && !grid_.is_last(body.cell, side ^ 1))
            return next_event(body, this->radius_of(i), now,
                              First(this->first_contact_after_crossing(bodies, i, side, now)));
    return predict(bodies, i, now);
}

template <typename Scalar, int Dimension>
bool OpenSpace<Scalar, Dimension>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                           Contact<Dimension>& contact) {
    const auto inverse_mass_of = [&](std::int32_t body) {
        return as_precise_as(at(bodies, i).x[0], properties_[body].inverse_mass);
    };
    if (!Base::collide(bodies, i, j, {inverse_mass_of(i), inverse_mass_of(j)}, contact))
        return false;
    surfaces_.path_has_changed(at(bodies, i));
    surfaces_.path_has_changed(at(bodies, j));
    return true;
}

template <typename Scalar, int Dimension>
void OpenSpace<Scalar, Dimension>::look_for_hits(Bodies& bodies, std::size_t k, const Scalar& now,
                                                 const Agenda<Scalar>& agenda) {
    list_reach(k);
    const Mover<Scalar>& mover = surfaces_.mover(k);
    for (const Moving& moving : moving_) {
        const auto& barrier = surfaces_.barrier(moving.barrier);
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
                               [&](const typename Grid::Slots& slots) {
                                   std::size_t count = 0;
                                   grid_.append(slots, near_, count);
                                   for (std::size_t n = 0; n < count; ++n) look_at(near_[n]);
                               });
    }
}

template class OpenSpace<double, 2>;
template class OpenSpace<double, 3>;
template class OpenSpace<Real, 2>;
template class OpenSpace<Real, 3>;

}  // namespace carom

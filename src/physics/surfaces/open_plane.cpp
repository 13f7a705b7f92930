#include "physics/surfaces/open_plane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/collision/pair_collision.h"

namespace carom {
namespace {

auto& at(auto& things, std::integral auto i) { return things[static_cast<std::size_t>(i)]; }

double radius_of_largest(const Particles& particles) {
    return particles.count() > 0 ? particles.radius.maxCoeff() : 0.0;
}

template <typename Scalar>
double size_of(const Scalar& number) {
    return std::abs(static_cast<double>(number));
}

// A disk in doubles, at the present.
struct View {
    std::array<double, 2> x, v, a;
    double now;

    template <typename Scalar>
    View(const FallingDisk<Scalar>& d, const Scalar& time) : now(static_cast<double>(time)) {
        for (std::size_t k = 0; k < 2; ++k) {
            x[k] = static_cast<double>(position_at(d, k, time));
            v[k] = static_cast<double>(velocity_at(d, k, time));
            a[k] = static_cast<double>(d.a[k]);
        }
    }
};

// A quick look at a disk that falls as the one that looks: whether it certainly does not touch that
// until a time (quick_look() and might_touch_within(), with their margins).
[[gnu::always_inline]] inline bool surely_misses(const View& view, const FallingDisk<double>& b,
                                                 double sigma, double shift_x, double shift_y,
                                                 double before) {
    const double t = view.now - b.time;
    const double fall_x = t * b.a[0], fall_y = t * b.a[1];
    const RelativeMotion<double> m{b.x[0] + t * (b.v[0] + 0.5 * fall_x) + shift_x - view.x[0],
                                   b.x[1] + t * (b.v[1] + 0.5 * fall_y) + shift_y - view.x[1],
                                   b.v[0] + fall_x - view.v[0], b.v[1] + fall_y - view.v[1]};
    const QuickLook<double> look = quick_look(m, sigma);
    const bool might = (look.approach > 0.0) & (look.slack >= 0.0) &
                       might_touch_within(m, sigma, look.approach, before - view.now);
    return !might & (b.a == view.a);
}

}  // namespace

template <typename Scalar>
OpenPlane<Scalar>::OpenPlane(const Box& box, const Particles& particles,
                             const Arithmetic& arithmetic)
    : box_(box),
      grid_(box, particles.radius),
      bits_(arithmetic.bits),
      largest_(radius_of_largest(particles)),
      surfaces_(box, largest_ + std::max(grid_.cell_size()[0], grid_.cell_size()[1]),
                grid_.cell_size(), arithmetic.bits) {}

// How far a disk in a cell may reach beyond it along an axis.
template <typename Scalar>
double OpenPlane<Scalar>::reach_of(std::size_t axis) const {
    return (largest_ + grid_.overhang()[axis]) * (1.0 + 1e-9) + 1e-9 * box_.size.maxCoeff();
}

// Each cell's list of what a disk in it may touch, one after the other.
template <typename Scalar>
void OpenPlane<Scalar>::list_barriers() {
    const std::array cells{grid_.last_cell()[0] + 1, grid_.last_cell()[1] + 1};
    const std::array<double, 2>& size = grid_.cell_size();
    std::vector<std::vector<std::int32_t>> lists(static_cast<std::size_t>(cells[0] * cells[1]));
    moving_.clear();
    for (std::size_t k = 0; k < surfaces_.barriers().size(); ++k) {
        const Barrier& barrier = surfaces_.barriers()[k];
        if (!surfaces_.is_there(barrier)) continue;
        if (surfaces_.is_mobile(barrier)) {
            moving_.push_back(static_cast<std::int32_t>(k));
            continue;
        }
        std::array<int, 2> from{}, to{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double reach = reach_of(axis);
            const auto cell = [&](double x) {
                return static_cast<int>(
                    std::clamp(std::floor(x / size[axis]), 0.0, cells[axis] - 1.0));
            };
            from[axis] = cell(barrier.low(axis) - reach);
            to[axis] = cell(barrier.high(axis) + reach);
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
void OpenPlane<Scalar>::enter(Bodies& bodies) {
    for (Body& body : bodies)
        body.cell = grid_.cell_at(static_cast<double>(body.x[0]), static_cast<double>(body.x[1]));
    fill_grid(bodies);
    resettle(bodies);
}

template <typename Scalar>
void OpenPlane<Scalar>::fill_grid(const Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k)
        grid_.add(static_cast<std::int32_t>(k), bodies[k].radius, bodies[k].cell);
}

template <typename Scalar>
void OpenPlane<Scalar>::renumber(Bodies& bodies, const std::vector<std::int32_t>& before) {
    renumber_partners(bodies, before);
    fill_grid(bodies);
}

template <typename Scalar>
void OpenPlane<Scalar>::resettle(Bodies& bodies) {
    list_barriers();
    for (Body& body : bodies) surfaces_.settle_at_rest(body);
    if (!bodies.empty()) surfaces_.enter(bodies, bodies[0].time);
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

template <typename Scalar>
void OpenPlane<Scalar>::look_at_barriers(const Body& body, const Scalar& now, First& first) const {
    const auto look = [&](std::int32_t k) {
        const Barrier& barrier = surfaces_.barrier(k);
        if (surfaces_.lets_pass(barrier, body.species)) return;
        const Scalar time = now + surfaces_.time_to(body, k, now);
        if (time < first.time) first = {time, -1 - k, surfaces_.changes_of(barrier)};
    };
    const int cell = body.cell[1] * (grid_.last_cell()[0] + 1) + body.cell[0];
    for (std::int32_t k = at(first_listed_, cell); k < at(first_listed_, cell + 1); ++k)
        look(at(listed_, k));
    for (const std::int32_t k : moving_) look(k);
}

// When a body leaves its cell, and by which side. A cell beside a wall has no border there. That is
// no event of physics: a time in doubles will do, as a cell is a little wider than it must be.
template <typename Scalar>
Scalar OpenPlane<Scalar>::border_time(const Body& body, const Scalar& now,
                                      std::uint32_t& side) const {
    const std::array<int, 2>& last = grid_.last_cell();
    double first = never<double>;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto x = static_cast<double>(position_at(body, axis, now));
        const auto v = static_cast<double>(velocity_at(body, axis, now));
        const auto a = static_cast<double>(body.a[axis]);
        const bool periodic = box_.is_periodic(axis);
        const double hang = grid_.overhang()[axis];
        for (const unsigned up : {0U, 1U}) {
            if (!periodic && body.cell[axis] == (up == 1 ? last[axis] : 0)) continue;
            const double border = grid_.cell_size()[axis] * (body.cell[axis] + up);
            const double t =
                up == 1 ? fall_time(border + hang - x, -v, -a) : fall_time(x - border + hang, v, a);
            if (!(t < first)) continue;
            first = t;
            side = first_cell_side + 2 * static_cast<unsigned>(axis) + up;
        }
    }
    return now + first;
}

// Of the disks in some cells.
template <typename Scalar>
auto OpenPlane<Scalar>::search_slots(const Bodies& bodies, std::int32_t i, const Scalar& now,
                                     First& first) {
    const Body& body = at(bodies, i);
    return [this, &bodies, &now, &first, &body, i, view = View(body, now)](
               const CellGrid::Slots& slots, double shift_x, double shift_y) {
        const std::array<double, 2> shift{shift_x, shift_y};
        std::size_t count = 0;
        grid_.append(slots, near_, count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t j = near_[k];
            const Body& other = at(bodies, j);
            if (j == i) continue;
            if constexpr (of_doubles)
                if (surely_misses(view, other, body.radius + other.radius, shift_x, shift_y,
                                  first.time))
                    continue;
            const Scalar time = now + pair_time(body, other, shift, now);
            if (time < first.time || (time == first.time && j < first.partner))
                first = {time, j, other.collisions & most_collisions};
        }
    };
}

// The contact, a hit of a surface, or the border of the cell. With doubles the body keeps a contact
// that may come after the border; with many bits two times may be one double.
template <typename Scalar>
Scalar OpenPlane<Scalar>::next_event(Body& body, const Scalar& now, First& first) {
    look_at_barriers(body, now, first);
    std::uint32_t side = 0;
    Scalar border = border_time(body, now, side);
    const bool is_contact = first.time <= border;
    body.prediction = {
        .contact_time = of_doubles || is_contact ? rounded_down(first.time) : never<double>,
        .partner = first.partner,
        .partner_collisions = first.partner_collisions & most_collisions,
        .border = side & 7U};
    return is_contact ? std::move(first.time) : std::move(border);
}

template <typename Scalar>
Scalar OpenPlane<Scalar>::predict(Bodies& bodies, std::int32_t i, const Scalar& now) {
    Body& body = at(bodies, i);
    First first;
    grid_.for_each_near(body.radius, body.cell, search_slots(bodies, i, now, first));
    return next_event(body, now, first);
}

template <typename Scalar>
Scalar OpenPlane<Scalar>::predict_after_crossing(Bodies& bodies, std::int32_t i, int side,
                                                 const Scalar& now) {
    if constexpr (of_doubles) {
        Body& body = at(bodies, i);
        // Beyond a periodic side it meets other images of the same barriers.
        if (grid_.is_last(body.cell, side ^ 1)) return predict(bodies, i, now);
        First first{body.prediction.contact_time, body.prediction.partner,
                    body.prediction.partner_collisions};
        grid_.for_each_newly_near(body.radius, body.cell, side,
                                  search_slots(bodies, i, now, first));
        return next_event(body, now, first);
    } else {
        return predict(bodies, i, now);
    }
}

template <typename Scalar>
void OpenPlane<Scalar>::cross(Bodies& bodies, std::int32_t i, int side, const Scalar& now) {
    Body& body = at(bodies, i);
    const Cell from = body.cell;
    body.cell = grid_.next_cell(from, side);
    if (grid_.is_last(from, side)) {  // leaves a periodic box, and enters at the other side
        const auto axis = static_cast<std::size_t>(side / 2);
        advance_body(body, now);
        body.x[axis] += side % 2 == 1 ? -box_.length(axis) : box_.length(axis);
    }
    grid_.move(i, body.radius, from, body.cell);
}

template <typename Scalar>
bool OpenPlane<Scalar>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                Contact<2>& contact) const {
    Body &a = at(bodies, i), &b = at(bodies, j);
    const double sigma = a.radius + b.radius;
    // Of the images of b the one in contact with a that it approaches.
    RelativeMotion<Scalar> m{0.0, 0.0, b.v[0] - a.v[0], b.v[1] - a.v[1]};
    double best = never<double>;
    for (int turns_x = -1; turns_x <= 1; ++turns_x) {
        if (turns_x != 0 && !box_.is_periodic(0)) continue;
        for (int turns_y = -1; turns_y <= 1; ++turns_y) {
            if (turns_y != 0 && !box_.is_periodic(1)) continue;
            const Scalar x = b.x[0] - a.x[0] + turns_x * box_.size[0];
            const Scalar y = b.x[1] - a.x[1] + turns_y * box_.size[1];
            const double misfit = size_of(Scalar(x * x + y * y - sigma * sigma));
            if (!(misfit < best) || !(x * m.vx + y * m.vy < 0.0)) continue;
            best = misfit, m.x = x, m.y = y;
        }
    }
    if (best == never<double>) return false;
    const Scalar square = m.x * m.x + m.y * m.y;
    const Scalar factor = divided_by_sum<Scalar>(2.0 * (m.x * m.vx + m.y * m.vy) / square,
                                                 as_precise_as(m.x, a.inverse_mass),
                                                 as_precise_as(m.x, b.inverse_mass));
    const std::array<Scalar, 2> r{m.x, m.y};
    for (std::size_t k = 0; k < 2; ++k) {
        a.v[k] += a.inverse_mass * factor * r[k];
        b.v[k] -= b.inverse_mass * factor * r[k];
    }
    for (Body* body : {&a, &b}) {
        body->passing = -1;
        surfaces_.settle_at_rest(*body);
    }
    const auto distance_square = static_cast<double>(square);
    contact = {{static_cast<double>(m.x), static_cast<double>(m.y)},
               -static_cast<double>(factor) * distance_square,
               0.5 * (1.0 - distance_square / (sigma * sigma))};
    return true;
}

template <typename Scalar>
void OpenPlane<Scalar>::look_for_hits(Bodies& bodies, std::size_t k, const Scalar& now,
                                      const Earlier<Scalar>& earlier) {
    const Mover<Scalar>& mover = surfaces_.mover(k);
    const double reach = reach_of(mover.axis);
    grid_.for_each_in_band(
        mover.axis, static_cast<double>(mover.low) - reach, static_cast<double>(mover.high) + reach,
        [&](const CellGrid::Slots& slots) {
            std::size_t count = 0;
            grid_.append(slots, near_, count);
            for (std::size_t n = 0; n < count; ++n) {
                Body& body = at(bodies, near_[n]);
                for (const std::int32_t barrier : moving_) {
                    if (surfaces_.barrier(barrier).surface != static_cast<std::int32_t>(k) ||
                        surfaces_.lets_pass(surfaces_.barrier(barrier), body.species))
                        continue;
                    const Scalar time = now + surfaces_.time_to(body, barrier, now);
                    if (!earlier(near_[n], time)) continue;
                    body.prediction.contact_time = rounded_down(time);
                    body.prediction.partner = -1 - barrier;
                    body.prediction.partner_collisions = mover.changes & most_collisions;
                }
            }
        });
}

template class OpenPlane<double>;
template class OpenPlane<Real>;

}  // namespace carom

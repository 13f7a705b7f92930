#include "physics/multiprecision/mp_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/cells/images.h"
#include "physics/collision/contact_rule.h"

namespace carom {
namespace {

// Relative error of one operation with doubles. Multiprecision results, with at least 64 bits, have
// errors 2,000 times smaller, for which the bounds below leave room.
constexpr double ulp = std::numeric_limits<double>::epsilon() / 2;
// Factors that cover the rounding errors of a few operations in the calculation of a bound itself.
constexpr double more = 1.0 + 1e-12, less = 1.0 - 1e-12;

const auto& at(const auto& bodies, std::int32_t i) { return bodies[static_cast<std::size_t>(i)]; }

// A predicted contact is always the next event, so any contact_time that is not later than it will
// do.
bool is_contact(const Prediction& prediction) { return prediction.contact_time < never<double>; }

}  // namespace

template <int Dimension>
MpSpace<Dimension>::MpSpace(const Box& box, const Particles& particles,
                            const Arithmetic& arithmetic)
    : box_(box),
      grid_(box, particles.radius),
      screened_(arithmetic.screened),
      bits_(arithmetic.bits) {
    for (auto* vector : {&here_, &r_, &v_}) vector->fill(Real(0.0, bits_));
    for (Real* number : {&approach_, &time_, &a_, &b_, &c_, &sigma_square_})
        *number = Real(0.0, bits_);
}

template <int Dimension>
void MpSpace<Dimension>::enter(Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        Body& body = bodies[k];
        body.cell = grid_.cell_at(body.shadow.x);
        grid_.add(static_cast<std::int32_t>(k), body.radius, body.cell);
    }
}

// The age is calculated from the multiprecision times: late in a long run doubles may be too coarse
// for them.
template <int Dimension>
auto MpSpace<Dimension>::viewer(const Body& body, const Real& now) -> Viewer {
    a_.set_difference(now, body.time);
    const double age = static_cast<double>(a_);
    const auto& s = body.shadow;
    placed_ = false;
    Viewer viewer{body, s.x, s.distance + s.speed * age, static_cast<double>(now)};
    for (std::size_t k = 0; k < axes; ++k) viewer.x[k] = s.x[k] + s.v[k] * age;
    return viewer;
}

// A time before which two bodies certainly do not touch, or `never` if they certainly miss each
// other. Variables are named as in contact_time(), each with a bound on its error.
template <int Dimension>
double MpSpace<Dimension>::soonest_contact(const Viewer& a, const Body& other,
                                           const Point& shift) const {
    const auto &s = a.body.shadow, &b = other.shadow;
    const double sigma = s.radius + b.radius;
    const double age = a.now - b.time;
    RelativeMotion<double, axes> m;
    std::array<double, axes> fast;
    // Errors of the conversions, of the age (the errors of both times), of the free flights, and of
    // the sums.
    const double times = std::abs(a.now) + std::abs(b.time);
    double scale = a.distance + b.distance + b.speed * times;
    for (std::size_t k = 0; k < axes; ++k) scale += std::abs(shift[k]);
    const double x_error = 16.0 * ulp * scale;
    const double v_error = 4.0 * ulp * (s.speed + b.speed);
    double r1 = 0.0, v1 = 0.0;
    for (std::size_t k = 0; k < axes; ++k) {
        m.r[k] = (b.x[k] + b.v[k] * age - a.x[k]) + shift[k];
        m.v[k] = b.v[k] - s.v[k];
        r1 += std::abs(m.r[k]);
        v1 += std::abs(m.v[k]);
        fast[k] = std::abs(m.v[k]) + v_error;
    }
    const double product_error =
        more * (r1 * v_error + v1 * x_error + 2.0 * x_error * v_error + 4.0 * ulp * r1 * v1);
    const double approach = scalar_product(m.r, m.v);
    if (approach >= product_error) return never<double>;
    double miss_square = 0.0;  // each component of the cross product has an error of its own
    for (const double component : cross_product(m)) {
        const double miss = std::max(0.0, std::abs(component) - product_error);
        miss_square += less * (miss * miss);
    }
    const double reach_square = more * (sigma * sigma * scalar_product(fast, fast));
    if (miss_square > reach_square) return never<double>;
    const double square = scalar_product(m.r, m.r);
    const double gap_error = more * (2.0 * r1 * x_error + 2.0 * x_error * x_error +
                                     8.0 * ulp * (square + sigma * sigma));
    const double gap = (square - sigma * sigma) - gap_error;
    if (!(gap > 0.0)) return -never<double>;
    const double root = std::sqrt(reach_square - miss_square);
    const double time = less * (gap / (root + std::abs(approach) + product_error));
    return (a.now + time) - 4.0 * ulp * (std::abs(a.now) + time);
}

template <int Dimension>
void MpSpace<Dimension>::place_viewer(const Body& a, const Real& now) {
    if (placed_) return;
    a_.set_difference(now, a.time);
    for (std::size_t k = 0; k < axes; ++k) {
        b_.set_product(a.v[k], a_);
        here_[k].set_sum(a.x[k], b_);
    }
    placed_ = true;
}

// Whether r . v, stored in approach_, is negative by more than its round-off
// (approach_round_off()).
template <int Dimension>
bool MpSpace<Dimension>::approaches(const Body& a, const Body& b) {
    if (approach_.sign() >= 0) return false;
    const auto &s = a.shadow, &t = b.shadow;
    double scale = 0.0;
    for (std::size_t k = 0; k < axes; ++k)
        scale += std::abs(static_cast<double>(r_[k])) * (std::abs(s.v[k]) + std::abs(t.v[k]));
    if (static_cast<double>(approach_) < -1e-12 * scale) return true;
    c_.set(-8.0 * scale);
    c_.scale_by_power_of_two(-bits_);
    return approach_ < c_;
}

// Caches the last square, since most pairs have the same contact distance.
template <int Dimension>
const Real& MpSpace<Dimension>::squared(double sigma) {
    if (sigma != sigma_) {
        sigma_ = sigma;
        sigma_square_.set(sigma);
        sigma_square_.set_square(sigma_square_);
    }
    return sigma_square_;
}

// Calculates the contact time in full precision into time_; returns false if the bodies miss each
// other. Plain arithmetic suffices: it loses no more by cancellation than the rounding of positions
// already has.
template <int Dimension>
bool MpSpace<Dimension>::solve_contact(const Body& a, const Body& b, const Point& shift,
                                       const Real& now) {
    place_viewer(a, now);
    a_.set_difference(now, b.time);
    for (std::size_t k = 0; k < axes; ++k) {
        b_.set_product(b.v[k], a_);
        b_.set_sum(b.x[k], b_);
        r_[k].set_difference(b_, here_[k]);
        if (shift[k] != 0.0) r_[k].set_sum(r_[k], shift[k]);
        v_[k].set_difference(b.v[k], a.v[k]);
    }
    set_approach();
    if (!approaches(a, b)) return false;
    const double sigma = a.radius + b.radius;
    set_square(a_, r_, b_);
    const Real& square = squared(sigma);
    a_.set_difference(a_, square);  // the gap
    if (a_.sign() <= 0) {
        time_.set(now);
        return true;
    }
    set_square(b_, v_, c_);
    b_.set_product(b_, square);  // the reach, squared
    subtract_miss_square();
    if (b_.sign() <= 0) return false;
    b_.set_root(b_);
    b_.set_difference(b_, approach_);
    time_.set_quotient(a_, b_);
    time_.set_sum(now, time_);
    return true;
}

// Accepts the contact with a candidate if it is the earliest so far and not later than the next
// event of the other body, which will predict again at that event.
template <int Dimension>
void MpSpace<Dimension>::consider(const Bodies& bodies, const Body& a, const Candidate& candidate,
                                  const Real& now, First& first) {
    const Body& b = at(bodies, candidate.other);
    if (!solve_contact(a, b, candidate.shift, now)) return;
    const double when = time_.rounded_up();
    if (coincidences_.may_coincide(when, first.late) ||
        (is_contact(b.prediction) && coincidences_.may_coincide(when, b.event_late)))
        coincidences_.note(when);
    const auto order = time_ <=> first.time;
    if (order > 0 || (order == 0 && is_contact(first) && candidate.other >= first.partner)) return;
    if (is_contact(b.prediction) && time_ > b.event_time) return;
    first.time.set(time_);
    first.contact_time = -never<double>;
    first.late = time_.rounded_up();
    first.partner = candidate.other;
    first.partner_collisions = b.collisions & most_collisions;
}

// Candidates are processed by increasing lower bound until the next one certainly comes too late. A
// candidate whose next event is already a contact with this body is skipped: its own event is
// sufficient.
template <int Dimension>
Real MpSpace<Dimension>::predict(Bodies& bodies, std::int32_t i, const Real& now) {
    Body& body = bodies[static_cast<std::size_t>(i)];
    const Viewer a = viewer(body, now);
    First first{{Prediction{}, Real(never<double>, bits_)}};
    predict_border(a, now, first);
    candidates_.clear();
    grid_.for_each_near(body.radius, body.cell, [&](const auto& slots, const Point& shift) {
        std::size_t count = 0;
        grid_.append(slots, near_, count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t j = near_[k];
            const Body& other = at(bodies, j);
            if (j == i || !(body.radius + other.radius > 0.0) ||
                !(body.inverse_mass + other.inverse_mass > 0.0))
                continue;
            const bool waits = is_contact(other.prediction);
            if (waits && other.prediction.partner == i &&
                other.prediction.partner_collisions == (body.collisions & most_collisions))
                continue;
            const double soonest = screened_ ? soonest_contact(a, other, shift) : -never<double>;
            if (soonest > first.late || (waits && soonest > other.event_late)) continue;
            if (soonest < never<double>) candidates_.push_back({soonest, j, shift});
        }
    });
    while (!candidates_.empty()) {
        const auto next = std::min_element(
            candidates_.begin(), candidates_.end(),
            [](const Candidate& p, const Candidate& q) { return p.soonest < q.soonest; });
        if (next->soonest > first.late) break;
        consider(bodies, body, *next, now, first);
        *next = candidates_.back();
        candidates_.pop_back();
    }
    body.prediction = first;
    body.event_time = first.time;
    body.event_late = first.late;
    return std::move(first.time);
}

// A body that leaves a periodic box is shifted by the length of the box without being advanced,
// which causes no rounding.
template <int Dimension>
void MpSpace<Dimension>::cross(Bodies& bodies, std::int32_t i, int side, const Real&) {
    Body& body = bodies[static_cast<std::size_t>(i)];
    const auto from = body.cell;
    body.cell = grid_.next_cell(from, side);
    if (grid_.is_last(from, side)) {
        const auto axis = static_cast<std::size_t>(side / 2);
        Real& x = body.x[axis];
        x.set_sum(x, side % 2 == 1 ? -box_.length(axis) : box_.length(axis));
        body_has_changed(body);
    }
    grid_.move(i, body.radius, from, body.cell);
}

// As in PlainSpace, walls are considered as soon as the body may touch them.
template <int Dimension>
auto MpSpace<Dimension>::border_ahead(const Viewer& a, std::size_t axis) const -> Border {
    const Body& d = a.body;
    const double v = d.shadow.v[axis];
    const int in = d.cell[axis];
    const int up = v > 0.0 ? 1 : 0;
    const unsigned side = 2U * static_cast<unsigned>(axis) + static_cast<unsigned>(up);
    Border border{grid_.cell_size()[axis] * (in + up), first_cell_side + side, never<double>};
    if (!box_.is_periodic(axis)) {
        const double size = box_.length(axis);
        const double wall = up ? size - d.radius : d.radius;
        if (in == (up ? grid_.last_cell()[axis] : 0) ||
            (up ? wall <= border.place : wall >= border.place)) {
            border.place = wall;
            border.kind = side;
        }
    }
    if (v == 0.0) return border;
    const double way = up ? border.place - a.x[axis] : a.x[axis] - border.place;
    const bool is_wall = border.kind < first_cell_side;
    const double error = is_wall ? 16.0 * ulp * (a.distance + std::abs(border.place)) : 0.0;
    border.soonest = std::max(0.0, way - error) / std::abs(v) * (is_wall ? less : 1.0);
    return border;
}

template <int Dimension>
void MpSpace<Dimension>::solve_wall(const Body& a, std::size_t axis, double place,
                                    const Real& now) {
    place_viewer(a, now);
    a_.set_difference(place, here_[axis]);
    time_.set_quotient(a_, a.v[axis]);
    if (time_.sign() <= 0)
        time_.set(now);
    else
        time_.set_sum(now, time_);
}

// The first of the borders ahead. The time of a cell border is calculated in doubles; that of a
// wall in full precision, unless the cell border certainly comes first.
template <int Dimension>
void MpSpace<Dimension>::predict_border(const Viewer& a, const Real& now, First& first) {
    std::array<Border, axes> borders;
    for (std::size_t axis = 0; axis < axes; ++axis) borders[axis] = border_ahead(a, axis);
    double cell = never<double>;
    for (const Border& border : borders) {
        if (border.kind < first_cell_side || border.soonest >= cell) continue;
        cell = border.soonest;
        first.border = border.kind & most_border;
    }
    if (cell < never<double>) first.time.set_sum(now, cell);
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const Border& border = borders[axis];
        if (border.kind >= first_cell_side || std::isinf(border.soonest)) continue;
        if (screened_ && border.soonest > cell) continue;
        solve_wall(a.body, axis, border.place, now);
        if (time_ >= first.time) continue;
        first.time.set(time_);
        first.border = border.kind & most_border;
    }
    first.late = first.time.rounded_up();
}

// The square of a vector; `part` is scratch.
template <int Dimension>
void MpSpace<Dimension>::set_square(Real& square, const std::array<Real, axes>& vector,
                                    Real& part) {
    square.set_square(vector[0]);
    for (std::size_t k = 1; k < axes; ++k) {
        part.set_square(vector[k]);
        square.set_sum(square, part);
    }
}

// Stores r . v in approach_; c_ is overwritten.
template <int Dimension>
void MpSpace<Dimension>::set_approach() {
    approach_.set_product(r_[0], v_[0]);
    for (std::size_t k = 1; k < axes; ++k) {
        c_.set_product(r_[k], v_[k]);
        approach_.set_sum(approach_, c_);
    }
}

// Subtracts |r x v|^2 from b_; c_ and time_ are overwritten.
template <int Dimension>
void MpSpace<Dimension>::subtract_miss_square() {
    const auto subtract = [&](std::size_t k, std::size_t l) {
        time_.set_product(r_[k], v_[l]);
        c_.set_product(r_[l], v_[k]);
        c_.set_difference(time_, c_);
        c_.set_square(c_);
        b_.set_difference(b_, c_);
    };
    subtract(0, 1);
    if constexpr (Dimension == 3) {
        subtract(1, 2);
        subtract(2, 0);
    }
}

template <int Dimension>
void MpSpace<Dimension>::separate(const Body& a, const Body& b, const Point& shift) {
    for (std::size_t k = 0; k < axes; ++k) {
        r_[k].set_difference(b.x[k], a.x[k]);
        if (shift[k] != 0.0) r_[k].set_sum(r_[k], shift[k]);
    }
    set_approach();
}

// As PairSearch::motion_at_contact(): r_, v_ and approach_ of the image of b in contact with a.
template <int Dimension>
bool MpSpace<Dimension>::find_image(const Body& a, const Body& b) {
    std::array<std::array<double, 2>, axes> shifts{};
    bool are_several = false;
    Point best;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        v_[axis].set_difference(b.v[axis], a.v[axis]);
        if (box_.is_periodic(axis)) {
            const double size = box_.length(axis);
            r_[axis].set_difference(b.x[axis], a.x[axis]);
            const auto plain = static_cast<double>(r_[axis]);
            const double nearest = -size * box_.turns(axis, plain);
            shifts[axis] = {nearest, plain + nearest > 0.0 ? nearest - size : nearest + size};
        }
        best[axis] = shifts[axis][0];
        are_several = are_several || grid_.narrow()[axis];
    }
    if (are_several) {
        const double sigma = a.radius + b.radius;
        Real least = never<double>;
        for_each_image(grid_.narrow(), [&](const std::array<std::size_t, axes>& which) {
            Point shift;
            for (std::size_t axis = 0; axis < axes; ++axis) shift[axis] = shifts[axis][which[axis]];
            separate(a, b, shift);
            if (approach_.sign() >= 0) return;
            const Real misfit = abs(scalar_product(r_, r_) - as_precise_as(r_[0], sigma) * sigma);
            if (misfit >= least) return;
            least = misfit;
            best = shift;
        });
        if (!least.is_finite()) return false;
    }
    separate(a, b, best);
    return approach_.sign() < 0;
}

template <int Dimension>
bool MpSpace<Dimension>::collide(Bodies& bodies, std::int32_t i, std::int32_t j,
                                 Contact<Dimension>& contact) {
    Body& a = bodies[static_cast<std::size_t>(i)];
    Body& b = bodies[static_cast<std::size_t>(j)];
    if (!find_image(a, b)) {
        body_has_changed(a);
        body_has_changed(b);
        return false;
    }
    set_square(a_, r_, b_);
    const double sigma = a.radius + b.radius;
    b_.set_difference(squared(sigma), a_);
    contact.overlap = 0.5 * static_cast<double>(b_) / (sigma * sigma);
    for (std::size_t k = 0; k < axes; ++k) contact.separation[k] = static_cast<double>(r_[k]);
    contact.virial =
        -ContactRule::change(static_cast<double>(approach_)) / (a.inverse_mass + b.inverse_mass);
    static_assert(ContactRule::keeps_species);
    ContactRule::push(a.v, b.v, r_, a.inverse_mass, b.inverse_mass, approach_, a_, c_, b_);
    body_has_changed(a);
    body_has_changed(b);
    return true;
}

template class MpSpace<2>;
template class MpSpace<3>;

}  // namespace carom

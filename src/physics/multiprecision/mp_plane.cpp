#include "physics/multiprecision/mp_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "physics/collision/contact_rule.h"

namespace carom {
namespace {

// Relative error of one operation with doubles. Multiprecision results, with at least 64 bits, have
// errors 2,000 times smaller, for which the bounds below leave room.
constexpr double ulp = std::numeric_limits<double>::epsilon() / 2;
// Factors that cover the rounding errors of a few operations in the calculation of a bound itself.
constexpr double more = 1.0 + 1e-12, less = 1.0 - 1e-12;

const MpDisk& at(const MpPlane::Bodies& bodies, std::int32_t i) {
    return bodies[static_cast<std::size_t>(i)];
}

// A predicted contact is always the next event, so any contact_time that is not later than it will
// do.
bool is_contact(const Prediction& prediction) { return prediction.contact_time < never<double>; }

}  // namespace

MpPlane::MpPlane(const Box& box, const Particles& particles, const Arithmetic& arithmetic)
    : box_(box),
      grid_(box, particles.radius),
      screened_(arithmetic.screened),
      bits_(arithmetic.bits) {
    for (Real* number : {&here_[0], &here_[1], &r_[0], &r_[1], &v_[0], &v_[1], &approach_, &time_,
                         &a_, &b_, &c_, &sigma_square_})
        *number = Real(0.0, bits_);
}

void MpPlane::enter(Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        MpDisk& body = bodies[k];
        body.cell = grid_.cell_at(body.shadow.x[0], body.shadow.x[1]);
        grid_.add(static_cast<std::int32_t>(k), body.radius, body.cell);
    }
}

// The age is calculated from the multiprecision times: late in a long run doubles may be too coarse
// for them.
MpPlane::Viewer MpPlane::viewer(const MpDisk& disk, const Real& now) {
    a_.set_difference(now, disk.time);
    const double age = static_cast<double>(a_);
    const MpDisk::Shadow& s = disk.shadow;
    placed_ = false;
    return {disk,
            {s.x[0] + s.v[0] * age, s.x[1] + s.v[1] * age},
            s.distance + s.speed * age,
            static_cast<double>(now)};
}

// A time before which two disks certainly do not touch, or `never` if they certainly miss each
// other. Variables are named as in contact_time(), each with a bound on its error.
double MpPlane::soonest_contact(const Viewer& a, const MpDisk& other,
                                const std::array<double, 2>& shift) const {
    const MpDisk::Shadow &s = a.disk.shadow, &b = other.shadow;
    const double sigma = s.radius + b.radius;
    const double age = a.now - b.time;
    const double x = (b.x[0] + b.v[0] * age - a.x[0]) + shift[0];
    const double y = (b.x[1] + b.v[1] * age - a.x[1]) + shift[1];
    const double vx = b.v[0] - s.v[0];
    const double vy = b.v[1] - s.v[1];
    // Errors of the conversions, of the age (the errors of both times), of the free flights, and of
    // the sums.
    const double times = std::abs(a.now) + std::abs(b.time);
    const double x_error =
        16.0 * ulp *
        (a.distance + b.distance + b.speed * times + std::abs(shift[0]) + std::abs(shift[1]));
    const double v_error = 4.0 * ulp * (s.speed + b.speed);
    const double r1 = std::abs(x) + std::abs(y);
    const double v1 = std::abs(vx) + std::abs(vy);
    const double product_error =
        more * (r1 * v_error + v1 * x_error + 2.0 * x_error * v_error + 4.0 * ulp * r1 * v1);
    const double approach = x * vx + y * vy;
    if (approach >= product_error) return never<double>;
    const double miss = std::max(0.0, std::abs(x * vy - y * vx) - product_error);
    const double fast_x = std::abs(vx) + v_error, fast_y = std::abs(vy) + v_error;
    const double reach_square = more * (sigma * sigma * (fast_x * fast_x + fast_y * fast_y));
    const double miss_square = less * (miss * miss);
    if (miss_square > reach_square) return never<double>;
    const double square = x * x + y * y;
    const double gap_error = more * (2.0 * r1 * x_error + 2.0 * x_error * x_error +
                                     8.0 * ulp * (square + sigma * sigma));
    const double gap = (square - sigma * sigma) - gap_error;
    if (!(gap > 0.0)) return -never<double>;
    const double root = std::sqrt(reach_square - miss_square);
    const double time = less * (gap / (root + std::abs(approach) + product_error));
    return (a.now + time) - 4.0 * ulp * (std::abs(a.now) + time);
}

void MpPlane::place_viewer(const MpDisk& a, const Real& now) {
    if (placed_) return;
    a_.set_difference(now, a.time);
    for (std::size_t k = 0; k < 2; ++k) {
        b_.set_product(a.v[k], a_);
        here_[k].set_sum(a.x[k], b_);
    }
    placed_ = true;
}

// Whether r . v, stored in approach_, is negative by more than its round-off
// (approach_round_off()).
bool MpPlane::approaches(const MpDisk& a, const MpDisk& b) {
    if (approach_.sign() >= 0) return false;
    const MpDisk::Shadow &s = a.shadow, &t = b.shadow;
    const double scale =
        std::abs(static_cast<double>(r_[0])) * (std::abs(s.v[0]) + std::abs(t.v[0])) +
        std::abs(static_cast<double>(r_[1])) * (std::abs(s.v[1]) + std::abs(t.v[1]));
    if (static_cast<double>(approach_) < -1e-12 * scale) return true;
    c_.set(-8.0 * scale);
    c_.scale_by_power_of_two(-bits_);
    return approach_ < c_;
}

// Caches the last square, since most pairs have the same contact distance.
const Real& MpPlane::squared(double sigma) {
    if (sigma != sigma_) {
        sigma_ = sigma;
        sigma_square_.set(sigma);
        sigma_square_.set_square(sigma_square_);
    }
    return sigma_square_;
}

// Calculates the contact time in full precision into time_; returns false if the disks miss each
// other. Plain arithmetic suffices: it loses no more by cancellation than the rounding of positions
// already has.
bool MpPlane::solve_contact(const MpDisk& a, const MpDisk& b, const std::array<double, 2>& shift,
                            const Real& now) {
    place_viewer(a, now);
    a_.set_difference(now, b.time);
    for (std::size_t k = 0; k < 2; ++k) {
        b_.set_product(b.v[k], a_);
        b_.set_sum(b.x[k], b_);
        r_[k].set_difference(b_, here_[k]);
        if (shift[k] != 0.0) r_[k].set_sum(r_[k], shift[k]);
        v_[k].set_difference(b.v[k], a.v[k]);
    }
    b_.set_product(r_[0], v_[0]);
    c_.set_product(r_[1], v_[1]);
    approach_.set_sum(b_, c_);
    if (!approaches(a, b)) return false;
    const double sigma = a.radius + b.radius;
    a_.set_square(r_[0]);
    b_.set_square(r_[1]);
    a_.set_sum(a_, b_);
    const Real& square = squared(sigma);
    a_.set_difference(a_, square);  // the gap
    if (a_.sign() <= 0) {
        time_.set(now);
        return true;
    }
    b_.set_square(v_[0]);
    c_.set_square(v_[1]);
    b_.set_sum(b_, c_);
    b_.set_product(b_, square);  // the reach, squared
    v_[1].set_product(r_[0], v_[1]);
    v_[0].set_product(r_[1], v_[0]);
    c_.set_difference(v_[1], v_[0]);
    c_.set_square(c_);
    b_.set_difference(b_, c_);
    if (b_.sign() <= 0) return false;
    b_.set_root(b_);
    b_.set_difference(b_, approach_);
    time_.set_quotient(a_, b_);
    time_.set_sum(now, time_);
    return true;
}

// Accepts the contact with a candidate if it is the earliest so far and not later than the next
// event of the other disk, which will predict again at that event.
void MpPlane::consider(const Bodies& bodies, const MpDisk& a, const Candidate& candidate,
                       const Real& now, First& first) {
    const MpDisk& b = at(bodies, candidate.other);
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
// candidate whose next event is already a contact with this disk is skipped: its own event is
// sufficient.
Real MpPlane::predict(Bodies& bodies, std::int32_t i, const Real& now) {
    MpDisk& disk = bodies[static_cast<std::size_t>(i)];
    const Viewer a = viewer(disk, now);
    First first{{Prediction{}, Real(never<double>, bits_)}};
    predict_border(a, now, first);
    candidates_.clear();
    grid_.for_each_near(
        disk.radius, disk.cell, [&](const CellGrid::Slots& slots, double shift_x, double shift_y) {
            std::size_t count = 0;
            grid_.append(slots, near_, count);
            for (std::size_t k = 0; k < count; ++k) {
                const std::int32_t j = near_[k];
                const MpDisk& other = at(bodies, j);
                if (j == i || !(disk.radius + other.radius > 0.0) ||
                    !(disk.inverse_mass + other.inverse_mass > 0.0))
                    continue;
                const bool waits = is_contact(other.prediction);
                if (waits && other.prediction.partner == i &&
                    other.prediction.partner_collisions == (disk.collisions & most_collisions))
                    continue;
                const std::array<double, 2> shift{shift_x, shift_y};
                const double soonest =
                    screened_ ? soonest_contact(a, other, shift) : -never<double>;
                if (soonest > first.late || (waits && soonest > other.event_late)) continue;
                if (soonest < never<double>) candidates_.push_back({soonest, j, shift});
            }
        });
    while (!candidates_.empty()) {
        const auto next = std::min_element(
            candidates_.begin(), candidates_.end(),
            [](const Candidate& p, const Candidate& q) { return p.soonest < q.soonest; });
        if (next->soonest > first.late) break;
        consider(bodies, disk, *next, now, first);
        *next = candidates_.back();
        candidates_.pop_back();
    }
    disk.prediction = first;
    disk.event_time = first.time;
    disk.event_late = first.late;
    return std::move(first.time);
}

// A disk that leaves a periodic box is shifted by the length of the box without being advanced,
// which causes no rounding.
void MpPlane::cross(Bodies& bodies, std::int32_t i, int side, const Real&) {
    MpDisk& body = bodies[static_cast<std::size_t>(i)];
    const Cell from = body.cell;
    body.cell = grid_.next_cell(from, side);
    if (grid_.is_last(from, side)) {
        const auto axis = static_cast<std::size_t>(side / 2);
        Real& x = body.x[axis];
        x.set_sum(x, side % 2 == 1 ? -box_.length(axis) : box_.length(axis));
        body_has_changed(body);
    }
    grid_.move(i, body.radius, from, body.cell);
}

// As in Plane, walls are considered as soon as the disk may touch them.
MpPlane::Border MpPlane::border_ahead(const Viewer& a, std::size_t axis) const {
    const MpDisk& d = a.disk;
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

void MpPlane::solve_wall(const MpDisk& a, std::size_t axis, double place, const Real& now) {
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
void MpPlane::predict_border(const Viewer& a, const Real& now, First& first) {
    const std::array<Border, 2> borders{border_ahead(a, 0), border_ahead(a, 1)};
    double cell = never<double>;
    for (const Border& border : borders) {
        if (border.kind < first_cell_side || border.soonest >= cell) continue;
        cell = border.soonest;
        first.border = border.kind & most_border;
    }
    if (cell < never<double>) first.time.set_sum(now, cell);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Border& border = borders[axis];
        if (border.kind >= first_cell_side || std::isinf(border.soonest)) continue;
        if (screened_ && border.soonest > cell) continue;
        solve_wall(a.disk, axis, border.place, now);
        if (time_ >= first.time) continue;
        first.time.set(time_);
        first.border = border.kind & most_border;
    }
    first.late = first.time.rounded_up();
}

void MpPlane::separate(const MpDisk& a, const MpDisk& b, double shift_x, double shift_y) {
    const std::array<double, 2> shift{shift_x, shift_y};
    for (std::size_t k = 0; k < 2; ++k) {
        r_[k].set_difference(b.x[k], a.x[k]);
        if (shift[k] != 0.0) r_[k].set_sum(r_[k], shift[k]);
    }
    a_.set_product(r_[0], v_[0]);
    b_.set_product(r_[1], v_[1]);
    approach_.set_sum(a_, b_);
}

// As Plane::separation_at_contact(): r_, v_ and approach_ of the image of b in contact with a.
bool MpPlane::find_image(const MpDisk& a, const MpDisk& b) {
    std::array<std::array<double, 2>, 2> shifts{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        v_[axis].set_difference(b.v[axis], a.v[axis]);
        if (!box_.is_periodic(axis)) continue;
        const double size = box_.length(axis);
        r_[axis].set_difference(b.x[axis], a.x[axis]);
        const auto plain = static_cast<double>(r_[axis]);
        const double nearest = -size * box_.turns(axis, plain);
        shifts[axis] = {nearest, plain + nearest > 0.0 ? nearest - size : nearest + size};
    }
    const std::size_t along_x = grid_.narrow()[0] ? 2 : 1, along_y = grid_.narrow()[1] ? 2 : 1;
    std::array<double, 2> best{shifts[0][0], shifts[1][0]};
    if (along_x + along_y > 2) {
        const double sigma = a.radius + b.radius;
        Real least = never<double>;
        for (std::size_t i = 0; i < along_x; ++i) {
            for (std::size_t j = 0; j < along_y; ++j) {
                separate(a, b, shifts[0][i], shifts[1][j]);
                if (approach_.sign() >= 0) continue;
                const Real misfit =
                    abs(r_[0] * r_[0] + r_[1] * r_[1] - as_precise_as(r_[0], sigma) * sigma);
                if (misfit >= least) continue;
                least = misfit;
                best = {shifts[0][i], shifts[1][j]};
            }
        }
        if (!least.is_finite()) return false;
    }
    separate(a, b, best[0], best[1]);
    return approach_.sign() < 0;
}

bool MpPlane::collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) {
    MpDisk& a = bodies[static_cast<std::size_t>(i)];
    MpDisk& b = bodies[static_cast<std::size_t>(j)];
    if (!find_image(a, b)) {
        body_has_changed(a);
        body_has_changed(b);
        return false;
    }
    a_.set_square(r_[0]);
    b_.set_square(r_[1]);
    a_.set_sum(a_, b_);
    const double sigma = a.radius + b.radius;
    b_.set_difference(squared(sigma), a_);
    contact.overlap = 0.5 * static_cast<double>(b_) / (sigma * sigma);
    contact.separation = {static_cast<double>(r_[0]), static_cast<double>(r_[1])};
    contact.virial =
        -ContactRule::change(static_cast<double>(approach_)) / (a.inverse_mass + b.inverse_mass);
    static_assert(ContactRule::keeps_species);
    ContactRule::push(a.v, b.v, r_, a.inverse_mass, b.inverse_mass, approach_, a_, c_, b_);
    body_has_changed(a);
    body_has_changed(b);
    return true;
}

}  // namespace carom

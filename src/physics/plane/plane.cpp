#include "physics/plane/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "physics/collision/pair_collision.h"
#include "physics/plane/order_of_cells.h"

namespace carom {
namespace {

template <typename Bodies>
auto& at(Bodies& bodies, std::int32_t i) {
    return bodies[static_cast<std::size_t>(i)];
}

bool crosses_cells(const Prediction& prediction, double time) {
    return (prediction.contact_time > time) & (prediction.border >= first_cell_side);
}
int cell_side(const Prediction& prediction) { return static_cast<int>(prediction.border & 3U); }

}  // namespace

Plane::Plane(const Box& box, const Particles& particles, const Arithmetic&)
    : box_(box),
      grid_(box, particles.radius),
      properties_(particles),
      nearest_(Pairing::nearest(box)),
      only_(Pairing::shifted(0.0, 0.0)) {
    if (properties_.alike()) nearest_.sigma = only_.sigma = 2.0 * particles.radius[0];
    cell_size_ = load_two(grid_.cell_size().data());
    overhang_ = load_two(grid_.overhang().data());
    for (std::size_t a = 0; a < 2; ++a) {
        const double size = box.length(a);
        const bool periodic = box.is_periodic(a);
        last_cell_[a] = grid_.last_cell()[a];
        box_size_[a] = size;
        solid_[a] = periodic ? 0 : -1;
        has_walls_ |= !periodic;
        surely_nearest_[a] = grid_.narrow()[a] ? -1.0 : periodic ? 0.5 * size : never<double>;
    }
}

Plane::Bodies Plane::bodies_of(const Particles& particles) {
    return Bodies(static_cast<std::size_t>(particles.count()));
}

bool Plane::is_resorted(std::size_t count) { return count >= least_in_order_of_cells; }

std::vector<std::int32_t> Plane::order(const Bodies& bodies) {
    std::vector<std::int32_t> numbers = order_of_cells(grid_, bodies);
    if (is_resorted(bodies.size())) properties_.renumber(numbers);
    return numbers;
}

void Plane::enter(Bodies& bodies) {
    for (Body& body : bodies) body.cell = grid_.cell_at(body.x[0], body.x[1]);
    fill_grid(bodies);
}

void Plane::renumber(Bodies& bodies, const std::vector<std::int32_t>& before) {
    renumber_partners(bodies, before);
    fill_grid(bodies);
}

void Plane::fill_grid(const Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k)
        grid_.add(static_cast<std::int32_t>(k), properties_[k].radius, bodies[k].cell);
}

// Of the images of b the one in contact with a: the nearest, or in a narrow periodic box, where two
// may touch, the one that a approaches. False if none approaches.
inline bool Plane::separation_at_contact(const Body& a, const Body& b, double sigma, double& x,
                                         double& y) const {
    x = b.x[0] - a.x[0];
    y = b.x[1] - a.x[1];
    if (std::abs(x) <= surely_nearest_[0] && std::abs(y) <= surely_nearest_[1]) [[likely]]
        return x * (b.v[0] - a.v[0]) + y * (b.v[1] - a.v[1]) < 0.0;
    return separation_of_images(a, b, sigma, x, y);
}

bool Plane::separation_of_images(const Body& a, const Body& b, double sigma, double& x,
                                 double& y) const {
    std::array<std::array<double, 2>, 2> along{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double plain = b.x[axis] - a.x[axis];
        const double size = box_.length(axis);
        const double nearest = plain - size * box_.turns(axis, plain);
        along[axis] = {nearest, nearest > 0.0 ? nearest - size : nearest + size};
    }
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < (grid_.narrow()[0] ? 2 : 1); ++i) {
        for (std::size_t j = 0; j < (grid_.narrow()[1] ? 2 : 1); ++j) {
            const double rx = along[0][i];
            const double ry = along[1][j];
            if (!(rx * (b.v[0] - a.v[0]) + ry * (b.v[1] - a.v[1]) < 0.0)) continue;
            const double misfit = std::abs(rx * rx + ry * ry - sigma * sigma);
            if (misfit >= best) continue;
            best = misfit;
            x = rx;
            y = ry;
        }
    }
    return std::isfinite(best);
}

bool Plane::collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const {
    Body& a = bodies[static_cast<std::size_t>(i)];
    Body& b = bodies[static_cast<std::size_t>(j)];
    const Properties &first = properties_[i], &second = properties_[j];
    const double sigma = first.radius + second.radius;
    RelativeMotion<double> m{0.0, 0.0, b.v[0] - a.v[0], b.v[1] - a.v[1]};
    if (!separation_at_contact(a, b, sigma, m.x, m.y)) return false;
    const double factor = impulse_factor(m, first.inverse_mass, second.inverse_mass);
    const TwoLanes r{m.x, m.y};
    store_two(load_two(a.v.data()) + first.inverse_mass * factor * r, a.v.data());
    store_two(load_two(b.v.data()) - second.inverse_mass * factor * r, b.v.data());
    const double square = m.x * m.x + m.y * m.y;
    contact = {{m.x, m.y}, -factor * square, 0.5 * (1.0 - square / (sigma * sigma))};
    return true;
}

void Plane::cross(Bodies& bodies, std::int32_t i, int side, double now) {
    Body& body = bodies[static_cast<std::size_t>(i)];
    const Cell from = body.cell;
    body.cell = grid_.next_cell(from, side);
    if (grid_.is_last(from, side)) [[unlikely]] {
        // leaves a periodic box, and enters at the other side
        const auto axis = static_cast<std::size_t>(side / 2);
        advance_body(body, now);
        body.x[axis] += side % 2 == 1 ? -box_.length(axis) : box_.length(axis);
    }
    grid_.move(i, properties_[i].radius, from, body.cell);
}

// The contact, or the first of the borders ahead on each axis, of the cell with its overhang or of
// the box. A large disk touches the wall from several cells away.
inline double Plane::next_event(Body& d, double radius, double now,
                                const FirstContact& contact) const {
    const TwoLanes none = both(never<double>), zero{};
    const TwoLanes v = load_two(d.v.data()), x = load_two(d.x.data());
    const TwoLanes cell{static_cast<double>(d.cell[0]), static_cast<double>(d.cell[1])};
    const TwoMasks up = v > 0.0;
    TwoLanes border =
        cell_size_ * (cell + select(up, both(1.0), zero)) + select(up, overhang_, -overhang_);
    TwoMasks kind = TwoMasks{0, 2} + first_cell_side - up;
    if (has_walls_) {
        const TwoLanes wall = select(up, box_size_ - radius, both(radius));
        const TwoLanes last = select(up, last_cell_, zero);
        // both the other way round for those that go down, so that one comparison is enough
        const TwoLanes before = select(up, wall, border), behind = select(up, border, wall);
        const TwoMasks at_wall = solid_ & ((cell == last) | (before <= behind));
        border = select(at_wall, wall, border);
        kind -= at_wall & first_cell_side;
    }
    const TwoLanes ahead = (border - (x + v * (now - d.time))) / v;
    const TwoLanes time = now + select(v == 0.0, none, select(ahead > 0.0, ahead, zero));
    // all in lanes: the processor cannot predict which is first
    const TwoMasks other_first = swapped(time) < time;
    const TwoMasks first_kind = other_first ? swapped(kind) : kind;
    const TwoLanes border_time = select(other_first, swapped(time), time);
    const TwoLanes contact_time = both(contact.time);
    d.prediction = {.contact_time = contact.time,
                    .partner = contact.partner(),
                    .partner_collisions = contact.collisions() & most_collisions,
                    .border = static_cast<std::uint32_t>(first_kind[0]) & 7U};
    return select(contact_time < border_time, contact_time, border_time)[0];
}

// With the disk itself, which it never collides with; afterwards there is at least one group.
inline void Plane::fill_up_lanes(std::int32_t i) {
    for (std::size_t k = 0; k < lanes; ++k) near_[near_count_ + k] = i;
    near_count_ = std::max(lanes, (near_count_ + lanes - 1) / lanes * lanes);
}

// The first contact with one of those listed.
inline void Plane::search(const Bodies& bodies, std::int32_t i, double now, const Pairing& pairing,
                          FirstContact& first) {
    fill_up_lanes(i);
    const std::size_t count = near_count_;
    near_count_ = 0;
    std::size_t k = 0;
    do {
        search_contact(bodies, properties_, i, now, &near_[k], std::min(count - k, most_searched),
                       pairing, first);
        k += most_searched;
    } while (k < count);
}

// Of those in the cells around.
inline const Pairing& Plane::pairing_near(Cell cell) const {
    const auto inner = [&](std::size_t a) {
        return cell[a] - grid_.inner()[a].first < grid_.inner()[a].count;
    };
    return inner(0) & inner(1) ? only_ : nearest_;
}

// As it is called for every cell, of which most about a large disk are empty.
inline auto Plane::search_slots(const Bodies& bodies, std::int32_t i, double now,
                                FirstContact& first) {
    return [&, i, now](const CellGrid::Slots& slots, double shift_x, double shift_y) {
        grid_.append(slots, near_, near_count_);
        if (near_count_ == 0) return;
        search(bodies, i, now, Pairing::shifted(shift_x, shift_y), first);
    };
}

double Plane::predict(Bodies& bodies, std::int32_t i, double now) {
    Body& a = at(bodies, i);
    const double radius = properties_[i].radius;
    FirstContact first;
    if (grid_.plain(radius)) {
        grid_.append_around(a.cell, near_, near_count_);
        search(bodies, i, now, pairing_near(a.cell), first);
    } else {
        grid_.for_each_near(radius, a.cell, search_slots(bodies, i, now, first));
    }
    return next_event(a, radius, now, first);
}

// The nearest image of the other recedes, and no other image comes into question.
bool Plane::predict_both(Bodies& bodies, std::int32_t i, std::int32_t j, double now,
                         std::array<double, 2>& when) {
    Body &a = at(bodies, i), &b = at(bodies, j);
    const std::array radius{properties_[i].radius, properties_[j].radius};
    if (!grid_.plain(radius[0]) || !grid_.plain(radius[1])) return false;
    grid_.append_around(a.cell, near_, near_count_);
    fill_up_lanes(i);
    const std::size_t split = near_count_;
    grid_.append_around(b.cell, near_, near_count_);
    fill_up_lanes(j);
    const std::size_t count = near_count_;
    near_count_ = 0;
    if (count > most_searched) return false;
    const bool at_edge = pairing_near(a.cell).several_images || pairing_near(b.cell).several_images;
    std::array<FirstContact, 2> contacts;
    search_two_contacts(bodies, properties_, {i, j}, now, near_.data(), split, count,
                        at_edge ? nearest_ : only_, contacts);
    when = {next_event(a, radius[0], now, contacts[0]), next_event(b, radius[1], now, contacts[1])};
    return true;
}

double Plane::predict_after_crossing(Bodies& bodies, std::int32_t i, int side, double now) {
    Body& a = at(bodies, i);
    const double radius = properties_[i].radius;
    const Prediction& before = a.prediction;
    FirstContact first(before.contact_time, before.partner, before.partner_collisions);
    if (grid_.plain(radius)) {
        grid_.append_newly_around(a.cell, side, near_, near_count_);
        search(bodies, i, now, pairing_near(a.cell), first);
    } else {
        grid_.for_each_newly_near(radius, a.cell, side, search_slots(bodies, i, now, first));
    }
    return next_event(a, radius, now, first);
}

std::int32_t Plane::partner_ahead(const Bodies& bodies, std::int32_t i, double time) {
    const Prediction& prediction = at(bodies, i).prediction;
    const std::int32_t meets = prediction.contact_time <= time ? -1 : 0;
    return i ^ ((i ^ prediction.partner) & meets);
}

// The processor cannot predict how many are listed, so at least `usual` entries are prefetched, the
// last of them from an earlier list; more are rare.
template <std::size_t usual>
inline void Plane::fetch_listed(const Bodies& bodies) {
#pragma GCC unroll 32
    for (std::size_t k = 0; k < usual; ++k) __builtin_prefetch(&at(bodies, near_[k]));
    for (std::size_t k = usual; k < near_count_; ++k) __builtin_prefetch(&at(bodies, near_[k]));
    near_count_ = 0;
}

void Plane::fetch_disk_ahead(const Bodies& bodies, std::int32_t i) const {
    __builtin_prefetch(&at(bodies, i));
}

// Without a branch: the processor cannot predict which event comes.
void Plane::fetch_cells_ahead(const Bodies& bodies, std::int32_t i, double time) const {
    const Body& a = at(bodies, i);
    const Cell next = grid_.next_cell(a.cell, cell_side(a.prediction));
    const unsigned crosses = crosses_cells(a.prediction, time) ? ~0U : 0U;
    Cell about;
    for (std::size_t k = 0; k < 2; ++k)
        about[k] = static_cast<std::uint16_t>(a.cell[k] ^ ((a.cell[k] ^ next[k]) & crosses));
    grid_.fetch_around(about);
    grid_.fetch_around(at(bodies, partner_ahead(bodies, i, time)).cell);
}

void Plane::fetch_neighbours_ahead(const Bodies& bodies, std::int32_t i, double time) {
    if (!grid_.plain(properties_[i].radius)) return;
    const Body& a = at(bodies, i);
    if (crosses_cells(a.prediction, time)) {
        const int side = cell_side(a.prediction);
        grid_.append_newly_around(grid_.next_cell(a.cell, side), side, near_, near_count_);
        fetch_listed<4>(bodies);
    } else {
        grid_.append_around(a.cell, near_, near_count_);
        grid_.append_around(at(bodies, partner_ahead(bodies, i, time)).cell, near_, near_count_);
        fetch_listed<20>(bodies);
    }
}

}  // namespace carom

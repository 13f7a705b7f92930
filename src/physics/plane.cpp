#include "physics/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

// Only GCC takes the attribute at the definition; its resolver would run before the address
// sanitizer is ready.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CAROM_FOR_EACH_PROCESSOR __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define CAROM_FOR_EACH_PROCESSOR
#endif

namespace carom {
namespace {

// Below this number the disks fit into the processor's nearest caches in any order.
constexpr std::size_t least_sorted = 4096;

// The bits of a number, with a zero between each two.
constexpr std::uint64_t spread_bits(std::uint64_t bits) {
    bits = (bits | bits << 8) & 0x00FF00FFU;
    bits = (bits | bits << 4) & 0x0F0F0F0FU;
    bits = (bits | bits << 2) & 0x33333333U;
    return (bits | bits << 1) & 0x55555555U;
}

const Plane::Body& at(const Plane::Bodies& bodies, std::int32_t i) {
    return bodies[static_cast<std::size_t>(i)];
}

}  // namespace

Plane::Plane(const Box& box, const Eigen::ArrayXd& radii) : box_(box), grid_(box, radii) {
    const double largest = radii.size() > 0 ? radii.maxCoeff() : 0.0;
    for (int a = 0; a < 2; ++a)
        narrow_[a] = box.walls[static_cast<std::size_t>(a)] == Wall::periodic &&
                     4.0 * largest > 0.99 * box.size[a];
}

bool Plane::sorts_again(std::size_t count) { return count >= least_sorted; }

std::vector<std::int32_t> Plane::order(const Bodies& bodies) const {
    std::vector<std::int32_t> numbers(bodies.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    if (bodies.size() < least_sorted) return numbers;
    std::vector<std::uint64_t> keys(bodies.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const Cell cell = grid_.cell_at(bodies[k].x[0], bodies[k].x[1]);
        keys[k] = (spread_bits(cell.column) | spread_bits(cell.row) << 1) << 32 | k;
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t k = 0; k < keys.size(); ++k)
        numbers[k] = static_cast<std::int32_t>(keys[k] & 0xFFFFFFFFU);
    return numbers;
}

void Plane::enter(Bodies& bodies) {
    grid_.clear();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        Body& body = bodies[k];
        body.cell = grid_.cell_at(body.x[0], body.x[1]);
        grid_.add(static_cast<std::int32_t>(k), body.radius, body.cell);
    }
}

bool Plane::collide(Bodies& bodies, std::int32_t i, std::int32_t j, Contact<2>& contact) const {
    Body& a = bodies[static_cast<std::size_t>(i)];
    Body& b = bodies[static_cast<std::size_t>(j)];
    RelativeMotion<double> m{0.0, 0.0, b.v[0] - a.v[0], b.v[1] - a.v[1]};
    if (!separation_at_contact(a, b, m.x, m.y)) return false;
    const double factor = impulse_factor(m, a.inverse_mass, b.inverse_mass);
    a.v[0] += a.inverse_mass * factor * m.x;
    a.v[1] += a.inverse_mass * factor * m.y;
    b.v[0] -= b.inverse_mass * factor * m.x;
    b.v[1] -= b.inverse_mass * factor * m.y;
    const double square = m.x * m.x + m.y * m.y;
    const double sigma = a.radius + b.radius;
    contact = {{m.x, m.y}, -factor * square, 0.5 * (1.0 - square / (sigma * sigma))};
    return true;
}

// Of the images of b the one in contact with a: the nearest, or in a narrow periodic box, where two
// may touch, the one that a approaches. False if none approaches.
bool Plane::separation_at_contact(const Body& a, const Body& b, double& x, double& y) const {
    std::array<std::array<double, 2>, 2> along{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double plain = b.x[axis] - a.x[axis];
        const double size = box_.size[static_cast<Eigen::Index>(axis)];
        const double half = box_.walls[axis] == Wall::periodic ? 0.5 * size : Event::never;
        const double nearest = plain > half ? plain - size : plain < -half ? plain + size : plain;
        along[axis] = {nearest, nearest > 0.0 ? nearest - size : nearest + size};
    }
    const double sigma = a.radius + b.radius;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < (narrow_[0] ? 2 : 1); ++i) {
        for (std::size_t j = 0; j < (narrow_[1] ? 2 : 1); ++j) {
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

void Plane::cross(Bodies& bodies, std::int32_t i, int side, double now) {
    Body& body = bodies[static_cast<std::size_t>(i)];
    const Cell from = body.cell;
    const int last = (side < 2 ? grid_.columns() : grid_.rows()) - 1;
    std::uint16_t& cell = side < 2 ? body.cell.column : body.cell.row;
    const bool up = side % 2 == 1;
    if (cell != (up ? last : 0)) {
        cell = static_cast<std::uint16_t>(up ? cell + 1 : cell - 1);
    } else {  // leaves a periodic box, and enters at the other side
        body.x[0] += body.v[0] * (now - body.time);
        body.x[1] += body.v[1] * (now - body.time);
        body.time = now;
        const double size = box_.size[side / 2];
        body.x[static_cast<std::size_t>(side / 2)] += up ? -size : size;
        cell = static_cast<std::uint16_t>(up ? 0 : last);
    }
    grid_.move(i, body.radius, from, body.cell);
}

// The first of the borders ahead on each axis, of the cell or of the box; it becomes the event
// unless a contact comes first. A large disk touches the wall from several cells away.
[[gnu::always_inline]] inline void Plane::foresee_border(const Body& d, double x, double y,
                                                         double now, Event& first) const {
    const std::array<double, 2> position{x, y};
    const std::array<double, 2> cell{grid_.cell_width(), grid_.cell_height()};
    const std::array<int, 2> in{d.cell.column, d.cell.row}, cells{grid_.columns(), grid_.rows()};
    double earliest = Event::never;
    for (std::size_t a = 0; a < 2; ++a) {
        const double v = d.v[a];
        if (v == 0.0) continue;
        const int up = v > 0.0 ? 1 : 0;
        const unsigned side = 2U * static_cast<unsigned>(a) + static_cast<unsigned>(up);
        double border = cell[a] * (in[a] + up);
        unsigned kind = first_cell_side + side;
        if (box_.walls[a] == Wall::solid) {
            const double size = box_.size[static_cast<Eigen::Index>(a)];
            const double wall = up ? size - d.radius : d.radius;
            if (in[a] == (up ? cells[a] - 1 : 0) || (up ? wall <= border : wall >= border)) {
                border = wall;
                kind = side;
            }
        }
        const double time = now + wall_time(position[a], v, border, border);
        if (time >= earliest) continue;
        earliest = time;
        first.border = kind & 7U;
    }
    first.time = std::min(earliest, first.contact_time);
}

Event Plane::foresee(const Bodies& bodies, std::int32_t i, double now, const EventQueue&) {
    const Body& a = at(bodies, i);
    near_.clear();
    grid_.for_each_near(a.radius, a.cell, [&](std::int32_t other, double sx, double sy) {
        note_near(bodies, i, other, sx, sy);
    });
    return first_event(bodies, a, now, Event{});
}

Event Plane::foresee_after_crossing(const Bodies& bodies, std::int32_t i, int side,
                                    const Event& before, double now, const EventQueue&) {
    const Body& a = at(bodies, i);
    near_.clear();
    grid_.for_each_newly_near(
        a.radius, a.cell, side,
        [&](std::int32_t other, double sx, double sy) { note_near(bodies, i, other, sx, sy); });
    return first_event(bodies, a, now, before);
}

// Fetched while the others are listed.
inline void Plane::note_near(const Bodies& bodies, std::int32_t i, std::int32_t other, double sx,
                             double sy) {
    if (other == i) return;
    __builtin_prefetch(&at(bodies, other));
    near_.push_back({other, sx, sy});
    if (near_.size() > suitors_.size()) suitors_.resize(2 * near_.size());
}

// Of equal times the lowest number counts.
[[gnu::always_inline]] inline void Plane::consider(const Bodies& bodies, const Body& a,
                                                   const Suitor& s, double now,
                                                   Event& first) const {
    if (touch_after(s.motion, s.sigma, first.contact_time - now)) return;
    const double time = now + time_of_contact(s.motion, s.sigma);
    if (time > first.contact_time || (time == first.contact_time && s.other >= first.partner))
        return;
    const Body& b = at(bodies, s.other);
    if (!(a.inverse_mass + b.inverse_mass > 0.0) || !(s.sigma > 0.0)) return;
    first.contact_time = time;
    first.partner = s.other;
    first.partner_collisions = b.collisions & most_collisions;
}

// Most of the disks near are told off without a branch that the processor could not foretell.
CAROM_FOR_EACH_PROCESSOR
Event Plane::first_event(const Bodies& bodies, const Body& a, double now, Event first) {
    const double x = a.x[0] + a.v[0] * (now - a.time);
    const double y = a.x[1] + a.v[1] * (now - a.time);
    Suitor* last = suitors_.data();
    for (const Near& near : near_) {
        const Body& b = at(bodies, near.other);
        const double age = now - b.time;
        const RelativeMotion<double> m{(b.x[0] + b.v[0] * age) + near.shift_x - x,
                                       (b.x[1] + b.v[1] * age) + near.shift_y - y, b.v[0] - a.v[0],
                                       b.v[1] - a.v[1]};
        const double sigma = a.radius + b.radius;
        *last = {m, sigma, near.other};
        last += may_touch(m, sigma, approach_round_off(m, a.v[0], a.v[1], b.v[0], b.v[1])) ? 1 : 0;
    }
    for (const Suitor* s = suitors_.data(); s != last; ++s) consider(bodies, a, *s, now, first);
    foresee_border(a, x, y, now, first);
    return first;
}

}  // namespace carom

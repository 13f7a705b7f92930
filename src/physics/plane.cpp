#include "physics/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
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

constexpr double epsilon = std::numeric_limits<double>::epsilon();

const Plane::Body& at(const Plane::Bodies& bodies, std::int32_t i) {
    return bodies[static_cast<std::size_t>(i)];
}

// Lanes are handed on between inlined functions only, where no calling convention matters.
#pragma GCC diagnostic ignored "-Wpsabi"

// Four disks at once. The compiler makes of it what the processor has; each lane is the same
// arithmetic as for one disk.
constexpr std::size_t lanes = 4;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));
using LaneMask = std::int64_t __attribute__((vector_size(lanes * sizeof(std::int64_t))));

// Brings the least value and its place into lane 0.
[[gnu::always_inline]] inline void fold_in_half(Lanes& least, LaneMask& place) {
    const Lanes far = __builtin_shufflevector(least, least, 2, 3, 0, 1);
    const LaneMask far_place = __builtin_shufflevector(place, place, 2, 3, 0, 1);
    LaneMask less = far < least;
    least = less ? far : least;
    place = less ? far_place : place;
    const Lanes next = __builtin_shufflevector(least, least, 1, 0, 3, 2);
    const LaneMask next_place = __builtin_shufflevector(place, place, 1, 0, 3, 2);
    less = next < least;
    least = less ? next : least;
    place = less ? next_place : place;
}

}  // namespace

// A disk as it is now.
struct Plane::Viewer {
    double x, y, vx, vy, radius, inverse_mass, now;
};

Plane::Plane(const Box& box, const Eigen::ArrayXd& radii) : box_(box), grid_(box, radii) {
    const double largest = radii.size() > 0 ? radii.maxCoeff() : 0.0;
    cell_size_ = {grid_.cell_width(), grid_.cell_height()};
    last_cell_ = {grid_.columns() - 1, grid_.rows() - 1};
    for (std::size_t a = 0; a < 2; ++a) {
        const double size = box.size[static_cast<Eigen::Index>(a)];
        const bool periodic = box.walls[a] == Wall::periodic;
        narrow_[a] = periodic && 4.0 * largest > 0.99 * size;
        surely_nearest_[a] = narrow_[a] ? -1.0 : periodic ? 0.5 * size : Event::never;
    }
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
    x = b.x[0] - a.x[0];
    y = b.x[1] - a.x[1];
    if (std::abs(x) <= surely_nearest_[0] && std::abs(y) <= surely_nearest_[1])
        return x * (b.v[0] - a.v[0]) + y * (b.v[1] - a.v[1]) < 0.0;
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
    std::array<double, 2> time;
    std::array<unsigned, 2> kind;
    for (std::size_t a = 0; a < 2; ++a) {
        const int in = a == 0 ? d.cell.column : d.cell.row;
        const int up = d.v[a] > 0.0 ? 1 : 0;
        const unsigned side = 2U * static_cast<unsigned>(a) + static_cast<unsigned>(up);
        double border = cell_size_[a] * (in + up);
        kind[a] = first_cell_side + side;
        if (box_.walls[a] == Wall::solid) {
            const double size = box_.size[static_cast<Eigen::Index>(a)];
            const double wall = up ? size - d.radius : d.radius;
            if (in == (up ? last_cell_[a] : 0) || (up ? wall <= border : wall >= border)) {
                border = wall;
                kind[a] = side;
            }
        }
        time[a] = now + wall_time(position[a], d.v[a], border, border);
    }
    const std::size_t a = time[1] < time[0] ? 1 : 0;
    first.border = kind[a] & 7U;
    first.time = std::min(time[a], first.contact_time);
}

// The disk itself, which it never meets, fills up each group to whole lanes.
inline void Plane::end_group(std::int32_t i) {
    for (std::size_t k = 0; k + 1 < lanes; ++k) near_[near_count_ + k] = i;
    near_count_ = (near_count_ + lanes - 1) / lanes * lanes;
    groups_.back().end = near_count_;
}

inline void Plane::list(std::int32_t i, const CellGrid::Slots& slots, double shift_x,
                        double shift_y) {
    if (shift_x != groups_.back().shift_x || shift_y != groups_.back().shift_y) {
        end_group(i);
        groups_.push_back({0, shift_x, shift_y});
    }
    if (near_.size() < near_count_ + CellGrid::spare) near_.resize(2 * near_.size());
    grid_.append(slots, near_, near_count_);
}

inline void Plane::begin_list() {
    near_count_ = 0;
    groups_.assign(1, {0, 0.0, 0.0});
}

void Plane::list_near(const Bodies& bodies, std::int32_t i) {
    const Body& a = at(bodies, i);
    begin_list();
    if (!grid_.append_around(a.radius, a.cell, near_, near_count_))
        grid_.for_each_near(a.radius, a.cell,
                            [=, this](const CellGrid::Slots& slots, double shift_x,
                                      double shift_y) { list(i, slots, shift_x, shift_y); });
    end_group(i);
}

Event Plane::foresee(const Bodies& bodies, std::int32_t i, double now, const EventQueue& queue) {
    list_near(bodies, i);
    return first_event(bodies, i, now, Event{}, queue);
}

Event Plane::foresee_after_crossing(const Bodies& bodies, std::int32_t i, int side,
                                    const Event& before, double now, const EventQueue& queue) {
    const Body& a = at(bodies, i);
    begin_list();
    grid_.for_each_newly_near(a.radius, a.cell, side,
                              [=, this](const CellGrid::Slots& slots, double shift_x,
                                        double shift_y) { list(i, slots, shift_x, shift_y); });
    end_group(i);
    return first_event(bodies, i, now, before, queue);
}

void Plane::fetch_bodies_ahead(const Bodies& bodies, std::int32_t i) {
    const Body& a = at(bodies, i);
    near_count_ = 0;
    if (!grid_.append_around(a.radius, a.cell, near_, near_count_)) return;
    for (std::size_t k = 0; k < near_count_; ++k) __builtin_prefetch(&at(bodies, near_[k]));
}

// The exact time of the contact with the k-th of those near, if it comes before what is known. A
// contact with a disk that will itself look for contacts before is left to it. Of equal times the
// lowest number counts.
[[gnu::always_inline]] inline void Plane::consider(const Bodies& bodies, const Viewer& a,
                                                   std::size_t k, const EventQueue& queue,
                                                   Event& first) const {
    std::size_t g = 0;
    while (k >= groups_[g].end) ++g;
    const Group& group = groups_[g];
    const std::int32_t other = near_[k];
    const Body& b = at(bodies, other);
    const double age = a.now - b.time;
    const RelativeMotion<double> m{(b.x[0] + b.v[0] * age) + group.shift_x - a.x,
                                   (b.x[1] + b.v[1] * age) + group.shift_y - a.y, b.v[0] - a.vx,
                                   b.v[1] - a.vy};
    const double sigma = a.radius + b.radius;
    const double round_off = approach_round_off(m, a.vx, a.vy, b.v[0], b.v[1]);
    const double time = a.now + contact_time(m, sigma, round_off);
    if (time > first.contact_time || (time == first.contact_time && other >= first.partner) ||
        time > queue.event(other).contact_time)
        return;
    if (!(a.inverse_mass + b.inverse_mass > 0.0) || !(sigma > 0.0)) return;
    first.contact_time = time;
    first.partner = other;
    first.partner_collisions = b.collisions & most_collisions;
}

// For four disks a time before which they certainly are not touched, counted from now; never for
// those that recede or pass wide.
template <typename Viewer, typename Group>
[[gnu::always_inline]] inline Lanes earliest_contacts(const Viewer& a, const Plane::Body* bodies,
                                                      const std::int32_t* near,
                                                      const Group& group) {
    const Plane::Body &b0 = bodies[near[0]], &b1 = bodies[near[1]], &b2 = bodies[near[2]],
                      &b3 = bodies[near[3]];
    const Lanes vx = {b0.v[0], b1.v[0], b2.v[0], b3.v[0]};
    const Lanes vy = {b0.v[1], b1.v[1], b2.v[1], b3.v[1]};
    const Lanes age = a.now - Lanes{b0.time, b1.time, b2.time, b3.time};
    const Lanes x = (Lanes{b0.x[0], b1.x[0], b2.x[0], b3.x[0]} + vx * age) + group.shift_x - a.x;
    const Lanes y = (Lanes{b0.x[1], b1.x[1], b2.x[1], b3.x[1]} + vy * age) + group.shift_y - a.y;
    const Lanes sigma = Lanes{b0.radius, b1.radius, b2.radius, b3.radius} + a.radius;
    const auto look = quick_look(RelativeMotion<Lanes>{x, y, vx - a.vx, vy - a.vy}, sigma);
    const LaneMask meet = (look.approach > 0.0) & (look.slack >= 0.0);
    const Lanes slack = meet ? look.slack : Lanes{};
    Lanes root;
    for (std::size_t lane = 0; lane < lanes; ++lane) root[lane] = std::sqrt(slack[lane]);
    const Lanes time = look.gap / (look.approach + root);
    return meet ? time : Lanes{} + Event::never;
}

// Fills earliest_ for all in near_; tells the place of the least, and the least of the others.
[[gnu::always_inline]] inline std::size_t Plane::estimate_times(const Bodies& bodies,
                                                                const Viewer& a, double& second) {
    if (earliest_.size() < near_count_) earliest_.resize(near_.size());
    Lanes least = Lanes{} + Event::never;
    Lanes others = least;
    LaneMask least_at{};
    std::size_t k = 0;
    for (const Group& group : groups_)
        for (; k < group.end; k += lanes) {
            const Lanes time = earliest_contacts(a, bodies.data(), &near_[k], group);
            std::memcpy(&earliest_[k], &time, sizeof time);
            const LaneMask less = time < least;
            const Lanes later = less ? least : time;
            others = later < others ? later : others;
            least = less ? time : least;
            least_at = less ? LaneMask{0, 1, 2, 3} + static_cast<std::int64_t>(k) : least_at;
        }
    const Lanes of_lanes = least;
    fold_in_half(least, least_at);
    const auto best = static_cast<std::size_t>(least_at[0]);
    second = Event::never;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const double its = lane == best % lanes ? Event::never : of_lanes[lane];
        second = std::min(second, std::min(its, others[lane]));
    }
    return best;
}

// How long from now a contact may come to be the first, as far as rounding can make times equal.
inline double last_chance(const Event& first, double now) {
    const double bound = (first.contact_time - now) + 4.0 * epsilon * first.contact_time;
    return std::min(bound, std::numeric_limits<double>::max());
}

// The place of the disk that might be met first, and not after `bound`, or near_count_.
std::size_t Plane::next_suitor(double bound) const {
    std::size_t best = near_count_;
    for (std::size_t k = 0; k < near_count_; ++k)
        if (earliest_[k] <= bound) {
            bound = earliest_[k];
            best = k;
        }
    return best;
}

// The exact time is solved for only while a disk might be the first.
CAROM_FOR_EACH_PROCESSOR
Event Plane::first_event(const Bodies& bodies, std::int32_t i, double now, Event first,
                         const EventQueue& queue) {
    const Body& body = at(bodies, i);
    const Viewer a{body.x[0] + body.v[0] * (now - body.time),
                   body.x[1] + body.v[1] * (now - body.time),
                   body.v[0],
                   body.v[1],
                   body.radius,
                   body.inverse_mass,
                   now};
    if (near_count_ > 0) {
        double second;
        std::size_t best = estimate_times(bodies, a, second);
        if (earliest_[best] <= last_chance(first, now)) {
            consider(bodies, a, best, queue, first);
            earliest_[best] = Event::never;
        }
        while (second <= last_chance(first, now)) {
            best = next_suitor(last_chance(first, now));
            if (best == near_count_) break;
            consider(bodies, a, best, queue, first);
            earliest_[best] = Event::never;
        }
    }
    foresee_border(body, a.x, a.y, now, first);
    return first;
}

}  // namespace carom

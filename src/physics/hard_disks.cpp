#include "physics/hard_disks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "util/interrupt.h"

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

// Borders: the sides of the box are 0 to 3, those of a cell 4 to 7.
constexpr unsigned first_cell_side = 4;

// Collision counts are compared modulo 2^29: an event has that many bits for them.
constexpr std::uint32_t most_collisions = (1U << 29) - 1U;

// Below this number the disks fit into the processor's nearest caches in any order.
constexpr std::size_t least_sorted = 4096;

// A lap is one or two collisions of each disk; it takes some tens for neighbours to part.
constexpr int laps_between_sorts = 20;

// The bits of a number, with a zero between each two.
constexpr std::uint64_t spread_bits(std::uint64_t bits) {
    bits = (bits | bits << 8) & 0x00FF00FFU;
    bits = (bits | bits << 4) & 0x0F0F0F0FU;
    bits = (bits | bits << 2) & 0x33333333U;
    return (bits | bits << 1) & 0x55555555U;
}

double wrapped(double x, double length) {
    const double inside = x - length * std::floor(x / length);
    return inside < length ? inside : 0.0;
}

}  // namespace

HardDisks::HardDisks(const Box& box, const Particles& particles)
    : box_(box),
      disks_(static_cast<std::size_t>(particles.count())),
      grid_(box, particles.radius),
      queue_(static_cast<std::int32_t>(particles.count())) {
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        number_.push_back(static_cast<std::int32_t>(i));
        disks_[i].radius = particles.radius[static_cast<Eigen::Index>(i)];
        disks_[i].inverse_mass = particles.inverse_mass[static_cast<Eigen::Index>(i)];
    }
    const double largest = disks_.empty() ? 0.0 : particles.radius.maxCoeff();
    for (int a = 0; a < 2; ++a)
        narrow_[a] = box.walls[static_cast<std::size_t>(a)] == Wall::periodic &&
                     4.0 * largest > 0.99 * box.size[a];
}

void HardDisks::forget() {
    counts_ = {};
    transfers_ = {};
}

void HardDisks::start(const Sample& state) {
    clock_ = LocalClock(state.time);
    now_ = 0.0;
    const auto inside = [this](double x, int axis) {
        return box_.walls[static_cast<std::size_t>(axis)] == Wall::periodic
                   ? wrapped(x, box_.size[axis])
                   : x;
    };
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        Disk& d = disks_[k];
        d.x = inside(state.position(number_[k], 0), 0);
        d.y = inside(state.position(number_[k], 1), 1);
        d.vx = state.velocity(number_[k], 0);
        d.vy = state.velocity(number_[k], 1);
        d.time = 0.0;
        d.cell = grid_.cell_at(d.x, d.y);
    }
    sort_along_curve();
    foresee_all();
}

// Disks near each other in the box come near each other in memory, along a Z-curve through the
// cells. Few disks stay in the order in which they are listed: they fit into the cache anyhow.
void HardDisks::sort_along_curve() {
    laps_since_sorted_ = 0;
    if (disks_.size() < least_sorted) return;
    std::vector<std::uint64_t> keys(disks_.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const Cell cell = disks_[k].cell;
        keys[k] = (spread_bits(cell.column) | spread_bits(cell.row) << 1) << 32 | k;
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Disk> disks(disks_.size());
    std::vector<std::int32_t> number(number_.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        disks[k] = disks_[keys[k] & 0xFFFFFFFFU];
        number[k] = number_[keys[k] & 0xFFFFFFFFU];
    }
    disks_.swap(disks);
    number_.swap(number);
}

// All disks are at local time 0.
void HardDisks::foresee_all() {
    last_collision_ = -1.0;
    at_one_instant_ = 0;
    grid_.clear();
    const auto count = static_cast<std::int32_t>(disks_.size());
    for (std::int32_t i = 0; i < count; ++i) {
        disk(i).collisions = 0;
        grid_.add(i, disk(i).radius, disk(i).cell);
    }
    std::vector<Event> events(disks_.size());
    for (std::int32_t i = 0; i < count; ++i) events[static_cast<std::size_t>(i)] = foresee(i);
    queue_.reset(events);
}

// At the time of the last event, which becomes the epoch.
void HardDisks::sort_again() {
    for (Disk& d : disks_) {
        fly_to_now(d);
        d.time = 0.0;
    }
    clock_.advance(now_);
    now_ = 0.0;
    sort_along_curve();
    foresee_all();
}

void HardDisks::advance(double time, std::vector<Collision>* record) {
    constexpr int events_between_looks = 4096;
    int until_look = events_between_looks;
    Collision collision;
    while (true) {
        const std::int32_t particle = next_particle();
        if (particle < 0 || !(queue_.event(particle).time <= clock_.local(time))) break;
        if (process(particle, record ? &collision : nullptr) && record)
            record->push_back(collision);
        if (--until_look == 0) {
            throw_if_interrupted();
            until_look = events_between_looks;
        }
    }
}

bool HardDisks::advance_one(double time, Collision& collision) {
    while (true) {
        const std::int32_t particle = next_particle();
        if (particle < 0 || !(queue_.event(particle).time <= clock_.local(time))) return false;
        if (process(particle, &collision)) return true;
    }
}

void HardDisks::sample(double time, Sample& state) const {
    const auto count = static_cast<Eigen::Index>(disks_.size());
    state.time = time;
    state.position.resize(count, 2);
    state.velocity.resize(count, 2);
    const double local = clock_.local(time);
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        const Disk& d = disks_[k];
        const Eigen::Index i = number_[k];
        state.position(i, 0) = d.x + d.vx * (local - d.time);
        state.position(i, 1) = d.y + d.vy * (local - d.time);
        state.velocity(i, 0) = d.vx;
        state.velocity(i, 1) = d.vy;
        for (int a = 0; a < 2; ++a)
            if (box_.walls[static_cast<std::size_t>(a)] == Wall::periodic)
                state.position(i, a) = wrapped(state.position(i, a), box_.size[a]);
    }
}

// The particle with the earliest event, -1 when nothing will ever happen. Between laps all times
// are counted from a new epoch, so that they stay small (a whole number of laps: exact).
std::int32_t HardDisks::next_particle() {
    while (true) {
        const std::int32_t particle = queue_.earliest();
        if (particle >= 0) return particle;
        const double shift = queue_.next_lap();
        if (!std::isfinite(shift)) return -1;
        queue_.begin_lap(shift);
        clock_.advance(shift);
        now_ -= shift;
        last_collision_ -= shift;
        for (Disk& d : disks_) d.time -= shift;
        if (++laps_since_sorted_ == laps_between_sorts && disks_.size() >= least_sorted)
            sort_again();
    }
}

// True if it was a collision, which is then told unless `collision` is null.
bool HardDisks::process(std::int32_t particle, Collision* collision) {
    const Event event = queue_.event(particle);
    if (event.time > now_)
        at_one_instant_ = 0;
    else
        refuse_to_stall();
    now_ = event.time;
    if (event.contact_time <= event.time) {
        if ((disk(event.partner).collisions & most_collisions) == event.partner_collisions &&
            collide(particle, event.partner, collision)) {
            queue_.schedule(particle, foresee(particle));
            queue_.schedule(event.partner, foresee(event.partner));
            return true;
        }
        queue_.schedule(particle, foresee(particle));
        return false;
    }
    if (event.border < first_cell_side) {
        bounce(particle, static_cast<int>(event.border), collision);
        queue_.schedule(particle, foresee(particle));
        return true;
    }
    const int side = static_cast<int>(event.border - first_cell_side);
    cross(particle, side);
    queue_.schedule(particle, foresee_after_crossing(particle, side, event));
    return false;
}

// Touching starts take some events at time 0, but far fewer than this.
void HardDisks::refuse_to_stall() {
    const auto bound = 1'000'000 + 100 * static_cast<std::int64_t>(disks_.size());
    if (++at_one_instant_ <= bound) return;
    throw std::runtime_error(
        fmt::format("disks collide without end at t = {:g}: they fill the box along a line, or are "
                    "crushed between infinite masses",
                    clock_.absolute(now_)));
}

void HardDisks::fly_to_now(Disk& d) const {
    d.x += d.vx * (now_ - d.time);
    d.y += d.vy * (now_ - d.time);
    d.time = now_;
}

bool HardDisks::collide(std::int32_t first, std::int32_t second, Collision* collision) {
    Disk& a = disk(first);
    Disk& b = disk(second);
    fly_to_now(a);
    fly_to_now(b);
    RelativeMotion<double> m{0.0, 0.0, b.vx - a.vx, b.vy - a.vy};
    if (!separation_at_contact(a, b, m.x, m.y)) return false;
    const double factor = impulse_factor(m, a.inverse_mass, b.inverse_mass);
    a.vx += a.inverse_mass * factor * m.x;
    a.vy += a.inverse_mass * factor * m.y;
    b.vx -= b.inverse_mass * factor * m.x;
    b.vy -= b.inverse_mass * factor * m.y;
    ++a.collisions;
    ++b.collisions;
    ++counts_.particle;
    const double square = m.x * m.x + m.y * m.y;
    const double square_sigma = (a.radius + b.radius) * (a.radius + b.radius);
    transfers_.virial -= factor * square;
    transfers_.largest_overlap =
        std::max(transfers_.largest_overlap, 0.5 * (1.0 - square / square_sigma));
    count_tie(first, second);
    if (collision)
        *collision = {clock_.absolute(now_),
                      number_of(first),
                      number_of(second),
                      {a.x, a.y},
                      {a.x + m.x, a.y + m.y}};
    return true;
}

// Of the images of b the one in contact with a: the nearest, or in a narrow periodic box, where two
// may touch, the one that a approaches. False if none approaches (a graze, by round-off).
bool HardDisks::separation_at_contact(const Disk& a, const Disk& b, double& x, double& y) const {
    std::array<std::array<double, 2>, 2> along{};
    const std::array<double, 2> plain{b.x - a.x, b.y - a.y};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double size = box_.size[static_cast<Eigen::Index>(axis)];
        const double half = box_.walls[axis] == Wall::periodic ? 0.5 * size : Event::never;
        const double nearest = plain[axis] > half    ? plain[axis] - size
                               : plain[axis] < -half ? plain[axis] + size
                                                     : plain[axis];
        along[axis] = {nearest, nearest > 0.0 ? nearest - size : nearest + size};
    }
    const double sigma = a.radius + b.radius;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < (narrow_[0] ? 2 : 1); ++i) {
        for (std::size_t j = 0; j < (narrow_[1] ? 2 : 1); ++j) {
            const double rx = along[0][i];
            const double ry = along[1][j];
            if (!(rx * (b.vx - a.vx) + ry * (b.vy - a.vy) < 0.0)) continue;
            const double misfit = std::abs(rx * rx + ry * ry - sigma * sigma);
            if (misfit >= best) continue;
            best = misfit;
            x = rx;
            y = ry;
        }
    }
    return std::isfinite(best);
}

void HardDisks::count_tie(std::int32_t first, std::int32_t second) {
    const auto was_in_last = [this](std::int32_t i) {
        return i == last_pair_[0] || i == last_pair_[1];
    };
    if (now_ == last_collision_ && (was_in_last(first) || was_in_last(second))) ++counts_.ties;
    last_collision_ = now_;
    last_pair_[0] = first;
    last_pair_[1] = second;
}

void HardDisks::bounce(std::int32_t particle, std::int32_t side, Collision* collision) {
    Disk& d = disk(particle);
    fly_to_now(d);
    double& v = side < 2 ? d.vx : d.vy;
    transfers_.wall[static_cast<std::size_t>(side)] += 2.0 * std::abs(v) / d.inverse_mass;
    v = -v;
    ++d.collisions;
    ++counts_.wall;
    if (!collision) return;
    Eigen::Array2d contact(d.x, d.y);
    contact[side / 2] = side % 2 == 0 ? 0.0 : box_.size[side / 2];
    *collision = {clock_.absolute(now_), number_of(particle), -1 - side, {d.x, d.y}, contact};
}

void HardDisks::cross(std::int32_t particle, std::int32_t side) {
    Disk& d = disk(particle);
    const Cell from = d.cell;
    const int last = (side < 2 ? grid_.columns() : grid_.rows()) - 1;
    std::uint16_t& cell = side < 2 ? d.cell.column : d.cell.row;
    const bool up = side % 2 == 1;
    if (cell != (up ? last : 0)) {
        cell = static_cast<std::uint16_t>(up ? cell + 1 : cell - 1);
    } else {  // leaves a periodic box, and enters at the other side
        fly_to_now(d);
        const double size = box_.size[side / 2];
        (side < 2 ? d.x : d.y) += up ? -size : size;
        cell = static_cast<std::uint16_t>(up ? 0 : last);
    }
    grid_.move(particle, d.radius, from, d.cell);
}

// The first of the borders ahead on each axis, of the cell or of the box; it becomes the event
// unless a contact comes first. A large disk touches the wall from several cells away.
[[gnu::always_inline]] inline void HardDisks::foresee_border(const Disk& d, double x, double y,
                                                             Event& first) const {
    const std::array<double, 2> position{x, y}, velocity{d.vx, d.vy};
    const std::array<double, 2> cell{grid_.cell_width(), grid_.cell_height()};
    const std::array<int, 2> at{d.cell.column, d.cell.row}, cells{grid_.columns(), grid_.rows()};
    double earliest = Event::never;
    for (std::size_t a = 0; a < 2; ++a) {
        const double v = velocity[a];
        if (v == 0.0) continue;
        const int up = v > 0.0 ? 1 : 0;
        const unsigned side = 2U * static_cast<unsigned>(a) + static_cast<unsigned>(up);
        double border = cell[a] * (at[a] + up);
        unsigned kind = first_cell_side + side;
        if (box_.walls[a] == Wall::solid) {
            const double size = box_.size[static_cast<Eigen::Index>(a)];
            const double wall = up ? size - d.radius : d.radius;
            if (at[a] == (up ? cells[a] - 1 : 0) || (up ? wall <= border : wall >= border)) {
                border = wall;
                kind = side;
            }
        }
        const double time = now_ + wall_time(position[a], v, border, border);
        if (time >= earliest) continue;
        earliest = time;
        first.border = kind & 7U;
    }
    first.time = std::min(earliest, first.contact_time);
}

Event HardDisks::foresee(std::int32_t particle) {
    const Disk& a = disk(particle);
    near_.clear();
    grid_.for_each_near(a.radius, a.cell, [&](std::int32_t other, double sx, double sy) {
        note_near(particle, other, sx, sy);
    });
    return first_event(a, Event{});
}

Event HardDisks::foresee_after_crossing(std::int32_t particle, int side, const Event& before) {
    const Disk& a = disk(particle);
    near_.clear();
    grid_.for_each_newly_near(
        a.radius, a.cell, side,
        [&](std::int32_t other, double sx, double sy) { note_near(particle, other, sx, sy); });
    return first_event(a, before);
}

// Fetched while the others are listed.
inline void HardDisks::note_near(std::int32_t particle, std::int32_t other, double sx, double sy) {
    if (other == particle) return;
    __builtin_prefetch(&disk(other));
    near_.push_back({other, sx, sy});
    if (near_.size() > suitors_.size()) suitors_.resize(2 * near_.size());
}

// Of equal times the lowest number counts.
[[gnu::always_inline]] inline void HardDisks::consider(const Disk& a, const Suitor& s,
                                                       Event& first) const {
    if (touch_after(s.motion, s.sigma, first.contact_time - now_)) return;
    const double time = now_ + time_of_contact(s.motion, s.sigma);
    if (time > first.contact_time || (time == first.contact_time && s.other >= first.partner))
        return;
    const Disk& b = disk(s.other);
    if (!(a.inverse_mass + b.inverse_mass > 0.0) || !(s.sigma > 0.0)) return;
    first.contact_time = time;
    first.partner = s.other;
    first.partner_collisions = b.collisions & most_collisions;
}

// Most of the disks near are told off without a branch that the processor could not foretell.
CAROM_FOR_EACH_PROCESSOR
Event HardDisks::first_event(const Disk& a, Event first) {
    const double x = a.x + a.vx * (now_ - a.time);
    const double y = a.y + a.vy * (now_ - a.time);
    Suitor* last = suitors_.data();
    for (const Near& near : near_) {
        const Disk& b = disk(near.other);
        const double age = now_ - b.time;
        const RelativeMotion<double> m{(b.x + b.vx * age) + near.shift_x - x,
                                       (b.y + b.vy * age) + near.shift_y - y, b.vx - a.vx,
                                       b.vy - a.vy};
        const double sigma = a.radius + b.radius;
        *last = {m, sigma, near.other};
        last += may_touch(m, sigma, approach_round_off(m, a.vx, a.vy, b.vx, b.vy)) ? 1 : 0;
    }
    for (const Suitor* s = suitors_.data(); s != last; ++s) consider(a, *s, first);
    foresee_border(a, x, y, first);
    return first;
}

}  // namespace carom

#include "physics/hard_disks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "physics/pair_collision.h"
#include "util/interrupt.h"

namespace carom {
namespace {

// Partners that are no particles: the sides of the box are -1 to -4, the sides of a cell -5 to -8.
constexpr std::int32_t first_cell_side = -5;

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
        disks_[i].radius = particles.radius[static_cast<Eigen::Index>(i)];
        disks_[i].inverse_mass = particles.inverse_mass[static_cast<Eigen::Index>(i)];
    }
    const double largest = disks_.empty() ? 0.0 : particles.radius.maxCoeff();
    for (int a = 0; a < 2; ++a)
        narrow_[a] = box.walls[static_cast<std::size_t>(a)] == Wall::periodic &&
                     4.0 * largest > 0.99 * box.size[a];
}

void HardDisks::start(const Sample& state) {
    clock_ = LocalClock(state.time);
    now_ = 0.0;
    last_collision_ = -1.0;
    at_one_instant_ = 0;
    grid_.clear();
    const auto inside = [this](double x, int axis) {
        return box_.walls[static_cast<std::size_t>(axis)] == Wall::periodic
                   ? wrapped(x, box_.size[axis])
                   : x;
    };
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(disks_.size()); ++i) {
        Disk& d = disk(i);
        d.x = inside(state.position(i, 0), 0);
        d.y = inside(state.position(i, 1), 1);
        d.vx = state.velocity(i, 0);
        d.vy = state.velocity(i, 1);
        d.time = 0.0;
        d.collisions = 0;
        d.cell = grid_.cell_at(d.x, d.y);
        grid_.add(i, d.radius, d.cell);
    }
    std::vector<Event> events(disks_.size());
    for (std::size_t i = 0; i < events.size(); ++i) events[i] = foresee(static_cast<int>(i));
    queue_.reset(events);
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
    for (Eigen::Index i = 0; i < count; ++i) {
        const Disk& d = disks_[static_cast<std::size_t>(i)];
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
    if (event.partner >= 0) {
        if (disk(event.partner).collisions == event.partner_collisions &&
            collide(particle, event.partner, collision)) {
            queue_.schedule(particle, foresee(particle));
            queue_.schedule(event.partner, foresee(event.partner));
            return true;
        }
        queue_.schedule(particle, foresee(particle));
        return false;
    }
    const bool wall = event.partner > first_cell_side;
    if (wall)
        bounce(particle, -1 - event.partner, collision);
    else
        cross(particle, first_cell_side - event.partner);
    queue_.schedule(particle, foresee(particle));
    return wall;
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
    count_tie(first, second);
    if (collision)
        *collision = {clock_.absolute(now_), first, second, {a.x, a.y}, {a.x + m.x, a.y + m.y}};
    return true;
}

// Of the images of b the one in contact with a: the nearest, or in a narrow periodic box, where two
// may touch, the one that a approaches. False if none approaches (a graze, by round-off).
bool HardDisks::separation_at_contact(const Disk& a, const Disk& b, double& x, double& y) const {
    std::array<std::array<double, 2>, 2> along{};
    const std::array<double, 2> plain{b.x - a.x, b.y - a.y};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double size = box_.size[static_cast<Eigen::Index>(axis)];
        const bool periodic = box_.walls[axis] == Wall::periodic;
        const double nearest =
            periodic ? plain[axis] - size * std::round(plain[axis] / size) : plain[axis];
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
    v = -v;
    ++d.collisions;
    ++counts_.wall;
    if (!collision) return;
    Eigen::Array2d contact(d.x, d.y);
    contact[side / 2] = side % 2 == 0 ? 0.0 : box_.size[side / 2];
    *collision = {clock_.absolute(now_), particle, -1 - side, {d.x, d.y}, contact};
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

// The first of the borders ahead on each axis, of the cell or of the box. A large disk touches the
// wall from several cells away.
Event HardDisks::next_border(const Disk& d, double x, double y) const {
    Event first;
    const std::array<double, 2> position{x, y}, velocity{d.vx, d.vy};
    const std::array<double, 2> cell{grid_.cell_width(), grid_.cell_height()};
    const std::array<int, 2> at{d.cell.column, d.cell.row}, cells{grid_.columns(), grid_.rows()};
    for (std::size_t a = 0; a < 2; ++a) {
        const double v = velocity[a];
        if (v == 0.0) continue;
        const int up = v > 0.0 ? 1 : 0;
        const auto side = 2 * static_cast<std::int32_t>(a) + up;
        const double size = box_.size[static_cast<Eigen::Index>(a)];
        double border = cell[a] * (at[a] + up);
        std::int32_t partner = first_cell_side - side;
        if (box_.walls[a] == Wall::solid) {
            const double wall = up ? size - d.radius : d.radius;
            if (at[a] == (up ? cells[a] - 1 : 0) || (up ? wall <= border : wall >= border)) {
                border = wall;
                partner = -1 - side;
            }
        }
        const double time = now_ + wall_time(position[a], v, border, border);
        if (time < first.time) first = {time, partner, 0};
    }
    return first;
}

Event HardDisks::foresee(std::int32_t particle) const {
    const Disk& a = disk(particle);
    const double x = a.x + a.vx * (now_ - a.time);
    const double y = a.y + a.vy * (now_ - a.time);
    Event first = next_border(a, x, y);
    grid_.for_each_near(a.radius, a.cell, [&](std::int32_t other, double sx, double sy) {
        const Disk& b = disk(other);
        const double sigma = a.radius + b.radius;
        if (other == particle || !(a.inverse_mass + b.inverse_mass > 0.0) || !(sigma > 0.0)) return;
        const RelativeMotion<double> m{(b.x + b.vx * (now_ - b.time)) + sx - x,
                                       (b.y + b.vy * (now_ - b.time)) + sy - y, b.vx - a.vx,
                                       b.vy - a.vy};
        const double time =
            now_ + contact_time(m, sigma, approach_round_off(m, a.vx, a.vy, b.vx, b.vy));
        if (time < first.time ||
            (time == first.time && first.partner >= 0 && other < first.partner))
            first = {time, other, b.collisions};
    });
    return first;
}

}  // namespace carom

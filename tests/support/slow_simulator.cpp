#include "support/slow_simulator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::test {

SlowSimulator::SlowSimulator(const Box& box, const Particles& particles, const Sample& start)
    : box_(box) {
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        disks_.push_back({start.position(i, 0), start.position(i, 1), start.velocity(i, 0),
                          start.velocity(i, 1), particles.radius[i], particles.inverse_mass[i]});
}

void SlowSimulator::look_at_pairs(Candidate& best) const {
    const int images_x = box_.is_periodic(0) ? 2 : 0;
    const int images_y = box_.is_periodic(1) ? 2 : 0;
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        for (std::size_t j = i + 1; j < disks_.size(); ++j) {
            const Disk &a = disks_[i], &b = disks_[j];
            if (a.inverse_mass + b.inverse_mass == 0.0L) continue;
            const long double vx = b.vx - a.vx, vy = b.vy - a.vy;
            const long double sigma = a.radius + b.radius;
            for (int ix = -images_x; ix <= images_x; ++ix) {
                for (int iy = -images_y; iy <= images_y; ++iy) {
                    const long double sx = ix * static_cast<long double>(box_.size[0]);
                    const long double sy = iy * static_cast<long double>(box_.size[1]);
                    const long double x = b.x + sx - a.x, y = b.y + sy - a.y;
                    const long double approach = x * vx + y * vy, v2 = vx * vx + vy * vy;
                    // An approach within the rounding errors of doubles is none.
                    constexpr long double epsilon = std::numeric_limits<double>::epsilon();
                    if (approach >= -4.0L * epsilon *
                                        (std::abs(x) * (std::abs(a.vx) + std::abs(b.vx)) +
                                         std::abs(y) * (std::abs(a.vy) + std::abs(b.vy))))
                        continue;
                    const long double gap = x * x + y * y - sigma * sigma;
                    const long double discriminant = approach * approach - v2 * gap;
                    if (discriminant <= 0.0L) continue;
                    const long double wait =
                        gap <= 0.0L ? 0.0L : (-approach - std::sqrt(discriminant)) / v2;
                    if (wait < best.wait)
                        best = {wait, static_cast<int>(i), static_cast<int>(j), sx, sy};
                }
            }
        }
    }
}

void SlowSimulator::look_at_walls(Candidate& best) const {
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        const Disk& d = disks_[i];
        for (int axis = 0; axis < 2; ++axis) {
            if (box_.is_periodic(axis)) continue;
            const long double x = axis == 0 ? d.x : d.y, v = axis == 0 ? d.vx : d.vy;
            if (v == 0.0L) continue;
            const long double wall = v > 0.0L ? box_.size[axis] - d.radius : d.radius;
            const long double wait = std::max(0.0L, (wall - x) / v);
            const int side = 2 * axis + (v > 0.0L ? 1 : 0);
            if (wait < best.wait) best = {wait, static_cast<int>(i), -1 - side, 0.0L, 0.0L};
        }
    }
}

void SlowSimulator::collide(const Candidate& event) {
    Disk& a = disks_[static_cast<std::size_t>(event.first)];
    if (event.second < 0) {
        (event.second > -3 ? a.vx : a.vy) *= -1.0L;
        return;
    }
    Disk& b = disks_[static_cast<std::size_t>(event.second)];
    const long double x = b.x + event.shift_x - a.x, y = b.y + event.shift_y - a.y;
    const long double distance = std::hypot(x, y);
    const long double nx = x / distance, ny = y / distance;
    const long double along = (b.vx - a.vx) * nx + (b.vy - a.vy) * ny;
    const long double impulse = 2.0L * along / (a.inverse_mass + b.inverse_mass);
    a.vx += a.inverse_mass * impulse * nx;
    a.vy += a.inverse_mass * impulse * ny;
    b.vx -= b.inverse_mass * impulse * nx;
    b.vy -= b.inverse_mass * impulse * ny;
}

void SlowSimulator::append_touches_of_pair(std::size_t i, std::size_t j,
                                           std::vector<SlowTouch>& all) const {
    const Disk &a = disks_[i], &b = disks_[j];
    if (a.inverse_mass + b.inverse_mass == 0.0L) return;
    const int images_x = box_.is_periodic(0) ? 2 : 0, images_y = box_.is_periodic(1) ? 2 : 0;
    const long double sigma = a.radius + b.radius;
    const long double furthest =
        std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y), sigma});
    for (int ix = -images_x; ix <= images_x; ++ix)
        for (int iy = -images_y; iy <= images_y; ++iy) {
            const SlowVector r{b.x + ix * static_cast<long double>(box_.size[0]) - a.x,
                               b.y + iy * static_cast<long double>(box_.size[1]) - a.y};
            const SlowVector normal = (1.0L / size(r)) * r;
            const long double speed = dot(normal, SlowVector{b.vx - a.vx, b.vy - a.vy});
            all.push_back({i, j, normal, size(r) - sigma,
                           distance_of_round_off(time_, speed, furthest + sigma)});
        }
}

// The walls are the participant after the disks.
void SlowSimulator::append_touches_of_walls(std::size_t i, std::vector<SlowTouch>& all) const {
    const Disk& d = disks_[i];
    if (d.inverse_mass == 0.0L) return;
    for (int axis = 0; axis < 2; ++axis) {
        if (box_.is_periodic(axis)) continue;
        const long double x = axis == 0 ? d.x : d.y, v = axis == 0 ? d.vx : d.vy;
        const long double length = box_.size[axis];
        for (const bool up : {false, true}) {
            SlowVector normal;
            normal[axis] = up ? 1.0L : -1.0L;
            all.push_back({i, disks_.size(), normal, (up ? length - x : x) - d.radius,
                           distance_of_round_off(time_, v, length)});
        }
    }
}

// Whether round-off decides if two disks touch at all.
bool SlowSimulator::grazes(const Candidate& event) const {
    if (event.second < 0) return false;
    const Disk &a = disks_[static_cast<std::size_t>(event.first)],
               &b = disks_[static_cast<std::size_t>(event.second)];
    const SlowVector r{b.x + event.shift_x - a.x, b.y + event.shift_y - a.y};
    const SlowVector v{b.vx - a.vx, b.vy - a.vy};
    return std::abs(dot(r, v)) < 1e-6L * size(r) * size(v);
}

// Carries out all contacts that coincide with the first one found and are connected with it.
void SlowSimulator::settle(const Candidate& first, SlowEvent& event) {
    std::vector<SlowTouch> touches;
    std::vector<SlowParticipant> participants;
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        const Disk& d = disks_[i];
        participants.push_back({{d.vx, d.vy}, {d.inverse_mass, d.inverse_mass}});
        append_touches_of_walls(i, touches);
        for (std::size_t j = i + 1; j < disks_.size(); ++j) append_touches_of_pair(i, j, touches);
    }
    participants.push_back({});
    for (const SlowTouch& touch : touches)
        event.is_doubtful = event.is_doubtful || touch.is_doubtful();
    event.is_doubtful = event.is_doubtful || grazes(first);
    const std::int32_t pushed = disks_[static_cast<std::size_t>(first.first)].inverse_mass > 0.0L
                                    ? first.first
                                    : first.second;
    if (pushed < 0) return collide(first);
    const auto connected = connected_with(static_cast<std::size_t>(pushed), touches, participants);
    if (connected.size() < 2) return collide(first);
    event.contacts = carry_out_rounds(participants, connected);
    if (event.contacts == 0) {
        event.contacts = 1;
        return collide(first);
    }
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        disks_[i].vx = participants[i].v.x;
        disks_[i].vy = participants[i].v.y;
    }
}

void SlowSimulator::adopt(const Sample& state) {
    time_ = state.time;
    for (std::size_t i = 0; i < disks_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        disks_[i].x = state.position(row, 0);
        disks_[i].y = state.position(row, 1);
        disks_[i].vx = state.velocity(row, 0);
        disks_[i].vy = state.velocity(row, 1);
    }
}

// The longest time step in which nothing flies further than a quarter of the box, so that the
// images examined suffice.
long double SlowSimulator::longest_step() const {
    long double fastest = 1e-300L;
    for (const Disk& d : disks_) fastest = std::max(fastest, std::hypot(d.vx, d.vy));
    return 0.25L * std::min(box_.size[0], box_.size[1]) / fastest;
}

void SlowSimulator::fly(long double wait) {
    const auto wrap = [](long double x, long double length) {
        return x - length * std::floor(x / length);
    };
    time_ += wait;
    for (Disk& d : disks_) {
        d.x += d.vx * wait;
        d.y += d.vy * wait;
        if (box_.is_periodic(0)) d.x = wrap(d.x, box_.size[0]);
        if (box_.is_periodic(1)) d.y = wrap(d.y, box_.size[1]);
    }
}

std::optional<SlowEvent> SlowSimulator::next(long double end) {
    while (true) {
        const long double step = longest_step();
        Candidate best{step, -1, -1, 0.0L, 0.0L};
        look_at_pairs(best);
        look_at_walls(best);
        if (!(time_ + best.wait <= end)) return std::nullopt;
        if (best.first < 0) {
            fly(step);
            continue;
        }
        // Carry out the collision before wrapping positions into the box: wrapping may change which
        // image is in contact.
        for (Disk& d : disks_) {
            d.x += d.vx * best.wait;
            d.y += d.vy * best.wait;
        }
        time_ += best.wait;
        SlowEvent event{time_, best.first, best.second};
        settle(best, event);
        fly(0.0L);
        return event;
    }
}

}  // namespace carom::test

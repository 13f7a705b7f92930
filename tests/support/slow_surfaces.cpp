#include "support/slow_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

namespace carom::test {

using Vector = SlowVector;

// --------------------------------------------------------------------------------- what is there

SlowSurfaces::SlowSurfaces(const Box& box, const Particles& particles, const Sample& start)
    : box_(box), slack_(0.0L) {
    const int dimension = box.dimension;
    for (int side = 0; side < 4; ++side) {
        const int axis = side / 2;
        const long double place = side % 2 == 0 ? 0.0L : box.size[axis];
        movers_.push_back({.axis = axis,
                           .place = place,
                           .behaviour = box.surfaces.sides[static_cast<std::size_t>(side)]});
        if (axis < dimension && !box.is_periodic(axis)) add_partition(axis, place, {}, side);
    }
    std::int32_t surface = 4;
    for (const Partition& line : box.surfaces.partitions) {
        movers_.push_back({.axis = line.axis,
                           .place = line.at,
                           .behaviour = line.behaviour,
                           .is_open = line.is_open});
        add_partition(line.axis, line.at, line.gaps, surface++);
    }
    for (const Obstacle& obstacle : box.surfaces.obstacles) add_obstacle(obstacle, surface++);
    for (Mover& mover : movers_) {
        if (const auto* piston = std::get_if<Piston>(&mover.behaviour))
            mover.velocity = piston->velocity;
        set_motion(mover);
    }
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        disks_.push_back({.x = {},
                          .v = {},
                          .a = {},
                          .radius = particles.radius[i],
                          .inverse_mass = particles.inverse_mass[i],
                          .species = particles.species[i]});
    adopt(start, {});
    order_.resize(disks_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](auto a, auto b) { return disks_[a].x.x < disks_[b].x.x; });
}

void SlowSurfaces::add_partition(int axis, long double at, const std::vector<Gap>& gaps,
                                 std::int32_t surface) {
    const auto point = [&](long double where) {
        return axis == 0 ? Vector{at, where} : Vector{where, at};
    };
    const Vector direction = axis == 0 ? Vector{0.0L, 1.0L} : Vector{1.0L, 0.0L};
    if (gaps.empty()) {
        parts_.push_back({true, point(0.0L), point(0.0L), direction, infinite, 0.0L, surface});
        return;
    }
    const long double end = box_.size[1 - axis];
    long double from = 0.0L;
    const auto add_piece = [&](long double to) {
        if (to <= from) return;
        parts_.push_back({true, point(from), point(to), direction, to - from, 0.0L, surface});
        if (!box_.is_periodic(1 - axis) && from == 0.0L)  // also beyond the wall, which may move
            parts_.push_back(
                {true, point(0.0L), point(0.0L), -1.0L * direction, 1e9L, 0.0L, surface});
        if (!box_.is_periodic(1 - axis) && to == end)
            parts_.push_back({true, point(end), point(end), direction, 1e9L, 0.0L, surface});
        for (const long double corner : {from, to})
            parts_.push_back({false, point(corner), point(corner), {}, 0.0L, 0.0L, surface});
    };
    for (const Gap& gap : gaps) {
        add_piece(gap.from());
        from = gap.to();
    }
    add_piece(end);
    // No corner where the partition reaches a wall or its own periodic image.
    const bool is_ring = box_.is_periodic(1 - axis);
    const bool is_whole = gaps.front().from() > 0.0 && gaps.back().to() < end;
    std::erase_if(parts_, [&](const Part& part) {
        const long double where = part.place[1 - axis];
        return part.surface == surface && !part.is_line && (where == 0.0L || where == end) &&
               (!is_ring || is_whole);
    });
}

void SlowSurfaces::add_obstacle(const Obstacle& obstacle, std::int32_t surface) {
    if (const auto* disk = std::get_if<Obstacle::Ball>(&obstacle.shape)) {
        const Vector center{disk->center[0], disk->center[1]};
        parts_.push_back({false, center, center, {}, 0.0L, disk->radius, surface});
        return;
    }
    const auto& lines = std::get<Obstacle::Lines>(obstacle.shape);
    const auto& corners = lines.corners;
    const auto corner = [&](std::size_t k) {
        return Vector{corners[k % corners.size()][0], corners[k % corners.size()][1]};
    };
    for (std::size_t k = 0; k < corners.size(); ++k)
        parts_.push_back({false, corner(k), corner(k), {}, 0.0L, 0.0L, surface});
    for (std::size_t k = 0; k + (lines.is_closed ? 0 : 1) < corners.size(); ++k) {
        const Vector line = corner(k + 1) - corner(k);
        const long double length = size(line);
        parts_.push_back(
            {true, corner(k), corner(k + 1), (1.0L / length) * line, length, 0.0L, surface});
    }
}

// Sets the motion that follows from the behaviour; a piston keeps its own velocity.
void SlowSurfaces::set_motion(Mover& mover) {
    mover.inverse_mass = mover.acceleration = 0.0L;
    mover.stops = infinite;
    if (const auto* driven = std::get_if<Driven>(&mover.behaviour)) {
        mover.is_mobile = true;
        mover.velocity = driven->until > time_ ? driven->velocity : 0.0;
        mover.stops = driven->until > time_ ? driven->until : infinite;
    } else if (const auto* piston = std::get_if<Piston>(&mover.behaviour)) {
        mover.is_mobile = true;
        if (mover.is_held) {
            mover.velocity = 0.0L;
        } else {
            mover.inverse_mass = 1.0L / piston->mass;
            mover.acceleration = piston->force / static_cast<long double>(piston->mass) +
                                 box_.surfaces.gravity[mover.axis];
        }
    } else {
        mover.velocity = 0.0L;
    }
}

// Disks fall, except those that rest on a wall that does not move.
void SlowSurfaces::settle() {
    const Vector gravity{box_.surfaces.gravity[0], box_.surfaces.gravity[1]};
    for (Disk& disk : disks_) {
        disk.a = gravity;
        for (const Part& part : parts_) {
            if (!part.is_line || part.length < infinite || !is_there(part)) continue;
            if (movers_[static_cast<std::size_t>(part.surface)].is_mobile) continue;
            const Vector normal = left_of(part.along);
            const long double side = side_of(part, dot(normal, disk.x - part.place));
            if (dot(normal, disk.v) == 0.0L && side * dot(normal, disk.a) < 0.0L &&
                side * dot(normal, disk.x - part.place) < disk.radius + slack_)
                disk.a = disk.a - dot(normal, disk.a) * normal;
        }
    }
}

// On which side of a line a body is. For walls it is always the inside of the box, which lies to
// the right of the left and top walls, seen along their direction.
long double SlowSurfaces::side_of(const Part& part, long double distance) {
    if (part.surface < 4) return part.surface == 0 || part.surface == 3 ? -1.0L : 1.0L;
    return distance < 0.0L ? -1.0L : 1.0L;
}

bool SlowSurfaces::is_there(const Part& part) const {
    const auto k = static_cast<std::size_t>(part.surface);
    return k >= movers_.size() || !movers_[k].is_open;
}

bool SlowSurfaces::lets_pass(const Part& part, const Disk& disk) const {
    const auto k = static_cast<std::size_t>(part.surface);
    if (k >= movers_.size()) return false;
    const auto* membrane = std::get_if<Membrane>(&movers_[k].behaviour);
    return membrane != nullptr && std::find(membrane->species.begin(), membrane->species.end(),
                                            disk.species) != membrane->species.end();
}

bool SlowSurfaces::admits(const Mover& mover, const Disk& disk) const {
    const auto* membrane = std::get_if<Membrane>(&mover.behaviour);
    if (membrane == nullptr) return false;
    const auto& speeds = disk.v[mover.axis] > 0.0L ? membrane->upward : membrane->downward;
    return size(disk.v) > speeds.faster_than && size(disk.v) < speeds.slower_than;
}

// ------------------------------------------------------------------------------ what comes next

std::vector<SlowVector> SlowSurfaces::images() const {
    std::vector<Vector> images;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            if ((x == 0 || box_.is_periodic(0)) && (y == 0 || box_.is_periodic(1)))
                images.push_back({x * static_cast<long double>(box_.size[0]),
                                  y * static_cast<long double>(box_.size[1])});
    return images;
}

SlowSurfaces::Motion SlowSurfaces::motion_of(const Disk& disk, const Part& part,
                                             const Vector& image) const {
    Motion m{disk.x + image - part.place, disk.v, disk.a};
    const auto k = static_cast<std::size_t>(part.surface);
    if (k >= movers_.size()) return m;
    const Mover& mover = movers_[k];
    // The place of a part is that at the start; the mover has the present one.
    m.r[mover.axis] = disk.x[mover.axis] + image[mover.axis] - mover.place;
    m.v[mover.axis] -= mover.velocity;
    m.a[mover.axis] -= mover.acceleration;
    return m;
}

SlowSurfaces::Motion SlowSurfaces::between(const Disk& a, const Disk& b,
                                           const Vector& image) const {
    return {b.x + image - a.x, b.v - a.v, b.a - a.a};
}

long double SlowSurfaces::time_to_circle(const Motion& m, long double distance,
                                         long double before) const {
    const long double way = before * (size(m.v) + 0.5L * before * size(m.a));
    if (size(m.r) > distance + way) return infinite;
    const Polynomial gap{{dot(m.r, m.r) - distance * distance, 2.0L * dot(m.r, m.v),
                          dot(m.v, m.v) + dot(m.r, m.a), dot(m.v, m.a), 0.25L * dot(m.a, m.a)}};
    const auto falls = falls_of(gap, before);
    return falls.empty() ? infinite : falls.front();
}

long double SlowSurfaces::time_to_part(const Disk& disk, const Part& part, const Motion& m,
                                       long double before) const {
    // A disk that is let through and overlaps the surface must leave it before it can meet it
    // again.
    const bool is_passing = disk.passing.contains(part.surface) && gap_of(m, part, disk) < slack_;
    const long double reach = disk.radius + part.radius - (is_passing ? 0.0L : slack_);
    const long double soonest = is_passing ? 1e-9L : 0.0L;
    if (!part.is_line) {
        if (reach <= 0.0L) return infinite;
        const long double t = time_to_circle(m, reach, before);
        return t < soonest ? infinite : t;
    }
    const Vector normal = left_of(part.along);
    const long double way =
        before * (std::abs(dot(normal, m.v)) + 0.5L * before * std::abs(dot(normal, m.a)));
    if (std::abs(dot(normal, m.r)) > std::abs(reach) + way) return infinite;
    const Polynomial foot = along(part.along, m.r, m.v, m.a);
    // A point on a line goes to the side that its velocity shows.
    const bool is_on_line = disk.radius == 0.0L && std::abs(dot(normal, m.r)) < slack_;
    const long double side = side_of(part, is_on_line ? dot(normal, m.v) : dot(normal, m.r));
    long double first = infinite;
    for (const long double from : {side, -side}) {
        if (part.surface < 4 && from != side) continue;
        Polynomial gap = along(from * normal, m.r, m.v, m.a);
        gap.c[0] -= reach;
        if (from != side && gap.c[0] > 0.0L) continue;  // a body in contact stays on its own side
        for (const long double t : falls_of(gap, before)) {
            if (t < soonest || (t == 0.0L && from != side)) continue;
            if (part.length == infinite || (foot(t) >= 0.0L && foot(t) <= part.length)) {
                first = std::min(first, t);
                break;
            }
        }
    }
    return first;
}

void SlowSurfaces::look_at_pairs(Next& next) const {
    const auto consider = [&](std::size_t i, std::size_t j, long double t) {
        if (t < next.wait) next = {t, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
    };
    if (box_.dimension == 1) {
        for (std::size_t k = 0; k + 1 < order_.size(); ++k) {
            const Disk &a = disks_[order_[k]], &b = disks_[order_[k + 1]];
            const Motion m = between(a, b, {});
            Polynomial gap = along({1.0L, 0.0L}, m.r, m.v, m.a);
            gap.c[0] -= a.radius + b.radius - slack_;
            const auto falls = falls_of(gap, next.wait);
            if (!falls.empty()) consider(order_[k], order_[k + 1], falls.front());
        }
        return;
    }
    const std::vector<Vector> all = images();
    for (std::size_t i = 0; i < disks_.size(); ++i)
        for (std::size_t j = i + 1; j < disks_.size(); ++j) {
            const Disk &a = disks_[i], &b = disks_[j];
            const long double distance = a.radius + b.radius - slack_;
            if (distance <= 0.0L || a.inverse_mass + b.inverse_mass == 0.0L) continue;
            for (const Vector& image : all)
                consider(i, j, time_to_circle(between(a, b, image), distance, next.wait));
        }
}

void SlowSurfaces::look_at_parts(Next& next) const {
    const std::vector<Vector> all = images();
    for (std::size_t i = 0; i < disks_.size(); ++i)
        for (const Part& part : parts_) {
            if (!is_there(part) || lets_pass(part, disks_[i])) continue;
            for (const Vector& image : all) {
                const Motion m = motion_of(disks_[i], part, image);
                const long double t = time_to_part(disks_[i], part, m, next.wait);
                if (t < next.wait) next = {t, static_cast<std::int32_t>(i), -1 - part.surface};
            }
        }
}

// The end of the part that the mover would hit; none if the mover is already alongside the part.
std::optional<long double> SlowSurfaces::end_towards(const Part& part, const Mover& mover) const {
    const long double first = part.place[mover.axis], last = part.end[mover.axis];
    const long double low = std::min(first, last) - part.radius;
    const long double high = std::max(first, last) + part.radius;
    if (mover.place > low && mover.place < high) return std::nullopt;
    return mover.place - low < high - mover.place ? low : high;
}

// Calls consider(distance, velocity, acceleration, what, place) for everything that mover k can
// hit: another mover (what = -2 - its number) or a part at rest (what = its number).
template <class Consider>
void SlowSurfaces::for_each_that_reaches(std::size_t k, const Consider& consider) const {
    const Mover& mover = movers_[k];
    for (std::size_t j = 0; j < movers_.size(); ++j)
        if (j != k && movers_[j].axis == mover.axis && movers_[j].is_mobile && !movers_[j].is_open)
            consider(mover.place - movers_[j].place, mover.velocity - movers_[j].velocity,
                     mover.acceleration - movers_[j].acceleration, -2 - static_cast<int>(j));
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        const Part& part = parts_[j];
        const auto its = static_cast<std::size_t>(part.surface);
        if (!is_there(part)) continue;
        if (its < movers_.size() && (movers_[its].is_mobile || movers_[its].axis != mover.axis))
            continue;
        if (const auto end = end_towards(part, mover))
            consider(mover.place - *end, mover.velocity, mover.acceleration, static_cast<int>(j),
                     *end);
    }
}

// Movers on one axis meet each other and whatever extends across their path. A mover that already
// overlaps the extent of such an obstacle passes by it.
void SlowSurfaces::look_at_movers(Next& next) const {
    for (std::size_t k = 0; k < movers_.size(); ++k) {
        const Mover& mover = movers_[k];
        if (!mover.is_mobile) continue;
        if (mover.stops - time_ < next.wait)
            next = {std::max(0.0L, mover.stops - time_), -1 - static_cast<int>(k), -1};
        if (mover.is_open) continue;
        const auto consider = [&](long double apart, long double v, long double a, int second,
                                  long double place = 0.0L) {
            const long double side = apart < 0.0L || (apart == 0.0L && v < 0.0L) ? -1.0L : 1.0L;
            const Polynomial gap{{side * apart, side * v, side * 0.5L * a, 0.0L, 0.0L}};
            const auto falls = falls_of(gap, next.wait);
            if (!falls.empty()) next = {falls.front(), -1 - static_cast<int>(k), second, place};
        };
        for_each_that_reaches(k, consider);
    }
}

long double SlowSurfaces::least_room() const {
    long double least = infinite;
    const auto consider = [&](long double apart, long double, long double, int,
                              long double = 0.0L) { least = std::min(least, std::abs(apart)); };
    for (std::size_t k = 0; k < movers_.size(); ++k)
        if (movers_[k].is_mobile && !movers_[k].is_open) for_each_that_reaches(k, consider);
    return least;
}

// The longest time step in which nothing moves further than a quarter of the box, so that the
// images examined suffice.
long double SlowSurfaces::longest_step() const {
    long double fastest = 1e-300L, acceleration = 0.0L;
    for (const Disk& disk : disks_) {
        fastest = std::max(fastest, size(disk.v));
        acceleration = std::max(acceleration, size(disk.a));
    }
    long double quarter = infinite;
    for (int axis = 0; axis < box_.dimension; ++axis)
        quarter = std::min(quarter, 0.25L * box_.size[axis]);
    return 2.0L * quarter /
           (fastest + std::sqrt(fastest * fastest + 2.0L * acceleration * quarter));
}

void SlowSurfaces::fly(long double wait) {
    time_ += wait;
    for (Disk& disk : disks_) {
        disk.x = disk.x + wait * (disk.v + 0.5L * wait * disk.a);
        disk.v = disk.v + wait * disk.a;
        for (int axis = 0; axis < 2; ++axis)
            if (box_.is_periodic(axis))
                disk.x[axis] -= box_.size[axis] * std::floor(disk.x[axis] / box_.size[axis]);
    }
    for (Mover& mover : movers_) {
        if (!mover.is_mobile) continue;
        mover.place += wait * (mover.velocity + 0.5L * wait * mover.acceleration);
        mover.velocity += wait * mover.acceleration;
    }
}

// A mover stops (second = -1), or bounces off another mover (-2 - its number) or off a part at
// rest.
void SlowSurfaces::bounce(const Next& next) {
    Mover& mover = movers_[static_cast<std::size_t>(-1 - next.first)];
    if (next.second == -1) {
        mover.velocity = 0.0L;
        mover.stops = infinite;
    } else if (next.second < -1) {
        Mover& other = movers_[static_cast<std::size_t>(-2 - next.second)];
        const long double impulse =
            2.0L * (other.velocity - mover.velocity) / (mover.inverse_mass + other.inverse_mass);
        mover.velocity += impulse * mover.inverse_mass;
        other.velocity -= impulse * other.inverse_mass;
        mover.place = other.place;
    } else {
        mover.place = next.place;  // exactly: from beyond the obstacle it would not meet it again
        mover.velocity = -mover.velocity;
    }
}

std::optional<SlowContact> SlowSurfaces::advance(long double time) {
    while (time_ < time) {
        Next next{std::min(time - time_, longest_step())};
        const long double step = next.wait;
        look_at_movers(next);
        look_at_pairs(next);
        look_at_parts(next);
        const bool is_last = next.wait == step && step == time - time_;
        fly(next.wait);
        if (is_last) time_ = time;
        if (next.wait == step) continue;
        if (next.first < 0) {
            bounce(next);
            continue;
        }
        if (next.second < 0) {
            const auto k = static_cast<std::size_t>(-1 - next.second);
            Disk& disk = disks_[static_cast<std::size_t>(next.first)];
            if (k < movers_.size() && admits(movers_[k], disk)) {
                disk.passing.insert(static_cast<std::int32_t>(k));
                continue;
            }
        }
        return SlowContact{next.first, next.second};
    }
    find_slack();
    return std::nullopt;
}

}  // namespace carom::test

#include "stats/pairs/rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace carom {
namespace {

// The room that two points have along an axis, as a function of their separation along it. `first`
// and `second` are the lengths of the intervals, about one centre, that each point can reach: the
// room is constant up to flat(), half the difference of the lengths, and decreases linearly with
// the separation from there to end(), where it is 0.
struct Room {
    double first, second;
    bool is_periodic;
    double flat() const { return is_periodic ? INFINITY : 0.5 * std::abs(first - second); }
    double end() const { return is_periodic ? INFINITY : 0.5 * (first + second); }
};

// The integral of the product of both rooms over all directions of a separation of length r, in
// closed form between the angles at which one of the rooms has a kink.
double rooms_around(const Room& x, const Room& y, double r) {
    std::vector<double> angles{0.0, 0.5 * std::numbers::pi};
    for (const double bend : {x.flat(), x.end()})
        if (bend < r) angles.push_back(std::acos(bend / r));
    for (const double bend : {y.flat(), y.end()})
        if (bend < r) angles.push_back(std::asin(bend / r));
    std::ranges::sort(angles);
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
        const double from = angles[k], to = angles[k + 1], middle = 0.5 * (from + to);
        const double at_x = r * std::cos(middle), at_y = r * std::sin(middle);
        if (at_x > x.end() || at_y > y.end()) continue;
        // (a - b cos)(c - d sin)
        const bool x_bends = at_x > x.flat(), y_bends = at_y > y.flat();
        const double a = x_bends ? x.end() : std::min(x.first, x.second), b = x_bends ? r : 0.0;
        const double c = y_bends ? y.end() : std::min(y.first, y.second), d = y_bends ? r : 0.0;
        const double sine_to = std::sin(to), sine_from = std::sin(from);
        sum += a * c * (to - from) - b * c * (sine_to - sine_from) -
               a * d * (std::cos(from) - std::cos(to)) +
               0.5 * b * d * (sine_to * sine_to - sine_from * sine_from);
    }
    return 4.0 * r * sum;
}

// Five-point Gauss-Legendre quadrature.
double integral(double low, double high, const auto& value) {
    constexpr std::array<double, 3> nodes{0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> weights{0.5688888888888889, 0.4786286704993665,
                                            0.2369268850561891};
    const double half = 0.5 * (high - low), middle = 0.5 * (low + high);
    double sum = weights[0] * value(middle);
    for (std::size_t k = 1; k < nodes.size(); ++k)
        sum += weights[k] * (value(middle - half * nodes[k]) + value(middle + half * nodes[k]));
    return half * sum;
}

// The same in space, of three rooms, over all directions. In closed form if no room has a kink
// within this distance, or just in its middle; else over the angle with z, between the angles at
// which a room has a kink for some direction.
double rooms_in_shell(const std::array<Room, 3>& rooms, double r) {
    using std::numbers::pi;
    const auto is_smooth = [&](const Room& room) {
        return room.flat() >= r || (room.flat() == 0.0 && room.end() >= r);
    };
    if (std::ranges::all_of(rooms, is_smooth)) {
        // The product of a - b n over an eighth of all directions n.
        std::array<double, 3> a{}, b{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool bends = rooms[axis].flat() < r;
            a[axis] = bends ? rooms[axis].end() : std::min(rooms[axis].first, rooms[axis].second);
            b[axis] = bends ? r : 0.0;
        }
        const double pairs = b[0] * a[1] * a[2] + a[0] * b[1] * a[2] + a[0] * a[1] * b[2];
        const double triples = b[0] * b[1] * a[2] + b[0] * a[1] * b[2] + a[0] * b[1] * b[2];
        return 8.0 * r * r *
               (0.5 * pi * a[0] * a[1] * a[2] - 0.25 * pi * pairs + triples / 3.0 -
                b[0] * b[1] * b[2] / 8.0);
    }
    const auto& [x, y, z] = rooms;
    std::vector<double> angles{0.0, 0.5 * pi};
    const auto add = [&](double sine, double cosine) {
        if (sine < r && cosine < r) angles.push_back(std::atan2(sine, cosine));
    };
    const auto at_radius = [&](double bend) {
        if (bend < r) add(bend, std::sqrt((r - bend) * (r + bend)));
    };
    for (const double bend : {z.flat(), z.end()})
        if (bend < r) add(std::sqrt((r - bend) * (r + bend)), bend);
    for (const double of_x : {x.flat(), x.end()}) {
        at_radius(of_x);
        for (const double of_y : {y.flat(), y.end()}) at_radius(std::hypot(of_x, of_y));
    }
    for (const double of_y : {y.flat(), y.end()}) at_radius(of_y);
    std::ranges::sort(angles);
    double sum = 0.0;
    for (std::size_t k = 1; k < angles.size(); ++k) {
        const double from = angles[k - 1], span = angles[k] - from;
        // Slow at both ends, where the rooms around have roots.
        constexpr int parts = 4;
        for (int part = 0; part < parts; ++part)
            sum += integral(double(part) / parts, double(part + 1) / parts, [&](double t) {
                const double angle = from + span * t * t * t * (10.0 - t * (15.0 - 6.0 * t));
                const double speed = span * 30.0 * t * t * (1.0 - t) * (1.0 - t);
                const double height = r * std::cos(angle), radius = r * std::sin(angle);
                if (height > z.end()) return 0.0;
                const double room =
                    height > z.flat() ? z.end() - height : std::min(z.first, z.second);
                return speed * r * room * rooms_around(x, y, radius);
            });
    }
    return 2.0 * sum;
}

double room_between(const Room& x, double r) {
    if (r > x.end()) return 0.0;
    return 2.0 * (r > x.flat() ? x.end() - r : std::min(x.first, x.second));
}

}  // namespace

BoxSides sides_of(const Box& box) {
    return {{{0.0, box.size[0]}, {0.0, box.size[1]}, {0.0, box.size[2]}}};
}

double ring_probability(const Box& box, const BoxSides& sides, std::pair<double, double> radii,
                        double low, double high) {
    const auto room = [&](std::size_t axis) {
        const double length = sides[axis].second - sides[axis].first;
        const bool is_periodic = box.is_periodic(axis);
        const auto its = [&](double radius) {
            return is_periodic ? length : std::max(0.0, length - 2.0 * radius);
        };
        return Room{its(radii.first), its(radii.second), is_periodic};
    };
    const Room x = room(0);
    if (box.dimension == 1) {
        const double all = x.first * x.second;
        return all > 0.0 ? integral(low, high, [&](double r) { return room_between(x, r); }) / all
                         : 0.0;
    }
    const Room y = room(1);
    if (box.dimension == 2) {
        const double all = x.first * x.second * y.first * y.second;
        return all > 0.0
                   ? integral(low, high, [&](double r) { return rooms_around(x, y, r); }) / all
                   : 0.0;
    }
    const std::array<Room, 3> rooms{x, y, room(2)};
    double all = 1.0;
    for (const Room& each : rooms) all *= each.first * each.second;
    if (!(all > 0.0)) return 0.0;
    // Where the rooms have kinks at distances of their own, each part is smooth.
    std::vector<double> ends{low, high};
    for (const Room& each : rooms)
        for (const double bend : {each.flat(), each.end()})
            if (bend > low && bend < high) ends.push_back(bend);
    std::ranges::sort(ends);
    double sum = 0.0;
    for (std::size_t k = 1; k < ends.size(); ++k)
        sum += integral(ends[k - 1], ends[k], [&](double r) { return rooms_in_shell(rooms, r); });
    return sum / all;
}

}  // namespace carom

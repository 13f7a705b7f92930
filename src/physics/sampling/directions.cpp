#include "physics/sampling/directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "util/exact_sum.h"

namespace carom {
namespace {

constexpr double sum_rounding = 1e-12;  // of sums of given numbers, relative to the sum of all
constexpr double parallel = 1e-14;      // the relative determinant of momenta that are parallel

// The angles of the sides of a triangle that is passed along in this order.
std::array<double, 3> sides_of_triangle(double a, double b, double c) {
    // between side a and the reverse of b, and between c and the reverse of a (law of cosines)
    const auto angle = [](double first, double second, double opposite) {
        if (!(first * second > 0.0)) return 0.0;
        const double cosine =
            (first * first + second * second - opposite * opposite) / (2.0 * first * second);
        return std::acos(std::clamp(cosine, -1.0, 1.0));
    };
    return {0.0, std::numbers::pi - angle(a, b, c), std::numbers::pi + angle(c, a, b)};
}

// Closes a polygon of these sides, of which none is longer than all others together: the longest is
// one side of a triangle, and the others are shared between its other two sides, the longest first,
// each to the shorter of the two. These then differ by less than the longest side, and the triangle
// exists.
Eigen::ArrayXd closed_triangle(const Eigen::ArrayXd& momenta, double turn, bool is_mirrored) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(momenta.size()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::ranges::stable_sort(order, [&](auto a, auto b) { return momenta[a] > momenta[b]; });
    std::vector<std::size_t> side(order.size(), 0);
    std::array<double, 3> lengths{momenta[order[0]], 0.0, 0.0};
    for (std::size_t k = 1; k < order.size(); ++k) {
        side[k] = lengths[1] <= lengths[2] ? 1 : 2;
        lengths[side[k]] += momenta[order[k]];
    }
    const std::array<double, 3> directions = sides_of_triangle(lengths[0], lengths[1], lengths[2]);
    Eigen::ArrayXd angles(momenta.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        angles[order[k]] = turn + (is_mirrored ? -directions[side[k]] : directions[side[k]]);
    return angles;
}

// What balance() needs to know of directions: their number of axes, the sum of the momenta, rounded
// once so that it does not depend on their order, the turns that cancel it, and directions drawn
// again or for the limits of what is possible.

// Directions in the plane, as angles.
class PlaneDirections {
  public:
    using Axes = std::array<bool, 2>;
    using Turns = Eigen::ArrayXd;  ///< of each direction, an angle

    PlaneDirections(const Eigen::ArrayXd& momenta, const Axes& axes, const Eigen::ArrayXd& drawn)
        : angles(drawn), momenta_(momenta), axes_(axes) {}

    Vec sum() const {
        std::array<ExactSum, 2> sums;
        for (Eigen::Index i = 0; i < angles.size(); ++i) {
            sums[0].add(momenta_[i] * std::cos(angles[i]));
            sums[1].add(momenta_[i] * std::sin(angles[i]));
        }
        return {axes_[0] ? sums[0].value() : 0.0, axes_[1] ? sums[1].value() : 0.0};
    }

    // The least turns, by the sum of their squares, that cancel a sum to first order; empty if
    // there are none because all momenta are parallel.
    Turns least_turns(const Vec& sum) const {
        const Eigen::Index count = angles.size();
        const Eigen::ArrayXd by_x =
            axes_[0] ? Eigen::ArrayXd(-momenta_ * angles.sin()) : Eigen::ArrayXd::Zero(count);
        const Eigen::ArrayXd by_y =
            axes_[1] ? Eigen::ArrayXd(momenta_ * angles.cos()) : Eigen::ArrayXd::Zero(count);
        const double xx = axes_[0] ? by_x.square().sum() : 1.0;
        const double yy = axes_[1] ? by_y.square().sum() : 1.0;
        const double xy = (by_x * by_y).sum();
        const double determinant = xx * yy - xy * xy;
        if (!(determinant > parallel * xx * yy)) return {};
        const double along_x = (yy * sum[0] - xy * sum[1]) / determinant;
        const double along_y = (xx * sum[1] - xy * sum[0]) / determinant;
        return -(along_x * by_x + along_y * by_y);
    }
    static double widest(const Turns& turns) { return turns.abs().maxCoeff(); }
    void turn(const Turns& turns, double share) { angles += turns * share; }

    void draw(Random& random) {
        for (double& angle : angles) angle = random_angle(random);
    }
    void draw_triangle(Random& random) {
        const double turn = random_angle(random);
        angles = closed_triangle(momenta_, turn, random.below(2) == 1);
    }
    void draw_across(Random& random) {
        for (double& angle : angles)
            angle = (axes_[0] ? 0.5 : 0.0) * std::numbers::pi +
                    (random.below(2) == 1 ? std::numbers::pi : 0.0);
    }

    Eigen::ArrayXd angles;

  private:
    const Eigen::ArrayXd& momenta_;
    Axes axes_;
};

// Directions in space, as unit vectors.
class SpaceDirections {
  public:
    using Axes = std::array<bool, 3>;
    using Turns = std::vector<Vec>;  ///< each across its direction, as long as the angle

    SpaceDirections(const Eigen::ArrayXd& momenta, const Axes& axes, const std::vector<Vec>& drawn)
        : units(drawn), momenta_(momenta), axes_(axes) {}

    Vec sum() const {
        std::array<ExactSum, 3> sums;
        for (std::size_t i = 0; i < units.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sums[axis].add(momentum(i) * units[i][axis]);
        return along_axes({sums[0].value(), sums[1].value(), sums[2].value()});
    }

    // A turn t of a unit vector u changes its momentum by p t to first order, and t is across u:
    // the least turns are t = p (m - u (u . m)), where m solves a linear equation whose matrix is
    // the sum of p^2 (1 - u u^T).
    Turns least_turns(const Vec& sum) const {
        std::array<Vec, 3> rows{};
        for (std::size_t i = 0; i < units.size(); ++i) {
            const Vec& u = units[i];
            const double square_of_momentum = momentum(i) * momentum(i);
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                    rows[static_cast<std::size_t>(a)][b] +=
                        square_of_momentum * ((a == b ? 1.0 : 0.0) - u[a] * u[b]);
        }
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                if (!is_chosen(a) || !is_chosen(b))
                    rows[static_cast<std::size_t>(a)][b] = a == b ? 1.0 : 0.0;
        const std::array<Vec, 3> adjugate{cross(rows[1], rows[2]), cross(rows[2], rows[0]),
                                          cross(rows[0], rows[1])};
        const double determinant = dot(rows[0], adjugate[0]);
        if (!(determinant > parallel * rows[0][0] * rows[1][1] * rows[2][2])) return {};
        const Vec m = along_axes(
            (sum[0] * adjugate[0] + sum[1] * adjugate[1] + sum[2] * adjugate[2]) / determinant);
        Turns turns;
        for (std::size_t i = 0; i < units.size(); ++i)
            turns.push_back(-momentum(i) * (m - dot(units[i], m) * units[i]));
        return turns;
    }
    static double widest(const Turns& turns) {
        double most = 0.0;
        for (const Vec& turn : turns) most = std::max(most, square(turn));
        return std::sqrt(most);
    }
    void turn(const Turns& turns, double share) {
        for (std::size_t i = 0; i < units.size(); ++i) {
            const Vec turned = units[i] + share * turns[i];
            units[i] = turned / length(turned);
        }
    }

    void draw(Random& random) {
        for (Vec& unit : units) unit = random_direction(random);
    }
    // In a plane that is turned at random.
    void draw_triangle(Random& random) {
        const Vec first = random_direction(random), other = random_direction(random);
        const Vec normal = cross(first, other), second = cross(normal, first) / length(normal);
        const Eigen::ArrayXd angles = closed_triangle(momenta_, 0.0, false);
        for (std::size_t i = 0; i < units.size(); ++i) {
            const double angle = angles[static_cast<Eigen::Index>(i)];
            units[i] = std::cos(angle) * first + std::sin(angle) * second;
        }
    }
    void draw_across(Random& random) {
        for (Vec& unit : units) {
            const Vec drawn = random_direction(random), across = drawn - along_axes(drawn);
            unit = across / length(across);
        }
    }

    std::vector<Vec> units;

  private:
    double momentum(std::size_t i) const { return momenta_[static_cast<Eigen::Index>(i)]; }
    bool is_chosen(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
    Vec along_axes(const Vec& a) const {
        return {axes_[0] ? a[0] : 0.0, axes_[1] ? a[1] : 0.0, axes_[2] ? a[2] : 0.0};
    }

    const Eigen::ArrayXd& momenta_;
    Axes axes_;
};

// Newton's method. Far from the solution no direction is turned by more than half a radian at a
// time.
template <class Directions>
bool turn_until_balanced(double sum_of_momenta, Directions& directions) {
    constexpr int most_steps = 100;
    constexpr double widest_turn = 0.5;
    const double close = 4.0 * std::numeric_limits<double>::epsilon() * sum_of_momenta;
    for (int step = 0; step < most_steps; ++step) {
        const Vec sum = directions.sum();
        if (on_each_axis(3, [&](int axis) { return std::abs(sum[axis]) <= close; })) return true;
        const auto turns = directions.least_turns(sum);
        if (turns.size() == 0) return false;
        directions.turn(turns, std::min(1.0, widest_turn / Directions::widest(turns)));
    }
    return false;
}

template <class Directions>
bool balance(const Eigen::ArrayXd& momenta, const typename Directions::Axes& axes, Random& random,
             Directions& directions) {
    constexpr int most_tries = 20;
    constexpr Eigen::Index rigid = 3;  // so few sides make a polygon that cannot be deformed
    const bool along_all = std::ranges::count(axes, false) == 0;
    const double sum = momenta.sum(), largest = momenta.maxCoeff();
    if (along_all && 2.0 * largest > (1.0 + sum_rounding) * sum) return false;
    const auto moving = (momenta > 0.0).count();
    if (!(along_all && moving <= rigid)) {
        for (int tries = 0; tries < most_tries; ++tries) {
            if (turn_until_balanced(sum, directions)) return true;
            directions.draw(random);
        }
    }
    if (along_all) {
        directions.draw_triangle(random);
        turn_until_balanced(sum, directions);  // removes rounding errors
    } else {
        directions.draw_across(random);
    }
    return true;
}

// Searches for a surplus of beads to the right, positive or negative and at most `most_surplus`,
// for each group, so that all momenta sum to zero. For each group in turn it finds all sums that
// the groups up to it can have.
class SurplusSearch {
  public:
    SurplusSearch(const std::vector<EqualMomenta>& groups, std::int64_t most_surplus)
        : groups_(groups) {
        for (const EqualMomenta& group : groups)
            left_ += group.momentum * static_cast<double>(group.count);
        unit_ = sum_rounding * left_;
        for (const EqualMomenta& group : groups)
            if (!add(group, std::min(group.count, most_surplus))) return;
    }

    bool is_too_large() const { return steps_ > most_steps; }

    std::optional<std::vector<std::int64_t>> found() const {
        if (reached_.size() <= groups_.size() || reached_.back().empty()) return std::nullopt;
        const auto end = reached_.back().begin();  // all sums that are left are zero
        std::vector<std::int64_t> surpluses(groups_.size());
        std::int64_t at = end->first;
        for (std::size_t k = groups_.size(); k-- > 0;) {
            const Step& step = reached_[k + 1].at(at);
            surpluses[k] = step.surplus;
            at = step.from;
        }
        return surpluses;
    }

  private:
    static constexpr std::size_t most_steps = 2'000'000;

    struct Step {
        std::int64_t from, surplus;
        double sum;
    };

    // Small surpluses come first, and of several ways to a sum the first is kept.
    bool add(const EqualMomenta& group, std::int64_t most_surplus) {
        left_ -= group.momentum * static_cast<double>(group.count);
        std::map<std::int64_t, Step> next;
        for (std::int64_t size = group.count % 2; size <= most_surplus; size += 2)
            for (const auto& [from, step] : reached_.back())
                for (const std::int64_t surplus : {size, -size}) {
                    if (++steps_ > most_steps) return false;
                    const double sum = step.sum + static_cast<double>(surplus) * group.momentum;
                    if (std::abs(sum) > left_ + unit_) continue;  // the others cannot cancel it
                    next.try_emplace(std::llround(sum / unit_), Step{from, surplus, sum});
                }
        reached_.push_back(std::move(next));
        return true;
    }

    const std::vector<EqualMomenta>& groups_;
    double left_ = 0.0;  // the sum of the momenta of the groups that are not yet added
    double unit_ = 0.0;  // sums closer than this are equal
    std::size_t steps_ = 0;
    std::vector<std::map<std::int64_t, Step>> reached_{{{0, {0, 0, 0.0}}}};
};

}  // namespace

double random_angle(Random& random) { return random.uniform(0.0, 2.0 * std::numbers::pi); }

Vec random_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0), azimuth = random_angle(random);
    const double across = std::sqrt((1.0 - z) * (1.0 + z));
    return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

bool balance_angles(const Eigen::ArrayXd& momenta, const std::array<bool, 2>& axes, Random& random,
                    Eigen::ArrayXd& angles) {
    PlaneDirections directions(momenta, axes, angles);
    const bool is_balanced = balance(momenta, axes, random, directions);
    if (is_balanced) angles = directions.angles;
    return is_balanced;
}

bool balance_directions(const Eigen::ArrayXd& momenta, const std::array<bool, 3>& axes,
                        Random& random, std::vector<Vec>& directions) {
    SpaceDirections space(momenta, axes, directions);
    const bool is_balanced = balance(momenta, axes, random, space);
    if (is_balanced) directions = std::move(space.units);
    return is_balanced;
}

bool balance_signs(std::vector<EqualMomenta>& groups, Random& random) {
    std::int64_t most_count = 1;
    for (const EqualMomenta& group : groups) most_count = std::max(most_count, group.count);
    for (std::int64_t most_surplus = 1;; most_surplus *= 3) {
        const SurplusSearch search(groups, most_surplus);
        if (const auto surpluses = search.found()) {
            const std::int64_t sign = random.below(2) == 1 ? 1 : -1;
            for (std::size_t k = 0; k < groups.size(); ++k)
                groups[k].to_the_right = (groups[k].count + sign * (*surpluses)[k]) / 2;
            return true;
        }
        if (search.is_too_large() || most_surplus >= most_count) return false;
    }
}

}  // namespace carom

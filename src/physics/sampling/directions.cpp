#include "physics/sampling/directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "physics/vec.h"
#include "util/exact_sum.h"

namespace carom {
namespace {

constexpr double sum_rounding = 1e-12;  // of sums of given numbers, relative to the sum of all

// The sum of the momenta along both axes, rounded once, so that it does not depend on their order.
Vec sum_of(const Eigen::ArrayXd& momenta, const Eigen::ArrayXd& angles) {
    std::array<ExactSum, 2> sums;
    for (Eigen::Index i = 0; i < angles.size(); ++i) {
        sums[0].add(momenta[i] * std::cos(angles[i]));
        sums[1].add(momenta[i] * std::sin(angles[i]));
    }
    return {sums[0].value(), sums[1].value()};
}

// The least turns, by the sum of their squares, that cancel a sum to first order; empty if there
// are none because all momenta are parallel.
Eigen::ArrayXd least_turns(const Eigen::ArrayXd& momenta, const Eigen::ArrayXd& angles,
                           const std::array<bool, 2>& axes, const Vec& sum) {
    const Eigen::ArrayXd by_x =
        axes[0] ? Eigen::ArrayXd(-momenta * angles.sin()) : Eigen::ArrayXd::Zero(angles.size());
    const Eigen::ArrayXd by_y =
        axes[1] ? Eigen::ArrayXd(momenta * angles.cos()) : Eigen::ArrayXd::Zero(angles.size());
    const double xx = axes[0] ? by_x.square().sum() : 1.0;
    const double yy = axes[1] ? by_y.square().sum() : 1.0;
    const double xy = (by_x * by_y).sum();
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-14 * xx * yy)) return {};
    const double along_x = (yy * sum[0] - xy * sum[1]) / determinant;
    const double along_y = (xx * sum[1] - xy * sum[0]) / determinant;
    return -(along_x * by_x + along_y * by_y);
}

// Newton's method. Far from the solution no angle is turned by more than half a radian at a time.
bool turn_until_balanced(const Eigen::ArrayXd& momenta, const std::array<bool, 2>& axes,
                         Eigen::ArrayXd& angles) {
    constexpr int most_steps = 100;
    constexpr double widest_turn = 0.5;
    const double close = 4.0 * std::numeric_limits<double>::epsilon() * momenta.sum();
    for (int step = 0; step < most_steps; ++step) {
        Vec sum = sum_of(momenta, angles);
        for (int axis = 0; axis < 2; ++axis)
            if (!axes[static_cast<std::size_t>(axis)]) sum[axis] = 0.0;
        if (std::abs(sum[0]) <= close && std::abs(sum[1]) <= close) return true;
        const Eigen::ArrayXd turns = least_turns(momenta, angles, axes, sum);
        if (turns.size() == 0) return false;
        angles += turns * std::min(1.0, widest_turn / turns.abs().maxCoeff());
    }
    return false;
}

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

double random_angle(Random& random) { return random.uniform(0.0, 2.0 * std::numbers::pi); }

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

bool balance_angles(const Eigen::ArrayXd& momenta, const std::array<bool, 2>& axes, Random& random,
                    Eigen::ArrayXd& angles) {
    constexpr int most_tries = 20;
    constexpr Eigen::Index rigid = 3;  // so few sides make a polygon that cannot be deformed
    const bool along_both = axes[0] && axes[1];
    const double sum = momenta.sum(), largest = momenta.maxCoeff();
    if (along_both && 2.0 * largest > (1.0 + sum_rounding) * sum) return false;
    const auto moving = (momenta > 0.0).count();
    if (!(along_both && moving <= rigid)) {
        Eigen::ArrayXd turned = angles;
        for (int tries = 0; tries < most_tries; ++tries) {
            if (turn_until_balanced(momenta, axes, turned)) {
                angles = turned;
                return true;
            }
            for (double& angle : turned) angle = random_angle(random);
        }
    }
    if (along_both) {
        const double turn = random_angle(random);
        angles = closed_triangle(momenta, turn, random.below(2) == 1);
        turn_until_balanced(momenta, axes, angles);  // removes rounding errors
    } else {                                         // all across the axis
        for (double& angle : angles)
            angle = (axes[0] ? 0.5 : 0.0) * std::numbers::pi +
                    (random.below(2) == 1 ? std::numbers::pi : 0.0);
    }
    return true;
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

#include "stats/paths/course.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace carom {
namespace {

// The course from a time after its start on, lower by `shift`.
Course part_of(const Course& course, double since, double to, double shift) {
    const auto [c0, c1, c2] = course.coefficients;
    return {course.from + since,
            course.from + to,
            {course.polynomial(since) - shift, c1 + 2.0 * since * c2, c2}};
}

}  // namespace

double Course::value(double since) const {
    const double value = polynomial(since);
    return is_root ? std::sqrt(std::max(0.0, value)) : value;
}

Course square_of_speed(const PathPiece& piece, double factor) {
    const auto of = [&](const Vec& a, const Vec& b) {
        const double product = dot(a, b);
        return product == 0.0 ? 0.0 : factor * product;
    };
    return {piece.from,
            piece.to,
            {of(piece.velocity, piece.velocity), 2.0 * of(piece.velocity, piece.acceleration),
             of(piece.acceleration, piece.acceleration)}};
}

Course course_of_place(const PathPiece& piece, Eigen::Index axis) {
    return {piece.from,
            piece.to,
            {piece.place[axis], piece.velocity[axis], 0.5 * piece.acceleration[axis]}};
}

void courses_in_box(const Course& place, double period,
                    const std::function<void(const Course&)>& take) {
    if (period == 0.0) return take(place);
    const auto [c0, c1, c2] = place.coefficients;
    const double end = place.to - place.from;
    std::vector<double> cuts{0.0, end};
    const auto add_cuts = [&](double side) {  // where the position is at a side
        const double root = c1 * c1 - 4.0 * c2 * (c0 - side);
        if (c2 == 0.0) return c1 == 0.0 ? void() : cuts.push_back((side - c0) / c1);
        if (root < 0.0) return;
        const double q = -0.5 * (c1 + std::copysign(std::sqrt(root), c1));
        cuts.push_back(q / c2);
        if (q != 0.0) cuts.push_back((c0 - side) / q);
    };
    const double turn = c2 == 0.0 ? 0.0 : std::clamp(-0.5 * c1 / c2, 0.0, end);
    const auto [low, high] = std::minmax({c0, place.polynomial(end), place.polynomial(turn)});
    const auto first = static_cast<std::int64_t>(std::ceil(low / period));
    for (std::int64_t k = first; static_cast<double>(k) * period < high; ++k)
        add_cuts(static_cast<double>(k) * period);
    std::erase_if(cuts, [&](double cut) { return !(cut >= 0.0 && cut <= end); });
    std::ranges::sort(cuts);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double middle = place.polynomial(0.5 * (cuts[k] + cuts[k + 1]));
        take(part_of(place, cuts[k], cuts[k + 1], period * std::floor(middle / period)));
    }
}

}  // namespace carom

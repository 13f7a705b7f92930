#include "stats/paths/stays.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

// Adds the times at which the piece passes a position on an axis, or an image of it.
void add_passages(const Box& box, const PathPiece& piece, int axis, double edge,
                  std::vector<double>& times) {
    if (!std::isfinite(edge)) return;
    const double span = piece.span(), start = piece.place[axis], velocity = piece.velocity[axis];
    const double pull = piece.acceleration[axis];
    const auto at = [&](double time) { return start + time * (velocity + 0.5 * time * pull); };
    double low = std::min(start, at(span)), high = std::max(start, at(span));
    const double turn = pull != 0.0 ? -velocity / pull : -1.0;
    if (turn > 0.0 && turn < span) {
        low = std::min(low, at(turn));
        high = std::max(high, at(turn));
    }
    const double length = box.length(axis);
    const bool is_periodic = box.is_periodic(axis);
    const double first = is_periodic ? std::ceil((low - edge) / length) : 0.0;
    const double last = is_periodic ? std::floor((high - edge) / length) : 0.0;
    const auto add_time = [&](double time) {
        if (time > 0.0 && time < span) times.push_back(time);
    };
    for (double k = first; k <= last; k += 1.0) {
        const double way = edge + k * length - start;
        const double square = velocity * velocity + 2.0 * pull * way;
        if (square < 0.0) continue;
        const double root = std::sqrt(square);
        for (const double sum : {velocity + root, velocity - root})
            if (sum != 0.0) add_time(2.0 * way / sum);
    }
}

}  // namespace

bool is_in(const Box& box, const Region& region, const Vec& place) {
    for (Eigen::Index axis = 0; axis < box.dimension; ++axis) {
        const double inside = box.wrapped(axis, place[axis]);
        if (inside < region.low[axis] || inside >= region.high[axis]) return false;
    }
    return true;
}

void find_stays(const Box& box, const Region& region, const PathPiece& piece,
                std::vector<Stay>& stays) {
    stays.clear();
    std::vector<double> times{0.0, piece.span()};
    for (int axis = 0; axis < box.dimension; ++axis)
        for (const double edge : {region.low[axis], region.high[axis]})
            add_passages(box, piece, axis, edge, times);
    std::ranges::sort(times);
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double from = times[i - 1], to = times[i];
        if (to > from)
            stays.push_back({from, to, is_in(box, region, piece.place_after(0.5 * (from + to)))});
    }
}

}  // namespace carom

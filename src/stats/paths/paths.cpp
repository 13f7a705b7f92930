#include "stats/paths/paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/reversal/mirrored_events.h"

namespace carom {

std::vector<double> velocity_changes(const Run& run) {
    std::vector<double> times;
    for (const RunEvent& event : run.events)
        if (reverses(event) || heats(event)) times.push_back(event.at);
    for (const MirroredEvent& mirrored : mirrored_events(run))
        if (heats(run.events[mirrored.event])) times.push_back(mirrored.at);
    std::ranges::sort(times);
    return times;
}

double length_of_way(const Vec& middle, const Vec& gravity, double span) {
    const double speed = length(middle), pull = length(gravity);
    const double change = pull * span;
    if (change < 1e-3 * speed || change == 0.0) return span * speed;  // accurate to six digits
    const double along = dot(middle, gravity) / pull;
    const double across = std::sqrt(std::max(0.0, speed * speed - along * along));
    const auto primitive = [&](double w) {
        const double bent = across > 0.0 ? across * across * std::asinh(w / across) : 0.0;
        return 0.5 * (w * std::hypot(across, w) + bent) / pull;
    };
    return primitive(along + 0.5 * change) - primitive(along - 0.5 * change);
}

Paths::Paths(const Box& box, std::vector<double> changes) : changes_(std::move(changes)) {
    for (int axis = 0; axis < box.dimension; ++axis) {
        gravity_[axis] = box.surfaces.gravity[axis];
        if (box.is_periodic(axis)) period_[axis] = box.length(axis);
    }
    is_straight_ = changes_.empty() && gravity_ == Vec();
}

void Paths::take(const Sample& sample, std::vector<Point>& points) {
    points.resize(static_cast<std::size_t>(sample.position.rows()));
    for (Eigen::Index i = 0; i < sample.position.rows(); ++i)
        points[static_cast<std::size_t>(i)] = at(sample, i);
}

bool Paths::changes_in(double after, double until) const {
    const auto next = std::ranges::upper_bound(changes_, after);
    return next != changes_.end() && *next <= until;
}

// The time for which a particle lies on a floor before it falls along an axis, or 0: it starts with
// zero velocity, and its final velocity tells for how long it has been falling. `is_changed`:
// velocities change without a collision on the way or at the end, so that the final velocity does
// not tell this.
double Paths::rest_of(const Point& from, const Point& to, std::size_t axis, bool is_changed) const {
    const double gravity = gravity_[axis], span = to.time - from.time;
    if (gravity == 0.0 || from.velocity[axis] != 0.0) return 0.0;
    if (is_changed)
        return to.velocity[axis] == 0.0 && to.place[axis] == from.place[axis] ? span : 0.0;
    constexpr double rounding = 1e-9;
    const double rest = span - std::clamp(to.velocity[axis] / gravity, 0.0, span);
    return rest > rounding * span ? rest : 0.0;
}

// Splits the path between two points into pieces. If velocities change in between, the path is
// computed forward from its start to the first change and backward from its end to the last change;
// between these it is taken as a single piece of constant acceleration.
void Paths::part(Eigen::Index particle, const Point& from, const Point& to,
                 std::vector<PathPiece>& pieces) const {
    pieces.clear();
    const auto first = std::ranges::lower_bound(changes_, from.time);
    const auto behind = std::lower_bound(first, changes_.end(), to.time);
    const bool is_changed = first != behind;
    const bool ends_changed = behind != changes_.end() && *behind == to.time;
    std::array<double, 3> rest{};
    for (std::size_t axis = 0; axis < rest.size(); ++axis)
        rest[axis] = rest_of(from, to, axis, is_changed || ends_changed);
    // Forward from the last point to the first change.
    PathPiece piece{
        .particle = particle, .from = from.time, .place = from.place, .velocity = from.velocity};
    double since = 0.0;
    const auto fall = [&](double after, double until) {
        for (std::size_t axis = 0; axis < rest.size(); ++axis)
            piece.acceleration[axis] = rest[axis] > since ? 0.0 : gravity_[axis];
        piece.to = until;
        pieces.push_back(piece);
        piece.place = pieces.back().place_after(piece.span());
        piece.velocity = pieces.back().velocity_after(piece.span());
        piece.from = until;
        since = after;
    };
    const double forward = is_changed ? *first : to.time;
    std::array<double, 3> ends = rest;
    std::ranges::sort(ends);
    for (const double after : ends)
        if (after > since && from.time + after < forward) fall(after, from.time + after);
    fall(forward - from.time, forward);
    if (!is_changed) return;
    const double change = *std::prev(behind), span = to.time - change;
    PathPiece last{.particle = particle, .from = change, .to = to.time};
    last.acceleration = pieces.back().acceleration;
    last.velocity = to.velocity - span * last.acceleration;
    last.place = to.place - span * (to.velocity - 0.5 * span * last.acceleration);
    if (change > forward) {
        const double between = change - forward;
        Vec way = last.place - piece.place;
        for (std::size_t axis = 0; axis < rest.size(); ++axis)
            if (period_[axis] > 0.0)
                way[axis] -= period_[axis] * std::round(way[axis] / period_[axis]);
        piece.to = change;
        piece.velocity = way / between - 0.5 * between * piece.acceleration;
        pieces.push_back(piece);
    }
    pieces.push_back(last);
}

}  // namespace carom

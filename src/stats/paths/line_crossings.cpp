#include "stats/paths/line_crossings.h"

#include <cmath>

namespace carom {

LineCrossings::LineCrossings(const Box& box, const Particles& particles, const CrossedLine& line,
                             const std::vector<Eigen::Index>& members,
                             std::vector<double> velocity_changes)
    : box_(box),
      particles_(particles),
      line_(line),
      paths_(box, std::move(velocity_changes)),
      ends_(static_cast<std::size_t>(particles.count())) {
    choose(members);
}

// Where a particle was when it was counted before says nothing of where it is when it is again.
void LineCrossings::choose(const std::vector<Eigen::Index>& members) {
    is_member_.assign(ends_.size(), false);
    for (const Eigen::Index i : members) is_member_[static_cast<std::size_t>(i)] = true;
    for (std::size_t i = 0; i < ends_.size(); ++i)
        if (!is_member_[i]) ends_[i].reset();
}

const CrossingTotals& LineCrossings::see(const Sample& sample,
                                         std::span<const Collision> collisions) {
    paths_(sample, collisions, [this](const PathPiece& piece) {
        if (is_member_[static_cast<std::size_t>(piece.particle)]) fly(piece);
    });
    return totals_;
}

// The number of the line (in a periodic box, of the image of the line) that is the last one at or
// below a position.
double LineCrossings::level(double place) const {
    const double above = (place - line_.at) / box_.length(line_.axis);
    if (!box_.is_periodic(line_.axis)) return above >= 0.0 ? 0.0 : -1.0;
    return std::floor(above);
}

// Consecutive pieces join only up to round-off. The level is therefore taken over from the previous
// piece: if a piece that ends at the line were followed by one that begins on the other side, the
// crossing would be lost.
double LineCrossings::level_at_start(const PathPiece& piece) const {
    const std::optional<End>& end = ends_[static_cast<std::size_t>(piece.particle)];
    const double place = piece.place[line_.axis];
    if (!end) return level(place);
    if (!box_.is_periodic(line_.axis)) return end->level;
    return end->level + std::round((place - end->place) / box_.length(line_.axis));
}

// Whether a place on the line is in the part that counts.
bool LineCrossings::is_between(const Vec& place) const {
    std::size_t k = 0;
    for (int axis = 0; axis < box_.dimension; ++axis) {
        if (axis == line_.axis) continue;
        const double along = box_.wrapped(axis, place[axis]);
        if (along < line_.between->low.at(k) || along > line_.between->high.at(k)) return false;
        ++k;
    }
    return true;
}

// Counts the crossings of a part of a flight on which the velocity along the axis does not change
// sign. The part begins at the time `begin` of the piece, on level `first`. Returns the level at
// its end.
double LineCrossings::add_monotone(const PathPiece& piece, double begin, const Point& from,
                                   const Point& to, double first) {
    const double way = from.velocity + to.velocity;
    const double last = level(to.place);
    if (first == last) return last;
    const std::size_t direction = last > first ? 0 : 1;
    const double pull = piece.acceleration[line_.axis];
    for (double k = std::min(first, last) + 1.0; k <= std::max(first, last); k += 1.0) {
        const double distance = line_.at + k * box_.length(line_.axis) - from.place;
        const double square = from.velocity * from.velocity + 2.0 * pull * distance;
        const double speed = std::copysign(std::sqrt(std::max(0.0, square)), way);
        const double sum = from.velocity + speed;
        const double time = begin + (sum != 0.0 ? 2.0 * distance / sum : 0.0);
        if (line_.between && !is_between(piece.place_after(time))) continue;
        ++totals_.count.at(direction);
        const double inverse_mass = particles_.inverse_mass[piece.particle];
        const Vec velocity = piece.velocity_after(time);
        if (inverse_mass > 0.0)
            totals_.energy.at(direction) += 0.5 * carom::square(velocity) / inverse_mass;
    }
    return last;
}

void LineCrossings::fly(const PathPiece& piece) {
    const double pull = piece.acceleration[line_.axis], span = piece.span();
    const double place = piece.place[line_.axis], velocity = piece.velocity[line_.axis];
    const auto at = [&](double time) {
        return Point{place + time * (velocity + 0.5 * time * pull), velocity + time * pull};
    };
    const Point from = at(0.0), to = at(span);
    double reached = level_at_start(piece);
    if (from.velocity * to.velocity >= 0.0) {
        reached = add_monotone(piece, 0.0, from, to, reached);
    } else {
        const double turn = -velocity / pull;
        const Point top = at(turn);
        reached = add_monotone(piece, 0.0, from, top, reached);
        reached = add_monotone(piece, turn, top, to, reached);
    }
    ends_[static_cast<std::size_t>(piece.particle)] = End{to.place, reached};
}

}  // namespace carom

#include "stats/paths/free_flights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carom {

FreeFlights::FreeFlights(const Box& box, bool ends_at_walls, std::vector<double> velocity_changes)
    : paths_(box, std::move(velocity_changes)),
      first_obstacle_(box.surfaces.first_obstacle()),
      ends_at_walls_(ends_at_walls) {}

bool FreeFlights::ends(const Collision& collision) const {
    return ends_at_walls_ || collision.second.is_particle() ||
           collision.second.surface() >= first_obstacle_;
}

const std::vector<FreeFlight>& FreeFlights::see(const Sample& sample,
                                                std::span<const Collision> collisions,
                                                const TakePiece& take) {
    const auto count = static_cast<std::size_t>(sample.position.rows());
    now_.resize(count);
    is_begun_.resize(count);
    ended_.clear();
    totals_.assign(count, {});
    paths_(sample, collisions, [&](const PathPiece& piece) {
        const auto i = static_cast<std::size_t>(piece.particle);
        const double span = piece.span();
        const double way =
            length_of_way(piece.velocity_after(0.5 * span), piece.acceleration, span);
        now_[i].length += way;
        now_[i].duration += span;
        totals_[i].way += way;
        totals_[i].time += span;
        const bool has_ended = piece.ended_by != nullptr && ends(*piece.ended_by);
        if (take) take(piece, has_ended);
        if (!has_ended) return;
        totals_[i].collisions += 1.0;
        if (is_begun_[i])
            ended_.push_back({piece.particle, piece.to, now_[i].length, now_[i].duration});
        is_begun_[i] = true;
        now_[i] = {};
    });
    return ended_;
}

}  // namespace carom

#include "panels/gas/flights.h"

#include <algorithm>
#include <cmath>

namespace carom {

Flights::Flights(const Box& box, const Run& run, Eigen::Index axis,
                 std::vector<Eigen::Index> particles)
    : box_(box),
      axis_(axis),
      particles_(std::move(particles)),
      paths_(box, velocity_changes(run)),
      pieces_(particles_.size()) {}

// Whether the last piece ends in a corner at the time of the frame: if a collision or a reversal
// coincides with it.
bool Flights::ends_in_corner(const Pieces& pieces, Eigen::Index particle,
                             const Sample& sample) const {
    const PathPiece& last = pieces.back();
    const double reached = last.velocity_after(last.span())[axis_];
    constexpr double rounding = 1e-9;
    const double gained = std::abs(box_.surfaces.gravity[axis_]) * last.span();
    return last.ended_by != nullptr || std::abs(sample.velocity(particle, axis_) - reached) >
                                           rounding * (std::abs(reached) + gained);
}

// Fills in the place of each particle at the time of the corner, and its velocities before and
// after.
void Flights::turn(Corner& corner, const FrameInput& input) const {
    for (std::size_t k = 0; k < particles_.size(); ++k) {
        const auto piece = std::ranges::find_if(
            pieces_[k], [&](const PathPiece& one) { return one.to >= corner.time; });
        const double span = corner.time - piece->from;
        corner.place.push_back(box_.wrapped(axis_, piece->place_after(span)[axis_]));
        corner.before.push_back(piece->velocity_after(span)[axis_]);
        corner.after.push_back(corner.before.back());
        if (piece->to > corner.time) continue;
        auto next = piece + 1;
        for (; next != pieces_[k].end() && next->from == corner.time; ++next)
            corner.after.back() = next->velocity[axis_];
        if (next == pieces_[k].end() && corner.time == input.sample.time)
            corner.after.back() = input.sample.velocity(particles_[k], axis_);
    }
}

std::vector<Flights::Corner> Flights::see(const FrameInput& input) {
    for (Pieces& pieces : pieces_) pieces.clear();
    paths_(input.sample, input.advanced.collisions, [&](const PathPiece& piece) {
        for (std::size_t k = 0; k < particles_.size(); ++k)
            if (particles_[k] == piece.particle) pieces_[k].push_back(piece);
    });
    std::vector<double> times;
    for (std::size_t k = 0; k < particles_.size(); ++k) {
        const Pieces& pieces = pieces_[k];
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (i + 1 < pieces.size() || ends_in_corner(pieces, particles_[k], input.sample))
                times.push_back(pieces[i].to);
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<Corner> corners;
    for (const double time : times) {
        corners.push_back({.time = time, .place = {}, .before = {}, .after = {}});
        turn(corners.back(), input);
    }

    Corner now{input.sample.time, {}, {}, {}};
    for (const Eigen::Index i : particles_) {
        now.place.push_back(input.sample.position(i, axis_));
        now.after.push_back(input.sample.velocity(i, axis_));
    }
    now.before = now.after;
    // A reversal between two frames of the same time.
    if (now.time == last_.time && now.after != last_.after && !last_.place.empty()) {
        now.before = last_.after;
        corners.push_back(now);
    }
    last_ = std::move(now);
    return corners;
}

}  // namespace carom

#include "stats/paths/lag_averages.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace carom {

LagAverages::LagAverages(const Box& box, Of of, std::vector<std::vector<Eigen::Index>> members,
                         double from, double longest, int count,
                         std::vector<double> velocity_changes)
    : of_(of),
      from_(from),
      longest_(longest),
      count_(count),
      paths_(box, std::move(velocity_changes)),
      sums_{Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(members.size()), count),
            Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(members.size()), count)} {
    for (std::size_t list = 0; list < members.size(); ++list)
        for (const Eigen::Index i : members[list]) {
            const auto particle = static_cast<std::size_t>(i);
            if (particle >= tracks_of_.size()) tracks_of_.resize(particle + 1);
            tracks_of_[particle].push_back(tracks_.size());
            tracks_.push_back({.list = static_cast<Eigen::Index>(list),
                               .older = std::vector<std::size_t>(static_cast<std::size_t>(count))});
        }
}

// Calls `use(index)` for each track of the piece's particle, if the piece ends after the start.
template <class Use>
void LagAverages::for_each_track(const PathPiece& piece, const Use& use) const {
    if (static_cast<std::size_t>(piece.particle) >= tracks_of_.size() || piece.to <= from_) return;
    for (const std::size_t track : tracks_of_[static_cast<std::size_t>(piece.particle)]) use(track);
}

void LagAverages::see(const Sample& sample, std::span<const Collision> collisions) {
    paths_.see_whole(sample, collisions, [this](const PathPiece& piece) {
        for_each_track(piece, [&](std::size_t track) { add(tracks_[track], piece); });
    });
}

// The piece from the start on, at the unwrapped position to which the track has led.
PathPiece LagAverages::continued(const Track& track, PathPiece piece) const {
    if (piece.from < from_) {
        piece.place = place(piece, from_);
        piece.velocity = velocity(piece, from_);
        piece.from = from_;
    }
    if (!track.pieces.empty()) piece.place = place(track.pieces.back(), piece.from);
    return piece;
}

void LagAverages::add(Track& track, const PathPiece& piece) {
    track.pieces.push_back(continued(track, piece));
    add_lags(track, sums_);
    while (track.pieces.front().to <= piece.to - longest_ && track.pieces.size() > 1) {
        track.pieces.pop_front();
        ++track.dropped;
    }
}

void LagAverages::add_lags(Track& track, Sums& to) const {
    for (int k = 0; k < count_; ++k)
        add_lag(track, k, track.older[static_cast<std::size_t>(k)], to);
}

// Integrates over the times of the last piece for which the earlier end lies after the start.
// Simpson's rule is exact here: the integrand is a product of two velocities, or the square
// of a displacement, each of which changes at a steady rate. `older` is the number of the piece in
// which the earlier end was last.
void LagAverages::add_lag(const Track& track, int k, std::size_t& older, Sums& to) const {
    const PathPiece& late = track.pieces.back();
    const std::size_t behind = track.dropped + track.pieces.size();
    double time = std::max(late.from, from_ + lag(k));
    older = std::max(older, track.dropped);
    while (time < late.to) {
        while (older + 1 < behind && track.pieces[older - track.dropped].to <= time - lag(k))
            ++older;
        const PathPiece& early = track.pieces[older - track.dropped];
        const bool is_last = older + 1 == behind;
        const double end = is_last ? late.to : std::min(late.to, early.to + lag(k));
        if (end > time) {
            const double middle = 0.5 * (time + end);
            to.products(track.list, k) += (end - time) / 6.0 *
                                          (value(early, time - lag(k), late, time) +
                                           4.0 * value(early, middle - lag(k), late, middle) +
                                           value(early, end - lag(k), late, end));
            to.times(track.list, k) += end - time;
        } else if (!is_last) {
            ++older;
        }
        if (!(end > time) && is_last) return;
        time = std::max(time, end);
    }
}

double LagAverages::value(const PathPiece& early, double early_time, const PathPiece& late,
                          double late_time) const {
    if (of_ == Of::velocities) return dot(velocity(early, early_time), velocity(late, late_time));
    return square(place(late, late_time) - place(early, early_time));
}

// With the flights that are still going on. If velocities change on the way, a flight has several
// pieces, so the tracks of such a particle are continued in a copy.
Eigen::ArrayXXd LagAverages::averages() const {
    Sums all = sums_;
    Eigen::Index particle = -1;
    std::vector<Track> going_on;
    paths_.see_open([&](const PathPiece& piece) {
        std::size_t next = 0;
        const bool is_new = std::exchange(particle, piece.particle) != piece.particle;
        if (is_new) going_on.clear();
        for_each_track(piece, [&](std::size_t index) {
            if (next == going_on.size()) going_on.push_back(tracks_[index]);
            Track& track = going_on[next++];
            track.pieces.push_back(continued(track, piece));
            add_lags(track, all);
        });
    });
    return (all.times > 0.0)
        .select(all.products / all.times, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace carom

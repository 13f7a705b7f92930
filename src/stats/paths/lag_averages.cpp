#include "stats/paths/lag_averages.h"

#include <algorithm>
#include <limits>

namespace carom {

LagAverages::LagAverages(const Box& box, Of of, std::vector<std::vector<Eigen::Index>> members,
                         double from, double longest, int count,
                         std::vector<double> velocity_changes)
    : of_(of),
      from_(from),
      longest_(longest),
      count_(count),
      paths_(box, std::move(velocity_changes)),
      sums_(Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(members.size()), count)),
      times_(sums_) {
    for (std::size_t list = 0; list < members.size(); ++list)
        for (const Eigen::Index i : members[list]) {
            const auto particle = static_cast<std::size_t>(i);
            if (particle >= tracks_of_.size()) tracks_of_.resize(particle + 1);
            tracks_of_[particle].push_back(tracks_.size());
            tracks_.push_back({.list = static_cast<Eigen::Index>(list),
                               .older = std::vector<std::size_t>(static_cast<std::size_t>(count))});
        }
}

void LagAverages::see(const Sample& sample, std::span<const Collision> collisions) {
    paths_(sample, collisions, [this](const PathPiece& piece) {
        if (static_cast<std::size_t>(piece.particle) >= tracks_of_.size() || piece.to <= from_)
            return;
        for (const std::size_t track : tracks_of_[static_cast<std::size_t>(piece.particle)])
            add(tracks_[track], piece);
    });
}

void LagAverages::add(Track& track, PathPiece piece) {
    if (piece.from < from_) {
        piece.place = place(piece, from_);
        piece.velocity = velocity(piece, from_);
        piece.from = from_;
    }
    if (!track.pieces.empty()) piece.place = place(track.pieces.back(), piece.from);
    track.pieces.push_back(piece);
    for (int k = 0; k < count_; ++k) add_lag(track, k);
    while (track.pieces.front().to <= piece.to - longest_ && track.pieces.size() > 1) {
        track.pieces.pop_front();
        ++track.dropped;
    }
}

// Integrates over the times of the last piece for which the earlier end lies after the start.
// Simpson's rule is exact here: the integrand is a product of two velocities, or the square
// of a displacement, each of which changes at a steady rate.
void LagAverages::add_lag(Track& track, int k) {
    const PathPiece& late = track.pieces.back();
    double time = std::max(late.from, from_ + lag(k));
    std::size_t& older = track.older[static_cast<std::size_t>(k)];
    older = std::max(older, track.dropped);
    while (time < late.to) {
        while (older + 1 < track.dropped + track.pieces.size() &&
               track.pieces[older - track.dropped].to <= time - lag(k))
            ++older;
        const PathPiece& early = track.pieces[older - track.dropped];
        const bool is_last = older + 1 == track.dropped + track.pieces.size();
        const double end = is_last ? late.to : std::min(late.to, early.to + lag(k));
        if (end > time) {
            const double middle = 0.5 * (time + end);
            sums_(track.list, k) += (end - time) / 6.0 *
                                    (value(early, time - lag(k), late, time) +
                                     4.0 * value(early, middle - lag(k), late, middle) +
                                     value(early, end - lag(k), late, end));
            times_(track.list, k) += end - time;
        } else if (!is_last) {
            ++older;
        }
        if (!(end > time) && is_last) return;
        time = std::max(time, end);
    }
}

double LagAverages::value(const PathPiece& early, double early_time, const PathPiece& late,
                          double late_time) const {
    if (of_ == Of::velocities)
        return (velocity(early, early_time) * velocity(late, late_time)).sum();
    return (place(late, late_time) - place(early, early_time)).square().sum();
}

Eigen::ArrayXd LagAverages::means(std::size_t list) const {
    const auto row = static_cast<Eigen::Index>(list);
    return (times_.row(row) > 0.0)
        .select(sums_.row(row) / times_.row(row), std::numeric_limits<double>::quiet_NaN())
        .transpose();
}

}  // namespace carom

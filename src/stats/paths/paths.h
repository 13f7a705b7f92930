// The paths of particles between two samples of a run, split into pieces of constant acceleration:
// the input of all averages that use exact times.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <span>
#include <vector>

#include "physics/run.h"
#include "physics/simulation.h"

namespace carom {

/// A piece of a particle's path. In one dimension all y components are 0.
struct PathPiece {
    Eigen::Index particle = 0;
    double from = 0.0, to = 0.0;          ///< times
    Vec place = {};                       ///< at `from`
    Vec velocity = {};                    ///< at `from`
    Vec acceleration = {};                ///< gravity; 0 along an axis while it lies on a floor
    const Collision* ended_by = nullptr;  ///< null: ended by the sample or an event of the run

    double span() const { return to - from; }
    Vec place_after(double time) const {
        return place + time * (velocity + 0.5 * time * acceleration);
    }
    Vec velocity_after(double time) const { return velocity + time * acceleration; }

    /// The part between two times since its start; ended_by is left out.
    PathPiece part(double since, double until) const {
        return {.particle = particle,
                .from = from + since,
                .to = until < span() ? from + until : to,
                .place = place_after(since),
                .velocity = velocity_after(since),
                .acceleration = acceleration};
    }

    /// Writes or reads all members except `ended_by`, which is valid only during the call that
    /// receives the piece.
    void archive(auto& archive) {
        archive(particle, from, to, place, velocity, acceleration);
        ended_by = nullptr;
    }
};

/// The times, in ascending order, at which velocities in a run change without a collision:
/// reversals, heating, and heating that is undone by a reversal.
std::vector<double> velocity_changes(const Run& run);

/// The length of a path, i.e. the integral of the speed over a time `span`, for constant
/// acceleration `gravity` and the velocity `middle` halfway through the time.
double length_of_way(const Vec& middle, const Vec& gravity, double span);

class Paths {
  public:
    Paths(const Box& box, std::vector<double> changes);

    /// Takes the next sample; samples must come in order of time, each with all collisions since
    /// the previous one. Calls `see(piece)` for each piece since then, the pieces of one particle
    /// in order of time.
    void operator()(const Sample& sample, std::span<const Collision> collisions,
                    std::invocable<const PathPiece&> auto&& see) {
        if (!last_.empty() && sample.time > time_) {
            collide(collisions, see);
            cut(sample, see);
        }
        take(sample, last_);
        time_ = sample.time;
    }

    /// The same with flights whole, for what takes long to do with each piece: a sample ends
    /// pieces only if velocities have changed without a collision since the previous one. The
    /// pieces do not depend on when samples are taken, except near such a change.
    void see_whole(const Sample& sample, std::span<const Collision> collisions,
                   std::invocable<const PathPiece&> auto&& see) {
        const bool is_first = last_.empty();
        if (!is_first && sample.time > time_) {
            collide(collisions, see);
            if (changes_in(time_, sample.time)) {
                cut(sample, see);
                take(sample, last_);
            }
        }
        if (is_first) take(sample, last_);
        if (!is_straight_) take(sample, now_);
        time_ = sample.time;
    }

    /// Ends all flights at the sample that see_whole() has taken last, and calls `see(piece)` for
    /// their last pieces: what follows belongs to something else.
    void end_flights(const Sample& sample, std::invocable<const PathPiece&> auto&& see) {
        cut(sample, see);
    }

    /// Calls `see(piece)` for the pieces from where see_whole() has left off to the last sample.
    void see_open(std::invocable<const PathPiece&> auto&& see) const {
        std::vector<PathPiece> pieces;
        for (std::size_t i = 0; i < last_.size(); ++i) {
            if (last_[i].time >= time_) continue;
            const auto particle = static_cast<Eigen::Index>(i);
            if (is_straight_) {
                see(straight(particle, last_[i], time_));
                continue;
            }
            part(particle, last_[i], now_[i], pieces);
            for (const PathPiece& piece : pieces) see(piece);
        }
    }

    /// Writes or reads the last known state of the particles.
    void archive(auto& archive) { archive(last_, now_, time_); }

  private:
    struct Point {
        double time = 0.0;
        Vec place = {}, velocity = {};
        void archive(auto& archive) { archive(time, place, velocity); }
    };
    static Point at(const Sample& sample, Eigen::Index particle) {
        return {sample.time, vec_in(sample.position, particle), vec_in(sample.velocity, particle)};
    }
    static void take(const Sample& sample, std::vector<Point>& points);
    bool changes_in(double after, double until) const;
    void part(Eigen::Index particle, const Point& from, const Point& to,
              std::vector<PathPiece>& pieces) const;
    double rest_of(const Point& from, const Point& to, std::size_t axis, bool is_changed) const;

    static PathPiece straight(Eigen::Index particle, const Point& from, double to) {
        return {.particle = particle,
                .from = from.time,
                .to = to,
                .place = from.place,
                .velocity = from.velocity};
    }

    void collide(std::span<const Collision> collisions, auto&& see) {
        for (const Collision& collision : collisions) {
            advance(collision.first,
                    {collision.time, collision.first_position, collision.first_before}, &collision,
                    see);
            last_[static_cast<std::size_t>(collision.first)].velocity = collision.first_after;
            if (!collision.second.is_particle()) continue;
            const std::int32_t second = collision.second.particle();
            advance(second, {collision.time, collision.second_position, collision.second_before},
                    &collision, see);
            last_[static_cast<std::size_t>(second)].velocity = collision.second_after;
        }
    }

    void cut(const Sample& sample, auto&& see) {
        for (Eigen::Index i = 0; i < sample.position.rows(); ++i)
            advance(i, at(sample, i), nullptr, see);
    }

    void advance(Eigen::Index particle, const Point& to, const Collision* by, auto&& see) {
        Point& from = last_[static_cast<std::size_t>(particle)];
        if (to.time < from.time) return;             // a collision before the first sample
        if (to.time > from.time || by != nullptr) {  // also of zero length, if two coincide
            if (is_straight_) {
                PathPiece piece = straight(particle, from, to.time);
                piece.ended_by = by;
                see(piece);
            } else {
                part(particle, from, to, pieces_);
                pieces_.back().ended_by = by;
                for (const PathPiece& piece : pieces_) see(piece);
            }
        }
        from = to;
    }

    Vec gravity_ = {};
    Vec period_ = {};  ///< 0 between walls
    std::vector<double> changes_;
    bool is_straight_ = true;        ///< no gravity and no changes
    std::vector<PathPiece> pieces_;  ///< scratch: between two points of a path
    std::vector<Point> last_;        ///< state of each particle at the end of its last piece
    std::vector<Point> now_;  ///< at the last sample, of see_whole(); none if paths are straight
    double time_ = 0.0;       ///< of the last sample
};

}  // namespace carom

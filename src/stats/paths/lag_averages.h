// Averages over pairs of times that are a given lag apart, since a start time: the velocity
// autocorrelation and the mean squared displacement. The integrals over free flights are exact, not
// computed from samples.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

class LagAverages {
  public:
    enum class Of {
        velocities,    ///< v(t) . v(t + lag)
        displacements  ///< (r(t + lag) - r(t))^2, continued through periodic sides
    };

    /// Averages at `count` equidistant lags from 0 to `longest`, for each list of particles in
    /// `members`, over times from `from` on.
    LagAverages(const Box& box, Of of, std::vector<std::vector<Eigen::Index>> members, double from,
                double longest, int count, std::vector<double> velocity_changes);

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one.
    void see(const Sample& sample, std::span<const Collision> collisions);

    double lag(int k) const { return longest_ * k / (count_ - 1); }

    /// The averages over all particles of a list (a row for each) and all pairs of times between
    /// the start and the last sample, at each lag (a column); NaN for lags longer than the time so
    /// far. They do not depend on which samples were given before. Takes as long as a collision of
    /// each particle.
    Eigen::ArrayXXd averages() const;

    /// Writes or reads the accumulated state; lists and lags are not part of it.
    void archive(auto& archive) { archive(paths_, tracks_, sums_); }

  private:
    struct Track {
        Eigen::Index list = 0;
        std::deque<PathPiece> pieces = {};    ///< within the longest lag, unwrapped positions
        std::size_t dropped = 0;              ///< number of earlier pieces, already discarded
        std::vector<std::size_t> older = {};  ///< by lag: the piece with its earlier end
        void archive(auto& archive) { archive(list, pieces, dropped, older); }
    };
    struct Sums {
        Eigen::ArrayXXd products, times;  ///< list x lag
        void archive(auto& archive) { archive(products, times); }
    };
    template <class Use>
    void for_each_track(const PathPiece& piece, const Use& use) const;
    PathPiece continued(const Track& track, PathPiece piece) const;
    void add(Track& track, const PathPiece& piece);
    void add_lags(Track& track, Sums& to) const;
    void add_lag(const Track& track, int k, std::size_t& older, Sums& to) const;
    double value(const PathPiece& early, double early_time, const PathPiece& late,
                 double late_time) const;
    Vec place(const PathPiece& piece, double time) const {
        return piece.place_after(time - piece.from);
    }
    Vec velocity(const PathPiece& piece, double time) const {
        return piece.velocity_after(time - piece.from);
    }

    Of of_;
    double from_, longest_;
    int count_;
    Paths paths_;
    std::vector<Track> tracks_;                        ///< one for each particle of each list
    std::vector<std::vector<std::size_t>> tracks_of_;  ///< indices in `tracks_`, for each particle
    Sums sums_;                                        ///< of flights that have ended
};

}  // namespace carom

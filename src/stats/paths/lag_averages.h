// Averages of what a particle does at two times that are a lag apart, over all such times since a
// start: the velocity autocorrelation, and the mean squared displacement. Exact integrals over
// free flights; nothing is sampled.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

class LagAverages {
  public:
    enum class Of {
        velocities,    ///< v(t) . v(t + lag)
        displacements  ///< (r(t + lag) - r(t))^2, on through periodic sides
    };

    /// At `count` lags from 0 to `longest`, of each list of particles.
    LagAverages(const Box& box, Of of, std::vector<std::vector<Eigen::Index>> members, double from,
                double longest, int count, std::vector<double> velocity_changes);

    /// Samples in order of time, with all collisions on the way from the one before.
    void see(const Sample& sample, std::span<const Collision> collisions);

    double lag(int k) const { return longest_ * k / (count_ - 1); }

    /// The mean at each lag over all particles of a list and all times from the start on at which
    /// the run has come to both ends; NaN where there are none yet.
    Eigen::ArrayXd means(std::size_t list) const;

    /// Writes or reads all that was seen; lists and lags are not part of it.
    void archive(auto& archive) { archive(paths_, tracks_, sums_, times_); }

  private:
    struct Track {
        Eigen::Index list = 0;
        std::deque<PathPiece> pieces = {};  ///< within the longest lag; places go on through sides
        std::size_t dropped = 0;            ///< before these
        std::vector<std::size_t> older = {};  ///< for each lag, the piece where its earlier end is
        void archive(auto& archive) { archive(list, pieces, dropped, older); }
    };
    void add(Track& track, PathPiece piece);
    void add_lag(Track& track, int k);
    double value(const PathPiece& early, double early_time, const PathPiece& late,
                 double late_time) const;
    Eigen::Array2d place(const PathPiece& piece, double time) const {
        return piece.place_after(time - piece.from);
    }
    Eigen::Array2d velocity(const PathPiece& piece, double time) const {
        return piece.velocity_after(time - piece.from);
    }

    Of of_;
    double from_, longest_;
    int count_;
    Paths paths_;
    std::vector<Track> tracks_;                        ///< of each particle in each list
    std::vector<std::vector<std::size_t>> tracks_of_;  ///< numbers of these, of each particle
    Eigen::ArrayXXd sums_, times_;                     ///< list x lag
};

}  // namespace carom

// The pair correlation g(r): how many pairs of particles are at a distance, over the number that
// points would have that lie anywhere where the centres can be. Times at a distance are exact, by
// free flights between collisions; nothing is sampled.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"
#include "stats/paths/sliding_sum.h"

namespace carom {

/// Where the sides of a box are: from and to, along each axis.
using BoxSides = std::array<std::pair<double, double>, 2>;
BoxSides sides_of(const Box& box);

/// The probability that two points, each anywhere where the centre of a disk of its radius can be,
/// are at a distance between `low` and `high`; in periodic boxes from nearest image to nearest
/// image, up to half of the box.
double ring_probability(const Box& box, const BoxSides& sides, std::pair<double, double> radii,
                        double low, double high);

class PairCorrelation {
  public:
    struct Wanted {
        std::vector<bool> first = {}, second = {};  ///< of all particles: pairs of one of these
                                                    ///< and one of those; empty: all of them
        double to = 1.0;                            ///< the largest distance
        int rings = 100;                            ///< equal bins up to there
        std::optional<double> window = {};          ///< time before the present, 0: the present
                                                    ///< alone; none: since the start
    };

    PairCorrelation(const Box& box, const Particles& particles, Wanted wanted,
                    std::vector<double> velocity_changes);

    /// Samples in order of time, with all collisions on the way from the one before, and where the
    /// sides are now.
    void see(const Sample& sample, std::span<const Collision> collisions, const BoxSides& sides);

    /// g in each ring, over the window; of the moment where no time has passed.
    Eigen::ArrayXd values() const;

    /// Writes or reads all that was seen; what is wanted is not part of it.
    void archive(auto& archive) {
        archive(paths_, pairs_, expected_, moment_, moment_expected_, sides_, time_);
    }

  private:
    bool is_wanted(Eigen::Index i, Eigen::Index j) const;
    void find_kinds();
    Eigen::ArrayXd expected(const BoxSides& sides);
    double farthest_from_end(std::span<const PathPiece> pieces) const;
    double distance(const Eigen::ArrayXXd& positions, Eigen::Index i, Eigen::Index j) const;
    void add_flights(const Eigen::ArrayXXd& positions, Eigen::ArrayXd& time);
    void add_pair(std::span<const PathPiece> first, std::span<const PathPiece> second,
                  Eigen::ArrayXd& time);
    int chords_of(double acceleration, double span) const;
    void add_images(const Eigen::Array2d& place, const Eigen::Array2d& velocity, double span,
                    Eigen::ArrayXd& time) const;
    void add_flight(const Eigen::Array2d& place, const Eigen::Array2d& velocity, double span,
                    Eigen::ArrayXd& time) const;
    void add_moment(const Sample& sample, const BoxSides& sides);
    void add_at(double distance, double time, Eigen::ArrayXd& sums) const;
    void add_between(double from, double to, double least, double speed,
                     Eigen::ArrayXd& sums) const;

    Box box_;
    Particles particles_;
    Wanted wanted_;
    double width_;  ///< of a ring
    std::vector<std::pair<std::pair<double, double>, double>>
        kinds_;  ///< radii, and how many pairs
    Paths paths_;
    SlidingSum pairs_, expected_;
    Eigen::ArrayXd moment_, moment_expected_;
    std::optional<BoxSides> sides_;  ///< at the sample before
    std::optional<std::pair<BoxSides, Eigen::ArrayXd>> last_expected_;
    std::vector<std::vector<PathPiece>> pieces_;  ///< of each particle, since the sample before
    double time_ = 0.0;
};

}  // namespace carom

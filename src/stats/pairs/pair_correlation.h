// The pair correlation function g(r): the number of pairs of particles at distance r, divided by
// the number expected for points distributed uniformly over the positions that the centres can
// reach. The times that pairs spend at a distance are exact, computed from the free flights between
// collisions, not from samples.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "stats/pairs/rings.h"
#include "stats/paths/paths.h"
#include "stats/paths/sliding_sum.h"

namespace carom {

class PairCorrelation {
  public:
    struct Wanted {
        std::vector<bool> first = {}, second = {};  ///< flags by particle: pairs of one of `first`
                                                    ///< and one of `second`; empty: all
        double to = 1.0;                            ///< the largest distance
        int rings = 100;                            ///< number of equal bins up to `to`; in space
                                                    ///< they are shells
        std::optional<double> window = {};  ///< length of time before the present; 0: the present
                                            ///< moment only; none: all since the start
    };

    PairCorrelation(const Box& box, const Particles& particles, Wanted wanted,
                    std::vector<double> velocity_changes);

    /// Changes `first` and `second` of Wanted for what is seen from now on. The present moment is
    /// that of the next call of see(), which may take the last sample again.
    void choose(std::vector<bool> first, std::vector<bool> second) {
        if (time_ > since_) add_all_pieces();  // of the pairs until now
        wanted_.first = std::move(first);
        wanted_.second = std::move(second);
        find_kinds();
    }

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one. `sides`: the positions of the sides at this sample.
    void see(const Sample& sample, std::span<const Collision> collisions, const BoxSides& sides);

    /// g (dimensionless) in each ring, averaged over the window; for the last sample alone if no
    /// time has passed. Takes as long as a flight of each particle.
    Eigen::ArrayXd values() const;

    /// How many times of two particles that fly near each other see() has added: the measure of its
    /// work. Without a window it hardly depends on how many samples are taken.
    double flights_added() const { return flights_added_; }

    /// Writes or reads the accumulated state; `wanted` is not part of it.
    void archive(auto& archive) {
        archive(paths_, pairs_, expected_, moment_, moment_expected_, sides_, pieces_, since_,
                speed_, time_, flights_added_, is_read_);
    }

  private:
    /// The pieces of each particle's path that are not added yet, in order of time.
    using Pieces = std::vector<std::vector<PathPiece>>;
    struct Interval {
        double from, to;
        double middle() const { return 0.5 * (from + to); }
    };
    static void for_each_slice(const SlidingSum& sums, Interval whole, const auto& add) {
        for (double from = whole.from; from < whole.to;) {
            const double to = std::min(whole.to, sums.end_of_slice(from));
            add(Interval{from, to});
            from = to;
        }
    }
    bool is_wanted(Eigen::Index i, Eigen::Index j) const;
    void find_kinds();
    Eigen::ArrayXd expected(const BoxSides& sides);
    void see_pieces(const Sample& sample, std::span<const Collision> collisions);
    Pieces with_open() const;
    void add_all_pieces();
    int slices_in(Interval within) const;
    void add_pieces(const Pieces& pieces, Interval whole, Eigen::ArrayXd& time,
                    double& flights) const;
    double farthest_from_end(std::span<const PathPiece> pieces, Interval within) const;
    double distance(const Eigen::ArrayXXd& positions, Eigen::Index i, Eigen::Index j) const;
    void add_flights(std::span<const std::span<const PathPiece>> pieces, Interval within,
                     Eigen::ArrayXd& time, double& flights) const;
    double add_pair(std::span<const PathPiece> first, std::span<const PathPiece> second,
                    Interval within, Eigen::ArrayXd& time) const;
    int chords_of(double acceleration, double span) const;
    void add_images(const Vec& place, const Vec& velocity, double span, Eigen::ArrayXd& time) const;
    void add_flight(const Vec& place, const Vec& velocity, double span, Eigen::ArrayXd& time) const;
    void add_moment(const Sample& sample, const BoxSides& sides);
    void add_at(double distance, double time, Eigen::ArrayXd& sums) const;
    void add_between(double from, double to, double least, double speed,
                     Eigen::ArrayXd& sums) const;

    Box box_;
    Particles particles_;
    Wanted wanted_;
    double width_;  ///< of a ring
    std::vector<std::pair<std::pair<double, double>, double>>
        kinds_;  ///< pairs of radii, and the number of particle pairs with these radii
    Paths paths_;
    SlidingSum pairs_, expected_;
    Eigen::ArrayXd moment_, moment_expected_;
    std::optional<BoxSides> sides_;  ///< at the previous sample
    std::optional<std::pair<BoxSides, Eigen::ArrayXd>> last_expected_;
    Pieces pieces_;       ///< from `since_` on; flights may begin before
    double since_ = 0.0;  ///< the time up to which pieces are added
    double speed_ = 0.0;  ///< of the fastest particles at the previous sample
    double time_ = 0.0;
    double flights_added_ = 0.0;
    mutable bool is_read_ = false;  ///< whether values() was called since the last see()
};

}  // namespace carom

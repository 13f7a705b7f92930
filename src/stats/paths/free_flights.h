// Free flights of particles from one collision to the next: their lengths and durations.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

struct FreeFlight {
    Eigen::Index particle = 0;
    double ended = 0.0;  ///< time
    double length = 0.0, duration = 0.0;
    void archive(auto& archive) { archive(particle, ended, length, duration); }
};

/// Totals of a particle over a time, including flights that have not ended with a collision.
struct FlightTotals {
    double collisions = 0.0;  ///< number of collisions that end flights
    double way = 0.0;         ///< of all together
    double time = 0.0;        ///< of all together

    FlightTotals& operator+=(const FlightTotals& other) {
        collisions += other.collisions;
        way += other.way;
        time += other.time;
        return *this;
    }
};

/// A flight ends at a collision with another particle or an obstacle. Walls and partitions change
/// its direction without ending it, unless `ends_at_walls`.
class FreeFlights {
  public:
    FreeFlights(const Box& box, bool ends_at_walls, std::vector<double> velocity_changes);

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one. Returns the flights that have ended since then, except the first one of
    /// each particle, whose beginning is unknown.
    /// `take` is called for each piece of the paths since then, and whether a flight ends with it.
    using TakePiece = std::function<void(const PathPiece&, bool ends_flight)>;
    const std::vector<FreeFlight>& see(const Sample& sample, std::span<const Collision> collisions,
                                       const TakePiece& take = {});

    /// The totals of each particle since the previous sample.
    const std::vector<FlightTotals>& totals() const { return totals_; }

    /// Writes or reads the flights in progress.
    void archive(auto& archive) { archive(paths_, now_, is_begun_); }

  private:
    bool ends(const Collision& collision) const;

    Paths paths_;
    std::int32_t first_obstacle_;
    bool ends_at_walls_;
    std::vector<FreeFlight> now_;  ///< the flight in progress of each particle
    std::vector<bool> is_begun_;   ///< whether it began at a collision
    std::vector<FreeFlight> ended_;
    std::vector<FlightTotals> totals_;
};

}  // namespace carom

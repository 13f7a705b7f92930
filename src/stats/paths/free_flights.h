// Free flights of particles from one collision to the next: their lengths and durations, and the
// exact means of both.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

struct FreeFlight {
    Eigen::Index particle = 0;
    double ended = 0.0;  ///< time
    double length = 0.0, duration = 0.0;
    void archive(auto& archive) { archive(particle, ended, length, duration); }
};

/// What particles have done in a time, whether or not it ended with a collision.
struct FlightTotals {
    double collisions = 0.0;  ///< that end flights
    double way = 0.0;         ///< of all together
    double time = 0.0;        ///< of all together
};

/// A flight ends at a collision with another particle or an obstacle. Walls and partitions turn it
/// without ending it, unless they count too.
class FreeFlights {
  public:
    FreeFlights(const Box& box, bool ends_at_walls, std::vector<double> velocity_changes);

    /// Samples in order of time, with all collisions on the way from the one before. Gives the
    /// flights that have ended since then, but for the first one of each particle, whose beginning
    /// nobody saw.
    const std::vector<FreeFlight>& see(const Sample& sample, std::span<const Collision> collisions);

    /// Since the sample before, of each particle.
    const std::vector<FlightTotals>& totals() const { return totals_; }

    /// Writes or reads the present flights.
    void archive(auto& archive) { archive(paths_, now_, is_begun_); }

  private:
    bool ends(const Collision& collision) const;

    Paths paths_;
    std::int32_t first_obstacle_;
    bool ends_at_walls_;
    std::vector<FreeFlight> now_;  ///< of each particle: the present flight
    std::vector<bool> is_begun_;   ///< whether it began at a collision
    std::vector<FreeFlight> ended_;
    std::vector<FlightTotals> totals_;
};

/// The exact mean free path of a single disk between fixed disks, from hit to hit: pi times the
/// area that its centre has over its perimeter. None where that does not hold: among other
/// obstacles, disks that it cannot pass between, partitions, gravity, walls that act or that do not
/// end a flight.
std::optional<double> mean_path_of_billiard(const Box& box, double radius, bool ends_at_walls);

}  // namespace carom

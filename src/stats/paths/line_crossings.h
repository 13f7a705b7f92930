// The particles and the energy that cross a line, in space a plane, in each direction, found
// exactly from the free flights between collisions, not from samples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

/// A line perpendicular to an axis, in space a plane, or a part of it.
struct CrossedLine {
    int axis = 0;
    double at = 0.0;
    std::optional<Gap> between = {};  ///< the part, like the gap of a partition; none: all
};

/// Totals since the first sample: [0] toward larger coordinates, [1] toward smaller.
struct CrossingTotals {
    std::array<std::int64_t, 2> count{};
    std::array<double, 2> energy{};  ///< kinetic energy of the crossing particles of finite mass
};

class LineCrossings {
  public:
    /// `members`: the indices of the particles that are counted.
    LineCrossings(const Box& box, const Particles& particles, const CrossedLine& line,
                  const std::vector<Eigen::Index>& members, std::vector<double> velocity_changes);

    /// Changes which particles are counted, from the last sample seen on.
    void choose(const std::vector<Eigen::Index>& members);

    /// Takes the next sample. Samples must come in order of time, each with all collisions since
    /// the previous one. Returns the totals up to this sample.
    const CrossingTotals& see(const Sample& sample, std::span<const Collision> collisions);

  private:
    /// Position and velocity along the axis.
    struct Point {
        double place, velocity;
    };
    void fly(const PathPiece& piece);
    /// The position of a particle at the end of a piece, and its level(). The next piece begins at
    /// the same position up to round-off, or a box length away.
    struct End {
        double place, level;
    };
    double add_monotone(const PathPiece& piece, double begin, const Point& from, const Point& to,
                        double first);
    bool is_between(const Vec& place) const;
    double level(double place) const;
    double level_at_start(const PathPiece& piece) const;

    Box box_;
    Particles particles_;
    CrossedLine line_;
    std::vector<bool> is_member_;
    Paths paths_;
    std::vector<std::optional<End>> ends_;
    CrossingTotals totals_;
};

}  // namespace carom

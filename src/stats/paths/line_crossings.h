// What crosses a straight line, each way, by exact flights between collisions: nothing is sampled.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "stats/paths/paths.h"

namespace carom {

/// A line perpendicular to an axis, or a part of it.
struct CrossedLine {
    int axis = 0;
    double at = 0.0;
    std::optional<std::pair<double, double>> between = {};  ///< along the other axis; none: all
};

/// Sums since the first sample: toward larger x or y, and toward smaller.
struct CrossingTotals {
    std::array<std::int64_t, 2> count{};
    std::array<double, 2> energy{};  ///< kinetic, of those of finite mass
};

class LineCrossings {
  public:
    /// `members`: which particles are counted.
    LineCrossings(const Box& box, const Particles& particles, const CrossedLine& line,
                  const std::vector<Eigen::Index>& members, std::vector<double> velocity_changes);

    /// Samples in order of time, with all collisions on the way from the one before.
    const CrossingTotals& see(const Sample& sample, std::span<const Collision> collisions);

  private:
    /// A point of a path along the axis.
    struct Point {
        double place, velocity;
    };
    void fly(const PathPiece& piece);
    /// Where a particle is at the end of a piece: its next one begins there but for round-off, or a
    /// box length away.
    struct End {
        double place, level;
    };
    double add_monotone(const PathPiece& piece, double begin, const Point& from, const Point& to,
                        double first);
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

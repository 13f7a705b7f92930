// World lines: where beads of a line were during the last while, as the places and times at which
// their velocities changed, or of frames where they fall. Knows no canvas.
#pragma once

#include <deque>
#include <vector>

#include "panels/gas/gas_colors.h"
#include "panels/line/line_map.h"
#include "panels/panel.h"

namespace carom {

class WorldLines {
  public:
    /// A place and a time at which a velocity changes, or of a frame while it falls.
    struct Bend {
        double time;          ///< simulated
        double place;         ///< as drawn, length
        std::uint16_t shade;  ///< of the piece that ends here
        void archive(auto& archive) { archive(time, place, shade); }
    };

    /// Of the last `memory` units of simulated time. Refers to the map and the colours.
    WorldLines(const PanelContext& context, const LineMap& map, const GasColors& colors,
               double memory);

    /// Every frame in order, with the places of all beads as drawn, now and one frame before.
    void see(const FrameInput& input, const Eigen::ArrayXd& places, const Eigen::ArrayXd& last);

    /// The beads whose lines are kept: all, or as many as part on a screen.
    std::size_t count() const { return particles_.size(); }
    Eigen::Index particle(std::size_t line) const { return particles_[line]; }

    /// A line with the present as its last bend, oldest first; the first may lie before the memory.
    std::vector<Bend> line(std::size_t line, const Bend& present) const;

    /// The simulated times of reversals in memory.
    std::vector<double> reversals(double now) const;

    /// Writes or reads the lines.
    void archive(auto& archive) { archive(bends_, reversals_); }

  private:
    void choose(const LineMap& map);
    void bend(std::size_t line, double time, double place, double mean_speed);

    PanelContext context_;
    const LineMap& map_;
    const GasColors& colors_;
    double memory_;
    std::vector<double> changes_;          ///< simulated times at which all velocities change
    std::vector<Eigen::Index> particles_;  ///< of each line
    std::vector<std::ptrdiff_t> line_of_;  ///< of each particle, or -1
    std::vector<std::deque<Bend>> bends_;  ///< of each line
    std::vector<double> reversals_;        ///< simulated times
};

/// Whether a film is about this bead: a single one among many, or one that should have a trail.
bool stands_out(const PanelContext& context, Eigen::Index particle);

}  // namespace carom

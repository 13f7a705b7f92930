// World lines: the recent paths of the beads of a line, stored as the places and times at which
// their velocities changed; under gravity, also at each frame. Independent of the canvas.
#pragma once

#include <deque>
#include <vector>

#include "panels/gas/gas_colors.h"
#include "panels/line/line_map.h"
#include "panels/panel.h"

namespace carom {

class WorldLines {
  public:
    /// A place and a time at which the velocity changes; under gravity, also those of each frame.
    struct Bend {
        double time;          ///< simulated
        double place;         ///< as drawn, length
        std::uint16_t shade;  ///< of the piece that ends here
        void archive(auto& archive) { archive(time, place, shade); }
    };

    /// Keeps the last `memory` units of simulated time. Holds references to `map` and `colors`.
    WorldLines(const PanelContext& context, const LineMap& map, const GasColors& colors,
               double memory);

    /// Called for every frame in order, with the places of all beads as drawn in this frame and in
    /// the frame before.
    void see(const FrameInput& input, const Eigen::ArrayXd& places, const Eigen::ArrayXd& last);

    /// The beads whose lines are kept: all, or as many as can be distinguished on a screen.
    std::size_t count() const { return particles_.size(); }
    Eigen::Index particle(std::size_t line) const { return particles_[line]; }

    /// The bends of a line, oldest first, with `present` as the last one; the first may be older
    /// than the memory.
    std::vector<Bend> line(std::size_t line, const Bend& present) const;

    /// The simulated times of reversals in memory.
    std::vector<double> reversals(double now) const;

    /// Writes or reads the lines.
    void archive(auto& archive) { archive(bends_, reversals_); }

  private:
    /// What the colours of a frame depend on.
    struct Present {
        double mean_speed;
        const Membership* membership;
    };
    void choose(const LineMap& map);
    void bend(std::size_t line, double time, double place, const Present& now);

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

/// Whether the film is about this bead: a single one among many, or one for which a trail is asked.
bool stands_out(const PanelContext& context, Eigen::Index particle);

}  // namespace carom

// The motion of particles between two frames along one axis, from one change of velocity to the
// next. Independent of the canvas.
#pragma once

#include <vector>

#include "panels/panel.h"
#include "stats/paths/paths.h"

namespace carom {

class Flights {
  public:
    /// A moment at which the velocity or the acceleration of one of the particles changes.
    struct Corner {
        double time;                ///< simulated
        std::vector<double> place;  ///< of each particle, length; wrapped into a periodic box
        std::vector<double> before, after;  ///< velocities of each
    };

    /// Follows `particles` along an axis (0 for x, 1 for y).
    Flights(const Box& box, const Run& run, Eigen::Index axis, std::vector<Eigen::Index> particles);

    /// Called for every frame in order, with the collisions since the frame before. Returns the
    /// corners since that frame, including those at this frame's time.
    std::vector<Corner> see(const FrameInput& input);

  private:
    using Pieces = std::vector<PathPiece>;
    void turn(Corner& corner, const FrameInput& input) const;
    bool ends_in_corner(const Pieces& pieces, Eigen::Index particle, const Sample& sample) const;

    Box box_;
    Eigen::Index axis_;
    std::vector<Eigen::Index> particles_;
    Paths paths_;
    std::vector<Pieces> pieces_;  ///< of each particle, since the frame before
    Corner last_{};               ///< the last frame
};

}  // namespace carom

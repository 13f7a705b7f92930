// How particles flew between two frames, along one axis: freely from one change of velocity
// to the next. Knows no canvas.
#pragma once

#include <vector>

#include "panels/panel.h"

namespace carom {

class Flights {
  public:
    /// A moment at which the velocity of one of the particles changes, or all are turned.
    struct Corner {
        double time;                        ///< simulated
        std::vector<double> place;          ///< of each particle, length; within a periodic box
        std::vector<double> before, after;  ///< velocities of each
    };

    /// Of some particles, along an axis (0 for x, 1 for y).
    Flights(const Box& box, Eigen::Index axis, std::vector<Eigen::Index> particles);

    /// Every frame in order, with the collisions on the way: the corners since the frame before,
    /// a reversal at this one included.
    std::vector<Corner> see(const FrameInput& input);

  private:
    void meet(Corner& corner, std::int32_t particle, double place, double after) const;
    double within(double place) const;

    Eigen::Index axis_;
    double period_;        ///< length; 0 between walls
    double acceleration_;  ///< of gravity
    std::vector<Eigen::Index> particles_;
    Corner last_{};  ///< or the last frame, whichever is later
    int reversals_ = 0;
};

}  // namespace carom

// The entropy of the positions of a gas, from counts in cells. That of velocities is in
// physics/theory/velocity_entropy.h.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "physics/particles.h"
#include "stats/cell_averages.h"

namespace carom {

/// -sum p ln p, where p is the share of the particles of finite mass that are in a cell of the box;
/// dimensionless. Particles that spread over a K times larger area or volume gain ln K.
class PositionEntropy {
  public:
    /// `along_longest`: the number of cells along the longest side; if empty, the even number that
    /// leaves about five particles in each cell.
    PositionEntropy(const Box& box, const Particles& particles, std::optional<int> along_longest);

    /// The entropy of these positions, N x dimension. Positions beyond sides that have moved count
    /// in the outermost cells.
    double of(const Eigen::ArrayXXd& position) const;

    const Cells& cells() const { return cells_; }

  private:
    Cells cells_;
    Eigen::ArrayXd counted_;  ///< 1 for finite masses
};

}  // namespace carom

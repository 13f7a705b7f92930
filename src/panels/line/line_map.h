// Maps the beads of a line to the places where they are drawn. Point particles are drawn with a
// radius, and all beads are shifted apart accordingly, so that two neighbours, or a bead and a
// wall, appear to touch when they collide. Independent of the canvas: lengths are those of the
// scene. The order of the beads and the radii that they are drawn with are those of the start.
#pragma once

#include <cstdint>
#include <vector>

#include "panels/panel.h"

namespace carom {

class LineMap {
  public:
    LineMap() = default;  ///< to be read into

    /// `start` determines the order of the beads, which never changes.
    LineMap(const PanelContext& context, const Sample& start);

    /// The particles from left to right.
    const std::vector<Eigen::Index>& order() const { return order_; }

    double radius(Eigen::Index i) const { return radius_[i]; }  ///< as drawn
    double length() const { return length_; }                   ///< of the line as drawn
    bool is_true(Eigen::Index i) const { return true_[i]; }     ///< drawn in its true length

    /// The places as drawn. On a ring they continue beyond its length without jumps; `last`, the
    /// places drawn before, determines the number of turns.
    Eigen::ArrayXd places(const Sample& sample, const Eigen::ArrayXd& last) const;

    /// The same for one particle at x, near `last`.
    double place(Eigen::Index i, double x, double last) const;

    void archive(auto& archive) {
        archive(true_length_, ring_, order_, radius_, true_, push_, length_);
    }

  private:
    double true_length_ = 0.0;
    bool ring_ = false;
    std::vector<Eigen::Index> order_;
    Eigen::ArrayXd radius_;
    Eigen::Array<bool, Eigen::Dynamic, 1> true_;
    Eigen::ArrayXd push_;  ///< shift to the right of the true place
    double length_ = 0.0;
};

}  // namespace carom

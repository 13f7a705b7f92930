// Particles that fade out after they have entered a part of the box.
#pragma once

#include <vector>

#include "panels/panel.h"

namespace carom {

class Fading {
  public:
    explicit Fading(const PanelContext& context) : context_(context) {}

    /// Every frame in order: dims what has been in that part for a while. `light`: the share of its
    /// colour that each particle keeps; empty: all of it.
    void see(const Tick& tick, const Eigen::ArrayXXd& position, std::vector<float>& light);

    /// Writes or reads since when each particle has been there.
    void archive(auto& archive) { archive(since_); }

  private:
    PanelContext context_;
    std::vector<double> since_;  ///< seconds of film; NaN: not there
};

}  // namespace carom

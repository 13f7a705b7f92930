// Measures averages over pairs of times that are a time lag apart. The particles are those chosen
// at the start, each followed by itself, whatever species it belongs to later.
#pragma once

#include <utility>
#include <vector>

#include "panels/chosen.h"
#include "panels/correlations/curve_panel.h"
#include "stats/paths/lag_averages.h"

namespace carom {

/// How many lags a curve has.
inline constexpr int lag_count = 61;

class LagMeter : public CurveMeter {
  public:
    LagMeter(const PanelContext& context, LagAverages::Of of,
             std::vector<std::vector<Eigen::Index>> members, double from, double lags)
        : averages_(context.box(), of, std::move(members), from, lags, lag_count,
                    velocity_changes(context.run())) {}

    void see(const FrameInput& input) override {
        averages_.see(input.sample, input.advanced.collisions);
    }
    void fix_axis(double, double, int) override {}  // the axis is given by the lags
    void archive(Archive& archive) override { archive(averages_); }

  protected:
    LagAverages averages_;
};

}  // namespace carom

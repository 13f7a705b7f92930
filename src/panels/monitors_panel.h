// Numbers under the gas, in fixed places: time, collisions, mean speed, mean energy, shares of
// slow, medium and fast.
#pragma once

#include "panels/panel.h"

namespace carom {

class MonitorsPanel : public Panel {
  public:
    explicit MonitorsPanel(const Cast& cast) : cast_(cast) {}

    void survey(const Observation& observation) override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;

  private:
    Cast cast_;
    double largest_speed_ = 0.0;  ///< of the mean over the film: fixes the number of decimals
    double largest_energy_ = 0.0;
};

}  // namespace carom

// Numbers under the gas or in a panel, in fixed places: time, collisions, mean speed, mean energy,
// shares of slow, medium and fast.
#pragma once

#include "panels/panel.h"

namespace carom {

class MonitorsPanel : public Panel {
  public:
    /// `in_row`: as a row of labels with their numbers under them, else as two columns.
    explicit MonitorsPanel(const Cast& cast, bool in_row = true) : cast_(cast), in_row_(in_row) {}

    void survey(const Observation& observation) override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;

  private:
    struct Place {
        Point label, number;
    };
    Place place(const Page& page, std::size_t index) const;

    Cast cast_;
    bool in_row_;
    double largest_speed_ = 0.0;  ///< of the mean over the film: fixes the number of decimals
    double largest_energy_ = 0.0;
};

}  // namespace carom

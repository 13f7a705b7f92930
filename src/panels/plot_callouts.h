// Callouts to places in plots: the words stand in their panel, beside the place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/layout.h"
#include "panels/panel_set.h"
#include "scene/time/showing.h"

namespace carom {

class PlotCallouts {
  public:
    explicit PlotCallouts(const PanelSet& panels);

    /// Draws those of a frame; `opacities`: how much is seen of each of the set's panels.
    void draw(Canvas& canvas, const FrameData& frame, const std::vector<double>& opacities,
              bool still);

    /// Notes which of them a frame shows.
    void see(const FrameData& frame);

    /// Those that no frame shows in spite of the time, as their places are beyond the axes:
    /// “words”.
    std::vector<std::string> never_shown() const;

  private:
    struct One {
        const Callout* callout;
        std::size_t panel;  ///< of the set
        bool is_due = false, is_shown = false;
    };
    double alpha(std::size_t k, const FrameData& frame) const;
    DrawContext context_of(const One& one);
    std::optional<Point> place_of(const One& one, const FrameData& frame);

    const PanelSet& panels_;
    Grid grid_;
    DiskPainter disks_;
    std::vector<One> callouts_;
    std::vector<Showing> times_;  ///< of each
};

}  // namespace carom

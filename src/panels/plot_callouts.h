// Callouts to points in plots: the words are within the panel, beside the point.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "panels/callouts/callout.h"
#include "panels/layout.h"
#include "panels/panel_set.h"
#include "scene/time/showing.h"

namespace carom {

class PlotCallouts {
  public:
    explicit PlotCallouts(const PanelSet& panels);

    /// Draws the callouts of a frame; `opacities`: the opacity of each of the set's panels, from 0
    /// to 1.
    void draw(Canvas& canvas, const FrameData& frame, const std::vector<double>& opacities,
              bool still);

    /// Records which callouts a frame shows.
    void see(const FrameData& frame);

    /// The callouts, as “words”, that no frame shows although their time came, because their points
    /// lie beyond the axes.
    std::vector<std::string> never_shown() const;

  private:
    struct Stand {
        Rect place;
        CalloutPlate plate;
    };
    struct One {
        const Callout* callout;
        std::size_t panel;  ///< of the set
        bool is_due = false, is_shown = false;
        std::optional<Stand> stand = {};  ///< once it has been shown: the same in all frames
    };
    double alpha(std::size_t k, const FrameData& frame) const;
    DrawContext context_of(const One& one);
    Stand stand(const One& one, Point target, std::span<const Rect> others);
    std::optional<Point> place_of(const One& one, const FrameData& frame);

    const PanelSet& panels_;
    Grid grid_;
    DiskPainter disks_;
    std::vector<One> callouts_;
    std::vector<Showing> times_;  ///< of each
};

}  // namespace carom

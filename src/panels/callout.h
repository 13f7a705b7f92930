// A callout: words on a plate, and a line from there to what they are about. Knows no gas.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// The words of a callout in lines, and the plate that holds them.
struct CalloutPlate {
    std::vector<std::string> lines;
    double width = 0.0, height = 0.0;  ///< pixels
};
CalloutPlate callout_plate(const DrawContext& dc, const std::string& words, double most_width);

/// The place in `area` for a plate that keeps clear of a target on all of its way, and of other
/// plates, and is near it. `reach`: how far the target reaches around its middle.
Rect free_place(const DrawContext& dc, const Rect& area, const CalloutPlate& plate,
                std::span<const Point> way, double reach, std::span<const Rect> others);

/// The place in a plot for a plate about something at `x`, whatever its height: at the side that
/// has more room.
Rect place_beside(const DrawContext& dc, const Rect& area, const CalloutPlate& plate, double x);

/// Draws it at its place, with a line to the target's edge.
void draw_callout(Canvas& canvas, const DrawContext& dc, const Rect& place,
                  const CalloutPlate& plate, Point target, double reach, double alpha);

}  // namespace carom

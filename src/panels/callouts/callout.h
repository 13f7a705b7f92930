// A callout: words on a plate, and a line from there to what they are about. Knows no gas.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "panels/panel.h"
#include "scene/time/showing.h"

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

/// Places of plates that stand still: each keeps clear of those that are seen with it and come
/// first. `place_of(k, others)` gives one for the plate with the number k beside others; none where
/// it has none. Of all that are `seen`, and of those by which they find their places.
std::vector<std::optional<Rect>> places_in_time(
    std::span<const Showing> times, std::span<const std::size_t> seen,
    const std::function<std::optional<Rect>(std::size_t, std::span<const Rect>)>& place_of);

/// The place in a plot for a plate about something at `x`, whatever its height: at the side that
/// has more room, in the middle, or as near to that as other plates leave it free.
Rect place_beside(const DrawContext& dc, const Rect& area, const CalloutPlate& plate, double x,
                  std::span<const Rect> others);

/// One at its place, with a line to its target's edge.
struct DrawnCallout {
    Rect place;
    CalloutPlate plate;
    Point target;
    double reach = 0.0;  ///< of the target around its middle
    double alpha = 1.0;
};

/// Draws them. No line goes over words.
void draw_callouts(Canvas& canvas, const DrawContext& dc, std::span<const DrawnCallout> callouts);

}  // namespace carom

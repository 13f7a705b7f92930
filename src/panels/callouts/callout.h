// A callout: words on ground of their own, the plate, and a line from there to the thing that they
// describe. Independent of the gas.
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
    double across = 0.0, above = 0.0;  ///< of that, on each side of the words
};
enum class PlateMargin { usual, thin };
CalloutPlate callout_plate(const DrawContext& dc, const std::string& words, double most_width,
                           PlateMargin margin = PlateMargin::usual);

/// Returns a place in `area` for a plate: near its target, but as far as possible clear of the
/// target's whole path `way` (pixels) and of the plates `others`. `reach`: the radius of the
/// target, pixels.
Rect free_place(const DrawContext& dc, const Rect& area, const CalloutPlate& plate,
                std::span<const Point> way, double reach, std::span<const Rect> others);

/// Returns places for plates that do not move: each keeps clear of those plates that are shown at
/// the same time and come first. `place_of(k, others)` returns the place of plate number k, given
/// the places `others` of these plates; none if there is no place for it. The result has a place
/// for each plate in `seen` and for the earlier plates on which these places depend; none for all
/// other plates.
std::vector<std::optional<Rect>> places_in_time(
    std::span<const Showing> times, std::span<const std::size_t> seen,
    const std::function<std::optional<Rect>(std::size_t, std::span<const Rect>)>& place_of);

/// Returns a place in a plot for a plate that describes something at the horizontal position `x`
/// (pixels): on the side of `x` that has more room and at mid-height, or as near to that as the
/// plates `others` allow.
Rect place_beside(const DrawContext& dc, const Rect& area, const CalloutPlate& plate, double x,
                  std::span<const Rect> others);

/// Returns the place in `area` nearest to a target and clear of it for which `is_free(place, end)`
/// says that nothing is at the place and no words are on the line from its `end` to the target;
/// none if there is none.
std::optional<Rect> place_in_room(
    const DrawContext& dc, const Rect& area, const CalloutPlate& plate, Point target,
    const std::function<bool(const Rect& place, const Point& end)>& is_free);

/// A callout at its place, with a line to the edge of its target.
struct DrawnCallout {
    Rect place;
    CalloutPlate plate;
    Point target;
    double reach = 0.0;  ///< radius of the target, pixels
    double alpha = 1.0;
};

/// Draws callouts. No line crosses words: all lines are drawn before the plates.
void draw_callouts(Canvas& canvas, const DrawContext& dc, std::span<const DrawnCallout> callouts);

}  // namespace carom

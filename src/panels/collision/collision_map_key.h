// The key of a collision map: a sample and words for each mark, and where they and the plane stand
// on the panel.
#pragma once

#include <string>
#include <vector>

#include "panels/collision/collision_map_marks.h"

namespace carom {

struct MapKeyEntry {
    MapMark mark;
    std::string words;  ///< markup
};

struct MapPlaces {
    Rect plane;
    std::vector<Point> key;        ///< of as many entries as there is room for
    std::vector<double> sample{};  ///< width of the sample of each, units
};

/// The key stands beside the plane or above it, whichever leaves the plane larger, which shows
/// velocities up to `reach`; `left` is for the labels of its axis.
MapPlaces map_places(const DrawContext& dc, double left, const std::vector<MapKeyEntry>& entries,
                     const Eigen::Array2d& reach);

void draw_map_key(Canvas& canvas, const DrawContext& dc, const std::vector<MapKeyEntry>& entries,
                  const MapPlaces& places);

}  // namespace carom

// The lines of a trail: thin and dim at the old positions of its particle, wide and bright at the
// present one.
#pragma once

#include <span>
#include <vector>

#include "draw/raster/tapers.h"

namespace carom {

/// A point of a trail, in the picture.
struct TrailPlace {
    Point at;      ///< pixels
    double light;  ///< from 0, where the trail ends, to 1, where its particle is
};

/// Adds the lines through the points of a trail, oldest first: mostly one for each free flight.
/// `unit` as in DrawContext.
void add_trail_lines(std::vector<Taper>& lines, std::span<const TrailPlace> way, Color ground,
                     Color ink, double unit);

}  // namespace carom

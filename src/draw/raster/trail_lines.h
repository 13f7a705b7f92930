// The lines of a trail: thin and dim where its particle was long ago, wide and bright where it is.
#pragma once

#include <span>
#include <vector>

#include "draw/raster/tapers.h"

namespace carom {

/// A place on a trail, in the picture.
struct TrailPlace {
    Point at;      ///< pixels
    double light;  ///< from 0, where the trail ends, to 1, where its particle is
};

/// Adds the lines through places, oldest first: one for each free flight, mostly. `unit` as in
/// DrawContext.
void add_trail_lines(std::vector<Taper>& lines, std::span<const TrailPlace> way, Color ground,
                     Color ink, double unit);

}  // namespace carom

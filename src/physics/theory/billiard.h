// The exact mean free path of a single disk among fixed disks.
#pragma once

#include <optional>

#include "physics/box.h"

namespace carom {

/// The exact mean free path of a single disk among fixed disks, from hit to hit: pi times the area
/// accessible to its centre, divided by the perimeter of that area. None if the formula does not
/// hold: with obstacles of other shapes, disks too close for the moving disk to pass between,
/// partitions, gravity, walls that act on particles other than by reflection, or walls that do not
/// end a flight.
std::optional<double> mean_path_of_billiard(const Box& box, double radius, bool ends_at_walls);

}  // namespace carom

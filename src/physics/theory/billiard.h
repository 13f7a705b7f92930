// The exact mean free path of a single disk or sphere among fixed ones.
#pragma once

#include <optional>

#include "physics/box.h"

namespace carom {

/// The exact mean free path of a single particle among fixed disks or spheres, from hit to hit: pi
/// times the area accessible to its centre, divided by the perimeter of that area; in space four
/// times the accessible volume, divided by its surface (Chernov, J. Stat. Phys. 88, 1, 1997). None
/// if the formula does not hold: on a line, with obstacles of other shapes, too close for the
/// particle to pass between, partitions, gravity, walls that act on particles other than by
/// reflection, or walls that do not end a flight.
std::optional<double> mean_path_of_billiard(const Box& box, double radius, bool ends_at_walls);

}  // namespace carom

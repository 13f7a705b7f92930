// The name of a disk in the picture: its place and its drawing.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// Draws a name (markup) near the disk with the bounding box `disk`, within `box`. An outline in
/// the colour of the ground makes it legible over disks and hides little of them. `disks`: the
/// disks that the name keeps clear of in a still picture; may be null.
void draw_name(Canvas& canvas, const DrawContext& dc, const Rect& box, const Rect& disk,
               const std::string& markup, double alpha, const std::vector<Disk>* disks);

}  // namespace carom

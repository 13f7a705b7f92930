// The name of a disk in the picture: where it stands, and how it is drawn.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// Draws a name (markup) near the disk inside of `disk`, within `box`: with an edge of the ground,
/// so that it can be read over disks and hides little of them. `disks`: to keep clear of, in a
/// picture that stands still; may be null.
void draw_name(Canvas& canvas, const DrawContext& dc, const Rect& box, const Rect& disk,
               const std::string& markup, double alpha, const std::vector<Disk>* disks);

}  // namespace carom

// The surfaces at which instruments measure: their names in a picture, their lengths or areas, and
// the momentum that they have received.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "panels/plots/series_panel.h"
#include "panels/surfaces/box_parts.h"

namespace carom {

/// The surfaces of a panel that shows walls and partitions that move; its keys, and the check that
/// there are some.
struct MovingOptions {
    SurfaceNumbers surfaces = {};
};
std::vector<Binding<PanelSpec>> moving_keys();
void check_moving(PanelSpec& panel, const Node& node, Reading& reading);

/// "left wall", or the name that the scene gives.
std::string short_name(Language language, const Box& box, std::int32_t surface);

/// A line for each surface, with its name.
std::vector<MeterLine> lines_of_surfaces(Language language, const Box& box,
                                         const std::vector<std::int32_t>& surfaces);

/// The length, in space the area, of a side, or of a partition without its gaps, between the
/// present positions of the adjacent sides; 1 in one dimension.
double size_of_surface(const Box& box, const std::vector<SurfaceState>& states,
                       std::int32_t surface);

/// The normal momentum that particles have given to a surface since t = 0: outward for a side,
/// toward larger coordinates for a partition.
double push_on_surface(const AdvanceResult& advanced, const Box& box, std::int32_t surface);

/// The length, area or volume that the sides of the box enclose at their present positions.
double enclosed_content(const Box& box, const std::vector<SurfaceState>& states);

}  // namespace carom

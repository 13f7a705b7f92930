// The surfaces that instruments measure at: what they are called in a picture, how far they reach,
// and what has pushed them.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "panels/plots/series_panel.h"

namespace carom {

/// The colour of one of several surfaces, or parts beside them, in a plot; that of an only one is
/// the bars'.
plot::Role surface_role(std::size_t place, std::size_t count);

/// "left wall", or the name that the scene gives.
std::string short_name(Language language, const Box& box, std::int32_t surface);

/// A line for each surface, and the title that names them.
void name_surfaces(SeriesSubject& subject, Language language, const Box& box,
                   const std::vector<std::int32_t>& surfaces, const std::string& what);

/// The length of a side or a partition without its gaps, between the sides at their places of the
/// moment; on a line 1.
double length_of_surface(const Box& box, const std::vector<SurfaceState>& states,
                         std::int32_t surface);

/// The momentum along its normal that particles have given it since t = 0: of a side outward, of a
/// partition toward larger x or y.
double push_on_surface(const AdvanceResult& advanced, const Box& box, std::int32_t surface);

/// The area (on a line the length) that a side encloses with its opposite at their places of the
/// moment.
double enclosed_area(const Box& box, const std::vector<SurfaceState>& states);

}  // namespace carom

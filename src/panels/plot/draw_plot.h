// What is made of a plot: the picture and the table. They cannot disagree, as both come from the
// same value.
#pragma once

#include <optional>

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "panels/table.h"

namespace carom::plot {

/// What of a plot is drawn: what is the same in every frame (title, notes, axes, still layers), or
/// the rest, over that.
enum class Part { still, changing };

/// Draws a part of the plot into `dc.area`. A pure function; any thread.
void draw_plot(Canvas& canvas, const DrawContext& dc, const Plot& plot, Part part);

/// Where a point of its axes is on the canvas: at `y`, or at the top of the highest bar or line at
/// `x` in what is drawn. None where it lies beyond the axes.
std::optional<Point> place_in(const DrawContext& dc, const Plot& plot, double x,
                              std::optional<double> y);

/// Its numbers: columns `part` and `of`, before them `run` where runs stand side by side, and then
/// `plot.columns`. Numbers that do not change from one row to the next are listed once.
Table table_of(const Plot& plot);

}  // namespace carom::plot

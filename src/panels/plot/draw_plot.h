// What is made of a plot: the picture and the table. They cannot disagree, as both come from the
// same value.
#pragma once

#include "panels/panel.h"
#include "panels/plot/plot.h"
#include "panels/table.h"

namespace carom::plot {

/// What of a plot is drawn: what is the same in every frame (title, notes, axes, still layers), or
/// the rest, over that.
enum class Part { still, changing };

/// Draws a part of the plot into `dc.area`. A pure function; any thread.
void draw_plot(Canvas& canvas, const DrawContext& dc, const Plot& plot, Part part);

/// Its numbers: columns `part` and `of`, before them `run` where runs stand side by side, and then
/// `plot.columns`. Numbers that do not change from one row to the next are listed once.
Table table_of(const Plot& plot);

}  // namespace carom::plot

// The words over bars: names and numbers of marks, and how many values lie beyond the ends of the
// axis. They stand still while marks and numbers change: beside the bars, where a tail leaves room,
// or in a row above the plot; the numbers beyond beside the axis's name.
#pragma once

#include "panels/plot/layers.h"

namespace carom::plot {

/// Where they stand, in every frame.
PlaceOfNotes place_of_notes(const Plot& plot, const DrawContext& dc);

/// Draws how many values lie beyond the ends of the axis.
void draw_counts_beyond(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws the names, over all that may lie behind them.
void draw_names(Canvas& canvas, const Frame& frame, const Plot& plot);

}  // namespace carom::plot

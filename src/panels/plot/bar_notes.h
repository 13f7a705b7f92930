// The text over bars: names and numbers of marks, and how many values lie beyond the ends of the
// axis. Its place is fixed while marks and numbers change: beside the bars if a tail of the
// distribution leaves room, otherwise in a row above the plot. The counts beyond the ends are
// beside the title of the axis.
#pragma once

#include "panels/plot/layers.h"

namespace carom::plot {

/// The places of the notes, the same in every frame.
PlaceOfNotes place_of_notes(const Plot& plot, const DrawContext& dc);

/// Draws how many values lie beyond the ends of the axis.
void draw_counts_beyond(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws the names, on top of all that may lie behind them.
void draw_names(Canvas& canvas, const Frame& frame, const Plot& plot);

}  // namespace carom::plot

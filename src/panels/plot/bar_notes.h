// The text over bars: names and numbers of marks, and how many values lie beyond the ends of the
// axis. Its place is fixed while marks and numbers change: beside the bars if no bar ever reaches
// there, otherwise in a row above the plot. The counts beyond the ends are beside the title of the
// axis.
#pragma once

#include "panels/plot/layers.h"

namespace carom::plot {

/// The places of the notes, the same in every frame; `frame` is the plot's without rows for them.
PlaceOfNotes place_of_notes(const Plot& plot, const Frame& frame);

/// The places that the names take in a frame.
std::vector<Rect> places_of_names(const Frame& frame, const Plot& plot);

/// Notes the names that have no place.
void leave_out_names(const Frame& frame, const Plot& plot);

/// Draws how many values lie beyond the ends of the axis.
void draw_counts_beyond(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws the names, on top of all that may lie behind them.
void draw_names(Canvas& canvas, const Frame& frame, const Plot& plot);

}  // namespace carom::plot

// Notes under the title of a plot: keys and sentences, in rows, or in a column beside the plot.
#pragma once

#include "panels/plot/draw_plot.h"
#include "panels/plot/layers.h"

namespace carom::plot {

/// Draws the notes under the title: those that change from frame to frame, or the others.
void draw_notes(Canvas& canvas, const Frame& frame, const Plot& plot, DrawnPart part);

/// The vertical position on the canvas of the baseline of the first note.
double first_note(const Plot& plot, const DrawContext& dc);

/// The width of the column that a note takes if it is beside the plot, in pixels.
double width_beside(const Note& note, const DrawContext& dc);

/// The height of all notes that are drawn under the title, in units, without a note that is beside
/// the plot. Notes that would leave less than `least_height` to the data are not drawn.
double height_of_rows(const Plot& plot, const DrawContext& dc, bool is_key_beside);
inline constexpr double least_height = 2.4;  // units

}  // namespace carom::plot

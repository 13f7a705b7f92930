// Notes under the title of a plot: keys and sentences, in rows, or in a column beside the plot.
#pragma once

#include "panels/plot/draw_plot.h"
#include "panels/plot/layers.h"

namespace carom::plot {

/// Draws the notes under the title: those that change from frame to frame, or the others.
void draw_notes(Canvas& canvas, const Frame& frame, const Plot& plot, Part part);

/// Where the baseline of the first note is, on the canvas.
double first_note(const Plot& plot, const DrawContext& dc);

/// The width of the column that a note takes beside a plot, in pixels.
double width_beside(const Note& note, const DrawContext& dc);

/// The height of all notes under the title that are drawn, in units, but for the one that stands
/// beside the plot if it does; those that would leave less than `least_height` to the data are not.
double height_of_rows(const Plot& plot, const DrawContext& dc, bool is_key_beside);
inline constexpr double least_height = 2.4;  // units

}  // namespace carom::plot

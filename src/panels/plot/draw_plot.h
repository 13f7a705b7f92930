// The picture and the table of a plot. They cannot disagree, as both are made from the same value.
#pragma once

#include <optional>
#include <vector>

#include "panels/panel.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/plot.h"
#include "panels/table.h"

namespace carom::plot {

/// The part of a plot that is drawn: what is the same in every frame (title, notes, axes, still
/// layers), or the rest, which is drawn over it.
enum class DrawnPart { still, changing };

/// Draws a part of the plot into `dc.area`. A pure function; may be called from any thread.
void draw_plot(Canvas& canvas, const DrawContext& dc, const Plot& plot, DrawnPart part);

/// Draws the names of growing lines, each once its line has come to it. `whole` is the plot of no
/// frame, from with_fixed_names().
void draw_arriving_names(Canvas& canvas, const DrawContext& dc, const Plot& whole, const Plot& now);

/// The plot of no frame with these names alone, each at its place: for all frames of one size.
Plot with_fixed_names(const Plot& whole, const DrawContext& dc);

/// What room the area of the data has that nothing takes in the whole film; `whole` is the plot of
/// no frame.
struct FreeRoom {
    Rect area;
    LabelPlacer taken;
    std::vector<Rect> words;  ///< inside and around the area

    bool is_free(const Rect& part) const;
    bool is_free(const Point& from, const Point& to) const;  ///< for a thin line, of words only

    /// The highest that anything reaches at `x`, pixels.
    double top_at(double x) const;
};
FreeRoom free_room(const DrawContext& dc, const Plot& whole);

/// The position on the canvas of a point in the plot's coordinates: at `y` or, without `y`, at the
/// top of the highest bar that is drawn at `x`, or of the highest line if there is no bar. None if
/// `x` lies beyond the axis; a `y` beyond the axis is clamped.
std::optional<Point> place_in(const DrawContext& dc, const Plot& plot, double x,
                              std::optional<double> y);

/// The numbers of a plot: the columns `part` and `of`, preceded by `run` if runs are compared, then
/// `plot.columns`. Numbers that do not change from one row to the next are listed once.
Table table_of(const Plot& plot);

}  // namespace carom::plot

// How each kind of layer is drawn: one file for each, behind draw_plot(). Knows where data lie on
// the canvas; axes, titles and notes are draw_plot.cpp's.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "draw/arrow.h"
#include "panels/panel.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/plot.h"

namespace carom::plot {

/// Where the words over bars stand: at the top right or left of the plot, or in rows above it.
struct PlaceOfNotes {
    enum class Side { right, left, above, none } side = Side::right;
    double width = 0.0;      ///< of a name and its number, pixels
    bool is_short = false;   ///< short names
    double row = 0.0;        ///< the height of all rows, units; 0: none
    std::size_t in_row = 2;  ///< how many share the width of a row
};

/// Where a plot's data lie on a canvas.
struct Frame {
    const DrawContext& dc;
    Rect area;               ///< that the data fill
    Scale x_scale, y_scale;  ///< unless an axis is linear, of decimal logarithms
    Axis::Kind y_kind;
    LabelPlacer& placer;
    PlaceOfNotes notes = {};     ///< over bars
    Point row = {};              ///< where the last row above the plot begins, on its baseline
    bool is_key_beside = false;  ///< of a note that may be

    double x(double value) const { return x_scale(value); }

    /// Of a datum; on an axis of powers of ten 0 has its place at the area's bottom.
    double y(double value, Beyond beyond = Beyond::drawn) const;
    double pixels(double units) const { return units * dc.unit; }
};

/// Where a plot's data lie in `dc.area`: under the title and the notes, left and above the axes'
/// labels.
Frame frame_of(const Plot& plot, const DrawContext& dc, LabelPlacer& placer);

void draw_layer(Canvas& canvas, const Frame& frame, const Bars& bars);
void draw_layer(Canvas& canvas, const Frame& frame, const Line& line);
void draw_layer(Canvas& canvas, const Frame& frame, const Band& band);
void draw_layer(Canvas& canvas, const Frame& frame, const Points& points);
void draw_layer(Canvas& canvas, const Frame& frame, const Level& level);
void draw_layer(Canvas& canvas, const Frame& frame, const Marker& marker);
void draw_layer(Canvas& canvas, const Frame& frame, const Arrow& arrow);
void draw_layer(Canvas& canvas, const Frame& frame, const Label& label);

/// Where a label goes, and keeps other labels off there; nothing where it is left out.
std::optional<Rect> rect_of(const Frame& frame, const Label& label);

/// A role's colour on the theme, and that of a stroke, with its shade and its fading.
Color color_of(const Role& role, const Theme& theme);
Color color_of(const Stroke& stroke, const Theme& theme);

/// A stroke's dashes in pixels; empty: solid.
std::vector<double> dashes_of(const Stroke& stroke, const DrawContext& dc);

/// Strokes a path, or a straight line with flat ends, with all that a stroke says.
void draw_stroke(Canvas& canvas, const DrawContext& dc, std::span<const Point> path,
                 const Stroke& stroke);
void draw_straight(Canvas& canvas, const DrawContext& dc, Point from, Point to,
                   const Stroke& stroke);

void draw_mark(Canvas& canvas, const DrawContext& dc, Point at, const Mark& mark);

/// An arrow in a picture that explains something; the edge's width in units.
ArrowStyle arrow_style(const DrawContext& dc, Color color, Color edge_color, double edge);

/// Draws an arrow between two points of the canvas.
void draw_arrow(Canvas& canvas, const DrawContext& dc, Point from, Point to, const Arrow& arrow);

/// A text as markup in a theme's colours.
std::string markup_of(const Text& text, const Theme& theme);

}  // namespace carom::plot

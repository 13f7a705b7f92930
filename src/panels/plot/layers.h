// The drawing of each kind of layer, in separate files behind draw_plot(). It knows the position of
// data on the canvas; axes, titles and notes belong to draw_plot.cpp.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "draw/arrow.h"
#include "panels/panel.h"
#include "panels/plot/label_placer.h"
#include "panels/plot/plot.h"

namespace carom::plot {

/// The place of the words over bars: at the top right or left of the plot, or in rows above it.
struct PlaceOfNotes {
    enum class Side { right, left, above, none } side = Side::right;
    double width = 0.0;     ///< of a name and its number, pixels
    bool is_short = false;  ///< short names
    double row = 0.0;       ///< the height of all rows, units; 0: none
};

/// What happens to data beyond the vertical axis.
enum class Beyond { clamped, drawn };

/// The mapping of a plot's data to the canvas.
struct Frame {
    const DrawContext& dc;
    Rect area;               ///< filled by the data
    Scale x_scale, y_scale;  ///< of decimal logarithms, unless an axis is linear
    Axis::Kind y_kind;
    LabelPlacer& placer;
    PlaceOfNotes notes = {};      ///< over bars
    Point row = {};               ///< where the last row above the plot begins, on its baseline
    bool is_key_beside = false;   ///< whether a note that may be beside the plot is there
    std::vector<Rect> gaps = {};  ///< where markers are not drawn, because words stand there
    std::vector<double> grid =
        {};  ///< the heights of the lines across the plot at its ticks; in the changing part

    double x(double value) const { return x_scale(value); }

    /// The vertical position of a value. On an axis of powers of ten, 0 is at the bottom of the
    /// area.
    double y(double value, Beyond beyond = Beyond::drawn) const;
    double pixels(double units) const { return units * dc.unit; }
};

/// Whether a point of the canvas lies in the area of the data, or at most a pixel beyond.
bool is_in_area(const Frame& frame, const Point& at);

/// Calls draw(), which draws lines of a width (pixels) along `path`, or fills it; clipped to the
/// area of the data, and half the width around it, if the path leaves it.
template <class Draw>
void draw_in_area(Canvas& canvas, const Frame& frame, std::span<const Point> path, double width,
                  const Draw& draw) {
    const bool is_inside =
        std::ranges::all_of(path, [&](const Point& at) { return is_in_area(frame, at); });
    if (is_inside) return draw();
    const Rect& area = frame.area;
    canvas.clip_to(
        {area.x - 0.5 * width, area.y - 0.5 * width, area.width + width, area.height + width});
    draw();
    canvas.release_clip();
}

/// Where a path leaves an area, or comes into it, and the direction outward along it, of length 1.
struct Exit {
    Point at, outward;
};

/// The pieces of a path that lie in an area, and its exits; those nearer to one another than
/// `apart` (pixels) are listed once.
struct CutPath {
    std::vector<std::vector<Point>> pieces;
    std::vector<Exit> exits;
};
CutPath cut_to(const Rect& area, std::span<const Point> path, double apart = 0.0);

/// The part of a straight piece that lies in an area, as shares of it; none if they do not meet.
std::optional<std::pair<double, double>> part_in(const Rect& area, Point from, Point to);

/// Draws the arrows of a line whose path leaves the area of the data, and gives the pieces of the
/// path that are to be drawn over them.
std::vector<std::vector<Point>> draw_exits(Canvas& canvas, const Frame& frame,
                                           std::span<const Point> path, const Polyline& line);

/// Where the arrow of a level stands that lies beyond the axis, at the right end; none if it does
/// not.
std::optional<Exit> exit_of(const Frame& frame, const Level& level);

/// Draws an arrow whose tip is at an exit.
void draw_exit(Canvas& canvas, const Frame& frame, const Exit& exit, const Stroke& stroke);

/// Lays out a plot in `dc.area`: the data are below the title and the notes, and inside the labels
/// of the axes.
Frame frame_of(const Plot& plot, const DrawContext& dc, LabelPlacer& placer);

void draw_layer(Canvas& canvas, const Frame& frame, const Bars& bars);
void draw_layer(Canvas& canvas, const Frame& frame, const Polyline& line);
void draw_layer(Canvas& canvas, const Frame& frame, const Band& band);
void draw_layer(Canvas& canvas, const Frame& frame, const Points& points);
void draw_layer(Canvas& canvas, const Frame& frame, const Level& level);
void draw_layer(Canvas& canvas, const Frame& frame, const Marker& marker);
void draw_layer(Canvas& canvas, const Frame& frame, const Arrow& arrow);
void draw_layer(Canvas& canvas, const Frame& frame, const Label& label);

/// A name of a growing line with the words and the only anchor that it has in a plot, where its
/// place is then taken; without anchors if it stands elsewhere, as a key.
Label fixed_label(const Frame& frame, const Label& label);

/// Draws such a name as far as the end of its line has come to it.
void draw_arriving(Canvas& canvas, const Frame& frame, const Label& label, const Polyline& line);

/// Places a label and reserves its place against other labels; none if the label is left out.
std::optional<Rect> rect_of(const Frame& frame, const Label& label);

/// The words of the horizontal axis, in the version that fits (markup).
std::string x_title_of(const Plot& plot, const Frame& frame);

/// The place of the words over the vertical axis, if it has any and they have room.
std::optional<Rect> place_of_y_title(const Plot& plot, const Frame& frame);

/// The places of the labels that stay the same in all frames; with those that come when a line has
/// come to them, or without.
std::vector<Rect> places_of_still_labels(const Frame& frame, const Plot& plot,
                                         bool with_arriving = true);

/// The width of clear ground around letters, units.
inline constexpr double halo_of_words = 0.2;

/// The heights of the lines of the grid.
std::vector<double> grid_of(const Frame& frame, const Plot& plot);

/// The style of words at a place in the plot: with clear ground around the letters if a line of the
/// grid runs there.
TextStyle clear_of_grid(const Frame& frame, TextStyle style, const Rect& words);

/// The plot as it is drawn: with the names of its lines beside these, or in its titles.
Plot with_names(const Plot& plot, const DrawContext& dc);

/// Fills a rectangle with colours from left to right, in steps of whole pixels, so that there are
/// no seams; `color_at` gives them for shares of the width.
void draw_strip(Canvas& canvas, const Rect& rect, const std::function<Color(double)>& color_at);

/// Keep words off what a layer draws.
void keep_clear_of(const Frame& frame, const AnyLayer& layer);

/// Keeps words off all that is shown in the film.
void keep_clear_of_film(const Frame& frame, const Plot& plot, LabelPlacer& placer);

/// The words of a layer; nullptr: none. Whether a part has any.
const Label* label_of(const AnyLayer& layer);
bool has_labels(const Plot& plot, bool still);

/// Layers of a part in the order in which they are drawn.
std::vector<const AnyLayer*> layers_in_order(const Plot& plot, bool still);

/// The colour of a role on a theme, and that of a stroke, with its shade and its fading applied.
Color color_of(const Role& role, const Theme& theme);
Color color_of(const Stroke& stroke, const Theme& theme);

/// A stroke's dashes in pixels; empty: solid.
std::vector<double> dashes_of(const Stroke& stroke, const DrawContext& dc);

/// Draw a path, or a straight line with flat ends, with all properties of a stroke.
void draw_stroke(Canvas& canvas, const DrawContext& dc, std::span<const Point> path,
                 const Stroke& stroke);
void draw_straight(Canvas& canvas, const DrawContext& dc, Point from, Point to,
                   const Stroke& stroke);

void draw_dot(Canvas& canvas, const DrawContext& dc, Point at, const Dot& dot);

/// The style of an arrow in an explanatory picture; `edge`: the width of its edge in units.
ArrowStyle arrow_style(const DrawContext& dc, Color color, Color edge_color, double edge);

/// Draws an arrow between two points of the canvas.
void draw_arrow(Canvas& canvas, const DrawContext& dc, Point from, Point to, const Arrow& arrow);

/// A text as markup in a theme's colours.
/// Coloured words are mixed with the page by `fade`, from 0 to 1.
std::string markup_of(const Text& text, const Theme& theme, double fade = 0.0);

}  // namespace carom::plot

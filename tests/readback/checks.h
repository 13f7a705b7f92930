// Compares pictures with the tables of the same figures. Each check describes the differences
// larger than half a pixel, or than half a level step of a colour; its result is empty if there are
// none.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "readback/figures.h"

namespace carom::test {

using Problems = std::vector<std::string>;

inline constexpr double half_a_pixel = 0.5;

/// The columns of the table that the axes of a plot show.
struct PlotColumns {
    std::string x, y;
    std::string to = {};          ///< of bars: the column of their right ends
    bool is_logarithmic = false;  ///< the upright axis is logarithmic
    bool has_exponents = false;   ///< logarithms in the column, powers of ten on the upright axis
};

/// Checks the bars, curves, levels, bands, points and marks of a plot.
Problems plot_problems(const DrawnFigure& figure, const PlotColumns& columns);

Problems thermometer_problems(const DrawnFigure& figure);
Problems needle_problems(const DrawnFigure& figure);
Problems counter_problems(const DrawnFigure& figure);
Problems monitor_problems(const DrawnFigure& figure);
Problems collision_problems(const DrawnFigure& figure);
Problems text_problems(const DrawnFigure& figure, const std::string& words);

/// Checks a box of disks of this width and height.
Problems gas_problems(const DrawnFigure& figure, double width, double height);

/// The same of spheres in a figure in print, in a box of this size seen from a viewpoint: turn and
/// tilt in degrees, lens. They are drawn from the farthest to the nearest.
Problems sphere_problems(const DrawnFigure& figure, const std::array<double, 3>& size,
                         const std::array<double, 3>& viewpoint);

/// The colour of a number, according to the colour key in the picture.
Paint key_color(const SvgPicture& picture, double value);

/// The colour "#rrggbb".
Paint paint_of(const std::string& hex);

/// Whether two colours differ by at most one level: a key has 256 steps, and so do disks.
bool is_near_color(const Paint& a, const Paint& b);

/// Checks the cells of a square box: each must have the colour that the key gives to its number in
/// `column`.
Problems field_problems(const DrawnFigure& figure, double side, const std::string& column);

/// Checks the areas of a stack, each between two lines of a plot.
Problems stack_problems(const DrawnFigure& figure, const PlotColumns& columns);

/// Checks the beads between two ends, which are drawn to scale, and their world lines.
Problems line_problems(const DrawnFigure& figure, double length);

}  // namespace carom::test

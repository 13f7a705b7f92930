// Compares what pictures show with their tables: each check says what differs by more than half a
// pixel, or by more than half a step of a colour's level; nothing where all is equal.
#pragma once

#include <string>
#include <vector>

#include "readback/figures.h"

namespace carom::test {

using Problems = std::vector<std::string>;

inline constexpr double half_a_pixel = 0.5;

/// Which columns the axes of a plot show.
struct PlotColumns {
    std::string x, y;
    std::string to = {};          ///< of bars: where they end
    bool is_logarithmic = false;  ///< up
    bool has_exponents = false;   ///< up: the column has logarithms, the labels powers of ten
};

/// Bars, curves, levels, bands, points and marks of a plot.
Problems plot_problems(const DrawnFigure& figure, const PlotColumns& columns);

Problems thermometer_problems(const DrawnFigure& figure);
Problems needle_problems(const DrawnFigure& figure);
Problems counter_problems(const DrawnFigure& figure);
Problems monitor_problems(const DrawnFigure& figure);
Problems collision_problems(const DrawnFigure& figure);
Problems text_problems(const DrawnFigure& figure, const std::string& words);

/// A box of disks, which is so wide and high.
Problems gas_problems(const DrawnFigure& figure, double width, double height);

/// The colour of a number, by the key of colours in the picture.
Paint key_color(const SvgPicture& picture, double value);

/// Of "#rrggbb".
Paint paint_of(const std::string& hex);

/// Whether colours are the same but for a level: a key has 256 steps, and disks have as many.
bool is_near_color(const Paint& a, const Paint& b);

/// The cells of a square box, each in the colour that the key has for its number in a column.
Problems field_problems(const DrawnFigure& figure, double side, const std::string& column);

/// The areas of a stack, each between two lines of a plot.
Problems stack_problems(const DrawnFigure& figure, const PlotColumns& columns);

/// Beads between two ends, which are drawn as large as they are, and their world lines.
Problems line_problems(const DrawnFigure& figure, double length);

}  // namespace carom::test

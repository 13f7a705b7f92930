// Scales and ticks of axes, and the drawing of axes. Pure arithmetic, plus one drawing function for
// each axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/text.h"
#include "util/language.h"

namespace carom {

/// A linear map from data to canvas coordinates: `low` maps to `from`, `high` to `to`.
struct Scale {
    double low = 0, high = 1;
    double from = 0, to = 1;
    double operator()(double value) const {
        return from + (value - low) / (high - low) * (to - from);
    }
};

struct TickMark {
    double value;
    std::string label;
};

/// Round values (multiples of 1, 2, 2.5 or 5 times a power of ten) inside [low, high], with labels
/// of equal precision: as many as `most` (>= 2) allows, and at least three for `most` = 5 and a
/// range from 0. Empty for an empty range. `whole`: whole numbers only, for counts.
std::vector<TickMark> ticks(double low, double high, int most = 5, bool whole = false);

/// The exponent of the power of ten that the labels of marks up to `largest` have in common; 0 if
/// these are written without one.
int common_power(const std::vector<TickMark>& marks, double largest);

/// Powers of ten from 10^low to 10^high; usually not more than `most`, and at least two if the
/// range contains two. Their exponents are multiples of 1, 2, 5, 10, 20, 25, 50 or 100. The value
/// of a mark is its exponent.
std::vector<TickMark> decade_ticks(double low, double high, int most = 5);

/// The smallest round value at or above `value` that gives an axis from 0 good ticks. 1 if `value`
/// is not positive or not finite, as when there are no data from which to choose the axis.
double round_up_for_axis(double value);

struct AxisStyle {
    double line_width = 1;
    double tick_length = 6;
    TextStyle label;  ///< of the tick labels
    TextStyle title;  ///< of the title at its end
    Color line;
    std::optional<Color> grid = {};  ///< lines across the area at the ticks of a vertical axis
    std::vector<Rect> words = {};    ///< through which these do not run
    double below = 0;    ///< space between a horizontal axis and its ticks, for a scale of colours
    bool whole = false;  ///< ticks of linear axes at whole numbers only
    bool decades = false;  ///< for a vertical axis: its scale maps decimal logarithms
    Language language = Language::english;  ///< language of the numbers
};

/// The height that an x axis needs below its area, and the width that a y axis needs to the left of
/// its area.
double x_axis_space(const AxisStyle& style);
double y_axis_space(const Scale& scale, const AxisStyle& style);

/// Draws a horizontal axis along the bottom edge of `area`, with ticks and labels below it, and
/// `title` (markup) in the row of the labels, in the rightmost gap with room for it; labels give
/// way to it.
void draw_x_axis(Canvas& canvas, const Rect& area, const Scale& scale, const std::string& title,
                 const AxisStyle& style);

/// Whether no label gives way to this title (markup) there.
bool keeps_labels(const Scale& scale, const std::string& title, const AxisStyle& style);

/// The positions of the thin lines that draw_y_axis() draws across the area.
std::vector<double> grid_lines(const Rect& area, const Scale& scale, const AxisStyle& style);

/// Draws a vertical axis along the left edge of `area`, with labels to the left of it.
void draw_y_axis(Canvas& canvas, const Rect& area, const Scale& scale, const AxisStyle& style);

}  // namespace carom

// Scales and ticks of axes, and how an axis is drawn. Pure arithmetic plus one drawing function
// each.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/text.h"
#include "util/language.h"

namespace carom {

/// A linear map from data to canvas: `low` goes to `from`, `high` to `to`.
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

/// Round values (multiples of 1, 2, 2.5 or 5 times a power of ten) inside [low, high]: as many as
/// `most` (>= 2) allows, three at least for `most` = 5 and a range from 0, with labels of equal
/// precision. Nothing for an empty range. `whole`: whole numbers only, for counts.
std::vector<TickMark> ticks(double low, double high, int most = 5, bool whole = false);

/// Powers of ten from 10^low to 10^high, mostly at most `most`, two at least if there are; their
/// exponents are multiples of 1, 2, 5, 10, 20, 25, 50 or 100. A mark's value is its exponent.
std::vector<TickMark> decade_ticks(double low, double high, int most = 5);

/// The smallest round value at or above `value` that gives an axis from 0 good ticks; 1 where
/// `value` is not positive or not finite, as where nothing was seen that an axis could be chosen
/// for.
double round_up_for_axis(double value);

struct AxisStyle {
    double line_width = 1;
    double tick_length = 6;
    TextStyle label;  ///< of the tick labels
    TextStyle title;  ///< of the words at its end
    Color line;
    bool whole = false;    ///< ticks of linear axes at whole numbers only
    bool decades = false;  ///< of a vertical axis: its scale maps decimal logarithms
    Language language = Language::english;  ///< of the numbers
};

/// The height that an x axis with a title takes below its area, and the width that a y axis takes
/// left of it.
double x_axis_space(const AxisStyle& style);
double y_axis_space(const Scale& scale, const AxisStyle& style);

/// A horizontal axis along the bottom edge of `area`, ticks and labels below it, and below those at
/// the right end `title` (markup).
void draw_x_axis(Canvas& canvas, const Rect& area, const Scale& scale, const std::string& title,
                 const AxisStyle& style);

/// A vertical axis along the left edge of `area`, labels left of it.
void draw_y_axis(Canvas& canvas, const Rect& area, const Scale& scale, const AxisStyle& style);

}  // namespace carom

// What is drawn over all bars of a plot, below its lines and marks: where bars are cut, the errors
// of those that are means, and casings that keep lines apart from bars.
#pragma once

#include <vector>

#include "panels/plot/layers.h"

namespace carom::plot {

/// The bars of a plot, in its order.
std::vector<const Bars*> bars_of(const Plot& plot);

/// Draws that; nothing where the plot has no bars.
void draw_over_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws the count of each bar that is taller than the axis, beside it; of several side by side all
/// counts beside the last. Where there is no room the count is left out: the break shows that the
/// bar is taller. To be called after lines and marks are drawn, which would cross out a number.
void draw_counts_of_broken_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// A count, or a mean of counts, which is no whole number.
std::string count_words(Language language, double count);

}  // namespace carom::plot

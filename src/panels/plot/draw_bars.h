// What is drawn over all bars of a plot and below its lines and marks: error bars of means, and
// casings that separate lines from bars; and the numbers of bars that are taller than the axis.
#pragma once

#include <vector>

#include "panels/plot/layers.h"

namespace carom::plot {

/// The bar layers of a plot, in its order.
std::vector<const Bars*> bars_of(const Plot& plot);

/// Draws error bars and casings; nothing if the plot has no bars.
void draw_over_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws the number of each bar that is taller than the axis beside the bar, inside the plot; for
/// several adjacent ones, all numbers together. A number without room is left out: that the bar
/// fades out still shows that it is taller.
void draw_numbers_of_tall_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// A count as text, or a mean of counts, which need not be whole.
std::string count_words(Language language, double count);

}  // namespace carom::plot

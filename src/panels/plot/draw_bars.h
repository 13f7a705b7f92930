// What is drawn over all bars of a plot and below its lines and marks: breaks of bars that are too
// tall, error bars of means, and casings that separate lines from bars.
#pragma once

#include <vector>

#include "panels/plot/layers.h"

namespace carom::plot {

/// The bar layers of a plot, in its order.
std::vector<const Bars*> bars_of(const Plot& plot);

/// Draws breaks, error bars and casings; nothing if the plot has no bars.
void draw_over_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws the count of each bar that is taller than the axis beside the bar or over it; for several
/// adjacent ones, all counts at the last. A count without room is left out: the break still shows
/// that the bar is taller.
void draw_counts_of_broken_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// A count as text, or a mean of counts, which need not be whole.
std::string count_words(Language language, double count);

}  // namespace carom::plot

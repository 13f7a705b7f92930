// What is drawn over all bars of a plot, below its lines and marks: where bars are cut, the errors
// of those that are means, and casings that keep lines apart from bars.
#pragma once

#include <vector>

#include "panels/plot/layers.h"

namespace carom::plot {

/// The bars of a plot, in its order.
std::vector<const Bars*> bars_of(const Plot& plot);

/// Draws that. Nothing where the plot has no bars.
void draw_over_bars(Canvas& canvas, const Frame& frame, const Plot& plot);

/// Draws what the axis cannot hold: the count of each bar that is broken, beside it; of several
/// side by side, all counts beside the last. None where there is no room, as the break says that
/// the bar is taller. Over lines and marks, which would cross out a number.
void draw_counts_of_broken(Canvas& canvas, const Frame& frame, const Plot& plot);

/// A count, or a mean of counts, which is no whole number.
std::string count_words(Language language, double count);

}  // namespace carom::plot

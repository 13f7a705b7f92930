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

/// A count, or a mean of counts, which is no whole number.
std::string count_words(Language language, double count);

}  // namespace carom::plot

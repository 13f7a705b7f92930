// Bars of a histogram.
#include "panels/plot/layers.h"

namespace carom::plot {

void draw_layer(Canvas&, const Frame&, const Bars&) {}
void draw_layer(Canvas&, const Frame&, const Steps&) {}

}  // namespace carom::plot

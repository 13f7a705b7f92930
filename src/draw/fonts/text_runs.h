// The runs of a line that Pango has laid out: words in one font each.
#pragma once

#include <pango/pangocairo.h>

#include <vector>

#include "draw/fonts/written_text.h"

namespace carom {

/// Whether a run needs more than its glyphs drawn in the colour of the line at their positions.
bool is_decorated(const PangoGlyphItem& run);

/// The runs of the first line of a layout whose baseline begins at `origin`, in `color` unless the
/// markup gives another.
std::vector<TextRun> runs_of(PangoLayout* layout, Point origin, Color color);

}  // namespace carom

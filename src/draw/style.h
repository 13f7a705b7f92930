// The colours of a picture by their role, for each ground. Knows colours only: sizes and places are
// the layout's.
#pragma once

#include "draw/color.h"

namespace carom {

enum class ThemeKind { light, dark, print };

/// Every text colour has a contrast of at least 4.5 with page and ground, every other colour that
/// carries a meaning at least 3 (WCAG 2.2, 1.4.3 and 1.4.11).
struct Theme {
    Color page;       ///< behind everything
    Color ground;     ///< inside the gas's box and behind panels that want one
    Color ink;        ///< titles, numbers, the ring of a chosen particle
    Color muted;      ///< subtitles, labels, axes, reference marks
    Color accent;     ///< the theory curve, and nothing else
    Color bar;        ///< bars of histograms, and words about them
    Color wall;       ///< the line around the gas
    Color trail;      ///< trails, before they fade
    Color highlight;  ///< what the viewer should look at: a caption, a reversal
    bool dark = false;
};

/// The colours of a theme.
const Theme& theme(ThemeKind kind);

}  // namespace carom

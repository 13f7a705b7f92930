// The colours of a picture by their role, for each theme, and its fonts. Sizes and positions belong
// to the layout.
#pragma once

#include <optional>
#include <span>

#include "draw/color.h"
#include "draw/fonts/font_families.h"

namespace carom {

enum class ThemeKind { light, dark, print };

/// Every text colour has a contrast of at least 4.5 with page and ground, and every other colour
/// that carries meaning at least 3 (WCAG 2.2, 1.4.3 and 1.4.11); grid lines carry none. A role that
/// has a hue has the same hue in all themes but print, which is grey.
struct Theme {
    Color page;       ///< behind everything
    Color ground;     ///< inside the gas's box and behind panels that want one
    Color ink;        ///< titles, numbers, the ring of a chosen particle
    Color second;     ///< numbers at ticks, and other words that are read after the ink's
    Color muted;      ///< subtitles, labels, axes, reference marks
    Color grid;       ///< thin lines across plots, behind everything in them
    Color accent;     ///< the theory curve, and nothing else
    Color bar;        ///< bars of histograms, and words about them
    Color wall;       ///< the line around the gas
    Color trail;      ///< trails, before they fade
    Color highlight;  ///< what the viewer should look at: a caption, a reversal
    ThemeKind kind = ThemeKind::dark;
    bool dark = false;
    std::span<const Color> series = {};  ///< of kinds of particles and of compared runs, in order;
                                         ///< empty: those of the palette
    std::span<const std::optional<Color>> runs = {};  ///< of compared runs, before the series
    std::span<const Color> ramp = {};     ///< of the scale from slow to fast; empty: the palette's
    const FontFamilies* fonts = nullptr;  ///< null: the usual font
};

/// The least contrast ratios of WCAG 2.2 with the background: of words (1.4.3), and of other marks
/// that carry meaning (1.4.11).
constexpr double least_contrast_of_words = 4.5, least_contrast_of_marks = 3.0;

/// The colours of a theme.
const Theme& theme(ThemeKind kind);

/// The colour itself if its contrast with all colours of `behind` is at least `least`; otherwise
/// the first shade on the way to the ink that has this contrast, or the ink if none has.
Color toward_ink(Color color, const Theme& theme, std::span<const Color> behind, double least);

/// A shade of the colour that stands out from page and ground, for the rim of a disk or the edge of
/// a line.
Color edge_of(Color color, const Theme& theme);

/// The same for words, which need more contrast.
Color legible(Color color, const Theme& theme);

/// A colour for letters on a fill of any colour.
Color letters_on(Color fill, const Theme& theme);

}  // namespace carom

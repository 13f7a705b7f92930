// A style: the colours, fonts and sizes of a house, as plain values. A picture's theme gives what
// the style does not.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/looks.h"
#include "util/diagnostics.h"

namespace carom {

/// Families of fonts; empty: of texts carom's own, of numbers and formulae that of texts.
struct StyleFonts {
    std::string text, numbers, formulas;

    bool operator==(const StyleFonts&) const = default;
};

/// Colours by their keys, as #rrggbb. Those that are not given are the theme's.
struct StyleColors {
    std::map<std::string, std::string> of;  ///< page, ground, ink, ..., slow, fast
    std::vector<std::string> series;        ///< of species and compared runs, in order

    bool operator==(const StyleColors&) const = default;
};

struct Style {
    ThemeName base = ThemeName::light;        ///< whose colours it changes, and the theme of films
    std::optional<ThemeName> figure_theme;    ///< none: the base
    std::optional<double> figure_width;       ///< centimetres; none: the usual one
    std::vector<std::string> figure_formats;  ///< empty: all
    StyleFonts fonts;
    StyleColors colors;
    double film_text = 1.0;             ///< size of the text of films, relative to the usual one
    std::optional<double> figure_text;  ///< size of the smallest text of figures, points
    std::optional<double> dots;         ///< of figures that are pixels, to the inch
    std::string path;                   ///< of its file
    std::map<std::string, Diagnostic> places;  ///< of the colours' keys, with an empty message
};

/// What the check of a style needs of the machine and of the pictures. Empty functions are not
/// asked.
struct StyleCheck {
    std::function<std::vector<std::string>()> families;           ///< of fonts on this machine
    std::function<std::vector<Diagnostic>(const Style&)> faults;  ///< of its colours
};

}  // namespace carom

// Text on a canvas: the one door to Pango and fontconfig. Every letter comes from one declared font
// (Inter) through a private font configuration, so that text is the same on every machine that has
// the font. A line with a letter that Inter lacks is set with the machine's own fonts beside it.
// May be used in several threads at once; each keeps its own fonts and its own recent lines.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"

namespace carom {

enum class Align { left, center, right };

struct TextStyle {
    double size = 16;  ///< height of the em, in the canvas's unit
    int weight = 400;  ///< 400 to 600, or 900
    Color color = {};
    Align align = Align::left;
    bool tabular = true;   ///< figures of equal width
    double max_width = 0;  ///< > 0: a longer line ends in an ellipsis
    double halo = 0;       ///< > 0: an edge of this width around the letters,
    Color behind = {};     ///< in this colour, so that they can be read over anything
};

struct TextExtent {
    double width = 0;
    double ascent = 0, descent = 0;  ///< of the line, from the baseline, both positive
};

/// Draws one line of Pango markup with its baseline through `at`; returns its extent. Ill-formed
/// markup is drawn as plain text. On pixels the baseline is moved to the nearest whole pixel (x is
/// kept to 1/8 pixel), so that horizontal strokes are crisp.
TextExtent draw_text(Canvas& canvas, Point at, const std::string& markup, const TextStyle& style);

/// The extent without drawing.
TextExtent measure_text(const std::string& markup, const TextStyle& style);

/// Plain words in lines of at most `style.max_width`, broken where their script allows it, a word
/// that is too long within it; the last of `most` lines holds whatever is left.
std::vector<std::string> wrapped(const std::string& words, const TextStyle& style,
                                 std::size_t most);

/// The letters of a plain text that no font of this machine has, each once.
std::vector<std::string> missing_letters(const std::string& text);

/// A line of text as it was drawn.
struct DrawnLine {
    std::string markup;
    double size = 0;  ///< height of the em
    Rect ink;         ///< what its letters touch
    bool is_cut = false;
};

/// Notes the lines that this thread draws while it lives, so that a layout can be checked for words
/// that are cut or lie on one another. One at a time on a thread.
class TextLog {
  public:
    TextLog();
    ~TextLog();
    TextLog(const TextLog&) = delete;
    TextLog& operator=(const TextLog&) = delete;

    std::vector<DrawnLine> lines;
};

/// The library that sets text, with its version.
std::string text_library();

/// Plain text made safe as markup: & < > ' " escaped.
std::string escape_markup(const std::string& text);

/// Throws SystemError, with the Debian package to install, if the font is not on this machine.
void require_font();

}  // namespace carom

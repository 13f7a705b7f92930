// Text on a canvas: the only interface to Pango and fontconfig. Every letter comes from one
// declared font (Inter, or the one that a style names) through a private font configuration, so
// that text is the same on every machine that has the font. A line with a letter that neither this
// font nor Inter has is set with the machine's own fonts as well. Thread safety: may be used in
// several threads at once; each has its own fonts and its own cache of recent lines.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/fonts/font_families.h"

namespace carom {

enum class Align { left, center, right };

/// What the letters of a text are, which decides its family of fonts.
enum class Lettering { text, numbers, formulas };

struct TextStyle {
    double size = 16;  ///< height of the em, in the unit of the canvas
    int weight = 400;  ///< 400 to 600, or 900
    Color color = {};
    Align align = Align::left;
    bool tabular = true;                  ///< digits of equal width
    double max_width = 0;                 ///< > 0: a longer line ends in an ellipsis
    double halo = 0;                      ///< > 0: an outline of this width around the letters,
    Color behind = {};                    ///< in this colour, so that they are legible on anything
    const FontFamilies* fonts = nullptr;  ///< null: Inter. Must stay valid until the thread ends
    Lettering lettering = Lettering::text;
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

/// Breaks plain words into lines of at most `style.max_width`, where their script allows it; a word
/// that is too long is broken inside. The last of `most` lines holds all that is left.
std::vector<std::string> wrapped(const std::string& words, const TextStyle& style,
                                 std::size_t most);

/// The letters of a plain text that no font of this machine has, each listed once.
std::vector<std::string> missing_letters(const std::string& text);

/// A line of text as it was drawn.
struct DrawnLine {
    std::string markup;
    double size = 0;  ///< height of the em
    Rect ink;         ///< bounding box of its letters
    bool is_cut = false;
};

/// Records the lines that this thread draws during the lifetime of the object, so that a layout can
/// be checked for words that are cut or overlap. Only one at a time on a thread.
class TextLog {
  public:
    TextLog();
    ~TextLog();
    TextLog(const TextLog&) = delete;
    TextLog& operator=(const TextLog&) = delete;

    std::vector<DrawnLine> lines;
    std::vector<std::string> left_out;  ///< plain words that leave_out() was told
    std::vector<std::string> in_keys;   ///< the same of name_in_key()
};

/// To be called for words (markup) that are not drawn because no place is free for them: notes them
/// in the log, if this thread keeps one.
void leave_out(const std::string& markup);

/// The same for words that stand in a key, because no place beside what they name is free.
void name_in_key(const std::string& markup);

/// The name and version of the text library.
std::string text_library();

/// Escapes plain text for use as markup: & < > ' ".
std::string escape_markup(const std::string& text);

/// Throws SystemError, with the Debian package to install, if the font is not on this machine.
void require_font();

/// The families of fonts that this machine has. Throws SystemError.
std::vector<std::string> installed_families();

}  // namespace carom

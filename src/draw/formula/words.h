// Draws text with formulae between `$` signs on a canvas. The text must be accepted by
// formula::check(); `\$` is a dollar sign. Text without formulae is drawn as by draw_text().
#pragma once

#include <string>
#include <vector>

#include "draw/formula/layout.h"
#include "draw/text.h"

namespace carom {

/// Plain text as such words: its dollar signs begin no formula.
std::string words_of_text(const std::string& text);

/// Draws one line with its baseline through `at`; returns its extent. A line with formulae is never
/// cut.
TextExtent draw_words(Canvas& canvas, Point at, const std::string& words, const TextStyle& style);

/// The extent without drawing, including the full height and depth of formulae.
TextExtent measure_words(const std::string& words, const TextStyle& style);

/// Breaks words into lines of at most `style.max_width` as wrapped() does, without breaking
/// formulae.
std::vector<std::string> wrapped_words(const std::string& words, const TextStyle& style,
                                       std::size_t most);

/// The height of a line in a paragraph: above its baseline, and in all.
struct LineHeight {
    double above, all;
};

/// The height of a line: `usual` times the size of its letters, one size of which is above the
/// baseline; more if formulae need it, with gaps around them.
LineHeight line_height_of(const std::string& words, const TextStyle& style, double usual);

/// Whether the text is a single formula, whose fractions and sums are set large.
bool is_formula_alone(const std::string& words);

/// Draws a formula with the start of its baseline at `at`, at `style.size` pixels per em.
void draw_formula(Canvas& canvas, Point at, const formula::Box& box, const TextStyle& style);

}  // namespace carom

// Words with formulae between `$` signs on a canvas. The words are those that formula::check()
// takes; `\$` is a dollar sign. Without a formula they are drawn as draw_text() draws them.
#pragma once

#include <string>
#include <vector>

#include "draw/formula/layout.h"
#include "draw/text.h"

namespace carom {

/// One line with its baseline through `at`; returns its extent. A line with formulae is never cut.
TextExtent draw_words(Canvas& canvas, Point at, const std::string& words, const TextStyle& style);

/// The extent without drawing; that of formulae as high and deep as they are.
TextExtent measure_words(const std::string& words, const TextStyle& style);

/// Words in lines of at most `style.max_width`, as wrapped() breaks them, formulae whole.
std::vector<std::string> wrapped_words(const std::string& words, const TextStyle& style,
                                       std::size_t most);

/// Of a line of words in a paragraph: how far it reaches above its baseline, and its whole height.
struct LineHeight {
    double above, all;
};

/// The height of a line is `usual` sizes of its letters, of which one is above the baseline; with
/// formulae that are higher or deeper than that, as much as they take, with gaps.
LineHeight line_height_of(const std::string& words, const TextStyle& style, double usual);

/// Whether words are a formula alone: its fractions and sums are large.
bool is_formula_alone(const std::string& words);

/// A formula with the begin of its baseline at `at`, in pixels of `style.size` to an em.
void draw_formula(Canvas& canvas, Point at, const formula::Box& box, const TextStyle& style);

}  // namespace carom

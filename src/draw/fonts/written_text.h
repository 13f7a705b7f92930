// A line of text as text of a document, instead of the outlines of its letters.
#pragma once

#include <string>
#include <vector>

#include "draw/color.h"
#include "draw/geometry.h"

namespace carom {

/// Words in one font and one colour.
struct TextRun {
    std::string words;    ///< plain, UTF-8
    double x = 0, y = 0;  ///< start of the baseline
    double width = 0;     ///< to the start of what follows
    std::string family;
    double size = 0;  ///< height of the em
    int weight = 400;
    bool is_italic = false;
    bool is_right_to_left = false;  ///< then x is its right end
    Color color;
};

struct WrittenText {
    std::vector<TextRun> runs;
    std::string kind;  ///< what its letters are: text, numbers or formulas
    bool tabular = false;
    double halo = 0;  ///< > 0: an outline of this width around the letters, in the colour `behind`
    Color behind = {};
};

}  // namespace carom

// Which texts of a picture touch one another, or what is drawn: found in the SVG alone, from the
// outlines of letters and shapes. Shares no code with the drawing.
#pragma once

#include <string>
#include <vector>

#include "support/svg_picture.h"

namespace carom::test {

/// Ink is shared by two parts of a picture where their parts overlap by more than this, in pixels:
/// less is antialiasing.
constexpr double least_overlap = 0.5;

/// The overlap of two boxes, the smaller of its width and its height; not positive: none.
double overlap(const Edges& a, const Edges& b);

/// Whether a shape puts ink into a box, less `least_overlap` on each side.
bool reaches(const Shape& shape, const Edges& box);

/// The box around all ink of a shape that its clip leaves.
Edges ink_of(const Shape& shape);

/// How a picture is looked at.
struct Look {
    std::vector<Paint> grounds;  ///< colours of the page and of plates, which are no ink
    std::vector<Edges> gases;    ///< where texts lie on the gas, on plates or with a rim: they may
                                 ///< lie on shapes there, but not on one another
};

struct Touching {
    Edges text;   ///< the ink of the text
    Edges other;  ///< that of the other text, or of the shape
    bool is_text = false;
};

/// All pairs that touch.
std::vector<Touching> touching(const SvgPicture& picture, const Look& look);

}  // namespace carom::test

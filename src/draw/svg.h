// Completes Cairo's SVG documents with what Cairo leaves out. Only the .cpp uses the XML library.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// Returns the document with `<title>`, `<desc>` and `role="img"`, from which screen readers know
/// what the picture is, and with ids that begin with the fingerprint of the document: several
/// pictures can be put into one page, where ids are shared, and the same picture always has the
/// same ids.
/// Marks of texts (Canvas::write) are replaced by these texts.
/// Throws SystemError if it is not SVG.
std::vector<std::uint8_t> finished_svg(std::span<const std::uint8_t> document,
                                       const PictureWords& words,
                                       std::span<const WrittenText> texts = {});

/// The mark of a text is a triangle: its corner, one pixel to the right, and so far down, in black
/// of this opacity. Cairo writes lengths in 1/256 pixel.
inline constexpr double alpha_of_text_marks = 0.12345;
constexpr double length_of_text_mark(std::size_t index) {
    return static_cast<double>(index + 1) / 64.0;
}

}  // namespace carom

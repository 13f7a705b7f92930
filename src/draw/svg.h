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
/// Throws SystemError if it is not SVG.
std::vector<std::uint8_t> finished_svg(std::span<const std::uint8_t> document,
                                       const PictureWords& words);

}  // namespace carom

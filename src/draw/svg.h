// What Cairo leaves out of its SVG documents. The .cpp is the one door to the XML library.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// The document with `<title>`, `<desc>` and `role="img"`, by which programs that read pages aloud
/// know what the picture is, and with ids that do not tell how much was drawn before in this
/// process. Throws SystemError when it is no SVG.
std::vector<std::uint8_t> finished_svg(std::span<const std::uint8_t> document,
                                       const PictureWords& words);

}  // namespace carom

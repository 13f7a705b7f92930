// What Cairo leaves out of PNG files: the size in which a picture is to be shown, and the
// description that other formats also carry. Knows no canvas.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// Returns the PNG with its resolution (chunk pHYs, PNG specification, 11.3.4.3), from which other
/// programs know how large the picture is on paper. The pixels are unchanged.
std::vector<std::uint8_t> with_resolution(std::vector<std::uint8_t> png, double dots_per_inch);

/// Returns the PNG with title, description and origin added as UTF-8 text (iTXt chunks, PNG
/// specification, 11.3.4.5); empty ones are left out. The pixels are unchanged.
std::vector<std::uint8_t> with_words(std::vector<std::uint8_t> png, const PictureWords& words);

}  // namespace carom

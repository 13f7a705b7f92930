// Text in PNG files: the description of a picture that other formats also carry. Knows no canvas.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// Returns the PNG with title, description and origin added as UTF-8 text (iTXt chunks, PNG
/// specification, 11.3.4.5); empty ones are left out. The pixels are unchanged.
std::vector<std::uint8_t> with_words(std::vector<std::uint8_t> png, const PictureWords& words);

}  // namespace carom

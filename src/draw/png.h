// PNG files with words in them: what a picture is, as other formats say it. Knows no canvas.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/canvas.h"

namespace carom {

/// A PNG with title, description and origin in it, as text in UTF-8 (chunks of type iTXt of the PNG
/// specification, 11.3.4.5); those that are empty are left out. The pixels stay as they are.
std::vector<std::uint8_t> with_words(std::vector<std::uint8_t> png, const PictureWords& words);

}  // namespace carom

// Still pictures: a PNG of a raster canvas, an SVG or PDF of a vector one.
#pragma once

#include <filesystem>

#include "draw/canvas.h"

namespace carom {

/// Writes the canvas's file(), whole or not at all. Throws SystemError naming the path and the
/// cause.
void write_image(Canvas& canvas, const std::filesystem::path& path);

}  // namespace carom

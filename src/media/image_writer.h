// Still pictures: PNG from a raster canvas.
#pragma once

#include <filesystem>

#include "draw/canvas.h"

namespace carom {

/// Writes a PNG, whole or not at all. Throws SystemError naming the path and the cause.
void write_png(const Canvas& canvas, const std::filesystem::path& path);

}  // namespace carom

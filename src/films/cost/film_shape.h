// Chooses a smaller picture size and a lower frame rate for a film that must not exceed a number of
// bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "media/formats.h"
#include "scene/layout.h"

namespace carom {

/// The most shapes in which fitting_shape() measures a film.
inline constexpr int most_shapes_measured = 6;

/// Picture size and frame rate (frames per second) of a film.
struct FilmShape {
    PictureSize size;
    int fps = 30;
};

/// Of the shapes in which the film takes at most `most` bytes, the one that differs least from
/// `asked`: halving width and height counts as much as halving the rate. `measure` gives the bytes
/// of the film in a shape, and is called for a few shapes only. Returns nothing if not even the
/// smallest legible shape (shorter side 240 pixels, 10 frames per second) is small enough.
std::optional<FilmShape> fitting_shape(const FilmShape& asked, const FormatCost& cost, double most,
                                       const std::function<double(const FilmShape&)>& measure);

/// The number of bytes of a size as people write it: 5MB, 800 kB, 2.5 GB, 3 MiB or 500000. Throws
/// UsageError, naming the option, if it is not a size.
double parsed_bytes(const std::string& option, const std::string& text);

}  // namespace carom

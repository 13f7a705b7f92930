// Smaller pictures and fewer of them, for a film that is to fit into so many bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "media/formats.h"
#include "scene/scene.h"

namespace carom {

/// Size and rate of a film.
struct FilmShape {
    PictureSize size;
    int fps = 30;
};

/// The shape that differs least from `asked` of those in which a film takes at most `most` bytes:
/// half the width and height count as much as half the rate. `measure` gives the bytes of a film of
/// a shape, and is asked for a few of them. None: not even the smallest that can be read does
/// (240 pixels, 10 frames a second).
std::optional<FilmShape> fitting_shape(const FilmShape& asked, const FormatCost& cost, double most,
                                       const std::function<double(const FilmShape&)>& measure);

/// A size as people write it, in bytes: 5MB, 800 kB, 2.5 GB, 3 MiB or 500000. Throws UsageError
/// naming the option.
double parsed_bytes(const std::string& option, const std::string& text);

}  // namespace carom

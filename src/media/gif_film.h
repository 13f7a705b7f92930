// A film as a GIF that loops forever: the choice of its colours from frames of the whole film, the
// delays between frames, and the file format. The pictures in it are encoded by GifEncoder.
#pragma once

#include <filesystem>
#include <memory>

#include "media/film_writer.h"

namespace carom {

/// The highest frame rate. Delays in a GIF are whole hundredths of a second, and most programs show
/// frames with a delay below two hundredths for much longer.
constexpr int most_gif_frames_per_second = 50;

/// The delay of frame number `frame` (from 0) in hundredths of a second; the delays of a film add
/// up to its length.
int gif_delay(int frame, int fps);

/// A GIF writer. The metadata are stored as a comment; the colours come from use_colors(). Throws
/// SystemError.
std::unique_ptr<FilmWriter> gif_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int frames);

}  // namespace carom

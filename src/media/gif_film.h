// A film as a GIF that loops forever: its colours from frames of the whole film, its delays, its
// file. Owns the format of the file; the pictures in it are GifEncoder's.
#pragma once

#include <filesystem>
#include <memory>

#include "media/film_writer.h"

namespace carom {

/// A GIF counts hundredths of a second, and what is to be shown for less than two of them is shown
/// much longer by most programs.
constexpr int most_gif_frames_per_second = 50;

/// Hundredths of a second for which frame number `frame` (from 0) is shown: the delays of a film
/// add up to its length.
int gif_delay(int frame, int fps);

/// The metadata stand in it as a comment. Its colours come from use_colors(). Throws SystemError.
std::unique_ptr<FilmWriter> gif_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int frames);

}  // namespace carom

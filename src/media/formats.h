// The table of the output formats of carom: the name of each, what it can hold, what a film in it
// costs, and the function that makes the writer.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "media/film_writer.h"

namespace carom {

/// The cost of a frame at quality `standard` as a power of the number of disks, through measured
/// films of 200 and of 1,000 disks at 1080p.
struct PowerLaw {
    double at_200, at_1000;
    double at(double disks) const;
};
/// The costs of the other qualities, as multiples of that of `standard`.
struct QualityFactors {
    double draft = 1.0, final_ = 1.0;
    double at(Quality quality) const;
};
struct FormatCost {
    PowerLaw core_seconds, bytes;  ///< of a frame
    double power_of_pixels;   ///< exponent with which the bytes of a frame grow with its pixels: it
                              ///< shows outlines, not areas
    double memory_per_pixel;  ///< largest memory of a thread that draws and encodes, in bytes per
                              ///< pixel
    double beforehand = 0.0;  ///< fixed cost of a film: seconds on one core at 1080p
    QualityFactors seconds_by_quality = {}, bytes_by_quality = {};

    /// Seconds on one core and bytes for a frame with this number of disks and of pixels.
    double frame_seconds(double disks, double pixels, Quality quality) const;
    double frame_bytes(double disks, double pixels, Quality quality) const;
    /// Seconds on one core that a film costs in addition, whatever its length.
    double seconds_before(double pixels) const;
};

/// The sound of films in a format.
struct FormatSound {
    const char* codec;
    double bytes;  ///< bytes per second
};

struct OutputFormat {
    std::string name;  ///< as given to --format; also the file name extension, after a dot
    bool stills = false, figures = false;
    std::optional<VectorFormat> vector =
        {};  ///< vector format of stills and figures; none: they are pixels, or not possible
    std::optional<FormatCost> film = {};  ///< cost of a film; none: the format cannot hold films
    std::string no_transparency = {};     ///< why a film in it cannot be transparent; empty: it can
    int most_frames_per_second = 0;       ///< 0: any number
    double large_bytes = 0.0;   ///< size from which a film is large for this format; 0: never
    bool in_one_piece = false;  ///< a film is made by one process; its cost is not reported
    std::optional<FormatSound> sound = {};  ///< none: its films are silent
    int previews = 0;  ///< number of frames, from the whole film, from which its colours are chosen
    std::unique_ptr<FilmWriter> (*make_film)(const std::filesystem::path&, const VideoSettings&,
                                             int frames) = nullptr;
};

/// All formats, in the order in which they are listed.
const std::vector<OutputFormat>& output_formats();

/// The format of this name, which must exist.
const OutputFormat& output_format(const std::string& name);

/// The ending of a file's name with its dot, in lower case: FILM.MP4 is an MP4, too.
std::string ending_of(const std::filesystem::path& path);

/// The format of a film at `path`: numbered PNG if the path ends in a slash, otherwise according to
/// its extension; MP4 for any other extension.
const OutputFormat& format_of_film(const std::filesystem::path& path);

/// A writer for the film at `path` with this number of frames. Throws SystemError.
std::unique_ptr<FilmWriter> film_writer(const std::filesystem::path& path,
                                        const VideoSettings& settings, int frames);

/// The names of the formats for films, for films made in chunks, for stills and for figures.
std::vector<std::string> film_formats();
std::vector<std::string> chunk_formats();
std::vector<std::string> still_formats();
std::vector<std::string> figure_formats();

}  // namespace carom

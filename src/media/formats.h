// The formats that carom writes, in one table: what each is called, what it can hold, what a film
// in it costs, and what makes it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "media/film_writer.h"

namespace carom {

/// What a frame costs at quality `standard`: through films of 200 and of 1,000 disks at 1080p.
struct PowerLaw {
    double at_200, at_1000;
    double at(double disks) const;
};
/// Of qualities, as factors of that of `standard`.
struct QualityFactors {
    double draft = 1.0, final_ = 1.0;
    double at(Quality quality) const;
};
struct FormatCost {
    PowerLaw core_seconds, bytes;  ///< of a frame
    double power_of_pixels;        ///< by which the bytes of a frame grow: outlines, not areas
    double memory_per_pixel;       ///< bytes of a thread that draws and encodes, at most
    double beforehand = 0.0;       ///< seconds on one core at 1080p, whatever the length
    QualityFactors seconds_by_quality = {}, bytes_by_quality = {};

    /// Of a frame with so many disks and pixels, on one core.
    double frame_seconds(double disks, double pixels, Quality quality) const;
    double frame_bytes(double disks, double pixels, Quality quality) const;
    /// On one core, whatever the length.
    double seconds_before(double pixels) const;
};

/// How films in a format have sound.
struct FormatSound {
    const char* codec;
    double bytes;  ///< of a second
};

struct OutputFormat {
    std::string name;  ///< as --format has it; behind a dot the ending of its files
    bool stills = false, figures = false;
    std::optional<VectorFormat> vector =
        {};                               ///< of stills and figures; none: pixels, or no picture
    std::optional<FormatCost> film = {};  ///< of a film; none: there are no films of it
    std::string no_transparency = {};     ///< why a film in it has none; empty: it can
    int most_frames_per_second = 0;       ///< 0: any number
    double large_bytes = 0.0;             ///< from which a film is large for it; 0: never
    bool in_one_piece = false;  ///< a film in it is made by one process, and its cost is not told
    std::optional<FormatSound> sound = {};  ///< none: its films are silent
    int previews = 0;  ///< frames of the whole film from which its colours are chosen
    std::unique_ptr<FilmWriter> (*make_film)(const std::filesystem::path&, const VideoSettings&,
                                             int frames) = nullptr;
};

/// All of them, in the order in which they are listed.
const std::vector<OutputFormat>& output_formats();

/// The format of this name, which must be one.
const OutputFormat& output_format(const std::string& name);

/// The format of a film at `path`: numbered PNG where it ends in a slash, otherwise by its ending;
/// MP4 under any other name.
const OutputFormat& format_of_film(const std::filesystem::path& path);

/// What writes the film at `path`, of so many frames. Throws SystemError.
std::unique_ptr<FilmWriter> film_writer(const std::filesystem::path& path,
                                        const VideoSettings& settings, int frames);

/// Names of those that can be films, films in chunks, stills or figures.
std::vector<std::string> film_formats();
std::vector<std::string> chunk_formats();
std::vector<std::string> still_formats();
std::vector<std::string> figure_formats();

}  // namespace carom

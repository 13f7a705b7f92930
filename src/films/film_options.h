// What is asked of a film besides its scene.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>

#include "media/film_writer.h"
#include "media/formats.h"
#include "panels/recording.h"

namespace carom {

/// Options of a scene's film that are not part of the scene.
struct FilmOptions {
    std::filesystem::path output = {};  ///< path; format_of_film() takes the format from it
    Quality quality = Quality::standard;
    bool is_quality_asked = false;  ///< the user has given --quality, even if with its default
    int threads = 1;
    bool text = false;                     ///< also write its FilmText, in files next to the film
    std::optional<double> joined_at = {};  ///< second at which it begins in a joined film
    std::optional<double> from = {},
                          to = {};  ///< times, as for frames_between(); none: the whole film
    Recording::Room room = {};      ///< for the frames of the run; a larger run is simulated again
    std::filesystem::path cache = {};  ///< folder of an AxesCache; empty: no cache
    double most_bytes = std::numeric_limits<double>::infinity();  ///< a larger film is not written
    /// If set, the film is not written to `output`, but to a temporary file that vanishes after it
    /// was passed to this function, finished.
    std::function<void(const FilmWriter&)> take = {};
};

}  // namespace carom

// The arguments of `carom render`, and which of them do not go together.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "app/film/film_path.h"
#include "films/film_options.h"

namespace carom {

struct RenderArguments : SceneOptions {
    std::vector<std::string> scenes;
    FilmDestination destination;
    FilmOptions film;      ///< without the path
    std::string max_size;  // empty: any
    std::string depfile, cache;
    bool join = false;
    int chunk = 0;  // number of a chunk of a plan; 0: all missing ones
    bool force = false, allow_mixed = false;
};

/// The largest number of bytes that a film may have. Throws UsageError as parsed_bytes().
double most_bytes(const RenderArguments& arguments);

/// Refuse, by UsageError, options that do not go together: with slides, with a page or with slides
/// and a format, and with the folder of a plan, which has fixed what changes its film.
void refuse_slide_options(const RenderArguments& arguments);
void refuse_page_options(const RenderArguments& arguments, const OutputFormat& format);
void refuse_film_options(const RenderArguments& arguments);

}  // namespace carom

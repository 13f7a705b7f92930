// The command-line options of films.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "films/film_options.h"

namespace carom {

/// --from, --to, --fps, --seconds, --no-sound, --no-recipe and --quality.
std::vector<Option> film_options(SceneOptions& options, FilmOptions& film);

/// --cache, of films and stills.
Option cache_option(std::string& folder);

/// Only --fps, --seconds, --no-sound, --no-recipe and --quality.
std::vector<Option> film_shape_options(SceneOptions& options, FilmOptions& film);

/// Whether --from, --to or --quality is given.
bool changes_film(const FilmOptions& film);

}  // namespace carom

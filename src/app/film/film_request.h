// What the command line asks of a film, and what it cannot ask.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "app/film/film_plan.h"
#include "media/formats.h"
#include "scene/scene.h"

namespace carom {

/// --from, --to, --fps, --seconds, --no-sound and --quality.
std::vector<Option> film_options(SceneOptions& options, FilmOptions& film);

/// --cache, for films and stills.
Option cache_option(std::string& folder);

/// The last four of these.
std::vector<Option> film_shape_options(SceneOptions& options, FilmOptions& film);

/// Whether --from, --to or --quality are given.
bool changes_film(const FilmOptions& film);

/// Throws UsageError where --from and --to are not times of a scene, in order.
void refuse_span(const FilmOptions& film, const Scene& scene);

/// Throws UsageError where a film of a scene cannot be in a format.
void refuse_format(const OutputFormat& format, const Scene& scene);

/// Both, and throws SystemError where this machine lacks letters that the film needs.
void refuse_unfit(const Scene& scene, const FilmOptions& film, const OutputFormat& format);

/// The name of a format as it is written.
std::string upper_case(std::string text);

}  // namespace carom

// The command-line options of films, and checks that they are consistent.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "films/film_options.h"
#include "media/formats.h"

namespace carom {

struct Scene;

/// --from, --to, --fps, --seconds, --no-sound and --quality.
std::vector<Option> film_options(SceneOptions& options, FilmOptions& film);

/// --cache, of films and stills.
Option cache_option(std::string& folder);

/// Only --fps, --seconds, --no-sound and --quality.
std::vector<Option> film_shape_options(SceneOptions& options, FilmOptions& film);

/// Whether --from, --to or --quality is given.
bool changes_film(const FilmOptions& film);

/// Throws UsageError unless --from and --to are times within the scene's run, with --from before
/// --to.
void refuse_span(const FilmOptions& film, const Scene& scene);

/// Throws UsageError if a scene's film cannot be written in a format.
void refuse_format(const OutputFormat& format, const Scene& scene);

/// Calls refuse_span() and refuse_format(). Also throws SystemError if no font of this machine has
/// some letter that the film needs.
void refuse_unfit(const Scene& scene, const FilmOptions& film, const OutputFormat& format);

/// The name of a format as it is written in text: in capitals.
std::string upper_case(std::string text);

}  // namespace carom

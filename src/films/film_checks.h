// Whether what is asked of a film can be: checked before any work.
#pragma once

#include <string>
#include <vector>

#include "films/film_options.h"
#include "media/formats.h"

namespace carom {

struct Scene;

/// Throws UsageError unless --from and --to are times within the scene's run, with --from before
/// --to.
void refuse_span(const FilmOptions& film, const Scene& scene);

/// Throws UsageError if a scene's film cannot be written in a format.
void refuse_format(const OutputFormat& format, const Scene& scene);

/// Calls refuse_span() and refuse_format(). Also throws SystemError if no font of this machine has
/// some letter that the film needs.
void refuse_unfit(const Scene& scene, const FilmOptions& film, const OutputFormat& format);

/// Throws UsageError if the films of these scenes cannot be joined to one film in a format.
void refuse_unjoinable(const std::vector<Scene>& scenes, const OutputFormat& format);

}  // namespace carom

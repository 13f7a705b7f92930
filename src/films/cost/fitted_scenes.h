// The scenes of a film in a shape in which it does not exceed a number of bytes.
#pragma once

#include <optional>
#include <vector>

#include "films/film_options.h"
#include "films/join.h"
#include "scene/scene.h"
#include "util/progress.h"

namespace carom {

/// The scenes of a film, of which several are joined under a title, with the picture size and frame
/// rate that differ least from their own among those in which the film takes at most `most` bytes;
/// nothing if there are none. The film is measured in a few shapes (fitting_shape()). Throws what
/// measured_cost() throws.
std::optional<std::vector<Scene>> fitted_scenes(const std::vector<Scene>& scenes,
                                                const JoinedTitle& title, double most,
                                                const FilmOptions& options, Progress& progress);

}  // namespace carom

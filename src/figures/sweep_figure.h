// The numbers of a figure that shows a sweep: of runs that it does itself, or of a joined sweep.
#pragma once

#include <filesystem>
#include <functional>

#include "panels/sweep/sweep_panel.h"
#include "scene/scene.h"

namespace carom {

/// The summary of a joined sweep that a figure shows: beside the scene, unless its path says
/// otherwise.
std::filesystem::path path_of_joined(const Scene& scene, const FigureSpec& spec);

/// Refuses what swept_numbers() would refuse, but for gases that cannot be placed, before anything
/// is run. Throws SceneError.
void check_swept_figure(const Scene& scene, const FigureSpec& spec);

/// What a figure of kind `sweep` of this scene shows. Runs what it has to on `threads` threads at
/// most, with `on_run` after each, from any thread. Throws SceneError (there is no such number, a
/// gas cannot be placed, the joined sweep is not there or is of another scene), Interrupted.
SweptNumbers swept_numbers(const Scene& scene, const FigureSpec& spec, int threads,
                           const std::function<void()>& on_run);

}  // namespace carom

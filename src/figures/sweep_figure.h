// The data of a figure that shows a sweep, from runs done for the figure or from a joined sweep.
#pragma once

#include <filesystem>
#include <functional>

#include "panels/sweep/sweep_panel.h"

namespace carom {

struct FigureSpec;
struct Scene;

/// The path of the summary of the joined sweep that a figure shows; relative paths start at the
/// scene's folder.
std::filesystem::path path_of_joined(const Scene& scene, const FigureSpec& spec);

/// Checks, before anything is run, for the errors that swept_numbers() would find, except gases
/// that cannot be placed. Throws SceneError.
void check_swept_figure(const Scene& scene, const FigureSpec& spec);

/// The data that a figure of kind `sweep` of this scene shows. Does the runs that it needs on at
/// most `threads` threads, and calls `on_run` after each, from any thread. Throws SceneError (there
/// is no such number, a gas cannot be placed, the joined sweep is missing or is of another scene),
/// Interrupted.
SweptNumbers swept_numbers(const Scene& scene, const FigureSpec& spec, int threads,
                           const std::function<void()>& on_run);

}  // namespace carom

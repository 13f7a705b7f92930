// The main road: from a scene to its plan, from the plan to segments, and these to a film, or to
// one frame of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/film/film_plan.h"
#include "app/film/segment_workers.h"
#include "app/progress.h"
#include "draw/canvas.h"
#include "media/formats.h"
#include "scene/scene.h"

namespace carom {

/// What a rendering did, and the seconds it took.
struct RenderReport {
    std::filesystem::path path;
    int frames = 0;
    std::int64_t bytes = 0;
    CollisionCounts collisions;
    std::vector<std::string> passes;       ///< what the run was simulated for
    std::vector<std::string> cut;          ///< as FramePainter::cut_words()
    std::vector<std::string> never_shown;  ///< as PlotCallouts::never_shown()
    bool lacks_sound = false;              ///< that the scene has, as its format has none
    double wall_seconds = 0.0;
    double simulate_seconds = 0.0;  ///< CPU, all passes and the panels, but for a first pass that
                                    ///< panels see on a thread of their own
    WorkerSeconds workers;
};

/// Whether the film has no more bytes than it may have.
bool fits(const RenderReport& report, const FilmOptions& options);

/// Renders the film of `scene`, whole or not at all: prepares it, draws its segments side by side
/// and joins them. One that does not fit is not written. Throws SceneError (the gas cannot be
/// placed, or does not return), SystemError, Interrupted.
RenderReport render(const Scene& scene, const FilmOptions& options, Progress& progress);

/// The same of what is prepared already, with what it was prepared for.
RenderReport render(const FilmPlan& plan, const FilmOptions& options, Progress& progress);

/// Draws all frames of a plan for `writer`, which is not committed, and adds to the report what
/// they took.
void draw_frames(const FilmPlan& plan, int threads, FilmWriter& writer, Progress& progress,
                 RenderReport& report);

/// What writes the film of a plan, whose metadata hold all that makes it again. Throws SystemError.
std::unique_ptr<FilmWriter> film_writer(const FilmPlan& plan, const FilmOptions& options,
                                        std::vector<FilmChapter> chapters = {});

/// The simulated time of the picture that stands for a film.
double time_of_poster(const Scene& scene, const FilmOptions& options = {});

/// A frame as a picture, in a format of stills.
Canvas paint_still(const PanelSet& panels, const FrameData& frame, const OutputFormat& format);

/// Draws the frame nearest to the simulated time `at`, in a format of stills. Throws as render()
/// does.
Canvas draw_still(const FilmPlan& plan, double at, const OutputFormat& format, Progress& progress);

/// Draws the frame of the film of `scene` that is nearest to the simulated time `at`, in a format
/// of stills: the same picture as draw_still() of the whole plan. With `is_quick` panels see the
/// run at some thirty times only, from which axes and colour scales are found, and what they
/// gather, unless `cache`, the folder of an AxesCache, has the axes already. Throws SceneError (the
/// gas cannot be placed, or does not return), SystemError, Interrupted.
Canvas draw_still_alone(const Scene& scene, double at, bool is_quick,
                        const std::filesystem::path& cache, const OutputFormat& format,
                        Progress& progress);

}  // namespace carom

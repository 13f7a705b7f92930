// The main road: from a scene to its plan, from the plan to segments, and these to a film, or to
// one frame of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/film/film_plan.h"
#include "app/progress.h"
#include "draw/canvas.h"
#include "media/formats.h"
#include "scene/scene.h"

namespace carom {

struct RenderOptions {
    std::filesystem::path output;  ///< as format_of_film() reads it
    Quality quality = Quality::standard;
    int threads = 1;
    bool text = false;  ///< the files of film_text.h beside it
    std::optional<double> from = {},
                          to = {};  ///< as frames_between() reads them; none: the whole film
};

/// What a rendering did, and the seconds it took.
struct RenderReport {
    std::filesystem::path path;
    int frames = 0;
    std::int64_t bytes = 0;
    CollisionCounts collisions;
    std::vector<std::string> passes;  ///< what the run was simulated for
    double wall_seconds = 0.0;
    double simulate_seconds = 0.0;  ///< CPU, all passes and the panels
    double draw_seconds = 0.0;      ///< CPU of all workers
    double encode_seconds = 0.0;    ///< CPU of all workers, conversion included
};

/// Renders the film of `scene`, whole or not at all: prepares it, draws its segments side by side
/// and joins them. Throws SceneError (the gas cannot be placed, or does not return), SystemError,
/// Interrupted.
RenderReport render(const Scene& scene, const RenderOptions& options, Progress& progress);

/// The same of what is prepared already, with what it was prepared for.
RenderReport render(const FilmPlan& plan, const RenderOptions& options, Progress& progress);

/// The settings of a film at `quality`, whose metadata hold all that makes it again.
VideoSettings film_settings(const Scene& scene, const RenderOptions& options);

/// Draws the frames of one of `plan.segments` alone, for `writer`; join() adds it to the film.
std::unique_ptr<FilmSegment> draw(const FilmPlan& plan, std::size_t segment, FilmWriter& writer);

/// Draws all segments, on `threads` threads at most, and joins them to the film. `report` gets
/// what was done.
void draw_all(const FilmPlan& plan, int threads, FilmWriter& writer, Progress& progress,
              RenderReport& report);

/// Draws the frame nearest to the simulated time `at`, in a format of stills. Throws as render()
/// does.
Canvas draw_still(const FilmPlan& plan, double at, const OutputFormat& format, Progress& progress);

}  // namespace carom

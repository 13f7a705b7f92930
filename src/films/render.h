// The main path of the program: from a scene to its plan, from the plan to segments, and from these
// to a film; or to a single frame of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "films/film_options.h"
#include "films/segment_workers.h"
#include "films/words/film_text.h"
#include "media/formats.h"
#include "util/progress.h"

namespace carom {

struct FilmPlan;

struct Scene;

/// Result of a rendering, and the seconds it took.
struct RenderReport {
    std::filesystem::path path;
    int frames = 0;
    std::int64_t bytes = 0;
    CollisionCounts collisions;
    std::vector<std::string> passes;       ///< what each simulation of the run was for
    std::vector<std::string> cut;          ///< as words_without_room()
    std::vector<std::string> never_shown;  ///< as PlotCallouts::never_shown()
    bool lacks_sound = false;  ///< the scene has sound, but the format of the film has none
    double wall_seconds = 0.0;
    double simulate_seconds = 0.0;  ///< CPU seconds of all passes and of the panels, except for
                                    ///< panels that see the first pass on a separate thread
    WorkerSeconds workers;
};

/// Whether the film has at most `options.most_bytes` bytes.
bool fits(const RenderReport& report, const FilmOptions& options);

/// Finishes a film that is drawn, and passes it on or gives it its name, with its text files,
/// unless it is larger than `options.most_bytes`. Sets the number of bytes in the report.
void finish_film(FilmWriter& writer, const FilmText& text, TextFiles wanted,
                 const FilmOptions& options, RenderReport& report);

/// Renders the film of `scene`, which appears complete or not at all: prepares it, draws its
/// segments in parallel and joins them. A film that exceeds `options.most_bytes` is not written.
/// Throws SceneError (the gas cannot be placed, or does not return), SystemError, Interrupted.
RenderReport render(const Scene& scene, const FilmOptions& options, Progress& progress);

/// The same for a plan that is already prepared; `options` are those it was prepared with.
RenderReport render(const FilmPlan& plan, const FilmOptions& options, Progress& progress);

/// Draws all frames of a plan and passes them to `writer`, without committing it. Adds the seconds
/// spent to the report.
void draw_frames(const FilmPlan& plan, int threads, FilmWriter& writer, Progress& progress,
                 RenderReport& report);

/// The writer for the film of a plan. The metadata of the film contain all that is needed to make
/// it again. Throws SystemError.
std::unique_ptr<FilmWriter> film_writer(const FilmPlan& plan, const FilmOptions& options,
                                        std::vector<FilmChapter> chapters = {});

/// The simulated time of the poster, the still picture that represents a film.
double time_of_poster(const Scene& scene, const FilmOptions& options = {});

/// Draws a frame as a picture in a still format.
Canvas paint_still(const PanelSet& panels, const FrameData& frame, const OutputFormat& format);

/// A still, and the frames of the film from which its panels know the run.
struct Still {
    Canvas picture;
    std::size_t frames_seen, frames;  ///< equal: it is the same picture as in the film
};

/// Draws the frame nearest to the simulated time `at`, in a still format. Throws what render()
/// throws.
Canvas draw_still(const FilmPlan& plan, double at, const OutputFormat& format, Progress& progress);

/// Draws the frame of the film of `scene` nearest to the simulated time `at`, in a still format:
/// the same picture as draw_still() with the plan of the whole film. With `is_quick` the panels see
/// the run at about thirty times only, so that axes, colour scales and accumulated data are
/// approximate, unless `cache`, the folder of an AxesCache, has the axes already; the picture's
/// description then says so. Throws SceneError (the gas cannot be placed, or does not return),
/// SystemError, Interrupted.
Still draw_still_alone(const Scene& scene, double at, bool is_quick,
                       const std::filesystem::path& cache, const OutputFormat& format,
                       Progress& progress);

}  // namespace carom

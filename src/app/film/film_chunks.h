// A film that is made in chunks, by several processes or on several machines: planned once, its
// chunks drawn and encoded in any order, and joined by stream copy to the very bytes of a film that
// is made in one process.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/chunks/plan_folder.h"
#include "app/film/film_plan.h"
#include "app/film/render.h"
#include "app/progress.h"
#include "scene/scene.h"

namespace carom {

/// Into how many chunks a film is divided. Chunks consist of whole segments, so that there are at
/// most as many.
struct FilmDivision {
    std::optional<int> chunks = {};      ///< none: by `seconds`
    std::optional<double> seconds = {};  ///< of expected work for each, on one core; none: 4 chunks
};

/// The first segment of each chunk, and the number of segments: of `segments` (as
/// segment_starts()), in about equal chunks.
std::vector<std::size_t> chunk_starts(const std::vector<int>& segments, int chunks);

struct FilmPlanReport {
    int chunks = 0;
    int frames = 0;
    bool is_new = true;               ///< else the folder held this plan already
    std::vector<std::string> cut;     ///< as FramePainter::cut_words()
    std::vector<std::string> passes;  ///< what the run was simulated for
    double wall_seconds = 0.0;
};

/// Plans the film of a scene in a folder: axes and words of the whole film, and for each chunk the
/// frames or the state of the simulation that it begins with. Does nothing where the folder holds
/// this plan already, unless `force`. The ending of `options.output` gives the format. Throws
/// UsageError (the folder holds something else), SceneError, SystemError, Interrupted.
FilmPlanReport plan_film(const Scene& scene, const FilmOptions& options,
                         const FilmDivision& division, const std::filesystem::path& folder,
                         bool force, Progress& progress);

/// How a chunk is made.
struct ChunkOptions {
    int threads = 1;
    bool force = false;        ///< also if it is done already
    bool allow_mixed = false;  ///< also by another build than that of the plan
};

/// Draws and encodes a chunk, whole or not at all; false, and nothing is done, where it is there
/// already. Throws UsageError, SystemError, Interrupted.
bool render_chunk(const PlanFolder& folder, const PlannedChunk& chunk, const ChunkOptions& options,
                  Progress& progress);

/// What join_film() is asked for.
struct JoinOptions {
    std::filesystem::path output;
    bool text = false;         ///< as FilmOptions::text
    bool poster = false;       ///< a picture of the film beside it, FILM.poster.png
    bool allow_mixed = false;  ///< also of chunks of other builds
};

/// Joins the chunks of a plan to its film, whole or not at all. Throws UsageError (chunks are
/// missing), SystemError (a chunk is damaged, or of another build), Interrupted.
RenderReport join_film(const PlanFolder& folder, const JoinOptions& options, Progress& progress);

/// The name of the format of a plan's film, and the scene that it is of, as the user gave it.
std::string format_of_plan(const PlanFolder& folder);
std::string scene_of_plan(const PlanFolder& folder);

}  // namespace carom

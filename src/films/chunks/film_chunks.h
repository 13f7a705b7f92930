// A film made in chunks, by several processes or on several machines. It is planned once; its
// chunks are drawn and encoded in any order, and joined by stream copy. The result is identical,
// byte for byte, to a film made in one process.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "films/film_plan.h"
#include "films/render.h"
#include "util/progress.h"
#include "works/plan_folder.h"

namespace carom {

struct Scene;
struct SceneSource;

/// How a film is divided into chunks. Chunks consist of whole segments, so there are at most as
/// many chunks as segments.
struct FilmDivision {
    std::optional<int> chunks = {};      ///< none: by `seconds`
    std::optional<double> seconds = {};  ///< of expected work for each, on one core; none: 4 chunks
};

/// Divides `segments` (as from segment_starts()) into about equal chunks. Returns the index of the
/// first segment of each chunk, followed by the number of segments.
std::vector<std::size_t> chunk_starts(const std::vector<int>& segments, int chunks);

struct FilmPlanReport {
    int chunks = 0;
    int frames = 0;
    bool is_new = true;               ///< false: the folder held this plan already
    std::vector<std::string> cut;     ///< as words_without_room()
    std::vector<std::string> passes;  ///< what each simulation of the run was for
    double wall_seconds = 0.0;
};

/// Plans the film of a scene in a folder: writes the axes and words of the whole film and, for each
/// chunk, its frames or the state of the simulation from which it begins. Does nothing if the
/// folder holds this plan already, unless `force`. The ending of `options.output` gives the format.
/// Throws UsageError (the folder holds something else), SceneError, SystemError, Interrupted.
FilmPlanReport plan_film(const Scene& scene, const FilmOptions& options,
                         const FilmDivision& division, const std::filesystem::path& folder,
                         bool force, Progress& progress);

/// How a chunk is made.
struct ChunkOptions {
    int threads = 1;
    bool force = false;        ///< make the chunk even if it is done already
    bool allow_mixed = false;  ///< make the chunk even if this build is not that of the plan
};

/// Draws and encodes a chunk; its file appears complete or not at all. Returns false, without doing
/// anything, if the chunk is done already. Throws UsageError, SystemError, Interrupted.
bool render_chunk(const PlanFolder& folder, const PlannedChunk& chunk, const ChunkOptions& options,
                  Progress& progress);

/// Options of join_film().
struct JoinOptions {
    std::filesystem::path output;
    bool text = false;         ///< as FilmOptions::text
    bool poster = false;       ///< also write a still picture next to the film, FILM.poster.png
    bool allow_mixed = false;  ///< accept chunks made by other builds
};

/// Joins the chunks of a plan to its film, which appears complete or not at all. Throws UsageError
/// (chunks are missing), SystemError (a chunk is damaged, or was made by another build),
/// Interrupted.
RenderReport join_film(const PlanFolder& folder, const JoinOptions& options, Progress& progress);

/// The name of the format of a planned film, and the path of its scene as the user gave it.
std::string format_of_plan(const PlanFolder& folder);
std::string scene_of_plan(const PlanFolder& folder);

/// The source of its scene, and the options with which it was planned, without a path.
SceneSource source_of_plan(const PlanFolder& folder);
FilmOptions options_of_plan(const PlanFolder& folder);

}  // namespace carom

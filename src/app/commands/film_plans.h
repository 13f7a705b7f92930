// What `carom plan` and `carom join` do with films.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "films/chunks/film_chunks.h"
#include "works/plan_folder.h"

namespace carom {

/// Arguments of `carom plan` for films.
struct FilmPlanArguments {
    std::string format;
    FilmOptions film;                          ///< without the path
    int chunks = 0;                            ///< for each film; 0: by the expected seconds
    std::optional<double> chunk_seconds = {};  ///< expected work for each chunk
    bool force = false;
};

/// --chunk-seconds, --format and the options of a film.
std::vector<Option> film_plan_options(SceneOptions& options, FilmPlanArguments& arguments);

/// Plans the films of scenes: a single one in the folder `output`, several in subfolders of it.
/// With an empty `output` the folders are out/SCENE.plan.
void plan_films(const std::vector<std::string>& scenes, const std::string& output,
                const FilmPlanArguments& arguments, const SceneOptions& options);

/// Throws SceneError if the film of a plan, all of its chunks together, exceeds the limits of a
/// classroom.
void refuse_much_plan(const PlanFolder& folder);

/// Arguments of `carom render` for the chunks of a film.
struct FilmChunkArguments {
    std::string plan;  ///< its folder
    int chunk = 0;     ///< its number; 0: all that are missing, or all if they are forced
    ChunkOptions how = {};
    bool is_classroom = false, quiet = false;
};

/// Draws and encodes chunks of a film.
void render_chunks(const FilmChunkArguments& arguments);

/// Arguments of `carom join` for films.
struct FilmJoinArguments {
    std::string output;
    bool text = false, poster = false, allow_mixed = false, quiet = false;
};

/// Joins the chunks of a film.
void join_film(const PlanFolder& folder, const FilmJoinArguments& arguments);

}  // namespace carom

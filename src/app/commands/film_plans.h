// What `carom plan` and `carom join` do with films.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/chunks/plan_folder.h"
#include "app/command.h"
#include "app/film/film_plan.h"

namespace carom {

/// What is asked of the films to be planned.
struct FilmPlanArguments {
    std::string format;
    FilmOptions film;                          ///< without the path
    int chunks = 0;                            ///< of each; 0: by their seconds
    std::optional<double> chunk_seconds = {};  ///< of expected work
    bool force = false;
};

/// --chunk-seconds, --format and the options of a film.
std::vector<Option> film_plan_options(SceneOptions& options, FilmPlanArguments& arguments);

/// Plans the films of scenes: of one in the folder `output`, of several in folders in it; empty:
/// out/SCENE.plan.
void plan_films(const std::vector<std::string>& scenes, const std::string& output,
                const FilmPlanArguments& arguments, const SceneOptions& options);

/// What is asked of a film to be joined.
struct FilmJoinArguments {
    std::string output;
    bool text = false, poster = false, allow_mixed = false, quiet = false;
};

/// Joins the chunks of a film.
void join_film(const PlanFolder& folder, const FilmJoinArguments& arguments);

}  // namespace carom

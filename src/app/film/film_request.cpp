#include "app/film/film_request.h"

namespace carom {
namespace {

Quality quality_of(const std::string& name) {
    if (name == "draft") return Quality::draft;
    return name == "final" ? Quality::final_ : Quality::standard;
}

}  // namespace

std::vector<Option> film_options(SceneOptions& options, FilmOptions& film) {
    return joined<Option>({{{"--from T", "simulated time at which the film begins", &film.from},
                            {"--to T", "simulated time at which the film ends", &film.to}},
                           film_shape_options(options, film)});
}

Option cache_option(std::string& folder) {
    return {
        "--cache FOLDER",
        "keep axes and colour scales in this folder, and take them from there: the next still or "
        "part of the same film needs the run only up to its last frame",
        &folder};
}

std::vector<Option> film_shape_options(SceneOptions& options, FilmOptions& film) {
    return {shortcut(options, "--fps N", "film.fps", "frames per second"),
            shortcut(options, "--seconds S", "film.seconds", "length of the film"),
            {"--no-sound",
             "no sound, whatever the scene says: film.sound=none",
             &options.no_sound,
             {},
             "film.sound"},
            {"--no-recipe",
             "leave the scene out of the film's file: film.recipe=false",
             &options.no_recipe,
             {},
             "film.recipe"},
            {"--quality",
             "draft, standard or final",
             [&film](const std::string& name) {
                 film.quality = quality_of(name);
                 film.is_quality_asked = true;
             },
             {"draft", "standard", "final"}}};
}

bool changes_film(const FilmOptions& film) { return film.from || film.to || film.is_quality_asked; }

}  // namespace carom

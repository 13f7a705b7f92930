#include "app/film/film_request.h"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "films/words/letters.h"
#include "scene/scene.h"
#include "util/diagnostics.h"

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
            {"--quality",
             "draft, standard or final",
             [&film](const std::string& name) {
                 film.quality = quality_of(name);
                 film.is_quality_asked = true;
             },
             {"draft", "standard", "final"}}};
}

bool changes_film(const FilmOptions& film) { return film.from || film.to || film.is_quality_asked; }

void refuse_span(const FilmOptions& film, const Scene& scene) {
    for (const auto& [flag, time] : {std::pair{"--from", film.from}, {"--to", film.to}})
        if (time && !(*time >= 0.0 && *time <= scene.run.until))
            throw UsageError(
                fmt::format("{} {}: the scene runs from 0 to {}", flag, *time, scene.run.until));
    const double from = film.from.value_or(0.0), to = film.to.value_or(scene.run.until);
    if (!(from < to))
        throw UsageError(
            fmt::format("--from {} --to {}: expected an end after the start{}", from, to,
                        from > to ? fmt::format("; write --from {} --to {}", to, from) : ""));
}

void refuse_format(const OutputFormat& format, const Scene& scene) {
    if (scene.film.transparent && !format.no_transparency.empty())
        throw UsageError(
            fmt::format("the ground is none, but {}; write a .webm or a folder of frames (--format "
                        "webm or png)",
                        format.no_transparency));
    const int most = format.most_frames_per_second;
    if (most > 0 && scene.film.fps > most)
        throw UsageError(
            fmt::format("a {} cannot show {} frames a second, {} are the most; give --fps {} or "
                        "fewer, or write a .webm or .mp4",
                        upper_case(format.name), scene.film.fps, most, most));
}

void refuse_unfit(const Scene& scene, const FilmOptions& film, const OutputFormat& format) {
    require_letters(scene);
    refuse_span(film, scene);
    refuse_format(format, scene);
}

std::string upper_case(std::string text) {
    for (char& letter : text)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return text;
}

}  // namespace carom

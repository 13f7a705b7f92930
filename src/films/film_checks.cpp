#include "films/film_checks.h"

#include <fmt/format.h>

#include <utility>

#include "films/words/letters.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {

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

void refuse_unjoinable(const std::vector<Scene>& scenes, const OutputFormat& format) {
    for (const Scene& scene : scenes)
        if (scene.film.transparent)
            throw UsageError("--join: scenes fade into their ground, and the ground is none");
    double seconds = 0.0;
    for (const Scene& scene : scenes) seconds += scene.film.seconds;
    if (scenes.front().source.is_held_to_classroom && seconds > most_classroom_seconds.value)
        throw UsageError(fmt::format("--join: the scenes together are a film of {:.6g} seconds; {}",
                                     seconds, to_text(most_classroom_seconds)));
    if (format.in_one_piece)
        throw UsageError(
            "--join: the pages of a PDF do not fade into one another; write a .mp4, a .webm or a "
            "folder of frames");
    if (format.previews > 0)
        throw UsageError(
            "--join: a GIF has its colours from one scene; write a .mp4, a .webm or a folder of "
            "frames");
}

}  // namespace carom

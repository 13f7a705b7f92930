#include "films/cost/fitted_scenes.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "films/cost/film_cost.h"
#include "films/cost/film_shape.h"
#include "media/formats.h"
#include "runs/own_files.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

// The scenes with another picture size and frame rate, overriding their own.
std::vector<Scene> in_shape(const std::vector<Scene>& scenes, const FilmShape& shape) {
    const Overrides values{fmt::format("film.size=[{}, {}]", shape.size.width, shape.size.height),
                           fmt::format("film.fps={}", shape.fps)};
    return all_made(scenes, [&](const Scene& scene) { return scene_from(scene.source, values); });
}

}  // namespace

std::optional<std::vector<Scene>> fitted_scenes(const std::vector<Scene>& scenes,
                                                const JoinedTitle& title, double most,
                                                const FilmOptions& options, Progress& progress) {
    const Film& film = scenes.front().film;
    std::map<std::pair<int, int>, std::vector<Scene>> tried;  // by width and rate
    const auto bytes_in = [&](const FilmShape& shape) {
        std::vector<Scene>& its = tried[{shape.size.width, shape.fps}];
        its = in_shape(scenes, shape);
        double bytes = bytes_of_title(its, title, options);
        for (const Scene& scene : its) bytes += measured_cost(scene, options, progress).bytes;
        return bytes;
    };
    const auto shape =
        fitting_shape({film.size, film.fps}, *format_of_film(options.output).film, most, bytes_in);
    if (!shape) return std::nullopt;
    return std::move(tried.at({shape->size.width, shape->fps}));
}

}  // namespace carom

// The main road: from a scene to a film, or to one frame of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/progress.h"
#include "draw/canvas.h"
#include "media/video_writer.h"
#include "physics/simulation.h"
#include "scene/scene.h"

namespace carom {

struct RenderOptions {
    std::filesystem::path output;  ///< as film_writer() reads it
    Quality quality = Quality::standard;
    int threads = 1;
    bool words = false;  ///< the files of film_words.h beside it
    std::optional<double> from = {},
                          to = {};  ///< as frames_between() reads them; none: the whole film
};

/// What a rendering did, and the seconds it took.
struct RenderReport {
    std::filesystem::path path;
    int frames = 0;
    std::int64_t bytes = 0;
    CollisionCounts collisions;
    double wall_seconds = 0.0;
    double simulate_seconds = 0.0;  ///< CPU, both passes and the observers
    double draw_seconds = 0.0;      ///< CPU of all workers
    double encode_seconds = 0.0;    ///< CPU of all workers, conversion included
};

/// Renders the film of `scene`, whole or not at all. Throws SceneError (the gas cannot be placed,
/// or not be brought home), SystemError, Interrupted.
RenderReport render(const Scene& scene, const RenderOptions& options, Progress& progress);

/// Draws the frame nearest to the simulated time `at` as pixels, or for `svg` and `pdf` as vectors.
/// Throws as render() does.
Canvas draw_still(const Scene& scene, double at, std::string_view format, Progress& progress);

/// Writes the same as a PNG, an SVG or a PDF, by the extension of `output`.
void render_still(const Scene& scene, double at, const std::filesystem::path& output,
                  Progress& progress);

}  // namespace carom

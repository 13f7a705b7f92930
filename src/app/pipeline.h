// The main road: from a scene to a film, or to one frame of it.
#pragma once

#include <cstdint>
#include <filesystem>

#include "app/progress.h"
#include "media/video_writer.h"
#include "physics/simulation.h"
#include "scene/scene.h"

namespace carom {

struct RenderOptions {
    std::filesystem::path output;  ///< as film_writer() reads it
    Quality quality = Quality::standard;
    int threads = 1;
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

/// Renders the film of `scene`, whole or not at all. Throws SceneError (the gas cannot be placed),
/// SystemError, Interrupted.
RenderReport render(const Scene& scene, const RenderOptions& options, Progress& progress);

/// Writes the frame nearest to the simulated time `at` as a PNG, an SVG or a PDF, by the
/// extension of `output`. Throws as render() does.
void render_still(const Scene& scene, double at, const std::filesystem::path& output);

}  // namespace carom

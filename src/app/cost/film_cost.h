// What films cost: estimated from films that were measured, or measured on a few of their frames.
#pragma once

#include <cstdint>
#include <string>

#include "app/film/film_plan.h"
#include "app/progress.h"
#include "media/formats.h"
#include "scene/scene.h"

namespace carom {

struct FilmCost {
    std::string format;
    double seconds = 0.0;  ///< of work on all cores
    double bytes = 0.0;    ///< of the film
    double memory = 0.0;   ///< bytes, at most, whatever the quality
};

/// Of the sound of so many frames, if there is one.
double bytes_of_sound(const Scene& scene, const OutputFormat& format, int frames);

/// An estimate for a film of so many frames at a quality, of so many particles in each of its runs,
/// in which so many collisions are calculated, in all passes and before time 0 too: interpolated
/// from films that were measured (docs/encoding.md), on a machine like the one they were made on.
/// Does not know how far everything moves from frame to frame: short films of fast gases take
/// several times as much.
FilmCost estimated_cost(const OutputFormat& format, const Scene& scene, const FilmOptions& options,
                        int frames, std::int64_t particles, double calculated,
                        const FilmCollisions& collisions);

/// Simulates the film's run, and draws and encodes a few frames at each of several places spread
/// over the film, as render() would: its bytes are right within a tenth or so. `options`
/// are those of the film; its `output` names the format, and is not written. Throws as render()
/// does.
FilmCost measured_cost(const Scene& scene, const FilmOptions& options, Progress& progress);

}  // namespace carom

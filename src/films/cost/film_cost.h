// What films cost in time, bytes and memory: estimated from measurements of other films, or
// measured on a few frames of the film itself.
#pragma once

#include <string>

#include "films/cost/work.h"
#include "films/film_plan.h"
#include "media/formats.h"
#include "util/progress.h"

namespace carom {

struct Scene;

struct FilmCost {
    std::string format;
    double seconds = 0.0;  ///< elapsed, with drawing and encoding on all FilmOptions::threads
    double bytes = 0.0;    ///< of the film
    double memory = 0.0;   ///< upper estimate in bytes, for any quality
};

/// Number of collisions in all runs of a film, including those with walls.
struct FilmCollisions {
    double count = 0.0;
    bool kept = false;  ///< the panels need them, so they are recorded; for sound they are seen but
                        ///< not recorded
};

/// The memory in bytes that render() takes at most for a film in a format, at any quality, with
/// `particles` particles in each of its runs: an upper estimate from measured peaks
/// (docs/scaling.md).
std::int64_t memory_of_film(const Scene& scene, const OutputFormat& format, std::int64_t particles,
                            const FilmCollisions& collisions, int threads);

/// Bytes of the sound of `frames` frames; 0 for a film without sound.
double bytes_of_sound(const Scene& scene, const OutputFormat& format, int frames);

/// Estimates the cost of a film from its work (work.h) and the collisions that it keeps in memory.
/// Interpolated from films that were measured (docs/encoding.md), and valid for a machine like the
/// one of these measurements. Ignores how far particles move from frame to frame: short films of
/// fast gases take several times as much.
FilmCost estimated_cost(const OutputFormat& format, const Scene& scene, const FilmOptions& options,
                        const SceneCounts& counts, const FilmCollisions& collisions);

/// Simulates the film's run, then draws and encodes a few successive frames at each of several
/// places spread over the film, as render() would. The bytes are accurate to about 10 %. `options`
/// are those of the film; the ending of `options.output` gives the format, and no file is written.
/// Throws what render() throws.
FilmCost measured_cost(const Scene& scene, const FilmOptions& options, Progress& progress);

}  // namespace carom

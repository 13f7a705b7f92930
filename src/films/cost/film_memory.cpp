#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "films/cost/film_cost.h"
#include "films/segment_workers.h"
#include "panels/chosen.h"
#include "panels/recording.h"
#include "panels/registry.h"
#include "physics/sample_times.h"
#include "scene/limits.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "sound/rate.h"

namespace carom {
namespace {

// Bytes for stored parts of the paths of particles: for trails, and for panels that average over
// all starting times.
double memory_of_ways(const Scene& scene, double particles) {
    constexpr double of_trail = 1000.0, of_place = 250.0, of_lags = 7000.0;  // measured peaks
    const Film& film = scene.film;
    double bytes = 0.0;
    const auto add_trails = [&](double count, double seconds) {
        if (seconds > 0.0) bytes += count * (of_trail + of_place * seconds * film.fps);
    };
    for (std::size_t k = 0; k < scene.looks.size(); ++k)
        add_trails(static_cast<double>(scene.gas.species[k].count),
                   scene.looks[k].trail.value_or(0.0));
    for (const Chosen& chosen : film.trails.of)
        add_trails(chosen.particle  ? 1.0
                   : chosen.species ? static_cast<double>(scene.gas.species[*chosen.species].count)
                                    : particles,
                   film.trails.seconds);
    for (const PanelSpec& panel : film.panels) {
        const PanelWork work = work_of(panel, scene.run);
        if (work.flights == PanelWork::Flights::lags)
            bytes += of_lags * particles;
        else if (work.keeps_places)  // of both runs
            bytes += sizeof(Vec) * std::min(particles, 2.0 * most_in_both_runs.value) *
                     (frame_count(film) + static_cast<double>(sample_count(scene.run)));
    }
    return bytes;
}

}  // namespace

std::int64_t memory_of_film(const Scene& scene, const OutputFormat& format, std::int64_t particles,
                            const FilmCollisions& collisions, int threads) {
    constexpr double of_program = 120e6, of_particle = 1500.0;
    constexpr double of_kept_particle = 40.0, of_frame = 8192.0;  // bytes, recorded or waiting
    constexpr double of_filed_frame = 512.0;  // bytes; samples are in a temporary file
    constexpr double most_of_pixel = 0.5;  // encoded bytes per pixel; PNGs of dense gases have 0.2
    constexpr double most_kept = static_cast<double>(Recording::most_bytes) + most_waiting_bytes;
    const double pixels = static_cast<double>(scene.film.size.width) * scene.film.size.height;
    const int frames = frame_count(scene.film);
    const double disks =
        static_cast<double>(particles) * static_cast<double>(scene.film.runs.count());
    const std::vector<int> segments = segment_starts(frames, particles);
    const auto workers = static_cast<double>(std::clamp<std::size_t>(
        static_cast<std::size_t>(std::max(1, threads)), 1, segments.size() - 1));
    // Two encoded segments per worker: one that is growing, and one that is finished and waits to
    // be joined.
    const double encoded =
        std::min(frames * most_of_pixel * pixels, 2.0 * workers * most_encoded_bytes);
    const double of_collisions = sizeof(Collision) * collisions.count;
    const double kept = std::min(
        most_kept + frames * of_filed_frame,
        frames * (of_frame + of_kept_particle * disks) + (collisions.kept ? of_collisions : 0.0));
    // Collisions of one frame: a growing list, its copy on the way to the panels, and the list that
    // is kept.
    const bool are_seen = collisions.kept || has_sound(scene, format);
    const double of_one_frame = are_seen ? 4.0 * of_collisions / frames : 0.0;
    const double sound =
        has_sound(scene, format)
            ? frames / scene.film.fps * (sizeof(std::int16_t) * sound_rate + format.sound->bytes)
            : 0.0;
    const double previews = 4.0 * pixels * std::min(format.previews, frames);
    return static_cast<std::int64_t>(
        of_program + of_particle * disks + memory_of_ways(scene, disks) + kept + of_one_frame +
        2.0 * encoded + sound + previews + workers * format.film->memory_per_pixel * pixels);
}

}  // namespace carom

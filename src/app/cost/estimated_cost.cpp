#include "app/cost/film_cost.h"

namespace carom {
namespace {

// On one core, `carom run --timings` of the scenes in scenes/ gives 1.0 to 1.3 million. Large gases
// are slower, limited by access to memory.
constexpr double events_per_second = 1e6;

}  // namespace

double bytes_of_sound(const Scene& scene, const OutputFormat& format, int frames) {
    return has_sound(scene, format) ? format.sound->bytes * frames / scene.film.fps : 0.0;
}

FilmCost estimated_cost(const OutputFormat& output, const Scene& scene, const FilmOptions& options,
                        int frames, std::int64_t particles, double calculated,
                        const FilmCollisions& collisions) {
    const FormatCost& format = *output.film;
    const Film& film = scene.film;
    const double disks = static_cast<double>(particles) * (film.beside ? 2.0 : 1.0);
    const double pixels = static_cast<double>(film.size.width) * film.size.height;
    return {
        output.name,
        calculated / events_per_second + format.seconds_before(pixels) +
            frames * format.frame_seconds(disks, pixels, options.quality) / options.threads,
        frames * format.frame_bytes(disks, pixels, options.quality) +
            bytes_of_sound(scene, output, frames),
        static_cast<double>(memory_of_film(scene, output, particles, collisions, options.threads))};
}

}  // namespace carom

#include "films/cost/film_cost.h"
#include "physics/placement/draws.h"

namespace carom {

double bytes_of_sound(const Scene& scene, const OutputFormat& format, int frames) {
    return has_sound(scene, format) ? format.sound->bytes * frames / scene.film.fps : 0.0;
}

// Pictures are drawn and encoded on all threads, and what comes before on one.
FilmCost estimated_cost(const OutputFormat& output, const Scene& scene, const FilmOptions& options,
                        const SceneCounts& counts, const FilmCollisions& collisions) {
    const Work work = work_of_film(scene, options, output, counts);
    double seconds = 0.0;
    for (const WorkPart& part : work.parts)
        seconds += part.seconds / (part.is_drawing ? options.threads : 1);
    return {output.name, seconds, work.bytes,
            static_cast<double>(memory_of_film(scene, output, total_count(scene.gas), collisions,
                                               options.threads))};
}

}  // namespace carom

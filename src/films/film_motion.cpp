#include "films/film_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/scene.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

// Approximate pixels per unit of length: in the templates the box fills most of the picture.
double scale_of(const Scene& scene) {
    constexpr double of_width = 0.6, of_height = 0.8;
    const Film& film = scene.film;
    const Box& box = scene.gas.box;
    const double across =
        of_width * film.size.width / static_cast<double>(film.runs.count()) / box.size[0];
    return box.dimension == 1 ? across
                              : std::min(across, of_height * film.size.height / box.size[1]);
}

// The mean displacement of all particles from one frame to the next, with their speeds at the
// start.
double pixels_moved(const Scene& scene, const Sample& start) {
    const double mean_speed = start.velocity.square().rowwise().sum().sqrt().mean();
    return mean_speed * scale_of(scene) * scene.run.until / frame_count(scene.film);
}

// The sum of the circumferences of all disks, divided by the side of a square with the area of the
// box in the picture.
double edges_of(const Box& box, const Particles& particles) {
    if (box.dimension == 1) return 0.0;
    return 2.0 * std::numbers::pi * particles.radius.sum() / std::sqrt(box.size[0] * box.size[1]);
}

}  // namespace

Motion motion_of(const Scene& scene, const Particles& particles, const Sample& start) {
    constexpr double fast = 2.5;        // pixels
    constexpr double few_edges = 25.0;  // 500 disks that cover a tenth of the box
    if (particles.count() == 0) return Motion::usual;
    if (edges_of(scene.gas.box, particles) > few_edges) return Motion::usual;
    if (pixels_moved(scene, start) > fast) return Motion::fast;
    // Beads on a line that touch each other also have edges close together.
    const bool is_sparse = scene.gas.box.dimension > 1 && !scene.film.field;
    return is_sparse ? Motion::sparse : Motion::usual;
}

}  // namespace carom

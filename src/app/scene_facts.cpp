#include "app/scene_facts.h"

#include <algorithm>
#include <cmath>

#include "physics/collision_rate.h"
#include "physics/draws.h"
#include "physics/placement.h"
#include "scene/timeline.h"
#include "util/diagnostics.h"

namespace carom {
namespace {

// Power laws through the films of 200 and of 1,000 disks at 1080p, quality standard, in
// docs/encoding.md ("Wall time": 900 frames in 6.86 and 9.04 s on two cores, 7.9 and 15.2 MB). They
// hold to a third up to 20,000 disks.
struct PowerLaw {
    double at_200, at_1000;
    double at(double disks) const {
        const double few = 20.0;  // type and histograms are there with any number
        const double power = std::log(at_1000 / at_200) / std::log(5.0);
        return at_200 * std::pow(std::max(few, disks) / 200.0, power);
    }
};
constexpr double frames_measured = 900.0;
constexpr double pixels_measured = 1920.0 * 1080.0;
constexpr PowerLaw core_seconds{2 * 6.86 / frames_measured, 2 * 9.04 / frames_measured};
constexpr PowerLaw frame_bytes{7.9e6 / frames_measured, 15.2e6 / frames_measured};

// One core, `carom run --timings` of the scenes in scenes/: 1.0 to 1.3 million. Slower in large
// gases, which memory holds up.
constexpr double events_per_second = 1e6;
constexpr double passes = 2.0;  // first for the axes, then for the frames

FilmCost cost_of(const Film& film, const SceneFacts& facts, double events, int cores) {
    const double pixels = static_cast<double>(film.size.width) * film.size.height;
    const double frames = facts.frames * pixels / pixels_measured;
    const auto disks = static_cast<double>(facts.particles);
    return {passes * events / events_per_second + frames * core_seconds.at(disks) / cores,
            frames * frame_bytes.at(disks), cores};
}

std::pair<Particles, Sample> drawn(const Scene& scene) {
    try {
        return draw_gas(scene.gas);
    } catch (const PlacementError& error) {
        Diagnostic diagnostic = scene.species_spans[error.species()];
        diagnostic.message = error.what();
        throw SceneError({diagnostic});
    }
}

}  // namespace

SceneFacts facts_of(const Scene& scene, bool has_film, int cores) {
    const Box& box = scene.gas.box;
    const auto [particles, sample] = drawn(scene);
    const auto rate = expected_collision_rate(box, particles, sample);
    SceneFacts facts;
    facts.particles = particles.count();
    facts.packing_fraction = packing_fraction(box, particles);
    if (rate) facts.collisions = *rate * scene.run.until;
    if (!has_film) return facts;
    facts.frames = frame_count(scene.film);
    const double events = rate.value_or(0.0) * (scene.run.until + scene.run.equilibrate);
    facts.cost = cost_of(scene.film, facts, events, cores);
    return facts;
}

}  // namespace carom

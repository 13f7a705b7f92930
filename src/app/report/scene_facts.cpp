#include "app/report/scene_facts.h"

#include <algorithm>
#include <cmath>

#include "app/film/film_plan.h"
#include "media/formats.h"
#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

constexpr double pixels_measured = 1920.0 * 1080.0;

// One core, `carom run --timings` of the scenes in scenes/: 1.0 to 1.3 million. Slower in large
// gases, which memory holds up.
constexpr double events_per_second = 1e6;

FilmCost cost_of(const OutputFormat& output, const Film& film, const SceneFacts& facts,
                 double events, int cores) {
    const FormatCost& format = *output.film;
    const double pixels = static_cast<double>(film.size.width) * film.size.height / pixels_measured;
    const double frames = facts.frames * pixels;
    const auto disks = static_cast<double>(facts.particles);
    const auto passes = static_cast<double>(facts.passes.size());
    return {output.name,
            passes * events / events_per_second + format.beforehand * pixels +
                frames * format.core_seconds.at(disks) / cores,
            facts.frames * std::pow(pixels, format.power_of_pixels) * format.bytes.at(disks),
            cores};
}

}  // namespace

SceneFacts facts_of(const Scene& scene, bool has_film, int cores) {
    const Box& box = scene.gas.box;
    const auto [particles, sample] = draw_gas(scene.gas);
    const auto rate = expected_collision_rate(box, particles, sample);
    SceneFacts facts;
    facts.particles = particles.count();
    facts.packing_fraction = packing_fraction(box, particles);
    if (rate) facts.collisions = *rate * scene.run.until;
    if (!has_film) return facts;
    facts.frames = frame_count(scene.film);
    const double events = rate.value_or(0.0) * (scene.run.until + scene.run.equilibrate);
    facts.passes = expected_passes(scene, facts.particles);
    for (const OutputFormat& format : output_formats())
        if (format.film) facts.costs.push_back(cost_of(format, scene.film, facts, events, cores));
    return facts;
}

}  // namespace carom

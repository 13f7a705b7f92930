#include "app/report/scene_facts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/placement/draws.h"
#include "physics/theory/collision_rate.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

// Power laws through films of 200 and of 1,000 disks at 1080p, quality standard. MP4's are those in
// docs/encoding.md ("Wall time": 900 frames in 6.86 and 9.04 s on two cores, 7.9 and 15.2 MB), the
// others by their ratio to it ("Rough costs" there). They hold to a third up to 20,000 disks.
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
struct FormatCost {
    const char* format;
    PowerLaw core_seconds, bytes;  ///< of a frame
    double power_of_pixels;        ///< by which the bytes of a frame grow: outlines, not areas
    double beforehand = 0.0;       ///< seconds on one core, whatever the length
};
constexpr double mp4_at_200 = 2 * 6.86 / frames_measured, mp4_at_1000 = 2 * 9.04 / frames_measured;
constexpr std::array<FormatCost, 4> format_costs{{
    {"mp4", {mp4_at_200, mp4_at_1000}, {7.9e6 / frames_measured, 15.2e6 / frames_measured}, 0.5},
    {"webm", {2.1 * mp4_at_200, 2.2 * mp4_at_1000}, {10.0e3, 21.0e3}, 0.5},
    {"gif", {1.3 * mp4_at_200, 1.2 * mp4_at_1000}, {27.3e3, 52.7e3}, 0.7, 0.7},
    {"png", {5.1 * mp4_at_200, 6.2 * mp4_at_1000}, {269e3, 401e3}, 0.8},
}};

// One core, `carom run --timings` of the scenes in scenes/: 1.0 to 1.3 million. Slower in large
// gases, which memory holds up.
constexpr double events_per_second = 1e6;
constexpr double passes = 2.0;  // first for the axes, then for the frames

FilmCost cost_of(const FormatCost& format, const Film& film, const SceneFacts& facts, double events,
                 int cores) {
    const double pixels = static_cast<double>(film.size.width) * film.size.height / pixels_measured;
    const double frames = facts.frames * pixels;
    const auto disks = static_cast<double>(facts.particles);
    return {format.format,
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
    for (const FormatCost& format : format_costs)
        facts.costs.push_back(cost_of(format, scene.film, facts, events, cores));
    return facts;
}

}  // namespace carom

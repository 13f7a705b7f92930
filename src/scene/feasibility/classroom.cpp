#include "scene/feasibility/classroom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/placement/draws.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"

namespace carom {
namespace {

// Returns the value of a key in a section; without it, the section; without that, the whole scene.
const Node& place_in(const Node& root, const char* section, const char* key) {
    const Node* its = find(root, section);
    if (its == nullptr) return root;
    const Node* value = its->is_mapping() ? find(*its, key) : nullptr;
    return value != nullptr ? *value : *its;
}

void check_run(const Run& run, std::int64_t particles, const Node& root, Errors& errors) {
    const auto check = [&](const char* key, const char* what, double every, const Limit& limit) {
        const double count = std::floor(run.until / every) * static_cast<double>(particles);
        if (count > limit.value)
            errors.add(place_in(root, "run", key),
                       fmt::format("{} every {:.6g} of a run of {:.6g} units of time, of {} "
                                   "particles: {:.3g}",
                                   what, every, run.until, particles, count),
                       to_text(limit));
    };
    if (run.sample_every > 0.0)
        check("sample_every", "samples", run.sample_every, most_classroom_samples);
    if (run.time_step) check("time_step", "steps", *run.time_step, most_classroom_steps);
}

void check_film(const Film& film, const Node& root, Errors& errors) {
    const auto refuse = [&](const char* key, const std::string& message, const Limit& limit) {
        errors.add(place_in(root, "film", key), message, to_text(limit));
    };
    if (film.seconds > most_classroom_seconds.value)
        refuse("seconds", fmt::format("a film of {:.6g} seconds", film.seconds),
               most_classroom_seconds);
    else if (film.seconds * film.fps > most_classroom_frames.value)
        refuse(
            "fps",
            fmt::format("a film of {:.6g} seconds at {} frames a second", film.seconds, film.fps),
            most_classroom_frames);
    if (std::max(film.size.width, film.size.height) > most_classroom_side.value)
        refuse("size", fmt::format("a picture of {} by {}", film.size.width, film.size.height),
               most_classroom_side);
}

const Limit& most_collisions_of(const Run& run) {
    return run.bits == bits_of_double ? most_classroom_collisions
                                      : most_classroom_precise_collisions;
}

}  // namespace

void hold_to_classroom(Scene& scene, const Node& root, bool has_film, Errors& errors) {
    const std::int64_t particles = total_count(scene.gas);
    if (static_cast<double>(particles) > most_classroom_particles.value)
        errors.add(place_in(root, "gas", ""), fmt::format("{} particles in all", particles),
                   to_text(most_classroom_particles));
    check_run(scene.run, particles, root, errors);
    if (has_film) check_film(scene.film, root, errors);
    scene.run.most_collisions =
        std::min(collision_ceiling(scene.run, particles),
                 static_cast<std::int64_t>(most_collisions_of(scene.run).value));
}

std::string classroom_hint(const Scene& scene) {
    const Limit& limit = most_collisions_of(scene.run);
    if (!scene.source.is_held_to_classroom ||
        scene.run.most_collisions != static_cast<std::int64_t>(limit.value))
        return "";
    return to_text(limit);
}

}  // namespace carom

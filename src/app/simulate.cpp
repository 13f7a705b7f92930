#include "app/simulate.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace carom {

TrialCallback shown_trials(const Scene& scene, Progress& progress) {
    return [&progress, run = scene.run, trying = 0](int bits, double time) mutable {
        if (bits != std::exchange(trying, bits))
            progress.begin(
                bits == bits_of_double ? "trying doubles" : fmt::format("trying {} bits", bits),
                run.equilibrate + run.until, "time units");
        progress.reach(run.equilibrate + time);
    };
}

Scene with_precision(const Scene& asked, Progress& progress) {
    return with_precision(asked, shown_trials(asked, progress));
}

StartedScene start_scene(const Scene& asked, Progress& progress) {
    if (!asked.run.bits) return start_scene(asked, shown_trials(asked, progress));
    const double all = asked.run.equilibrate;
    if (all > 0.0) progress.begin("equilibrating", all, "time units");
    return start_scene(asked, [&](int, double time) { progress.reach(all + time); });
}

Simulation simulate(const Scene& scene, const TimeCallback& on_progress) {
    std::optional<Simulation> simulation;
    with_places_of_errors(scene, [&] { simulation.emplace(scene.gas, scene.run, on_progress); });
    return std::move(*simulation);
}

Simulation simulate(const Scene& scene, Progress& progress) {
    const double all = scene.run.equilibrate;
    if (all > 0.0) progress.begin("equilibrating", all, "time units");
    return simulate(scene, [&](double time) { progress.reach(all + time); });
}

}  // namespace carom

#include "app/simulate.h"

#include <fmt/format.h>

#include <utility>

#include "panels/precision.h"
#include "physics/placement/placement.h"
#include "util/diagnostics.h"

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

Simulation simulate(const Scene& scene, const TimeCallback& on_progress) {
    try {
        return Simulation(scene.gas, scene.run, on_progress);
    } catch (const PlacementError& error) {
        Diagnostic diagnostic = scene.species_spans[error.species()];
        diagnostic.message = error.what();
        throw SceneError({diagnostic});
    }
}

Simulation simulate(const Scene& scene, Progress& progress) {
    const double all = scene.run.equilibrate;
    if (all > 0.0) progress.begin("equilibrating", all, "time units");
    return simulate(scene, [&](double time) { progress.reach(all + time); });
}

}  // namespace carom

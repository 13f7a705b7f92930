#include "app/simulate.h"

#include <fmt/format.h>

#include <utility>

#include "panels/precision.h"
#include "physics/placement.h"
#include "util/diagnostics.h"

namespace carom {

TrialTold shown_trials(const Scene& scene, Progress& progress) {
    return [&progress, until = scene.run.until, trying = 0](int bits, double time) mutable {
        if (bits != std::exchange(trying, bits))
            progress.begin(bits == bits_of_double ? "counting collisions"
                                                  : fmt::format("trying {} bits", bits),
                           until, "time units");
        progress.reach(time);
    };
}

Scene with_precision(const Scene& asked, Progress& progress) {
    return with_precision(asked, shown_trials(asked, progress));
}

Simulation simulate(const Scene& scene) {
    try {
        return Simulation(scene.gas, scene.run);
    } catch (const PlacementError& error) {
        Diagnostic diagnostic = scene.species_spans[error.species()];
        diagnostic.message = error.what();
        throw SceneError({diagnostic});
    }
}

}  // namespace carom

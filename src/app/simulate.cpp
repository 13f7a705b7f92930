#include "app/simulate.h"

#include <fmt/format.h>

#include <utility>

#include "panels/precision.h"
#include "physics/placement.h"
#include "util/diagnostics.h"

namespace carom {

Scene with_precision(const Scene& asked, Progress& progress) {
    int trying = 0;
    return with_precision(asked, [&](int bits, double time) {
        if (bits != std::exchange(trying, bits))
            progress.begin(bits == bits_of_double ? "counting collisions"
                                                  : fmt::format("trying {} bits", bits),
                           asked.run.until, "time units");
        progress.reach(time);
    });
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

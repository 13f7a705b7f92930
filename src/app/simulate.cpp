#include "app/simulate.h"

#include "physics/placement.h"
#include "util/diagnostics.h"

namespace carom {

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

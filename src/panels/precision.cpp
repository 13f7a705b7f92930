#include "panels/precision.h"

#include <variant>

#include "physics/placement/placement.h"
#include "physics/simulation.h"
#include "util/interrupt.h"

namespace carom {
namespace {

[[noreturn]] void refuse(Diagnostic place, const std::string& message, const std::string& hint) {
    place.message = message;
    place.hint = hint;
    throw SceneError({place});
}

// In stretches, so that it can be told how far it has come.
void try_perturbations(const Scene& scene, const TrialCallback& on_progress) {
    double last = -1.0;
    for (const RunEvent& event : scene.run.events)
        if (std::holds_alternative<Perturbation>(event.action)) last = event.at;
    if (last < 0.0) return;
    try {
        const auto tell = [&](double time) {
            throw_if_interrupted();
            if (on_progress) on_progress(scene.run.bits.value(), time);
        };
        Simulation simulation(scene.gas, scene.run, tell);
        constexpr int stretches = 64;
        for (int k = 1; k <= stretches; ++k) {
            const double time = last * k / stretches;
            simulation.advance_to(k == stretches ? last : time);
            tell(time);
        }
    } catch (const PerturbationError& error) {
        refuse(scene.event_places.at(error.event()), error.what(), "a smaller one may have room");
    }
}

}  // namespace

Scene with_precision(const Scene& scene, const TrialCallback& on_progress) {
    Scene precise = scene;
    try {
        if (!scene.run.bits) precise.run.bits = bits_for_return(scene.gas, scene.run, on_progress);
        try_perturbations(precise, on_progress);
    } catch (const PrecisionError& error) {
        refuse(scene.precision_place, error.what(), error.hint());
    } catch (const PlacementError& error) {
        refuse(scene.species_spans.at(error.species()), error.what(), "");
    }
    return precise;
}

}  // namespace carom

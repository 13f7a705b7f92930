#include "panels/precision.h"

#include <variant>

#include "physics/placement.h"
#include "physics/simulation.h"

namespace carom {
namespace {

[[noreturn]] void refuse(Diagnostic place, const std::string& message, const std::string& hint) {
    place.message = message;
    place.hint = hint;
    throw SceneError({place});
}

void try_nudges(const Scene& scene) {
    double last = -1.0;
    for (const RunEvent& event : scene.run.events)
        if (std::holds_alternative<Nudge>(event.action)) last = event.at;
    if (last < 0.0) return;
    try {
        Simulation(scene.gas, scene.run).advance_to(last);
    } catch (const NudgeError& error) {
        refuse(scene.event_places.at(error.event()), error.what(), "a smaller one may have room");
    }
}

}  // namespace

Scene with_precision(const Scene& scene, const TrialTold& told) {
    Scene precise = scene;
    try {
        if (!scene.run.bits) precise.run.bits = bits_to_come_home(scene.gas, scene.run, told);
        try_nudges(precise);
    } catch (const PrecisionError& error) {
        refuse(scene.precision_place, error.what(), error.hint());
    } catch (const PlacementError& error) {
        refuse(scene.species_spans.at(error.species()), error.what(), "");
    }
    return precise;
}

}  // namespace carom

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
void try_nudges(const Scene& scene, const TrialTold& told) {
    double last = -1.0;
    for (const RunEvent& event : scene.run.events)
        if (std::holds_alternative<Nudge>(event.action)) last = event.at;
    if (last < 0.0) return;
    try {
        const auto tell = [&](double time) {
            throw_if_interrupted();
            if (told) told(scene.run.bits.value(), time);
        };
        Simulation simulation(scene.gas, scene.run, tell);
        constexpr int stretches = 64;
        for (int k = 1; k <= stretches; ++k) {
            const double time = last * k / stretches;
            simulation.advance_to(k == stretches ? last : time);
            tell(time);
        }
    } catch (const NudgeError& error) {
        refuse(scene.event_places.at(error.event()), error.what(), "a smaller one may have room");
    }
}

}  // namespace

Scene with_precision(const Scene& scene, const TrialTold& told) {
    Scene precise = scene;
    try {
        if (!scene.run.bits) precise.run.bits = bits_to_come_home(scene.gas, scene.run, told);
        try_nudges(precise, told);
    } catch (const PrecisionError& error) {
        refuse(scene.precision_place, error.what(), error.hint());
    } catch (const PlacementError& error) {
        refuse(scene.species_spans.at(error.species()), error.what(), "");
    }
    return precise;
}

}  // namespace carom

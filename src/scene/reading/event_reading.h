// The items of `run.events`, and what they mean together with the gas and its box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/reading/run_reading.h"
#include "scene/reading/surface_reading.h"
#include "scene/scene.h"

namespace carom {

/// An item of `events`.
struct EventDraft : ActingDraft {
    double at = 0.0;
    bool reverses = false;
    std::optional<Perturbation> nudge;
    const Node *open = nullptr, *close = nullptr, *move = nullptr, *hold = nullptr,
               *release = nullptr, *wall = nullptr;  ///< names of surfaces
    bool solid = false;                              ///< what a wall becomes
    std::optional<Heat> heat;
    bool is_mirrored = true;
    std::optional<std::string> mark, caption;
    std::optional<double> seconds, pause;
};

Notation<EventDraft> event_notation(int dimension);

/// Adds one event at its time to the run: what happens to the gas, or what the film shows. Surfaces
/// and species that it names are found later (resolve_names()).
void add_event(const EventDraft& event, const Node& node, RunDraft& run, Errors& errors);

/// Fills in the numbers of the surfaces and species that events name; reports those that are not
/// there. Without a gas that is complete, events that no name is found for are left out.
void resolve_names(RunDraft& run, const PlacedSurfaces& surfaces,
                   const std::vector<std::string>& species, int dimension, Errors& errors);

/// Whether nudges have their particles, and numbers of so few bits room for them.
void check_nudges(const RunDraft& run, const Gas& gas, Errors& errors);

}  // namespace carom

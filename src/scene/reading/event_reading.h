// The items of `run.events`, and their checks against the gas and its box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/reading/run_reading.h"
#include "scene/reading/surface_reading.h"

namespace carom {

/// An item of `events`.
struct EventDraft : ActingDraft {
    double at = 0.0;
    bool reverses = false;
    std::optional<Perturbation> nudge;
    const Node *open = nullptr, *close = nullptr, *move = nullptr, *hold = nullptr,
               *release = nullptr, *wall = nullptr;  ///< nodes with names of surfaces
    bool solid = false;                              ///< whether a wall becomes solid
    std::optional<Heat> heat;
    bool is_mirrored = true;
    std::optional<std::string> mark, caption;
    std::optional<double> seconds, pause;
};

Notation<EventDraft> event_notation(int dimension);

/// Adds one event to the run, at its time: an action on the gas, or something that the film shows.
/// The surfaces and species that it names are resolved later, by resolve_names().
void add_event(const EventDraft& event, const Node& node, RunDraft& run, Errors& errors);

/// Replaces the names of surfaces and species in events by their numbers. Events with unknown names
/// are removed and reported, unless the surface of that name was left out because of a mistake.
void resolve_names(RunDraft& run, const PlacedSurfaces& surfaces,
                   const std::vector<std::string>& species, int dimension, Errors& errors);

/// Reports nudges of particles that do not exist, and nudges that move nothing, lead out of the
/// box, or are too small for the run's number of bits.
void check_nudges(const RunDraft& run, const Gas& gas, Errors& errors);

}  // namespace carom

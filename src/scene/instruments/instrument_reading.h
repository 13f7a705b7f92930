// The surfaces and the parts of the box that panels measure at, and which of them each kind of
// panel can take.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/keys/notation.h"
#include "scene/scene.h"

namespace carom {

/// The name of a wall or a partition of the box, or a list of these.
Notation<std::vector<std::int32_t>> surfaces_notation();

/// A list of {name, within}.
Notation<std::vector<NamedRegion>> regions_notation();

/// {x: place} or {y: place}, with `between: [from, to]`.
Notation<CountingLine> counting_line_notation();

/// A time, or what starts a stopwatch: `start`, `reversal`, `heat`, or the name of a wall or a
/// partition, whose first event it is.
Notation<WatchStart> watch_start_notation();

/// What the kinds of panel need of the box: what moves
/// at some time of the run for a piston; a wall that moves for a pressure against a volume; a
/// partition, or regions, for the sides. They name the only one there is where the scene names
/// none, and report what is wrong. The node is the panel's mapping, or its name alone.
void check_pressure_volume(PanelSpec& panel, const Node& node, Reading& reading);
void check_piston(PanelSpec& panel, const Node& node, Reading& reading);
void check_piston_histogram(PanelSpec& panel, const Node& node, Reading& reading);
void check_sides(PanelSpec& panel, const Node& node, Reading& reading);

/// A gauge needs a solid wall; a thermometer takes particles or regions, not both.
void check_pressure(PanelSpec& panel, const Node& node, Reading& reading);
void check_thermometer(PanelSpec& panel, const Node& node, Reading& reading);

/// A flux needs a partition that lets particles through, or a line; a counter takes these, or
/// counts hits: without a choice of the scene on all walls, or crossings where there is something
/// to cross.
void check_flux(PanelSpec& panel, const Node& node, Reading& reading);
void check_counter(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom

// The surfaces and regions of the box at which panels measure, and the checks that each kind of
// panel can use them.
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

/// A time, or the event that starts a stopwatch: `start`, `reversal`, `heat`, or the name of a wall
/// or a partition, which stands for the first event that acts on it.
Notation<WatchStart> watch_start_notation();

/// Checks of what the kinds of panel need of the box: a piston, a surface that moves at some time
/// of the run; a pressure against a volume, a wall that moves; the sides, a partition or regions.
/// If the scene names no surface, those that fit are filled in; kinds that show one surface require
/// that only one fits. Errors are reported. The node is the panel's mapping, or the name of its
/// kind alone.
void check_pressure_volume(PanelSpec& panel, const Node& node, Reading& reading);
void check_piston(PanelSpec& panel, const Node& node, Reading& reading);
void check_piston_histogram(PanelSpec& panel, const Node& node, Reading& reading);
void check_sides(PanelSpec& panel, const Node& node, Reading& reading);

/// A histogram takes particles, regions, or the sides of a partition that stays in its place.
void check_parts(PanelSpec& panel, const Node& node, Reading& reading);

/// A gauge needs a solid wall; a thermometer takes particles or regions, not both.
void check_pressure(PanelSpec& panel, const Node& node, Reading& reading);
void check_thermometer(PanelSpec& panel, const Node& node, Reading& reading);

/// A flux needs a partition that lets particles through, or a line. A counter takes these, too, or
/// counts hits. Unless the scene says what to count, a counter counts crossings if there is
/// something to cross, and otherwise hits on all walls.
void check_flux(PanelSpec& panel, const Node& node, Reading& reading);
void check_counter(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom

// The surfaces and regions of the box at which panels measure: how scenes write them, and whether
// the box has those that a panel needs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/instruments/places.h"
#include "scene/keys/notation.h"
#include "scene/panel_spec.h"

namespace carom {

/// The name of a wall or a partition of the box, or a list of these.
Notation<SurfaceNumbers> surfaces_notation();

/// A list of {name, within}.
Notation<std::vector<NamedRegion>> regions_notation();

/// {x: place}, {y: place} or {z: place}, with `between: [from, to]`, in space [a0, b0, a1, b1].
Notation<CountingLine> counting_line_notation();

/// A time, or the event that starts a stopwatch: `start`, `reversal`, `heat`, or the name of a wall
/// or a partition, which stands for the first event that acts on it.
Notation<WatchStart> watch_start_notation();

/// Whether a surface moves at some time of the run.
bool may_move(const Reading& reading, std::int32_t surface);

/// Whether particles can pass through a surface at some time of the run, while the surface stays in
/// one place.
bool lets_through(const Reading& reading, std::int32_t surface);

/// Whether the box has a side that is not periodic.
bool has_solid_side(const Box& box);

/// Whether a panel's mapping gives a key; the node may also be the name of its kind alone, here and
/// below.
bool is_written(const Node& node, const char* key);

/// Where the scene names the surfaces of a panel, or else the panel.
const Node& place_of_surfaces(const Node& node);

/// The surfaces at which a panel can measure, and what messages say of them: "a partition that does
/// not move".
struct SuitableSurface {
    std::function<bool(std::int32_t)> suits;
    std::string what, hint;
};

/// Reports surfaces that the scene names and that do not suit the panel. If it names none, takes
/// all that do, of which there must be one.
void keep_suitable(const PanelSpec& panel, SurfaceNumbers& surfaces, const SuitableSurface& what,
                   const Node& node, Reading& reading);

/// Reports more than one surface, of a panel that shows one.
void require_one(const PanelSpec& panel, const SurfaceNumbers& surfaces, const Node& node,
                 Reading& reading);

}  // namespace carom

// The keys of what a film or a figure shows of the box: a part of it, the moves of the camera, and
// from where a box in space is seen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scene/film.h"
#include "scene/keys/binding.h"

namespace carom {

struct Gas;

/// A part of the box, as the value of a key: its corners (corners_of(), keys/notation.h). `instead`
/// names, for messages, what else the key may take.
Notation<Region> region_notation(const std::string& key, const std::string& instead = "");

/// The view of the box: all of it or a part.
Notation<View> view_notation();

/// From where a box in space is seen, as far as it is given; refused in other boxes.
Notation<ViewpointChange> viewpoint_notation();

/// The keys of a film for the moves of its camera, and for the viewpoint.
Binding<Film> camera_key();
Binding<Film> viewpoint_key();

/// Reports something that begins at or after the end of the run: it would never be visible.
void check_begin(const Node& place, const char* key, double time, Reading& reading);

/// Returns the particle chosen by its number, or the only particle of a species.
std::optional<std::int64_t> only_one(const Chosen& chosen, const Gas& gas);

}  // namespace carom

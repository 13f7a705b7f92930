// From the checked `box` and `gas` of a scene to a Gas, and what these values mean together:
// lengths of lists, names, places, room.
#pragma once

#include <vector>

#include "scene/fields.h"
#include "scene/scene.h"

namespace carom {

/// The box; nothing when an error leaves its size open.
std::optional<Box> read_box(const Fields& scene, Errors& errors);

/// A species and what is known of it although something in it may be wrong.
struct SpeciesDraft {
    const Node* node = nullptr;  ///< the item of `gas`
    Species species;
    SpeciesLook look;
    bool radius_known = true;    ///< false: an error left the radius open
    bool position_known = true;  ///< false: an error left the positions open
};

/// The species in the order of the list.
std::vector<SpeciesDraft> read_species(const Fields& scene, Errors& errors);

/// Reports what cannot be placed: disks too large for the box, too many for its area, places
/// outside, places that overlap.
void check_room(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors);

}  // namespace carom

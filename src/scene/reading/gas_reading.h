// The keys of `box` and `gas`, and what their values mean together: lengths of lists, names,
// places, room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

/// The box of one or two dimensions; nothing when an error leaves its size open.
Notation<Box> box_notation(int dimension);

/// A species and what is known of it although something in it may be wrong.
struct SpeciesDraft {
    const Node* node = nullptr;  ///< the item of `gas`
    Species species;
    SpeciesLook look;
    bool radius_known = true;    ///< false: an error left the radius open
    bool position_known = true;  ///< false: an error left the positions open
};

/// The species in the order of the list, for a box of one or two dimensions.
Notation<std::vector<SpeciesDraft>> gas_notation(int dimension);

/// Keys that would make collisions lose energy: they are refused wherever they are likely to be
/// tried.
std::vector<Refused> inelastic_keys();

/// How many there are in all; nothing while an error leaves the count of a species open.
std::optional<std::int64_t> particles_in(const Gas& gas);

/// Where a key of the species is written; the species if it is not.
const Node& at_key(const SpeciesDraft& draft, std::string_view key);

/// What a message calls a particle of the species; `particle` counts over all species.
std::string called(const SpeciesDraft& draft, std::size_t particle);

/// Of particle `i` of a species, counted from 0; 0 where a distribution draws it.
double number_of(const Quantity& quantity, std::size_t i);

/// Reports what cannot be placed in a box of two dimensions: disks too large for it, too many for
/// its area or for a lattice, places outside, places that overlap.
void check_room(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors);

/// The same for beads on a wire, and those of infinite mass that run into one another before the
/// run ends or turns round.
void check_wire(const Box& box, const std::vector<SpeciesDraft>& drafts, const Run& run,
                Errors& errors);

/// Reports particles that would move where they have no room, as far as it is known before they are
/// placed: those listed, those of a wire that is full, disks as wide as the box, a species on a
/// lattice. Of a gas without other errors.
void check_jam(const Box& box, const std::vector<SpeciesDraft>& drafts, Errors& errors);

}  // namespace carom

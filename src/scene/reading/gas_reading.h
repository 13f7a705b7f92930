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
#include "scene/reading/wall_reading.h"
#include "scene/scene.h"

namespace carom {

/// A box and what its sides do.
struct BoxDraft : Box {
    SidesDraft sides;
    const Node* node = nullptr;
};

/// The box of one or two dimensions; nothing when an error leaves its size open.
Notation<BoxDraft> box_notation(int dimension);

/// A species and how it is drawn.
struct SpeciesDraft : Species, SpeciesLook {
    const Node* node = nullptr;                      ///< the item of `gas`
    bool radius_known = true;                        ///< false: an error left the radius open
    const Node *side = nullptr, *side_of = nullptr;  ///< where its position says so
};

/// The species in the order of the list, for a box of one or two dimensions.
Notation<std::vector<SpeciesDraft>> gas_notation(int dimension);

/// Keys that would make collisions lose energy: they are refused wherever they are likely to be
/// tried.
std::vector<Refused> inelastic_keys();

/// How many there are in all; nothing while an error leaves the count of a species open.
std::optional<std::int64_t> particles_in(const Gas& gas);

/// The same of those that a panel or a view chooses.
std::optional<std::int64_t> count_of(const Chosen& chosen, const Gas& gas);

/// Reports a particle of this number, as it is written, where there are only `count`.
void report_no_particle(const Node& place, const std::string& number, std::int64_t count,
                        Errors& errors);

/// Puts those on the side of a partition into that part of the box. `others` are the names of
/// partitions with mistakes.
void place_beside_partitions(std::vector<SpeciesDraft>& drafts, const Box& box,
                             const std::vector<std::string>& others, Errors& errors);

/// Where a key of the species is written; the species if it is not.
const Node& at_key(const SpeciesDraft& draft, std::string_view key);

}  // namespace carom

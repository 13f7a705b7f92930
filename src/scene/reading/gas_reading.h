// The keys of `gas`, and the rules between their values: lengths of lists, names,
// positions, and room for the particles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/gas.h"
#include "scene/keys/binding.h"
#include "scene/looks.h"
#include "scene/panel_spec.h"
#include "scene/reading/wall_reading.h"

namespace carom {

struct NamedGas;

/// A species and how it is drawn.
struct SpeciesDraft : Species, SpeciesLook {
    const Node* node = nullptr;                      ///< the item of `gas`
    const NamedGas* named = nullptr;                 ///< null: its values are its own
    bool radius_known = true;                        ///< false: an error leaves the radius unknown
    const Node *side = nullptr, *side_of = nullptr;  ///< side and partition in its position
};

/// The notation of the list of species, in its order, for a box of one, two or three
/// dimensions.
Notation<std::vector<SpeciesDraft>> gas_notation(int dimension);

/// Returns keys that would make collisions inelastic. They are refused, with an explanation, in
/// every section where users are likely to try them.
std::vector<Refused> inelastic_keys();

/// Returns the number of particles of the gas; nothing if an error leaves the count of a species
/// unknown.
std::optional<std::int64_t> particles_in(const Gas& gas);

/// Returns the number of particles that a panel or a view chooses; nothing if an error leaves it
/// unknown.
std::optional<std::int64_t> count_of(const Chosen& chosen, const Gas& gas);

/// Reports at `place` that there is no particle `number` (as written in the scene), because there
/// are only `count` particles.
void report_no_particle(const Node& place, const std::string& number, std::int64_t count,
                        Errors& errors);

/// Sets the region of each species whose position is given as a side of a partition to that part of
/// the box. `others` are the names of partitions with mistakes, which are not reported again.
void place_beside_partitions(std::vector<SpeciesDraft>& drafts, const Box& box,
                             const std::vector<std::string>& others, Errors& errors);

/// Returns the node of a key of the species, or that of the species if the key is not given.
const Node& at_key(const SpeciesDraft& draft, std::string_view key);

}  // namespace carom

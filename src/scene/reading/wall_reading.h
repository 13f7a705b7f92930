// The keys of the sides of a box, and those for the behaviour of a side or a partition.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scene/keys/binding.h"

namespace carom {

/// The behaviour of a side or a partition, as read from the file.
struct ActingDraft {
    std::optional<double> temperature, mass, force, velocity, until;
    bool is_diffuse = false;
};

std::vector<Binding<ActingDraft>> acting_keys();

/// The key of partitions and events for what is a word of its own for a side of the box.
Binding<ActingDraft> diffuse_key();

/// Returns the groups of acting_keys() that cannot be combined; with `diffuse`, that key too.
std::vector<Choice> acting_choices(bool with_diffuse);

/// Returns the behaviour of the surface that is written at `node`: reflecting, if none of the keys
/// is given. Reports mistakes, and then returns nothing.
std::optional<Behaviour> behaviour_of(const ActingDraft& draft, const Node& node, Errors& errors);

/// A side of the box.
struct SideDraft {
    Wall wall = Wall::solid;
    Behaviour behaviour = Reflecting{};
    const Node* node = nullptr;  ///< null: the scene does not give it
};

/// The sides of a box: left, right, bottom, top.
using SidesDraft = std::array<SideDraft, 4>;

/// The notation of `walls`: one word for all sides, or a value for each side.
Notation<SidesDraft> sides_notation(int dimension);

}  // namespace carom

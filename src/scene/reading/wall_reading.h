// The keys of `box` and its sides, and those for the behaviour of a side or a partition.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "physics/box.h"
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

/// The sides of a box: left, right, bottom, top, back, front; those that it does not have are not
/// given.
using SidesDraft = std::array<SideDraft, 6>;

/// Returns the names of the sides of a box of this dimension, in the order of their numbers.
std::vector<std::string> side_names(int dimension);

/// The notation of `walls`: one word for all sides, or a value for each side.
Notation<SidesDraft> sides_notation(int dimension);

/// A box and the behaviour of its sides.
struct BoxDraft : Box {
    SidesDraft sides;
    std::optional<double> pressure = {};  ///< then the size is only known as a shape
    const Node* node = nullptr;
};

/// The notation of a box of one, two or three dimensions. It reads as nothing if an error leaves
/// the size undetermined.
Notation<BoxDraft> box_notation(int dimension);

}  // namespace carom

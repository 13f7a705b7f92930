// The keys of the sides of a box, and of all that a side or a partition may do.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"

namespace carom {

/// What a side or a partition does, as it is written.
struct ActingDraft {
    std::optional<double> temperature, mass, force, velocity, until;
};

std::vector<Binding<ActingDraft>> acting_keys();

/// Which of these keys cannot be combined.
std::vector<Choice> acting_choices();

/// What a surface does of which `node` is written; nothing if there is a mistake, which is
/// reported. One of which nothing is said reflects.
std::optional<Behaviour> behaviour_of(const ActingDraft& draft, const Node& node, Errors& errors);

/// A side of the box.
struct SideDraft {
    Wall wall = Wall::solid;
    Behaviour behaviour = Reflecting{};
    const Node* node = nullptr;  ///< null: it is not written
};

/// Those of a box: left, right, bottom, top.
using SidesDraft = std::array<SideDraft, 4>;

/// `walls`: one word for all, or each by itself.
Notation<SidesDraft> sides_notation(int dimension);

}  // namespace carom

// The names and actions of surfaces in words: for labels in the picture, and for descriptions of
// it.
#pragma once

#include <span>
#include <string>

#include "physics/box.h"
#include "physics/surface.h"
#include "util/language.h"

namespace carom {

struct Gas;

/// The present position along its normal of surface number k, a side or a partition.
double place_of_surface(const Box& box, std::span<const SurfaceState> states, std::size_t k);

/// A side, or a partition, in a word or two: "back", "lid".
std::string short_name_of_surface(Language language, const Box& box, std::size_t k);

/// The label of a surface in a picture: "T = 2", "M = 50, F = −5", "passes small"; empty for a
/// surface that only reflects or is driven.
std::string label_of_surface(Language language, const Gas& gas, const Behaviour& behaviour,
                             int axis);

/// A side or a partition in its present state, for a table: "divider, open", "left, T = 2".
std::string table_entry_of_surface(const Gas& gas, const SurfaceState& state, std::size_t k);

/// Describes partitions, and walls that do more than reflect, at a moment, in whole sentences;
/// empty for a plain box. `only_changes`: only those that move or are open.
std::string words_at_present(Language language, const Gas& gas,
                             std::span<const SurfaceState> states, bool only_changes = false);

}  // namespace carom

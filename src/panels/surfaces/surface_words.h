// What surfaces are called and do, in words: on the picture, and for those who do not see it.
#pragma once

#include <span>
#include <string>

#include "physics/gas.h"
#include "physics/surface.h"
#include "util/language.h"

namespace carom {

/// Its place along its normal at present: of a side, or of a partition, by its number.
double place_of_surface(const Box& box, std::span<const SurfaceState> states, std::size_t k);

/// What stands beside it in a picture: "T = 2", "M = 50, F = −5", "passes small"; empty for what
/// only reflects or is driven.
std::string mark_of_surface(Language language, const Gas& gas, const Behaviour& behaviour,
                            int axis);

/// "divider, open", "left, T = 2": of a side or a partition, as it is, for a table.
std::string surface_label(const Gas& gas, const SurfaceState& state, std::size_t k);

/// Walls that act and partitions as they are at a moment, in whole sentences; nothing of a plain
/// box. `only_changes`: only of those that move or are open.
std::string words_at_present(Language language, const Gas& gas,
                             std::span<const SurfaceState> states, bool only_changes = false);

}  // namespace carom

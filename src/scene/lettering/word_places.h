// The places of disks that write a word in a part of the box.
#pragma once

#include <cstdint>
#include <optional>

#include "physics/gas.h"
#include "scene/yaml/node.h"

namespace carom {

/// So many disks across a stroke of the letters that there are `count`, or, where that is 0, as
/// many as leave a quarter of their diameter between them. Nothing where the letters have no room
/// for them, which is reported.
std::optional<Places> places_of_word(const Node& word, const Region& region, const Quantity& radius,
                                     std::int64_t count, Errors& errors);

}  // namespace carom

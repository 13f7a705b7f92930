// Places of disks or spheres that spell a word in a part of the box.
#pragma once

#include <cstdint>
#include <optional>

#include "physics/box.h"
#include "physics/value_rule.h"
#include "scene/yaml/node.h"

namespace carom {

struct Places;

/// Returns places for `count` disks or, in a region of space, spheres half way between its back and
/// its front, with as many of them across a stroke of the letters as that takes. If `count` is 0,
/// there are as many across as leave a gap of a quarter of their diameter. Reports it and returns
/// nothing if they do not fit into the letters.
std::optional<Places> places_of_word(const Node& word, const Region& region, int dimension,
                                     const ValueRule& radius, std::int64_t count, Errors& errors);

}  // namespace carom

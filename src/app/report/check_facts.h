// What `carom check` found, for people and for programs.
#pragma once

#include <span>
#include <string>

#include "app/report/scene_facts.h"

namespace carom {

/// A short table for each valid scene or set, a line for each that is not; ends with a line break.
std::string check_table(std::span<const CheckedScene> scenes);

/// A list with one object for each scene or set, in UTF-8; `null` for what there is none of; ends
/// with a line break.
std::string check_json(std::span<const CheckedScene> scenes);

}  // namespace carom

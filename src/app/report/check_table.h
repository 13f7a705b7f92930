// What `carom check` found, for people.
#pragma once

#include <span>
#include <string>

#include "app/report/scene_facts.h"

namespace carom {

/// A short table for each valid scene, a line for each that is not; ends with a line break.
std::string check_table(std::span<const CheckedScene> scenes);

}  // namespace carom

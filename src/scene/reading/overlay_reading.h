// The keys of what a film shows for a while or lays over the gas: when panels are there,
// spotlights, callouts, the camera, a field.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// When a panel is there.
Notation<TimeSpan> show_notation();

}  // namespace carom

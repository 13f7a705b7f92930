// The options of return distances, and the kind of panel (return_distance_kind.cpp); the panel
// itself is in return_distance.cpp.
#pragma once

#include <memory>

#include "panels/panel.h"

namespace carom {

struct ReturnDistanceOptions {
    bool against_collisions = false;  ///< false: against time
};

std::unique_ptr<Panel> make_return_distance(const PanelContext& context, const PanelSpec& spec);

}  // namespace carom

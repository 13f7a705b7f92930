// What a picture of return distances shows: complete, immutable.
#pragma once

#include <cstddef>
#include <vector>

#include "panels/panel.h"

namespace carom {

struct ReturnDistanceState : PanelState {
    std::vector<std::size_t> shown;  // steps of the way home, of each run
};

}  // namespace carom

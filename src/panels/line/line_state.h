// What the panel of a wire shows in one frame: made by wire_panel.cpp, drawn by wire_drawing.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "panels/gas/flashes.h"
#include "panels/gas/ghosts.h"
#include "panels/line/world_lines.h"
#include "panels/panel.h"

namespace carom {

struct WireState : PanelState {
    double time = 0.0;
    std::vector<float> places;                         // of all beads, as drawn
    std::vector<float> velocities;                     // empty: not shown
    std::vector<std::uint8_t> shades;                  // index into the film's colours
    std::vector<std::vector<WorldLines::Bend>> lines;  // oldest bend first, the present last
    std::vector<double> reversals;                     // simulated times in memory
    double label_alpha = 0.0;
    std::shared_ptr<const Ghosts> ghosts;  // may be null
    double ghost_words = 0.0;
    std::vector<Flash> flashes;

    std::size_t bytes() const override {
        std::size_t sum = places.size() * (sizeof(float) + 1) + velocities.size() * sizeof(float);
        for (const auto& line : lines) sum += line.size() * sizeof(WorldLines::Bend);
        return sum;
    }
};

}  // namespace carom

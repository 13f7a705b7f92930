// What the panel of the gas shows in one frame: made by gas_panel.cpp, drawn by gas_drawing.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "panels/gas/flashes.h"
#include "panels/gas/ghosts.h"
#include "panels/panel.h"

namespace carom {

struct GasState : PanelState {
    struct Trail {
        std::vector<Point> places;  // oldest first, scene units
        std::vector<float> ages;    // seconds of film
    };
    std::vector<float> x, y;           // scene units
    std::vector<float> vx, vy;         // scene units; empty: not shown
    std::vector<std::uint8_t> shades;  // index into the film's colours
    std::vector<Trail> trails;         // one for each chosen particle
    float label_alpha = 0.0F;
    std::shared_ptr<const Ghosts> ghosts;  // may be null
    double ghost_words = 0.0;
    std::vector<Flash> flashes;

    std::size_t bytes() const override {
        std::size_t sum = x.size() * (2 * sizeof(float) + 1) + vx.size() * 2 * sizeof(float);
        for (const Trail& trail : trails) sum += trail.places.size() * 20;
        return sum;
    }
};

}  // namespace carom

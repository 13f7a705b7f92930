// The frames of a film without its file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "panels/frame.h"
#include "panels/precision.h"

namespace carom::test {

/// A film's frames, or the first `most` of them, and what draws them.
struct Shot {
    Scene scene;
    std::unique_ptr<Observers> observers;
    std::vector<FrameData> frames;

    explicit Shot(const Scene& loaded, std::size_t most = std::numeric_limits<std::size_t>::max())
        : scene(with_precision(loaded)) {
        Simulation survey(scene.gas, scene.run);
        Simulation simulation(scene.gas, scene.run);
        observers = std::make_unique<Observers>(scene, simulation.particles(), simulation.sample());
        std::vector<Tick> ticks = timeline(scene);
        survey.record_collisions(observers->surveys_collisions());
        survey.measure_return(observers->return_times(ticks));
        for (const Tick& tick : ticks) {
            const AdvanceResult advanced = survey.advance_to(tick.time);
            observers->survey(tick, survey.sample(), advanced);
        }
        observers->fix_axes();
        ticks.resize(std::min(ticks.size(), most));
        simulation.record_collisions(observers->wants_collisions());
        for (const Tick& tick : ticks) {
            const AdvanceResult advanced = simulation.advance_to(tick.time);
            frames.push_back(observers->frame_data(tick, simulation.sample(), advanced));
        }
    }
};

}  // namespace carom::test

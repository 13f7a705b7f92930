// The first frame of a scene, as its own first pass sees it.
#pragma once

#include <memory>
#include <utility>

#include "panels/frame.h"

namespace carom::test {

struct FirstFrame {
    Scene scene;
    Simulation simulation;
    Observers observers;
    std::unique_ptr<FramePainter> painter;
    PixelView view;

    explicit FirstFrame(Scene loaded)
        : scene(std::move(loaded)),
          simulation(scene.gas, scene.run),
          observers(scene, simulation.particles(), simulation.sample()) {
        const AdvanceResult advanced = simulation.advance_to(0.0);
        const Tick tick{};
        observers.survey(tick, simulation.sample(), advanced);
        observers.fix_axes();
        const FrameData frame = observers.frame_data(tick, simulation.sample(), advanced);
        painter = std::make_unique<FramePainter>(scene, observers);
        view = painter->paint(frame).pixels();
    }

    /// The box on the picture.
    Rect box() const {
        return observers.gas().frame_in(
            Grid(scene.film.layout, scene.film.size).place(scene.film.layout.gas));
    }
};

}  // namespace carom::test

// The first frame of a scene, drawn after a first pass over that frame alone.
#pragma once

#include <memory>
#include <utility>

#include "panels/frame.h"
#include "scene/scene.h"

namespace carom::test {

struct FirstFrame {
    Scene scene;
    Simulation simulation;
    PanelSet panels;
    FrameData frame;
    std::unique_ptr<FramePainter> painter;
    PixelView view;

    explicit FirstFrame(Scene loaded)
        : scene(std::move(loaded)),
          simulation(scene.gas, scene.run),
          panels(scene, simulation.particles(), simulation.sample()) {
        const AdvanceResult advanced = simulation.advance_to(0.0);
        const Tick tick{};
        panels.survey(tick, simulation.sample(), advanced);
        panels.fix_axes();
        frame = panels.frame_data(tick, simulation.sample(), advanced);
        painter = std::make_unique<FramePainter>(panels);
        view = painter->paint(frame).pixels();
    }

    /// The rectangle of the gas box in the picture, in pixels.
    Rect box() const {
        return panels.gas().frame_in(
            Grid(scene.film.layout, scene.film.size).place(scene.film.layout.gas), 1.0);
    }
};

}  // namespace carom::test

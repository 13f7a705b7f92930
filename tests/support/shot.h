// The frames of a film without its file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "panels/frame.h"
#include "panels/precision.h"
#include "panels/recording.h"
#include "util/archive.h"

namespace carom::test {

/// A film's frames, or the first `most` of them, and what draws them: panels that have read what
/// the first pass of others has fixed.
struct Shot {
    Scene scene;
    Recording beside;  ///< of the run beside the film's own, if there is one
    std::unique_ptr<PanelSet> panels;
    std::vector<FrameData> frames;

    explicit Shot(const Scene& loaded, std::size_t most = std::numeric_limits<std::size_t>::max())
        : Shot(start_scene(loaded), most) {}

    Shot(StartedScene started, std::size_t most) : scene(std::move(started.scene)) {
        Simulation& start = started.simulation;
        const Particles particles = start.particles();
        const Sample sample_at_start = start.sample();
        std::optional<StartedScene> other;
        std::optional<RunStart> start_beside;
        if (scene.film.beside) {
            other = start_scene(*scene.film.beside->scene);
            start_beside = {other->simulation.particles(), other->simulation.sample()};
        }
        const RunStart* its = start_beside ? &*start_beside : nullptr;
        PanelSet first(scene, particles, sample_at_start, its);
        const auto ignore = [](const Tick&, const Sample&, const AdvanceResult&) {};
        if (other)
            beside = first.record_beside(std::move(other->simulation), timeline(scene), ignore);
        const Recording run = first.record(start, timeline(scene), ignore);
        first.fix_axes();
        Archive written;
        first.archive(written);
        panels = std::make_unique<PanelSet>(scene, particles, sample_at_start, its);
        Archive read(written.finished(), "axes");
        panels->archive(read);
        read.expect_end();
        if (other) panels->play_beside(beside);
        run.play(std::min(run.ticks().size(), most),
                 [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                     frames.push_back(panels->frame_data(tick, sample, advanced));
                 });
    }
};

}  // namespace carom::test

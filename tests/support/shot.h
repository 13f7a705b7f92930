// The frames of a film without its file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
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
    std::unique_ptr<PanelSet> panels;
    std::vector<FrameData> frames;

    explicit Shot(const Scene& loaded, std::size_t most = std::numeric_limits<std::size_t>::max())
        : Shot(start_scene(loaded), most) {}

    Shot(StartedScene started, std::size_t most) : scene(std::move(started.scene)) {
        Simulation& start = started.simulation;
        const Particles particles = start.particles();
        const Sample sample_at_start = start.sample();
        PanelSet first(scene, particles, sample_at_start);
        const Recording run = first.record(start, timeline(scene),
                                           [](const Tick&, const Sample&, const AdvanceResult&) {});
        first.fix_axes();
        Archive written;
        first.archive(written);
        panels = std::make_unique<PanelSet>(scene, particles, sample_at_start);
        Archive read(written.finished(), "axes");
        panels->archive(read);
        read.expect_end();
        run.play(std::min(run.ticks().size(), most),
                 [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                     frames.push_back(panels->frame_data(tick, sample, advanced));
                 });
    }
};

}  // namespace carom::test

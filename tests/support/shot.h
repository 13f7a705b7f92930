// The frames of a film, without writing its file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "panels/frame.h"
#include "panels/precision.h"
#include "panels/recording.h"
#include "util/archive.h"

namespace carom::test {

/// A film after its first pass. Its panels hold references to it, so it is not copyable.
struct SurveyedFilm {
    Scene scene;
    Particles particles;
    Sample start;                          ///< at time 0
    std::optional<RunStart> start_beside;  ///< of the run shown beside the film's own, if any
    Recording run, beside;
    std::string axes;  ///< the archive of what the first pass has fixed

    /// `room`: how much room the recording of each run may take.
    explicit SurveyedFilm(const Scene& loaded, const Recording::Room& room = {})
        : SurveyedFilm(start_scene(loaded), room) {}
    SurveyedFilm(const SurveyedFilm&) = delete;
    SurveyedFilm& operator=(const SurveyedFilm&) = delete;

    /// Panels that have restored what the first pass has fixed, ready for the second pass.
    std::unique_ptr<PanelSet> read_panels() const {
        auto panels = std::make_unique<PanelSet>(scene, particles, start,
                                                 start_beside ? &*start_beside : nullptr);
        Archive read(axes, "axes");
        panels->archive(read);
        read.expect_end();
        if (start_beside) panels->play_beside(beside);
        return panels;
    }

  private:
    SurveyedFilm(StartedScene started, const Recording::Room& room)
        : scene(std::move(started.scene)),
          particles(started.simulation.particles()),
          start(started.simulation.sample()) {
        std::optional<StartedScene> other;
        if (scene.film.beside) {
            other = start_scene(*scene.film.beside->scene);
            start_beside = {other->simulation.particles(), other->simulation.sample()};
            scene.film.beside->scene = std::make_shared<Scene>(other->scene);
        }
        PanelSet first(scene, particles, start, start_beside ? &*start_beside : nullptr);
        const auto ignore = [](const Tick&, const Sample&, const AdvanceResult&) {};
        if (other)
            beside =
                first.record_beside(std::move(other->simulation), timeline(scene), ignore, room);
        run = first.record(std::move(started.simulation), timeline(scene), ignore, room);
        first.fix_axes();
        Archive written;
        first.archive(written);
        axes = written.finished();
    }
};

/// The frames of a film, or the first `most` of them, and the panels for drawing them, which have
/// restored what the first pass of other panels has fixed.
struct Shot : SurveyedFilm {
    std::unique_ptr<PanelSet> panels;
    std::vector<FrameData> frames;

    explicit Shot(const Scene& loaded, std::size_t most = std::numeric_limits<std::size_t>::max())
        : SurveyedFilm(loaded), panels(read_panels()) {
        run.play(std::min(run.ticks().size(), most),
                 [&](const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
                     frames.push_back(panels->frame_data(tick, sample, advanced));
                 });
    }
};

}  // namespace carom::test

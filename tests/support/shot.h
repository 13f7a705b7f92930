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
    std::vector<RunStart> starts = {};  ///< of the runs that it shows, its own first
    std::vector<Recording> runs = {};
    std::string axes = {};  ///< the archive of what the first pass has fixed

    /// `room`: how much room the recording of each run may take.
    explicit SurveyedFilm(const Scene& loaded, const Recording::Room& room = {})
        : SurveyedFilm(start_scene(loaded), room) {}
    SurveyedFilm(const SurveyedFilm&) = delete;
    SurveyedFilm& operator=(const SurveyedFilm&) = delete;

    /// Panels that have restored what the first pass has fixed, ready for the second pass.
    std::unique_ptr<PanelSet> read_panels() const {
        auto panels = std::make_unique<PanelSet>(scene, starts);
        Archive read(axes, "axes");
        panels->archive(read);
        read.expect_end();
        return panels;
    }

  private:
    SurveyedFilm(StartedScene started, const Recording::Room& room)
        : scene(std::move(started.scene)) {
        std::vector<Simulation> simulations{std::move(started.simulation)};
        for (ComparedRun& run : scene.film.runs.others) {
            StartedScene other = start_scene(*run.scene);
            run.scene = std::make_shared<Scene>(std::move(other.scene));
            simulations.push_back(std::move(other.simulation));
        }
        for (Simulation& simulation : simulations)
            starts.push_back({simulation.particles(), simulation.sample()});
        PanelSet first(scene, starts);
        for (Simulation& simulation : simulations)
            runs.push_back(first.record(runs.size(), std::move(simulation), timeline(scene),
                                        [](const Tick&, const Sample&, const AdvanceResult&) {},
                                        {.room = room}));
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
        RunsPlayer player(runs);
        while (player.shown() < std::min(runs.front().ticks().size(), most)) {
            player.next();
            frames.push_back(panels->frame_data(player.tick(), player.frames()));
        }
    }
};

}  // namespace carom::test

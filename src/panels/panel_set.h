// The panels of a film in order of time, and the frame as a value.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "panels/layout.h"
#include "panels/panel.h"
#include "panels/recording.h"
#include "scene/time/showing.h"

namespace carom {

/// Everything one frame shows, complete and immutable.
struct FrameData {
    Tick tick;
    std::vector<std::shared_ptr<const PanelState>>
        states;  ///< one for each of the set's panels, in order; none in a card
    std::size_t bytes = 0;
};

/// A run as it begins: the state at t = 0 fixes the equilibrium that curves show.
struct RunStart {
    Particles particles;
    Sample sample;

    void archive(Archive& archive);
};

/// The panels of a film, or of figures that show one run. Their axes are fixed by a first pass over
/// the run, or read from what another set has fixed; then they give what each frame shows.
///
/// A film may show another run beside its own (Film::beside): its box, and in plots a line of each.
/// Each run has its first pass; in the second the set takes the other's frames from its recording.
class PanelSet {
  public:
    /// `start` is the state at t = 0, `beside` that of the run beside it, where the film has one.
    /// Throws SceneError where words do not fit into their place. `scene` outlives the set.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start,
             const RunStart* beside = nullptr);

    /// Panels without a place, as figures have them, of a run of so many frames.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start, int frames,
             const std::vector<PanelSpec>& specs);
    PanelSet(const PanelSet&) = delete;  // its panels refer to its particles
    PanelSet& operator=(const PanelSet&) = delete;

    /// First pass, every frame in order. Cards show nothing of the gas: panels do not see them.
    void survey(const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
        survey(own, tick, sample, advanced);
    }
    void fix_axes();

    /// The first pass over a whole run, from a simulation at time 0; `see` sees each frame after
    /// the panels. Errors have their places in the scene file. `room` is for what is kept. With
    /// `aside` panels see it, and `see` does, on a thread of their own, while the run is simulated.
    /// With `all_collisions` `see` sees the collisions also where no panel wants them. Throws
    /// SceneError, Interrupted.
    Recording record(Simulation start, std::vector<Tick> ticks, const Recording::Viewer& see,
                     const Recording::Room& room = {}, bool aside = false,
                     bool all_collisions = false) {
        return record(own, std::move(start), std::move(ticks), see, room,
                      {.first_collisions = all_collisions, .aside = aside});
    }

    /// The same for the run beside it.
    Recording record_beside(Simulation start, std::vector<Tick> ticks, const Recording::Viewer& see,
                            const Recording::Room& room = {}, bool aside = false) {
        return record(other, std::move(start), std::move(ticks), see, room, {.aside = aside});
    }

    /// The first pass over frames of a run with none beside it, of which nothing is kept; `see`
    /// sees each after the panels, with positions up to the frame `last_whole`, beyond it only if
    /// the panels need them. Throws SceneError, Interrupted.
    void survey_run(Simulation start, const std::vector<Tick>& ticks, int last_whole,
                    const Recording::Viewer& see);

    /// Where the second pass takes the frames of the run beside it from, one for each frame_data().
    /// Refers to the recording.
    void play_beside(const Recording& recording) { beside_.emplace(recording); }

    /// The frames of the run beside it that the coming frame_data() will take, before number `end`
    /// (Player::rest()). None where nothing plays beside it.
    std::optional<Recording> rest_beside(std::size_t end) const {
        return beside_ ? std::optional(beside_->rest(end)) : std::nullopt;
    }

    /// Writes or reads what the first pass has fixed.
    void archive(Archive& archive);

    /// Writes or reads how far the second pass is: all that its frames so far have left in the
    /// panels. A set that reads it after archive() gives, from the next frame on, the very same as
    /// one that has given all frames before. What play_beside() plays is not part of it: it must
    /// begin with that frame.
    void archive_progress(Archive& archive);

    /// Second pass, every frame in order. Numbers in words stay the same for a fifth of a second,
    /// so that they can be read; in a still they are those of its frame, and spotlights and
    /// callouts are whole.
    FrameData frame_data(const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
                         bool is_still = false);

    /// Whether any panel needs the collisions on the way, in either pass.
    bool wants_collisions() const;

    /// Whether any panel needs the distance from the return, which is measured at all frames.
    bool wants_return_distances() const;

    /// A panel and its place in the template's grid.
    struct Placed {
        Slot slot;
        std::unique_ptr<Panel> panel;
        std::optional<Showing> showing = {};  ///< none: throughout
        std::size_t run = 0;                  ///< that it sees: 1 is the run beside the film's own
        /// How much of it is seen in a frame, from 0 to 1.
        double opacity(const Film& film, const Tick& tick) const;
    };
    /// A film's gas is the first, and its panels are the last.
    const std::vector<Placed>& panels() const { return panels_; }
    /// With two runs, the line below the box of one of them.
    const Placed& line_of_run(std::size_t run) const { return panels_[2 * run + 1]; }
    const Panel& gas() const { return *panels_.front().panel; }
    const Scene& scene() const { return runs_.front()->scene; }

    /// Where the box of each run is in a picture with this grid.
    std::vector<Rect> boxes(const Grid& grid) const;

    /// What happens to the gas in the box of that place in boxes().
    const carom::Run& run_in(std::size_t box) const { return runs_[box]->scene.run; }

  private:
    static constexpr std::size_t own = 0, other = 1;

    /// What is known of one of the runs.
    struct Run {
        Run(const Scene& its_scene, const Particles& its_particles, const Sample& start);
        const Scene& scene;
        Particles particles;
        std::optional<EquilibriumGas> equilibrium;
        Eigen::ArrayXd speed = {}, energy = {};  ///< of the present frame
        FrameInput input(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);
    };

    PanelContext context_of(std::size_t run) const;
    void add_boxes(const LayoutSpec& layout);
    void add_film_panels(const LayoutSpec& layout);
    template <typename Function>
    void for_each_panel(Function&& f) const;
    void survey(std::size_t run, const Tick& tick, const Sample& sample,
                const AdvanceResult& advanced);
    Recording record(std::size_t run, Simulation start, std::vector<Tick> ticks,
                     const Recording::Viewer& see, const Recording::Room& room,
                     Recording::Wanted wanted);
    std::vector<double> return_times(std::size_t run, const std::vector<Tick>& ticks) const;
    void fix_axes_of_both();
    bool refreshes_readouts(const Tick& tick) const;

    std::vector<std::unique_ptr<Run>> runs_;  ///< one, or the film's own and the one beside it
    std::vector<Placed> panels_;
    std::vector<std::unique_ptr<Panel>>
        of_other_;  ///< for each panel of a film that shows two runs what sees the other one
    std::optional<Recording::Player> beside_;
    bool is_film_ = true;
};

}  // namespace carom

// The panels of a film, driven through the run in order of time, and the frame as a value.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
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
        states;  ///< one for each of the set's panels, in order; empty in a card
    std::size_t bytes = 0;
};

/// A run at its beginning: the state at t = 0 determines the equilibrium that curves show.
struct RunStart {
    Particles particles;
    Sample sample;

    void archive(Archive& archive);
};

/// The panels of a film, or of figures that show one run. Their axes are fixed by a first pass over
/// the run, or read from what another set has fixed; in the second pass they give the content of
/// each frame.
///
/// A film may compare its own run with another one (Film::beside): it shows the boxes of both, and
/// plots have a line for each. Each run has its own first pass; in the second pass the set takes
/// the frames of the other run from its recording.
class PanelSet {
  public:
    /// `start` is the state at t = 0; `beside` is the start of the other run, if the film has one.
    /// Throws SceneError if a text does not fit into its place. `scene` must outlive the set.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start,
             const RunStart* beside = nullptr);

    /// Panels without places, as in figures, for a run of `frames` frames.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start, int frames,
             const std::vector<PanelSpec>& specs);
    PanelSet(const PanelSet&) = delete;  // its panels refer to its particles
    PanelSet& operator=(const PanelSet&) = delete;

    /// First pass, every frame in order, each of which also counts as a sample. Title and end cards
    /// show nothing of the gas, so panels do not see them.
    void survey(const Tick& tick, const Sample& sample, const AdvanceResult& advanced) {
        survey(own, {tick}, sample, advanced, advanced.collisions);
    }
    void fix_axes();

    /// Makes the first pass over a whole run, from a simulation at time 0, at its samples and at
    /// the frames of `ticks`; `see` is called for each frame after the panels. Errors are reported
    /// with their places in the scene file. `room` limits the bytes that the recording keeps. With
    /// `aside`, panels and `see` run on a separate thread while the run is simulated. With
    /// `all_collisions`, `see` gets the collisions even if no panel needs them. Throws SceneError,
    /// Interrupted.
    Recording record(Simulation start, const std::vector<Tick>& ticks, const Recording::Viewer& see,
                     const Recording::Room& room = {}, bool aside = false,
                     bool all_collisions = false) {
        return record(own, std::move(start), ticks, see, room,
                      {.first_collisions = all_collisions, .aside = aside});
    }

    /// The same for the other run.
    Recording record_beside(Simulation start, const std::vector<Tick>& ticks,
                            const Recording::Viewer& see, const Recording::Room& room = {},
                            bool aside = false) {
        return record(other, std::move(start), ticks, see, room, {.aside = aside});
    }

    /// Makes the first pass without keeping a recording; there must be no other run. `see` is
    /// called for each frame after the panels; samples have positions up to the frame `last_whole`,
    /// and beyond it only if the panels need them. With `only_frames`, what is measured is measured
    /// at the frames, for a quick still. Throws SceneError, Interrupted.
    void survey_run(Simulation start, const std::vector<Tick>& ticks, int last_whole,
                    const Recording::Viewer& see, bool only_frames = false);

    /// Sets the recording from which the second pass takes the frames of the other run, one for
    /// each frame_data(). `recording` must outlive the second pass.
    void play_beside(const Recording& recording) { beside_.emplace(recording); }

    /// The frames of the other run that coming calls of frame_data() will take, up to but excluding
    /// number `end` (Player::rest()). None without another run.
    std::optional<Recording> rest_beside(std::size_t end) const {
        return beside_ ? std::optional(beside_->rest(end)) : std::nullopt;
    }

    /// Writes or reads what the first pass has fixed.
    void archive(Archive& archive);

    /// Writes or reads the progress of the second pass: all state that the frames so far have left
    /// in the panels. A set that has read it after archive() gives, from the next frame on, exactly
    /// the same frames as a set that has given all frames before. The recording of play_beside() is
    /// not included: it must begin with that next frame.
    void archive_progress(Archive& archive);

    /// Second pass, every frame in order. Numbers in texts are refreshed every fifth of a second,
    /// so that they can be read. In a still they are those of its frame, and spotlights and
    /// callouts are at full strength.
    FrameData frame_data(const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
                         bool is_still = false);

    /// Second pass of figures, every frame in order: the states of the panels for which
    /// `is_shown(number)`; the others are empty.
    std::vector<std::shared_ptr<const PanelState>> states(
        const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
        const std::function<bool(std::size_t)>& is_shown);

    /// Whether any panel needs the collisions between frames, in either pass.
    bool wants_collisions() const;

    /// Whether any panel needs return distances.
    bool wants_return_distances() const;

    /// A panel and its place in the template's grid.
    struct Placed {
        Slot slot;
        std::unique_ptr<Panel> panel;
        std::optional<Showing> showing = {};  ///< none: always shown
        std::size_t run = 0;                  ///< that it sees: 0 the film's own, 1 the other one
        /// Where it stands. In the gas's place, a panel comes with the first collision, unless the
        /// scene says when it is shown; over the box it lies on a plate, which is larger than its
        /// place by plate_margin.
        enum class Stand { own_place, beside_box, over_box };
        Stand stand = Stand::own_place;
        bool is_over_box() const { return stand == Stand::over_box; }
        bool is_box() const;  ///< of one of the runs
        /// The opacity of the panel in a frame, from 0 to 1.
        double opacity(const Film& film, const Tick& tick) const;
    };
    /// All panels: in a film the gas is the first, and the panels that the scene lists are the
    /// last.
    const std::vector<Placed>& panels() const { return panels_; }
    /// With two runs: the panel of the line of text below the box of one of them.
    const Placed& line_of_run(std::size_t run) const { return panels_[2 * run + 1]; }
    const Panel& gas() const { return *panels_.front().panel; }
    const Scene& scene() const { return runs_.front()->scene; }

    /// The rectangle of each run's box in a picture with this grid.
    std::vector<Rect> boxes(const Grid& grid) const;

    /// The pixels per unit length in these boxes of a plane, where a camera shows the whole box.
    double scale(const Grid& grid) const;

    /// The run that is shown in the box with this index in boxes().
    const carom::Run& run_in(std::size_t box) const;

  private:
    static constexpr std::size_t own = 0, other = 1;

    /// The data of one of the runs.
    struct Run {
        Run(const Scene& its_scene, const Particles& its_particles, const Sample& start);
        const Scene& scene;
        Particles particles;
        BoxedGas gas;                            ///< refers to the particles
        Eigen::ArrayXd speed = {}, energy = {};  ///< of the present frame
        JoinedCollisions since_sample = {};      ///< in the first pass
        FrameInput input(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);
    };

    PanelContext context_of(std::size_t run) const;
    void add_boxes(const LayoutSpec& layout);
    void add_numbers(const LayoutSpec& layout, std::vector<Monitor> numbers);
    void add_film_panels(const LayoutSpec& layout);
    void make_room(std::size_t run, const Sample& start);
    void share_ranges_of_lines();
    template <typename Function>
    void for_each_panel(Function&& f) const;
    void survey(std::size_t run, const SeenMoment& moment, const Sample& sample,
                const AdvanceResult& advanced, std::span<const Collision> since_frame);
    std::vector<SeenMoment> moments(std::size_t run, const std::vector<Tick>& ticks) const;
    Recording record(std::size_t run, Simulation start, const std::vector<Tick>& ticks,
                     const Recording::Viewer& see, const Recording::Room& room,
                     Recording::Wanted wanted);
    std::vector<double> return_times(std::size_t run, const std::vector<Tick>& ticks) const;
    void fix_axes_of_both();
    bool refreshes_readouts(const Tick& tick) const;
    void enter_with_collisions();
    void share_colors();
    std::vector<Slot> places_of_panels(const LayoutSpec& layout) const;
    using States = std::vector<std::shared_ptr<const PanelState>>;
    States film_states(const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
                       bool is_still);
    States states_behind_card(const Tick& tick, const Sample& sample,
                              const AdvanceResult& advanced);

    std::vector<std::unique_ptr<Run>> runs_;  ///< one, or the film's own and the other
    std::vector<Placed> panels_;
    std::vector<std::unique_ptr<Panel>>
        of_other_;  ///< for each panel of a film with two runs, the panel of the other one
    std::optional<Recording::Player> beside_;
    std::optional<double> first_collision_;  ///< simulated time of the first frame after it
    bool is_film_ = true;
    States behind_card_;               ///< of the last card of which a frame was seen,
    std::optional<Phase> card_phase_;  ///< and which this is
};

}  // namespace carom

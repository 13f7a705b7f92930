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
#include "panels/words/word_numbers.h"
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
/// A film may compare its own run with others (Film::runs): it shows the boxes of all, and plots
/// have a line for each. Runs are numbered in this order, the film's own is number 0. Each has its
/// own first pass; in the second pass the set sees the frames of all runs together.
class PanelSet {
  public:
    /// `starts`: of each run. Throws SceneError if a text does not fit into its place. `scene` must
    /// outlive the set.
    PanelSet(const Scene& scene, const std::vector<RunStart>& starts);

    /// The same for a film of its own run alone.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start)
        : PanelSet(scene, std::vector<RunStart>{{particles, start}}) {}

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

    /// To be called before the first pass: reads the numbers for which words ask, of the own run.
    void ask(std::vector<WordRequest> requests);

    /// As WordNumbers::texts(), after the first pass; empty if nothing was asked.
    std::vector<std::string> number_texts() const;

    /// How a run is surveyed.
    struct Survey {
        Recording::Room room = {};    ///< limits the bytes that the recording keeps
        bool aside = false;           ///< panels and `see` on a thread besides the simulation
        bool all_collisions = false;  ///< `see` gets them even if no panel needs them
        std::optional<std::size_t> frames = {};  ///< that are recorded, the first ones; none: all.
                                                 ///< Later samples have positions only if the
                                                 ///< panels need them
        bool only_frames = false;                ///< what is measured is measured at the frames
    };

    /// Makes the first pass over a whole run, from a simulation at time 0, at its samples and at
    /// the frames of `ticks`; `see` is called for each frame after the panels. Errors are reported
    /// with their places in the scene file. Throws SceneError, Interrupted.
    Recording record(std::size_t run, Simulation start, const std::vector<Tick>& ticks,
                     const Recording::Viewer& see, const Survey& how);
    Recording record(Simulation start, const std::vector<Tick>& ticks, const Recording::Viewer& see,
                     const Recording::Room& room = {}) {
        return record(own, std::move(start), ticks, see, {.room = room});
    }

    /// Writes or reads what the first pass has fixed.
    void archive(Archive& archive);

    /// Writes or reads the progress of the second pass: all state that the frames so far have left
    /// in the panels. A set that has read it after archive() gives, from the next frame on, exactly
    /// the same frames as a set that has given all frames before.
    void archive_progress(Archive& archive);

    /// Second pass, every frame in order, with what it shows of each run. Numbers in texts are
    /// refreshed every fifth of a second, so that they can be read. In a still they are those of
    /// its frame, and spotlights and callouts are at full strength.
    FrameData frame_data(const Tick& tick, const std::vector<RunFrame>& runs,
                         bool is_still = false);

    /// The same for a film of its own run alone.
    FrameData frame_data(const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
                         bool is_still = false) {
        return frame_data(tick, {{sample, advanced}}, is_still);
    }

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
        std::size_t run = 0;  ///< that it sees, or whose panel it is if it shows all runs
        /// Where it stands. In the gas's place, a panel comes with the first collision, unless the
        /// scene says when it is shown; over the box it lies on a plate, which is larger than its
        /// place by plate_margin.
        enum class Stand { own_place, beside_box, over_box };
        Stand stand = Stand::own_place;
        /// The panels of the same kind that see the other runs, of one that shows all runs.
        std::vector<std::unique_ptr<Panel>> of_others = {};
        bool is_over_box() const { return stand == Stand::over_box; }
        bool is_box() const;  ///< of one of the runs
        /// The opacity of the panel in a frame, from 0 to 1.
        double opacity(const Film& film, const Tick& tick) const;
    };
    /// All panels: in a film the gas is the first, and the panels that the scene lists are the
    /// last.
    const std::vector<Placed>& panels() const { return panels_; }
    /// With several runs: the panel of the line of text below the box of one of them.
    const Placed& line_of_run(std::size_t run) const { return panels_[runs_[run]->line]; }
    const Panel& gas() const { return *panels_.front().panel; }
    const Scene& scene() const { return runs_.front()->scene; }

    /// The rectangle of each run's box in a picture with this grid.
    std::vector<Rect> boxes(const Grid& grid) const;

    /// The pixels per unit length in these boxes of a plane, where a camera shows the whole box.
    double scale(const Grid& grid) const;

    /// The run that is shown in the box with this index in boxes().
    const carom::Run& run_in(std::size_t box) const;

  private:
    static constexpr std::size_t own = 0;

    /// The data of one of the runs.
    struct Run {
        Run(const Scene& its_scene, const Particles& its_particles, const Sample& start);
        const Scene& scene;
        Particles particles;
        BoxedGas gas;                            ///< refers to the particles
        Eigen::ArrayXd speed = {}, energy = {};  ///< of the present frame
        JoinedCollisions since_sample = {};      ///< in the first pass
        std::size_t line = 0;                    ///< index of the panel of its line, if it has one
        FrameInput input(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);
    };

    PanelContext context_of(std::size_t run) const;
    void add_boxes(const LayoutSpec& layout);
    void add_numbers(const LayoutSpec& layout, std::vector<Monitor> numbers);
    void add_film_panels(const LayoutSpec& layout);
    void make_room(std::size_t run, const Sample& start);
    void share_ranges_of_lines();
    bool is_compared() const { return runs_.size() > 1; }
    template <typename Function>
    void for_each_panel(Function&& f) const;
    void survey(std::size_t run, const SeenMoment& moment, const Sample& sample,
                const AdvanceResult& advanced, std::span<const Collision> since_frame);
    std::vector<SeenMoment> moments(std::size_t run, const std::vector<Tick>& ticks) const;
    std::vector<double> return_times(std::size_t run, const std::vector<Tick>& ticks) const;
    void fix_axes_of_runs();
    bool refreshes_readouts(const Tick& tick) const;
    void enter_with_collisions();
    void share_colors();
    std::vector<Slot> places_of_panels(const LayoutSpec& layout) const;
    using States = std::vector<std::shared_ptr<const PanelState>>;
    States film_states(const Tick& tick, const std::vector<RunFrame>& runs, bool is_still);
    States states_behind_card(const Tick& tick, const std::vector<RunFrame>& runs);

    std::vector<std::unique_ptr<Run>> runs_;  ///< the film's own first
    std::vector<Placed> panels_;
    std::optional<WordNumbers> numbers_;     ///< if words ask for any
    std::optional<double> first_collision_;  ///< simulated time of the first frame after it
    bool is_film_ = true;
    States behind_card_;               ///< of the last card of which a frame was seen,
    std::optional<Phase> card_phase_;  ///< and which this is
};

}  // namespace carom

// The frame as a value, the panels that make it in order of time, and the painter that draws it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "panels/layout.h"
#include "panels/panel.h"
#include "panels/recording.h"
#include "scene/time/captions.h"
#include "scene/time/showing.h"

namespace carom {

/// Everything one frame shows, complete and immutable.
struct FrameData {
    Tick tick;
    std::vector<std::shared_ptr<const PanelState>>
        states;  ///< one for each of the set's panels, in order; none in a card
    std::size_t bytes = 0;
};

/// The panels of a film, or of figures that show one run. Their axes are fixed by a first pass over
/// the run, or read from what another set has fixed; then they give what each frame shows.
class PanelSet {
  public:
    /// `start` is the state at t = 0, which fixes the equilibrium that curves show. Throws
    /// SceneError where words do not fit into their place. `scene` outlives the set.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start);

    /// Panels without a place, as figures have them, of a run of so many frames.
    PanelSet(const Scene& scene, const Particles& particles, const Sample& start, int frames,
             const std::vector<PanelSpec>& specs);
    PanelSet(const PanelSet&) = delete;  // its panels refer to its particles
    PanelSet& operator=(const PanelSet&) = delete;

    /// First pass, every frame in order. Cards show nothing of the gas: panels do not see them.
    void survey(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);
    void fix_axes();

    /// The first pass over a whole run, from a simulation at time 0; `see` sees each frame after
    /// the panels. Errors have their places in the scene file. At most `most` bytes are kept.
    /// Throws SceneError, Interrupted.
    Recording record(Simulation start, std::vector<Tick> ticks, const Recording::Viewer& see,
                     std::size_t most = Recording::most_bytes);

    /// Writes or reads what the first pass has fixed.
    void archive(Archive& archive);

    /// Second pass, every frame in order. Numbers in words stay the same for a fifth of a second,
    /// so that they can be read; in a still they are those of its frame.
    FrameData frame_data(const Tick& tick, const Sample& sample, const AdvanceResult& advanced,
                         bool is_still = false);

    /// Whether any panel needs the collisions on the way, in either pass.
    bool wants_collisions() const;

    /// Times at which the first pass measures return distances; none if no panel needs them.
    std::vector<double> return_times(const std::vector<Tick>& ticks) const;

    /// A panel and its place in the template's grid.
    struct Placed {
        Slot slot;
        std::unique_ptr<Panel> panel;
        std::optional<Showing> showing = {};  ///< none: throughout
        /// How much of it is seen in a frame, from 0 to 1.
        double opacity(const Film& film, const Tick& tick) const;
    };
    const std::vector<Placed>& panels() const { return panels_; }  ///< a film's gas is the first
    const Panel& gas() const { return *panels_.front().panel; }
    const Scene& scene() const { return scene_; }

  private:
    FrameInput input(const Tick& tick, const Sample& sample, const AdvanceResult& advanced);

    const Scene& scene_;
    Particles particles_;
    std::optional<EquilibriumGas> equilibrium_;
    std::vector<Placed> panels_;
    bool is_film_ = true;
    Eigen::ArrayXd speed_, energy_;  ///< of the present frame
};

/// The theme's page, behind everything that is not transparent.
Color page_color(const Film& film);

/// Draws frames of one film on one thread. Any number of painters may share a set whose axes are
/// fixed.
class FramePainter {
  public:
    explicit FramePainter(const PanelSet& panels);

    /// An empty raster such as the film's frames are drawn on.
    static Canvas blank(const Film& film);

    /// The picture of a frame, a pure function of `frame`; valid until the next call.
    const Canvas& paint(const FrameData& frame);

    /// Draws the same picture on another canvas of the film's size, as a still: a caption that
    /// or a panel that comes or goes is whole.
    void paint_on(Canvas& canvas, const FrameData& frame);

  private:
    DrawContext context_at(const Slot& slot);
    std::vector<double> opacities(const Tick& tick, bool still) const;
    void prepare_ground(const std::vector<double>& opacities);
    void draw_fading(Canvas& canvas, const PanelSet::Placed& placed, const PanelState& state,
                     double opacity);
    struct SetTitle {
        TextStyle style;
        std::vector<std::string> lines;
    };
    SetTitle set_title(const Rect& area) const;
    void draw_ground(Canvas& canvas, const std::vector<double>& opacities);
    void draw_title(Canvas& canvas) const;
    void draw_changing(Canvas& canvas, const FrameData& frame, const std::vector<double>& opacities,
                       bool still);
    void draw_callouts(Canvas& canvas, const FrameData& frame, bool still);
    void draw_announcement(Canvas& canvas, const Tick& tick) const;
    void draw_slowness(Canvas& canvas, const Tick& tick) const;
    double card_alpha(const Tick& tick) const;
    void draw_card(Canvas& canvas, const Tick& tick) const;
    void draw_caption(Canvas& canvas, const Tick& tick, bool still) const;

    const Scene& scene_;
    const PanelSet& panels_;
    const Theme& theme_;
    Grid grid_;
    double unit_;
    DiskPainter disks_;
    std::vector<CaptionSpan> captions_;
    std::vector<std::pair<const Callout*, Showing>> callouts_;  ///< to points of plots
    std::vector<bool> grounded_;  ///< the panels whose ground is in `ground_`
    Canvas ground_;               ///< what is the same in every frame with these panels
    Canvas canvas_;
};

}  // namespace carom

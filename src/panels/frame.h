// The painter that draws the frames of a film.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/callouts/cards.h"
#include "panels/layout.h"
#include "panels/panel_set.h"
#include "panels/plot_callouts.h"
#include "scene/time/captions.h"

namespace carom {

/// The colour of the theme's page; it is behind everything, unless the film is transparent.
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

    /// Draws the same picture on another canvas of the film's size, as a still: captions and panels
    /// that are just fading in or out are drawn at full opacity.
    void paint_on(Canvas& canvas, const FrameData& frame);

    /// Returns what does not fit into its place: texts of the scene that are cut with an ellipsis
    /// ("the title", "the caption “...”"), and panels whose places are too small or missing. Does
    /// not need the axes to be fixed.
    std::vector<std::string> cut_words();

  private:
    DrawContext context_at(const Slot& slot);
    std::vector<double> opacities(const Tick& tick, bool still) const;
    void prepare_ground(const std::vector<double>& opacities, bool has_title);
    void draw_fading(Canvas& canvas, const PanelSet::Placed& placed, const PanelState& state,
                     double opacity);
    PlacedWords title_place(double end) const;
    void draw_ground(Canvas& canvas, const std::vector<double>& opacities, bool has_title);
    void draw_title(Canvas& canvas, double end, bool has_title) const;
    bool has_subtitle_in_title() const;
    Panel::Key key();
    double end_of_title(const Panel::Key& key) const;
    void draw_whole(Canvas& canvas, const PanelSet::Placed& placed, const DrawContext& dc,
                    const PanelState& state);
    Rect before_numbers(Rect line) const;
    PlacedWords lines_of_caption(const std::string& words, const Rect& place,
                                 TextStyle style) const;
    PlacedWords caption_place(const std::string& words) const;
    void draw_changing(Canvas& canvas, const FrameData& frame, const std::vector<double>& opacities,
                       bool still);
    void draw_announcement(Canvas& canvas, const Tick& tick) const;
    void draw_slowness(Canvas& canvas, const Tick& tick) const;
    void draw_card(Canvas& canvas, const Tick& tick, double cover);
    void draw_captions(Canvas& canvas, const Tick& tick, bool still) const;
    void draw_caption(Canvas& canvas, const std::string& words, double alpha) const;

    const Scene& scene_;
    const PanelSet& panels_;
    const Theme& theme_;
    Grid grid_;
    double unit_;
    DiskPainter disks_;
    std::vector<CaptionSpan> captions_;
    std::optional<Showing> subtitle_;  ///< at the place of captions
    PlotCallouts callouts_;
    std::vector<bool> grounded_;  ///< the panels whose ground is in `ground_`, and the title
    Canvas ground_;               ///< what is the same in every frame that shows these panels
    Canvas canvas_;
};

}  // namespace carom

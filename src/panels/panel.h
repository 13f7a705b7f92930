// What a panel is: an observer that turns the run into immutable states, one a frame, and a pure
// function that draws a state. The run is seen twice: first without drawing, to fix axes and scales
// for the whole film, then frame by frame.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draw/axis.h"
#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/style.h"
#include "panels/table.h"
#include "physics/simulation.h"
#include "physics/theory/theory.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"

namespace carom {

class Archive;

/// What all panels of a film know from the start. Outlives them.
struct PanelContext {
    const Scene& scene;
    const Particles& particles;
    int frames;                                        ///< of the film
    const std::optional<EquilibriumGas>& equilibrium;  ///< of all particles; none: draw no curve
    bool in_film = true;  ///< so that there is a present, and names fade after a while
    Language language() const { return scene.film.language; }  ///< of the program's own words
};

/// The gas at one frame, and what happened since the frame before.
struct FrameInput {
    const Tick& tick;
    const Sample& sample;
    const Eigen::ArrayXd& speed;   ///< N
    const Eigen::ArrayXd& energy;  ///< N
    const AdvanceResult& advanced;
    bool refreshes_readouts = true;  ///< else numbers in words stay as they are
    bool is_still = false;           ///< what comes or goes is whole
};

/// What one panel shows in one frame: complete and immutable.
struct PanelState {
    virtual ~PanelState() = default;
    virtual std::size_t bytes() const { return 0; }  ///< beyond a small constant
};

/// Where and how to draw: an area of the canvas, the layout's unit, the theme, and the drawing
/// thread's own disk masks.
struct DrawContext {
    Rect area;
    double unit;  ///< pixels of one grid unit: the smallest size of text
    const Theme& theme;
    DiskPainter& disks;
};

class Panel {
  public:
    virtual ~Panel() = default;

    /// First pass, every frame in order.
    virtual void survey(const FrameInput&) {}

    /// Between the passes: fixes axes and scales.
    virtual void fix_axes() {}

    /// Writes or reads all that the first pass has fixed: axes, scales, records of the whole run.
    /// A panel that reads it has seen no first pass, and is ready for the second.
    virtual void archive(Archive& archive) = 0;

    /// Second pass, every frame in order.
    virtual std::shared_ptr<const PanelState> state(const FrameInput& input) = 0;

    /// Writes or reads all that state() keeps from frame to frame. A panel that reads it after
    /// archive() gives, from the next frame on, the states of one that has seen all frames before.
    virtual void archive_progress(Archive& archive) = 0;

    /// Draws what is the same in every frame. Called from any thread after fix_axes().
    virtual void draw_ground(Canvas& canvas, const DrawContext& dc) const = 0;

    /// Draws what changes, over the ground, at most one unit outside of the area. A pure function
    /// of the state.
    virtual void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const = 0;

    /// What draw_ground() and draw() show, as numbers; colours are those on a theme. No columns
    /// where there are none.
    virtual Table table(const PanelState& state, const Theme& theme) const = 0;

    /// What a caption says of a state beyond what it shows, in whole sentences; mostly nothing.
    virtual std::string finding(const PanelState&) const { return ""; }

    /// What it shows, with its numbers, in whole sentences: for captions and alternative texts that
    /// the scene does not give; mostly nothing.
    virtual std::string account(const PanelState&) const { return ""; }

    /// Whether its states need the collisions on the way.
    virtual bool wants_collisions() const { return false; }

    /// Whether its survey needs them.
    virtual bool surveys_collisions() const { return false; }

    /// Whether its survey looks at positions; where none does, samples of the first pass have none.
    virtual bool surveys_positions() const { return true; }

    /// Whether its survey needs the distances from the mirror states after a reversal.
    virtual bool wants_return_distances() const { return false; }

    /// Whether it shows the time, and beside it how slow the film is.
    virtual bool shows_time() const { return false; }

    /// The height, in units, beyond which it gains nothing and leaves room to others; none: it
    /// gains by any.
    virtual std::optional<double> enough_height() const { return {}; }

    /// Width and height, in units.
    struct Room {
        double width = 0.0, height = 0.0;
    };

    /// The least room in which what it shows can be read.
    virtual Room least_room() const { return {}; }

    /// What the scene asks for by name and an area has no room for: "the monitor `fast`". Mostly
    /// nothing.
    virtual std::vector<std::string> left_out(const DrawContext&) const { return {}; }

    /// What the panel fills of an area; `unit` as in DrawContext.
    virtual Rect frame_in(const Rect& area, double unit) const {
        (void)unit;
        return area;
    }

    /// Where on the canvas a point of its plot is in a state: what a callout points to. None where
    /// it has no axes, or the point lies beyond them.
    virtual std::optional<Point> place_of(const DrawContext&, const PanelState&,
                                          const PlotPoint&) const {
        return {};
    }

    /// Draws what its colours and arrows mean into an area beside it; `own` is the panel's.
    virtual void draw_key(Canvas&, const DrawContext&, const DrawContext& own) const { (void)own; }
};

/// Reports what a scene asks of a panel, at its place in the file.
[[noreturn]] void refuse(Diagnostic place, std::string message, std::string hint);

/// How much of what is behind a plate under words is covered.
constexpr double plate_alpha = 0.9;

/// The colours of a theme that a scene names.
const Theme& theme_of(ThemeName name);

/// Text of the panels: labels at the smallest size, titles a little larger.
TextStyle label_style(const DrawContext& dc);
TextStyle title_style(const DrawContext& dc);
AxisStyle axis_style(const DrawContext& dc);

/// The part of a panel's area that data fill: under the title, left and above the axes' labels.
Rect plot_area(const DrawContext& dc);

/// The height of a row of words between a panel's title and its plot, in units.
inline constexpr double note_height = 1.5;

/// How slow a film is, as a viewer reads it: ×0.1, and ×0 in a pause.
std::string slow_words(const Slowness& slow);

/// The panel's title at its top left (markup), smaller where it is too long.
void draw_panel_title(Canvas& canvas, const DrawContext& dc, const std::string& markup);

/// The first of some titles (markup, from the longest on) that is not cut; if all are, the last.
/// Empty where there are none.
std::string fitting_title(const DrawContext& dc, const std::vector<std::string>& titles);

/// In print, a sample of a line or a disk to stand before the words about it, as markup with a
/// space after it; elsewhere nothing, as the words have the colour.
std::string line_sample(std::size_t line, Color color, const Theme& theme);
std::string disk_sample(Color color, const Theme& theme);

/// Whether a disk is of a grey that hardly differs from the paper, so that it looks like a ring.
bool looks_hollow(Color color, const Theme& theme);

}  // namespace carom

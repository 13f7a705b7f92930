// The interface of panels. A panel is an observer that turns the run into immutable states, one for
// each frame, and a pure function that draws a state. It sees the run twice: first without drawing,
// to fix axes and scales for the whole film, then again to produce the states.
#pragma once

#include <Eigen/Core>
#include <array>
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
#include "physics/theory/law.h"
#include "physics/units/number_text.h"
#include "scene/looks.h"
#include "scene/panel_spec.h"
#include "scene/time/timeline.h"

namespace carom {

class Archive;
struct FigureSpec;
struct Film;
struct Gas;
struct Scene;
struct Species;
struct Style;
struct PlotPoint;

/// What all panels of a film know from the start. Must outlive the panels.
struct PanelContext {
    const Scene& scene;
    const Particles& particles;
    int frames;           ///< of the film
    const BoxedGas& gas;  ///< at the start, for law()
    bool in_film = true;  ///< then a present is marked, and names fade out after a while
    /// Of the runs that share a box, the number of the one whose colour its disks have; those
    /// after the first are drawn over it.
    std::optional<std::size_t> run_in_box = {};
    bool is_laid_over() const { return run_in_box.value_or(0) > 0; }

    // What most panels need of the scene, so that they need not know the rest of it.
    const Box& box() const;
    const std::vector<Species>& species() const;
    const Run& run() const;
    const Gas& gas_in_scene() const;  ///< before its particles were placed
    const Film& film() const;
    const std::vector<SpeciesLook>& looks() const;  ///< one for each species
    Language language() const;                      ///< of the program's texts
    Wording wording() const;                        ///< the same, and the units of numbers
};

/// The gas at one moment, and what happened since the moment before: a frame or, in the first pass,
/// what SurveyedAt says.
struct FrameInput {
    const Tick& tick;
    const Sample& sample;
    const Eigen::ArrayXd& speed;   ///< N
    const Eigen::ArrayXd& energy;  ///< N
    const AdvanceResult& advanced;
    bool refreshes_readouts = true;  ///< false: numbers in texts keep their values
    bool is_still = false;           ///< true: what is fading in or out is shown at full opacity
    bool is_frame = true;            ///< in the first pass: whether this moment is shown
    bool is_sample = true;           ///< in the first pass: whether it is a sample of the run
};

/// What a panel sees in the first pass. What is drawn belongs to the frames; what is measured
/// belongs to the samples of the run, which do not depend on the frames of a film.
enum class SurveyedAt { frames, samples, both };

/// A number that a panel shows, by the name with which words of its figure ask for it.
struct PanelNumber {
    std::string name;  ///< "mean", "light.mean"
    Quantity quantity;
    double value;
};

/// What one panel shows in one frame: complete and immutable.
struct PanelState {
    virtual ~PanelState() = default;
    virtual std::size_t bytes() const { return 0; }  ///< beyond a small constant
};

/// Where and how to draw: an area of the canvas, the unit of the layout, the theme, and the disk
/// masks, which belong to the drawing thread.
struct DrawContext {
    Rect area;
    double unit;  ///< pixels of one grid unit: the smallest size of text
    const Theme& theme;
    DiskPainter& disks;
    double growth = 1.0;  ///< share of the height of bars that has grown, while a panel enters
};

class GasColors;

class Panel {
  public:
    virtual ~Panel() = default;

    /// First pass, in order of time: at every moment that surveyed_at() names.
    virtual void survey(const FrameInput&) {}
    virtual SurveyedAt surveyed_at() const { return SurveyedAt::frames; }

    /// Between the passes: fixes axes and scales.
    virtual void fix_axes() {}

    /// Writes or reads all that the first pass has fixed: axes, scales, records of the whole run. A
    /// panel that has read it is ready for the second pass without a first one.
    virtual void archive(Archive& archive) = 0;

    /// Second pass, every frame in order.
    virtual std::shared_ptr<const PanelState> state(const FrameInput& input) = 0;

    /// Second pass, instead of state() for a frame that is not shown.
    virtual void see(const FrameInput& input) { state(input); }

    /// Writes or reads all that state() keeps from frame to frame. A panel that has read it after
    /// archive() gives, from the next frame on, the same states as a panel that has seen all frames
    /// before.
    virtual void archive_progress(Archive& archive) = 0;

    /// Draws what is the same in every frame. Called from any thread after fix_axes().
    virtual void draw_ground(Canvas& canvas, const DrawContext& dc) const = 0;

    /// Draws what changes over the ground; may extend at most one unit beyond the area. A pure
    /// function of the state.
    virtual void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const = 0;

    /// The numbers that draw_ground() and draw() show; colours are those of `theme`. Without
    /// columns if there are no numbers.
    virtual Table table(const PanelState& state, const Theme& theme) const = 0;

    /// What a caption adds to the picture of a state, in whole sentences; empty for most panels.
    virtual std::string finding(const PanelState&) const { return ""; }

    /// A description of what the panel shows, with its numbers, in whole sentences: for captions
    /// and alternative texts that the scene does not give; empty for most panels.
    virtual std::string account(const PanelState&) const { return ""; }

    /// The numbers that sum up what it shows; those of its kind (PanelKind::numbers), as far as it
    /// has them.
    virtual std::vector<PanelNumber> scalars(const PanelState&) const { return {}; }

    /// The simulated time of what a figure at the time `at` shows, from and until, if it is not
    /// what the figure's spec says: the time of a collision, or the time that is averaged over.
    /// Valid after fix_axes().
    virtual std::optional<std::array<double, 2>> time_shown(double at) const {
        (void)at;
        return {};
    }

    /// Whether what it shows is of the run; otherwise of what the scene gives in its place.
    virtual bool is_of_run() const { return true; }

    /// The names of the parts of the box that it shows instead of the whole; empty for most panels.
    virtual std::vector<std::string> parts() const { return {}; }

    /// Whether state() needs the collisions between frames.
    virtual bool wants_collisions() const { return false; }

    /// Whether survey() needs the collisions between its moments.
    virtual bool surveys_collisions() const { return false; }

    /// Whether survey() uses positions. If no panel does, the samples of the first pass have none.
    virtual bool surveys_positions() const { return true; }

    /// Whether survey() needs the distances from the mirror states after a reversal.
    virtual bool wants_return_distances() const { return false; }

    /// Whether the panel shows the time, and with it the factor of slow motion.
    virtual bool shows_time() const { return false; }

    /// The height, in units, beyond which the panel has no use for more room and leaves it to
    /// others; none: it always has.
    virtual std::optional<double> enough_height() const { return {}; }

    /// Width and height, in units.
    struct Room {
        double width = 0.0, height = 0.0;
    };

    /// The least room in which the panel is legible.
    virtual Room least_room() const { return {}; }

    /// The items that the scene asks for by name but that do not fit into the area: "the monitor
    /// `fast`". Empty for most panels.
    virtual std::vector<std::string> left_out(const DrawContext&) const { return {}; }

    /// The part of an area that the panel fills; `unit` as in DrawContext.
    virtual Rect frame_in(const Rect& area, double unit) const {
        (void)unit;
        return area;
    }

    /// The position on the canvas of a point of the plot in a state, for callouts. None if the
    /// panel has no axes or the point's x lies beyond them; a y beyond them is moved to their end.
    virtual std::optional<Point> place_of(const DrawContext&, const PanelState&,
                                          const PlotPoint&) const {
        return {};
    }

    /// Takes the colours of the gas in the same film, after all axes have been fixed.
    virtual void take_colors(const GasColors&) {}

    /// Whether the panel shows what the colours of the disks mean, so that no key has to.
    virtual bool explains_colors() const { return false; }

    /// The key of the panel's colours and arrows.
    struct Key {
        DrawContext at;        ///< its place
        DrawContext own;       ///< that of the panel itself
        bool is_row = false;   ///< in one line that ends at the right, instead of upright
        bool has_ramp = true;  ///< with the scale of the disks' colours
    };
    virtual void draw_key(Canvas&, const Key&) const {}

    /// The part of its place that a key in one line fills.
    virtual Rect place_of_key(const Key& key) const { return key.at.area; }
};

/// Rejects what a scene asks of a panel: throws SceneError with the place in the scene file.
[[noreturn]] void refuse(Diagnostic place, std::string message, std::string hint);

/// The opacity of a plate under text.
constexpr double plate_alpha = 0.9;

/// The colours of compared runs, in order, as #rrggbb; none: that of the theme.
using RunColors = std::vector<std::optional<std::string>>;

/// The colours and fonts of a theme, by its name in a scene: of the theme on which a style is
/// based, those of the style; of another, its own colours and the fonts of the style. They stay
/// valid until the program ends, and the same style always gives the same object.
const Theme& theme_of(ThemeName name, const Style* style = nullptr, const RunColors& runs = {});

/// Those of the pictures of a film, also as if it had another theme, and of a figure.
const Theme& theme_of(const Film& film);
const Theme& theme_of(const Film& film, ThemeName name);
const Theme& theme_of(const FigureSpec& figure);

/// The light, the dark and the print theme of a film.
std::array<const Theme*, 3> themes_of(const Film& film);

/// Text of the panels: labels at the smallest size, titles a little larger.
TextStyle label_style(const DrawContext& dc);
TextStyle title_style(const DrawContext& dc);
AxisStyle axis_style(const DrawContext& dc);

/// The part of a panel's area that data fill: below the title and inside the labels of the axes.
Rect plot_area(const DrawContext& dc);

/// The height of a row of words between a panel's title and its plot, in units.
inline constexpr double note_height = 1.5;

/// The factor of slow motion as a viewer reads it: ×0.1, and ×0 in a pause.
std::string slow_words(const Slowness& slow);

/// Draws the panel's title (markup) at its top left, smaller if it is too long.
void draw_panel_title(Canvas& canvas, const DrawContext& dc, const std::string& markup);

/// The first of some titles (markup, from longest to shortest) that fits without being cut; the
/// last if none fits. Empty if there are no titles.
std::string fitting_title(const DrawContext& dc, const std::vector<std::string>& titles);

/// In print, a swatch of a line or a disk to be put before the text about it, as markup followed by
/// a space. Empty on other themes, where the text itself is coloured.
std::string line_swatch(std::size_t line, Color color, const Theme& theme);
std::string disk_swatch(Color color, const Theme& theme);

/// Whether the grey of a disk differs so little from the paper that the disk looks like a ring.
bool looks_hollow(Color color, const Theme& theme);

}  // namespace carom

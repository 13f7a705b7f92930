// A figure as plain values: what it shows, when, how large, and the runs that it compares.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/looks.h"
#include "scene/panel_spec.h"
#include "scene/sweep.h"
#include "util/diagnostics.h"

namespace carom {

struct Scene;
struct Style;

/// The file formats of figures, as media/formats.h has them.
inline constexpr std::array figure_format_names{"svg", "pdf", "png", "csv"};

/// One of the runs that a figure or a film shows side by side.
struct ComparedRun {
    std::string label;                      ///< in the picture
    std::vector<std::string> values;        ///< overrides of its scene, as KEY.PATH=VALUE
    Diagnostic place = {};                  ///< with an empty message, for errors found later
    std::optional<std::string> color = {};  ///< #rrggbb, in plots; none: by its place
    std::shared_ptr<const Scene> scene =
        {};  ///< with these values; of a figure with this one only, which compares nothing there
};

/// A picture of one moment, or of several side by side, for a document or a slide.
struct FigureSpec {
    std::string name;  ///< of its files
    PanelSpec panel;   ///< its kind may be `gas` too; of numbers over a time, `over` is a window
    std::vector<double> times;     ///< simulated, in increasing order; several: a strip
    double width = 8.9;            ///< centimetres
    std::optional<double> height;  ///< centimetres; none: by kind
    bool slide = false;            ///< large type
    bool svg_has_text = false;     ///< words of an SVG are text, not outlines
    ThemeName theme = ThemeName::light;
    std::shared_ptr<const Style> style;       ///< null: none
    std::optional<std::string> caption, alt;  ///< none: made from what the figure shows
    std::vector<ComparedRun> compare = {};    ///< shown in one panel; empty: the scene's run alone
};

/// What a figure shows of a sweep; null if it shows none. And whether it does the runs of one
/// itself.
inline const SweepShown* sweep_of(const FigureSpec& figure) {
    return figure.panel.options.find<SweepShown>();
}

inline bool runs_sweep(const FigureSpec& figure) {
    return sweep_of(figure) != nullptr && !figure.panel.joined;
}

}  // namespace carom

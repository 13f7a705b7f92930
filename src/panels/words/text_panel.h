// A text in the place of a panel, with formulae: in the largest of a few fixed sizes that fits, and
// never cut. A line that consists of a formula only is centred.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

struct TextOptions {
    std::string words = {};  ///< with formulae
};

/// A text set in lines; an empty line is a gap between paragraphs.
struct SetWords {
    std::vector<std::string> lines;
    double size = 0.0;  ///< of the text, pixels
    const FontFamilies* fonts = nullptr;
};

/// Sets plain words in the largest of the fixed sizes, down to `unit`, in which they fit into a
/// width and a height (pixels); none if they fit in no size.
std::optional<SetWords> set_words(const std::string& words, double width, double height,
                                  double unit, const FontFamilies* fonts = nullptr);

/// The height of set words, pixels.
double height_of(const SetWords& set);

/// The error, with its place in the scene file, if the panel has words that do not fit into `place`
/// (pixels) in any of the sizes; otherwise none.
std::optional<Diagnostic> problem_of_words(const PanelSpec& spec, const Rect& place, double unit,
                                           const FontFamilies* fonts);

/// Throws SceneError if a panel of the film has words that do not fit into its place: one of
/// `places`, or that of the template, which may differ where a panel stands in the gas's place.
void refuse_long_words(const Scene& scene, const std::vector<Slot>& places);
void refuse_long_words(const Scene& scene);

}  // namespace carom

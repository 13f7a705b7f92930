// Words in a panel's place, with formulae: as large as they fit there, in whole steps of size,
// never cut. A line that is a formula alone stands in the middle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// Words set in lines; an empty line is a gap between paragraphs.
struct SetWords {
    std::vector<std::string> lines;
    double size = 0.0;  ///< of the text, pixels
};

/// Plain words in the largest step of size, down to `unit`, at which they fit into a width and a
/// height (pixels); none if they fit in none.
std::optional<SetWords> set_words(const std::string& words, double width, double height,
                                  double unit);

/// The height of set words, pixels.
double height_of(const SetWords& set);

/// What is wrong, with its place, where the words of a panel fit into its own place (pixels) in no
/// step of size.
std::optional<Diagnostic> problem_of_words(const PanelSpec& spec, const Rect& place, double unit);

/// Throws SceneError where a panel of the film has words that its place has no room for.
void refuse_long_words(const Scene& scene);

}  // namespace carom

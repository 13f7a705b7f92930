// The caption and the alternative text of a figure: those that the scene gives, or else generated
// from what the figure shows.
#pragma once

#include <string>

#include "figures/figure_run.h"

namespace carom {

struct FigureWords {
    std::string caption;  ///< with formulae between `$` signs; `\$` is a dollar sign
    std::string alt;      ///< plain text, for people who cannot see the picture
};

/// The simulated times that a figure shows: 12, 6 to 12, "0, 1 and 4".
std::string shown_times(Language language, const FigureSpec& spec);

/// The quantity that a key of a scene sets, in words: "temperature" for "gas.0.temperature.exact",
/// with the name of the species if there are several.
std::string words_of_key(Language language, const std::string& key, const Gas& gas);

/// The same with a value, written as in a scene: "radius 0.35".
std::string words_of_value(Language language, const std::string& key, const std::string& value,
                           const Gas& gas);

FigureWords words_of(const FigureRun& run, const Figure& figure);

}  // namespace carom

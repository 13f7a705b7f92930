// What a figure shows, in words: its caption and its alternative text, the scene's own or made from
// what is in it.
#pragma once

#include <string>

#include "figures/figure_run.h"

namespace carom {

struct FigureWords {
    std::string caption;  ///< with formulae between `$` signs; `\$` is a dollar sign
    std::string alt;      ///< plain text, for those who cannot see the picture
};

/// The simulated times that a figure shows: 12, 6 to 12, "0, 1 and 4".
std::string shown_times(Language language, const FigureSpec& spec);

/// What a key of a scene holds: "gas.0.temperature.exact" as "temperature", with the name of one of
/// several species.
std::string words_of_key(Language language, const std::string& key, const Gas& gas);

/// The same with a value, as it is written in a scene: "radius 0.35".
std::string words_of_value(Language language, const std::string& key, const std::string& value,
                           const Gas& gas);

FigureWords words_of(const FigureRun& run, const Figure& figure);

}  // namespace carom

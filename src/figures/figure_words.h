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

FigureWords words_of(const FigureRun& run, const Figure& figure);

}  // namespace carom

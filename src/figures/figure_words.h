// What a figure shows, in words: its caption and its alternative text, the scene's own or made from
// what is in it.
#pragma once

#include <string>

#include "figures/figure_run.h"

namespace carom {

struct FigureWords {
    std::string caption;  ///< plain text
    std::string alt;      ///< plain text, for those who cannot see the picture
};

FigureWords words_of(const FigureRun& run, const Figure& figure);

}  // namespace carom

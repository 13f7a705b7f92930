// What `carom check` reports of the figures of a set.
#pragma once

#include "app/figures/figure_set.h"
#include "app/report/facts.h"

namespace carom {

/// A part of a set and its figures, for programs.
Json section_value(const SetPart& part);

/// A row for each scene of a set, each comparison and each figure.
Facts section_rows(const FigureSet& set);

}  // namespace carom

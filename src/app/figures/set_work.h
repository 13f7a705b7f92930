// What the figures of a set take, so that it can be refused or reported before they are made.
#pragma once

#include <string>
#include <vector>

#include "app/figures/figure_set.h"
#include "films/cost/work.h"

namespace carom {

/// The work of the figures with these names (none: all) and, with `films`, of the films of the
/// scenes. Figures that are up to date already are counted too. Throws what try_run() throws.
Work work_of_set(const FigureSet& set, const std::vector<std::string>& only, bool films);

}  // namespace carom

// Runs a scene for its figures without writing files.
#pragma once

#include "figures/figure_run.h"

namespace carom::test {

inline FigureRun run_of(const Scene& scene, int threads = 1) { return FigureRun(scene, threads); }

}  // namespace carom::test

// What it takes that panels see a run, by what they do with it (PanelWork).
#pragma once

#include <string>

#include "films/cost/trial_run.h"
#include "physics/run.h"

namespace carom {

struct PanelSpec;
struct Scene;

/// CPU seconds in which a panel sees `frames` frames of a run and is read in `pictures` of them.
double panel_seconds(const Scene& scene, const PanelSpec& panel, double frames, double pictures,
                     const RunCounts& counts);

/// What makes that less: keys of the panel or of the run.
std::string reduces_panel(const PanelSpec& panel, const Run& run);

}  // namespace carom

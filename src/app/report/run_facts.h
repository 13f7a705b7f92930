// What a run was like, for people and for programs.
#pragma once

#include <string>

#include "runs/run.h"
#include "scene/scene.h"

namespace carom {

/// A table that fits on a screen of 80 columns if the names do.
std::string run_table(const Scene& scene, const RunReport& report);

/// The report of `carom run --json`: one object in UTF-8, numbers with all their digits, `null` for
/// what has no meaning; ends with a line break.
std::string run_json(const Scene& scene, const RunReport& report);

/// The seconds of each stage, and events per second.
std::string run_timings(const RunReport& report);

}  // namespace carom

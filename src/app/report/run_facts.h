// The report of a run, for people and for programs.
#pragma once

#include <string>

#include "runs/run.h"

namespace carom {

struct Scene;

/// A table for people, at most 80 columns wide unless names are long.
std::string run_table(const Scene& scene, const RunReport& report);

/// The output of `carom run --json`: one object in UTF-8, numbers with all their digits, `null` for
/// values that have no meaning; ends with a line break.
std::string run_json(const Scene& scene, const RunReport& report);

/// The seconds of each stage, and events per second.
std::string run_timings(const RunReport& report);

}  // namespace carom

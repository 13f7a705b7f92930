// What a run was like, for programs.
#pragma once

#include <string>

#include "app/report/run.h"
#include "scene/scene.h"

namespace carom {

/// The report of `carom run --json`: one object in UTF-8, numbers with all their digits, `null` for
/// what has no meaning; ends with a line break.
std::string run_json(const Scene& scene, const RunReport& report);

}  // namespace carom

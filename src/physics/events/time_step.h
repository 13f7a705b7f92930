// Which runs can advance in steps of fixed length (Run::time_step). Any function may be called from
// any thread.
#pragma once

#include <optional>

#include "physics/box.h"
#include "physics/run.h"
#include "physics/surfaces/surface_problem.h"

namespace carom {

/// Why a run in this box cannot use its time step; nothing if it can, or if it has none.
std::optional<ProblemText> time_step_problem(const Box& box, const Run& run);

}  // namespace carom

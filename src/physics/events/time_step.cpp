#include "physics/events/time_step.h"

#include <algorithm>
#include <cmath>

namespace carom {

std::optional<ProblemText> time_step_problem(const Box& box, const Run& run) {
    if (!run.time_step) return std::nullopt;
    if (!(*run.time_step > 0.0) || !std::isfinite(*run.time_step))
        return ProblemText{"a time step is positive and finite", "leave it out"};
    if (box.dimension == 1)
        return ProblemText{"beads on a wire do not move in time steps", "leave it out"};
    if (run.bits != bits_of_double)
        return ProblemText{"time steps are calculated in double precision",
                           "leave out `precision`, or the time step"};
    if (act_on_box(run.events) || !box.surfaces.are_plain())
        return ProblemText{
            "with a time step there are only walls that reflect as mirrors do, without gravity and "
            "obstacles",
            "leave it out"};
    return std::nullopt;
}

}  // namespace carom

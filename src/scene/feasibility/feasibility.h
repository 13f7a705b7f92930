// What physics finds wrong with a gas, said at the place of the scene where it is written. Decides
// nothing itself (physics/placement/feasibility.h).
#pragma once

#include <cstdint>
#include <vector>

#include "physics/placement/problem.h"
#include "physics/surfaces/surface_problem.h"
#include "scene/reading/gas_reading.h"

namespace carom {

/// Where surfaces and events are written, by their numbers; null: a side that is not.
struct SurfaceNodes {
    const Run& run;
    const std::vector<const Node*>& surfaces;
    const std::vector<const Node*>& events;
};

/// Reports what no surface can be, and what no event can do to it; of a gas without other errors
/// also when it would be crushed.
void check_surfaces(const Gas& gas, const SurfaceNodes& nodes, Errors& errors);

/// Reports what keeps the species from being placed in the box, and where there are no other
/// errors, what would keep them from moving.
void check_feasibility(const Box& box, const std::vector<SpeciesDraft>& drafts, std::uint64_t seed,
                       const Run& run, Errors& errors);

/// A problem that is found when a scene is run, at its species.
SceneError scene_error(const Scene& scene, const PlacementError& error);

}  // namespace carom

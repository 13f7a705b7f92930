// Reports what makes a gas physically impossible, at the place in the scene where it is written.
// The checks themselves are in physics/placement/feasibility.h.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/placement/problem.h"
#include "physics/surfaces/surface_problem.h"
#include "scene/reading/gas_reading.h"

namespace carom {

struct Scene;

/// The nodes of surfaces and events, indexed by their numbers; null: a side that is not in the
/// file.
struct SurfaceNodes {
    const Run& run;
    const std::vector<const Node*>& surfaces;
    const std::vector<const Node*>& events;
};

/// Reports impossible surfaces and events that cannot act on their surface; for a gas without other
/// errors, also surfaces whose motion would crush it.
void check_surfaces(const Gas& gas, const SurfaceNodes& nodes, Errors& errors);

/// Reports what prevents the species from being placed in the box and, if there are no other
/// errors, what would prevent them from moving.
void check_feasibility(const Box& box, const std::vector<SpeciesDraft>& drafts, std::uint64_t seed,
                       const Run& run, Errors& errors);

/// Returns the error for a placement problem found when a scene is run, at the place of its
/// species.
SceneError scene_error(const Scene& scene, const PlacementError& error);

}  // namespace carom

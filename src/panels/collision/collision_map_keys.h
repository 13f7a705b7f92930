// The options of collision maps: the pair, if it is not one of the scene, and how it is shown.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_spec.h"

namespace carom {

/// Two colliding beads, which need not exist in the scene.
struct GivenPair {
    Eigen::Array2d inverse_mass;  ///< 0: infinite mass, at most one of the two
    Eigen::Array2d velocity;      ///< before the collision; unequal
};

struct CollisionMapOptions {
    std::optional<GivenPair> given = {};  ///< none: a pair of the run
    bool walk = false;                    ///< all collisions so far
    std::optional<bool> scaled = {};      ///< by the roots of the masses; none: walks
};

std::vector<Binding<CollisionMapOptions>> collision_map_keys();

/// Reports a map for disks, which have two velocity components each; a pair that is given
/// incompletely or twice; and a pair that never collides.
void check_collision_map(PanelSpec& panel, const Node& node, Reading& reading);

}  // namespace carom

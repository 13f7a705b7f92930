// The paths that followed particles take in runs with other seeds, drawn faintly under the gas.
#pragma once

#include <vector>

#include "panels/panel.h"

namespace carom {

class Archive;

/// The path of one particle in one run.
struct SeedPath {
    std::vector<double> time;  ///< simulated
    std::vector<Point> place;  ///< scene units
    std::vector<int> piece;    ///< of the path, which a periodic side interrupts
    void archive(auto& archive) { archive(time, place, piece); }
};

/// Simulates the scene with as many of the seeds that follow its own as `trails` of the film says,
/// and returns the paths of these particles. Throws SceneError, Interrupted.
std::vector<SeedPath> seed_paths(const PanelContext& context,
                                 const std::vector<Eigen::Index>& particles);

}  // namespace carom

// The scenes at the points of a sweep, and what one of their runs costs.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/progress.h"
#include "scene/load.h"
#include "scene/sweep.h"

namespace carom {

/// A scene file as it was read, and what is laid over it at all points.
struct SweptScene {
    std::string text;
    std::string path;      ///< of the file, as the user gave it
    FileTexts files = {};  ///< that it names, as they were read
    Overrides overrides = {};
};

/// The scene at a point. Throws SceneError: mistakes in values of an axis stand at `--vary`, others
/// name the point.
std::shared_ptr<const Scene> scene_at_point(const SweptScene& swept, const Sweep& sweep,
                                            std::int64_t point);

/// What a run needs.
struct RunCost {
    double seconds = 0.0;                      ///< on one core
    std::int64_t memory_bytes = 0;             ///< of the process that does it
    std::int64_t memory_bytes_per_thread = 0;  ///< of each further run at the same time
};

/// Measured on the first point's run with the first seed and, of several points, the last one's;
/// runs that take longer than a few seconds are not finished. The greater of both.
RunCost cost_of_runs(const SweptScene& swept, const Sweep& sweep, Progress& progress);

}  // namespace carom

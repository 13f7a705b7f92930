// The scenes at the points of a sweep, and what one of their runs costs.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "scene/load.h"
#include "scene/scene.h"
#include "scene/sweep.h"
#include "util/progress.h"

namespace carom {

/// A scene file as it was read, and the overrides that apply at all points.
struct SweptScene {
    std::string text;
    std::string path;      ///< of the file, as the user gave it
    FileTexts files = {};  ///< files that it names, as they were read
    Overrides overrides = {};
    bool is_classroom = false;  ///< whether the limits of classroom.h apply at all points
};

/// The scene at a point. Throws SceneError: mistakes in values of an axis refer to `--vary`, others
/// name the point.
std::shared_ptr<const Scene> scene_at_point(const SweptScene& swept, const Sweep& sweep,
                                            std::int64_t point);

/// Time and memory that a run needs.
struct RunCost {
    double seconds = 0.0;                      ///< on one core
    std::int64_t memory_bytes = 0;             ///< of a process that does one run at a time
    std::int64_t memory_bytes_per_thread = 0;  ///< for each further run at the same time
};

/// The cost of a run, measured with the first seed at the first point and, if there are several
/// points, at the last one: the greater of both. Runs that take longer than a few seconds are
/// stopped early and extrapolated.
RunCost cost_of_runs(const SweptScene& swept, const Sweep& sweep, Progress& progress);

}  // namespace carom

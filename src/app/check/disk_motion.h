// How the disks of a film look while they move: how wide they are, and how far they travel from one
// frame to the next. A disk that travels more than half of its diameter is no longer seen to move:
// it seems to jump.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/facts.h"
#include "films/cost/trial_run.h"
#include "physics/particles.h"
#include "physics/run.h"

namespace carom {

struct Film;
struct Scene;

/// The disks of one species in a film. Means over its disks, which may differ in radius.
struct DiskMotion {
    std::string species;
    std::string run = {};    ///< of a film with two runs, the label of its box
    double pixels = 0.0;     ///< diameter
    double diameters = 0.0;  ///< the mean way from one frame to the next, divided by the diameter,
                             ///< where it is longest
    double time = 0.0;       ///< simulated, of this
};

/// Those of a scene's film, with `scale` pixels per unit length, as far as the speeds in its run
/// are known (RunCounts::speeds). Without species of points; none of beads on a line.
std::vector<DiskMotion> disk_motion(const Scene& scene, const Particles& drawn,
                                    const std::vector<MeanSpeeds>& speeds, double scale);

/// The list for programs.
Json motion_value(const std::vector<DiskMotion>& disks);

/// Rows about disks that travel too far, unless streaks show their ways, and about those that are
/// too small.
Facts motion_rows(const Scene& scene, const std::vector<DiskMotion>& disks);

}  // namespace carom

// What no simulation can be: boxes, particles, states, runs and events that are refused. Each
// function throws std::invalid_argument. Functions may be called from any thread.
#pragma once

#include <vector>

#include "physics/gas.h"
#include "physics/particles.h"
#include "physics/run.h"

namespace carom {

void check_box(const Box& box);

/// Of a box that passes check_box(), as all below.
void check_particles(const Box& box, const Particles& particles);

/// Particles, and their state.
void check_start(const Box& box, const Particles& particles, const Sample& start);

void check_surfaces(const Box& box, const Run& run);
/// Also of particles that lie in a surface.
void check_surfaces(const Box& box, const Particles& particles, const Sample& start,
                    const Run& run);

/// Returns the bits.
int check_run(const Run& run, Eigen::Index particles, const Box& box);

/// Of events that are to come after `present`.
void check_events(const std::vector<RunEvent>& events, double present, Eigen::Index particles,
                  const Box& box);

/// Whether an event needs the loop of boxes with surfaces.
bool needs_surfaces(const RunEvent& event);

}  // namespace carom

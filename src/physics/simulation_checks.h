// Validation of boxes, particles, states, runs and events before a simulation. The check_ functions
// throw std::invalid_argument if their input is invalid. All functions may be called from any
// thread.
#pragma once

#include <vector>

#include "physics/box.h"
#include "physics/particles.h"
#include "physics/run.h"

namespace carom {

void check_box(const Box& box);

/// The box must have passed check_box(), here and below.
void check_particles(const Box& box, const Particles& particles);

/// Checks particles and their initial state.
void check_start(const Box& box, const Particles& particles, const Sample& start);

void check_surfaces(const Box& box, const Run& run);
/// Also refuses particles that lie in a surface.
void check_surfaces(const Box& box, const Particles& particles, const Sample& start,
                    const Run& run);

/// Returns the significand bits of the run.
int check_run(const Run& run, Eigen::Index particles, const Box& box);

/// Checks future events, none of which may lie before `present`.
void check_events(const std::vector<RunEvent>& events, double present, Eigen::Index particles,
                  const Box& box);

}  // namespace carom

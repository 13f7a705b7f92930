// How what a film shows moves from frame to frame, for its encoder.
#pragma once

#include "media/film_writer.h"
#include "physics/particles.h"
#include "scene/scene.h"

namespace carom {

/// Of a film of this scene, whose gas begins with these particles and velocities; by its size, its
/// frame rate and the length of its run, so that all parts of a film have the same. Without
/// particles, as films that are joined of several have them, it is the usual one.
Motion motion_of(const Scene& scene, const Particles& particles, const Sample& start);

}  // namespace carom

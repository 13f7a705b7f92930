// Classifies the motion from frame to frame in a film, for the settings of its encoder.
#pragma once

#include "media/film_writer.h"
#include "physics/particles.h"

namespace carom {

struct Scene;

/// The motion in the film of a scene whose gas begins with these particles and velocities. Depends
/// on the picture size, the frame rate and the length of the run, so that all parts of a film get
/// the same result. Returns Motion::usual without particles, as for films joined from several.
Motion motion_of(const Scene& scene, const Particles& particles, const Sample& start);

}  // namespace carom

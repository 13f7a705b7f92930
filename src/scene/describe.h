// What a scene shows, in words for those who cannot see it.
#pragma once

#include <string>

#include "scene/scene.h"

namespace carom {

/// What the film shows, in a plain sentence or two.
std::string describe(const Scene& scene);

/// "Particle 3 is moved by 1.00×10⁻²⁰": a whole sentence without its full stop.
std::string words_of(const Perturbation& nudge);

/// What the events of a run do, in whole sentences; empty if there are none. Of many nudges only
/// how many they are.
std::string words_of_events(const Run& run);

}  // namespace carom

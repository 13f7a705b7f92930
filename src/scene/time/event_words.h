// What happens to the gas on the way, in words for those who cannot see it.
#pragma once

#include <string>

#include "physics/run.h"

namespace carom {

/// "Particle 3 is moved by 1.00×10⁻²⁰": a whole sentence without its full stop.
std::string words_of(const Perturbation& nudge);

/// What the events of a run do, in whole sentences; empty if there are none. Of many nudges only
/// how many they are.
std::string words_of_events(const Run& run);

}  // namespace carom

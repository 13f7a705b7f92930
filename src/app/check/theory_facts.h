// The part of a report about theory: for which panels there is none, and why.
#pragma once

#include <string>
#include <vector>

#include "physics/theory/law.h"

namespace carom {

struct Scene;

/// A line for each panel of the film and each figure that shows theory where there is a law, and
/// for this gas there is none: its name and the reason.
std::vector<std::string> missing_theory(const Scene& scene, const BoxedGas& gas);

}  // namespace carom

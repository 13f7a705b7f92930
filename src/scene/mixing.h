// Whether a gas comes to an equilibrium that theory knows, as far as its rules tell before anything
// is drawn from them: why a curve that a scene asks for cannot be drawn.
#pragma once

#include <optional>
#include <string>

#include "physics/gas.h"

namespace carom {

/// Why there is no equilibrium curve for this gas, in words; nothing if none is known. What only
/// drawn masses, velocities and places decide is not looked at.
std::optional<std::string> why_no_equilibrium(const Gas& gas);

}  // namespace carom

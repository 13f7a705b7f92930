// Checks a scene against those parts of the Web Content Accessibility Guidelines 2.1, levels A and
// AA, that depend on it: text alternatives, colour, text size, flashes, motion that cannot be
// stopped. https://www.w3.org/TR/WCAG21/
#pragma once

#include <vector>

#include "media/formats.h"
#include "util/diagnostics.h"

namespace carom {

struct Scene;

/// The barriers that keep some viewers from the film of a scene, each with the number of the
/// success criterion and a way to remove it; empty if there are none. `format` is the format of the
/// film; null means one that is shown in a player. Flashes are estimated from the speed and the
/// density of the gas.
std::vector<Diagnostic> barriers_in(const Scene& scene, const OutputFormat* format);

}  // namespace carom

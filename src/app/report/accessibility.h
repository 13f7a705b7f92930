// What of the Web Content Accessibility Guidelines 2.1, levels A and AA, a scene decides: text
// alternatives, colour, size of text, flashes, motion that cannot be stopped.
// https://www.w3.org/TR/WCAG21/
#pragma once

#include <vector>

#include "media/formats.h"
#include "scene/scene.h"
#include "util/diagnostics.h"

namespace carom {

/// What keeps some viewers from the film of a scene, each with the number of the success criterion
/// and how to mend it; of films in `format`, null for those with a player. Empty where nothing
/// does. Flashes are estimated from how fast and how dense the gas is.
std::vector<Diagnostic> barriers_in(const Scene& scene, const OutputFormat* format);

}  // namespace carom

// Whether this machine has the letters that a scene's words are written in.
#pragma once

#include "scene/scene.h"

namespace carom {

/// Throws SystemError where a picture of the scene would show empty boxes instead of letters, or
/// where there is no font at all.
void require_letters(const Scene& scene);

}  // namespace carom

// The templates and panel kinds of carom, in the form that the scene loader expects.
#pragma once

#include "panels/registry.h"
#include "scene/load.h"
#include "support/test_root.h"

namespace carom::test {

/// The templates of this checkout, and all panel kinds.
inline SceneResources resources() { return {checkout() / "templates", panel_kinds()}; }

}  // namespace carom::test

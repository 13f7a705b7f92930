// What carom brings along for scenes, as the loader takes it.
#pragma once

#include "panels/registry.h"
#include "scene/load.h"
#include "support/test_root.h"

namespace carom::test {

/// The templates of the checkout, and all kinds of panel.
inline SceneResources resources() { return {checkout() / "templates", panel_kinds()}; }

}  // namespace carom::test

// The keys of a scene's `figures`, and of the comparisons of a set, and what they mean together.
#pragma once

#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// The figures that a scene lists. Names are files of their own, times lie in the run. `kinds` as
/// MadeOnce takes them.
const Notation<std::vector<FigureSpec>>& figures_notation(PanelKinds kinds);

/// A comparison of a set, as a figure of one of its scenes: the keys of a figure that shows several
/// runs, with `scenes`, which are kept for others to read.
Notation<FigureSpec> comparison_notation(PanelKinds kinds, const Notation<const Node*>& scenes);

/// The keys of a compared run: its name, and what is laid over its scene.
Binding<ComparedRun> label_key();
Binding<ComparedRun> changes_key();

/// Notes where a compared run is written.
void place_run(ComparedRun& run, const Node& node, Reading& reading);

}  // namespace carom

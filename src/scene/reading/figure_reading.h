// The keys of a scene's `figures`, and of the comparisons of a set, and what they mean together.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// The figures that a scene lists. Names are files of their own, times lie in the run.
Notation<std::vector<FigureSpec>> figures_notation(PanelKinds kinds);

/// A comparison of a set, as a figure of one of its scenes: the keys of a figure that shows several
/// runs, with `scenes`, which are kept for others to read.
Notation<FigureSpec> comparison_notation(PanelKinds kinds, const Notation<const Node*>& scenes);

/// What is laid over the scene of a compared run: KEY.PATH=VALUE, or a list of these.
Notation<std::vector<std::string>> changes_notation();
inline constexpr const char* meaning_of_changes =
    "The values that differ in its scene: KEY.PATH=VALUE as for `--set`, or a list of these.";

/// KEY.PATH=VALUE as a key path and a value.
std::pair<std::string, std::string> parted_change(const std::string& change);

}  // namespace carom

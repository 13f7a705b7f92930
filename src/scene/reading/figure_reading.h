// The keys of a scene's `figures` and of the comparisons of a figure set, with the rules between
// them.
#pragma once

#include <vector>

#include "scene/figure_spec.h"
#include "scene/keys/binding.h"
#include "scene/panel_kind.h"

namespace carom {

/// The notation of a scene's list of figures. Reports names that are used twice, since each figure
/// writes its own files, and times outside the run. For `kinds` see MadeOnce.
const Notation<std::vector<FigureSpec>>& figures_notation(PanelKinds kinds);

/// The width of a figure on paper, in centimetres.
Notation<double> width_notation();

/// The file formats of figures.
Notation<std::vector<std::string>> figure_formats_notation();

/// Keys that the figures of a scene or of a set have unless they give them themselves.
struct FigureDefaults : FigureSpec {
    std::vector<std::string> formats;
};

/// The table of keys of `figure_defaults`.
const FixedTable<FigureDefaults>& figure_defaults_table();

/// Gives a figure, or each of a list, the keys of `defaults` that it does not give itself. Both
/// have been checked.
void add_defaults(Node& figure, const Node& defaults);
void add_defaults_to_all(Node& figures, const Node& defaults);

/// The notation of a comparison of a figure set, read as a figure of one of its scenes: the keys of
/// a figure that shows several runs, and `scenes`, whose node is kept unread.
Notation<FigureSpec> comparison_notation(PanelKinds kinds, const Notation<const Node*>& scenes);

/// The keys of a compared run: its label, the values that it changes in its scene, and its colour.
Binding<ComparedRun> label_key();
Binding<ComparedRun> changes_key();
Binding<ComparedRun> run_color_key();

/// Stores in `run` its place in the file, for errors that are found later.
void place_run(ComparedRun& run, const Node& node, Reading& reading);

}  // namespace carom

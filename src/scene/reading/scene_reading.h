// The keys of a whole scene: the notations of its parts put together.
#pragma once

#include <optional>
#include <vector>

#include "scene/keys/made_once.h"
#include "scene/panel_kind.h"
#include "scene/reading/gas_reading.h"
#include "scene/reading/run_reading.h"
#include "scene/reading/surface_reading.h"
#include "scene/scene.h"

namespace carom {

/// The version of the scene format that this program reads.
inline constexpr int scene_format = 1;

/// A scene as it is written. Refers to its nodes.
struct SceneDraft : Scene, SurfacesDraft {
    int format = scene_format;
    std::optional<BoxDraft> box;
    std::vector<SpeciesDraft> species;
    RunDraft written_run;
    std::vector<const Node*> surface_nodes;  ///< by the numbers of surfaces; null: not written
    const Node* film_node = nullptr;         ///< to be read over its template
    const Node* figures_node = nullptr;      ///< to be read when the gas and the run are known
};

/// A scene with a box of one dimension or of two. `kinds` as MadeOnce takes them.
const FixedTable<SceneDraft>& scene_table(PanelKinds kinds, int dimension);

}  // namespace carom

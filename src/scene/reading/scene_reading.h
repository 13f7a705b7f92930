// The keys of a whole scene, put together from the notations of its parts.
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

/// A scene as read from the file. Holds pointers to its nodes, which must outlive it.
struct SceneDraft : Scene, SurfacesDraft {
    int format = scene_format;
    std::optional<BoxDraft> box;
    double scale = 1.0;  ///< of the diameters in pictures
    std::vector<SpeciesDraft> species;
    RunDraft written_run;
    std::vector<const Node*> surface_nodes;  ///< indexed by surface number; null: not in the file
    const Node* film_node = nullptr;         ///< read later, combined with its template
    const Node* figures_node = nullptr;      ///< read later, when the gas and the run are known
    const Node* defaults_node = nullptr;     ///< of figures; the same
    std::string style_name;                  ///< its file is read before the scene
    const Node* measure_node = nullptr;      ///< the same
};

/// The table of keys of a scene with a box of one, two or three dimensions. For `kinds` see
/// MadeOnce.
const FixedTable<SceneDraft>& scene_table(PanelKinds kinds, int dimension);

}  // namespace carom

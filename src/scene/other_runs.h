// The further runs that a scene is shown with: those that its figures compare, and the second run
// of its film. Each is a scene of its own, which the loader reads again with other values.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/overrides.h"
#include "scene/panel_kind.h"
#include "scene/yaml/node.h"
#include "util/diagnostics.h"

namespace carom {

struct ComparedRun;
struct Scene;

/// The part of a scene that is loaded for another scene. For a run that a figure compares, only
/// that figure is read, if the scene has it. For the second run of a film, the film and the end of
/// the run are taken from the other scene.
struct ScenePart {
    std::optional<std::string> figure = {};
    const Node* film = nullptr;
    const Node* until = nullptr;

    bool is_whole() const { return !figure && film == nullptr; }
};

/// Reduces a scene's tree to such a part.
void keep_part(Node& root, const ScenePart& part);

/// Reduces a scene's tree to its run, without film and figures.
void keep_run(Node& root);

/// Throws SceneError if loading all compared runs, each a scene of its own, would take too much
/// time and memory.
void refuse_many_scenes(const Scene& scene);

/// Loads the scene with overrides and, of its figures, only the one of this name.
using ReloadCompared = std::function<Scene(const std::string& figure, const Overrides&)>;

/// Whether a figure of this kind cannot compare the run with the first of its runs, because their
/// boxes have different numbers of dimensions: an error at the run.
std::optional<Diagnostic> of_another_dimension(const ComparedRun& run, const Scene& first,
                                               const std::string& kind, PanelKinds kinds);

/// Loads the runs that figures compare, with boxes of one dimension unless the kind of the figure
/// can compare any. Throws SceneError with the errors of all of them.
void load_compared(Scene& scene, PanelKinds kinds, const Overrides& overrides,
                   const ReloadCompared& reload);

/// Loads, as a part, the scene in a file in the same folder, or the scene itself if the name is
/// empty.
using ReloadBeside =
    std::function<Scene(const std::string& file, const ScenePart&, const Overrides&)>;

/// Loads the second run that a film shows, if there is one. The film's times, captions and callouts
/// are those of the scene itself. Throws SceneError.
void load_beside(Scene& scene, const Node& root, const Overrides& overrides,
                 const ReloadBeside& reload);

}  // namespace carom

// The runs that a scene is shown with: those that its figures compare, and the one beside its
// film's own. Each is a scene, which the loader makes anew.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/overrides.h"
#include "scene/scene.h"
#include "scene/yaml/node.h"

namespace carom {

/// A scene as another's: of a run that a figure compares, that figure is the only one that is
/// looked at, if it is here; of the run beside a film's, the film and the end of the run are the
/// other's.
struct ScenePart {
    std::optional<std::string> figure = {};
    const Node* film = nullptr;
    const Node* until = nullptr;

    bool is_whole() const { return !figure && film == nullptr; }
};

/// Leaves of a scene what the part is.
void keep_part(Node& root, const ScenePart& part);

/// Throws SceneError where so many compared runs, each a scene of its own in time and memory, would
/// be too much.
void refuse_many_scenes(const Scene& scene);

/// The scene with overrides, of its figures only the one of this name.
using ReloadCompared = std::function<Scene(const std::string& figure, const Overrides&)>;

/// Loads the runs that figures compare. Throws SceneError with the mistakes of all of them.
void load_compared(Scene& scene, const Overrides& overrides, const ReloadCompared& reload);

/// The scene in a file beside this one, or this one where there is no name, as a part.
using ReloadBeside =
    std::function<Scene(const std::string& file, const ScenePart&, const Overrides&)>;

/// Loads the run beside the film's, if there is one; the film's times, words and callouts are those
/// of the scene itself. Throws SceneError.
void load_beside(Scene& scene, const Node& root, const Overrides& overrides,
                 const ReloadBeside& reload);

}  // namespace carom

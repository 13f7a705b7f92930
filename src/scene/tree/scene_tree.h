// The trees of a scene and of the files that it names: its template and its style.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "scene/style/style.h"
#include "scene/tree/resources.h"
#include "scene/yaml/node.h"

namespace carom {

/// The trees of a scene, its template and its style; their form has been checked.
struct SceneTree {
    Node root;
    int dimension = 2;  ///< of the box
    Node film;          ///< the scene's `film`, completed by its template
    Node template_file;
    std::string template_name;
    std::shared_ptr<const Style> style;  ///< null: none
    Node style_file;
};

/// Returns the dimension of the box that a scene gives, 1 to 3, before the scene is checked: keys
/// and forms depend on it.
int dimension_of(const Node& root);

/// Reads the files that the checked scene `tree.root` at the path `scene` names, or their usual
/// ones, and completes its film; they are added to `sources`, which must outlive the tree. The
/// fonts of a style are looked for if pictures are wanted.
void read_named_files(SceneTree& tree, const std::filesystem::path& scene,
                      const SceneResources& resources, Wanted wanted, Sources& sources,
                      Errors& errors);

}  // namespace carom

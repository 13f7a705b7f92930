// Templates of films: how their files are found, their layout, and how their keys are combined with
// those of a scene's `film`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/layout.h"
#include "scene/yaml/node.h"

namespace carom {

/// A file that holds a template, and the name under which a scene knows it.
struct TemplateFile {
    std::string name;
    std::filesystem::path path;
};

/// Files that scenes know by name: templates of films, or styles.
struct NamedFiles {
    const char* what;    ///< a "template"
    const char* folder;  ///< in templates/
    bool has_ending;     ///< whether names may end in .yaml
};
inline constexpr NamedFiles film_templates{"template", "films", false},
    style_files{"style", "styles", true};

/// Finds a template or a style: first in the folder of the scene file `scene`, then in the folder
/// of such files in `templates`. `asked` is the node that gives its name. Reports an unknown one,
/// with the names of those available, and returns nothing.
std::optional<TemplateFile> find_template(const Node& asked, const std::filesystem::path& scene,
                                          const std::filesystem::path& templates, Errors& errors,
                                          const NamedFiles& kind = film_templates);

/// Where a file that find_template() has found may be among the texts of a scene's other files,
/// which are used instead, wherever the scene is now.
std::vector<std::filesystem::path> named_paths(const Node& asked,
                                               const std::filesystem::path& scene,
                                               const NamedFiles& kind);

/// Returns whether a file lies directly in a folder after symbolic links are followed.
bool stays_inside(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The notation of a layout, the places of everything in a frame. It reads as nothing if an error
/// leaves the layout undetermined.
Notation<LayoutSpec> layout_notation();

/// Returns the layout of a film without panels: the gas has their room, too, and what stands
/// between it and them moves to the end of that room.
LayoutSpec without_panels(LayoutSpec layout);

/// Returns the names of the templates in `templates`/films that have places for at least `panels`
/// panels, in order of increasing number of places.
std::vector<std::string> templates_with_places(const std::filesystem::path& templates,
                                               std::size_t panels);

/// Returns `film` with the keys added that only the template gives, except `layout` and keys that
/// cannot be combined (`choices`) with a key that `film` gives.
Node lay_over(const Node& film, const Node& template_file, const std::vector<Choice>& choices);

}  // namespace carom

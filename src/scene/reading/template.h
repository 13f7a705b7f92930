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

/// Finds a template: first in the folder of the scene file `scene`, then in `templates`/films.
/// `asked` is the node that gives its name. Reports an unknown template, with the names of those
/// available, and returns nothing.
std::optional<TemplateFile> find_template(const Node& asked, const std::filesystem::path& scene,
                                          const std::filesystem::path& templates, Errors& errors);

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

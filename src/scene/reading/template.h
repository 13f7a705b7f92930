// Templates of films: where they are found, their layout, and how they lie under a scene's `film`.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/scene.h"
#include "scene/yaml/node.h"

namespace carom {

/// A file that holds a template, and the name under which a scene knows it.
struct TemplateFile {
    std::string name;
    std::filesystem::path path;
};

/// Looks for a template: in the scene's folder, then in `templates`/films. `asked` is where its
/// name is written. Reports an unknown one with those there are; nothing then.
std::optional<TemplateFile> find_template(const Node& asked, const std::filesystem::path& scene,
                                          const std::filesystem::path& templates, Errors& errors);

/// Whether what a file is, or what a link of its name leads to, lies in a folder.
bool stays_inside(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Where things stand in a frame; nothing when an error leaves it open.
Notation<LayoutSpec> layout_notation();

/// The names of the templates in `templates`/films with places for at least `panels` panels, those
/// with the fewest first.
std::vector<std::string> templates_with_places(const std::filesystem::path& templates,
                                               std::size_t panels);

/// `film` with what only the template says added to it, but its layout and what one of `choices`
/// excludes.
Node lay_over(const Node& film, const Node& template_file, const std::vector<Choice>& choices);

}  // namespace carom

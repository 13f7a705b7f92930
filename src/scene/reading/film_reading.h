// From the checked `film` of a scene, and its template, to values, and what these mean together:
// frames, panels for the slots there are.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/keys/fields.h"
#include "scene/scene.h"

namespace carom {

/// The theme of a checked word.
ThemeName read_theme(const std::string& word);

/// Where things stand, from a checked template; nothing when an error leaves it open.
std::optional<LayoutSpec> read_layout(const Fields& template_file, Errors& errors);

/// The names of templates with places for so many panels.
using TemplatesFor = std::function<std::vector<std::string>(std::size_t panels)>;

/// The film, from `film` laid over its template. `run` gives the length where the film does not,
/// `gas` what its panels may choose from. A scene's panels may be more than the places of a
/// template that the command line asks for: the first are shown. Where they are too many,
/// `templates` is asked for others.
Film read_film(const Fields& film, const Fields& scene, const Run& run, const Gas& gas,
               const std::optional<LayoutSpec>& layout, const TemplatesFor& templates,
               Errors& errors);

/// What the film shows, in a plain sentence or two.
std::string describe(const Scene& scene);

}  // namespace carom

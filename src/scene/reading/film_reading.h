// The keys of `film` and of its templates, and what they mean together: frames, panels for the
// slots there are.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"

namespace carom {

/// A span of slow motion, as far as it is given.
struct SlowDraft {
    double from = 0.0;
    std::optional<double> to;
    std::optional<double> factor;
};

/// A film as it is written. Refers to its nodes.
struct FilmDraft : Film {
    std::optional<double> given_seconds;
    double pace = 1.0;
    std::vector<Placed<SlowDraft>> spans;
};

KeyTable<FilmDraft> film_table(PanelKinds kinds);

/// The keys of `film` but `template`, and `layout`.
KeyTable<FilmDraft> template_table(PanelKinds kinds);

/// Where things stand, from a checked template; nothing when an error leaves it open.
std::optional<LayoutSpec> read_layout(const Node& template_file, Reading& reading);

/// The names of templates with places for so many panels.
using TemplatesFor = std::function<std::vector<std::string>(std::size_t panels)>;

/// The film of a draft that was read from `film`, which is laid over its template, in the scene
/// `root`. Its run gives the length where the film does not. A scene's panels may be more than the
/// places of a template that the command line asks for: the first are shown. Where they are too
/// many, `templates` is asked for others.
Film complete_film(const FilmDraft& draft, const Node& film, const Node& root,
                   const std::optional<LayoutSpec>& layout, const TemplatesFor& templates,
                   Reading& reading);

/// What the film shows, in a plain sentence or two.
std::string describe(const Scene& scene);

}  // namespace carom
